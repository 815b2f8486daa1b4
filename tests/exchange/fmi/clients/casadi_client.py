"""Model exchange by CasADi's DaeBuilder: right-hand sides and their sparse Jacobian at points, and a motion by CVODES.

Asked, too: `states`, `inputs`, `points` (t, x, u). Answered, too: `ode`, `jacobian` d ode / d (x, u), `pattern` its
structural entries.
"""

from typing import Any

import casadi as ca
import numpy as np
from request import answer


def client(asked: dict[str, Any]) -> dict[str, Any]:
    dae = ca.DaeBuilder("model", asked["folder"], {})
    assert dae.x() == asked["states"], dae.x()
    assert dae.u() == asked["inputs"], dae.u()
    right = dae.create("right", ["t", "x", "u"], ["ode"])
    slopes = right.factory("slopes", ["t", "x", "u"], ["jac:ode:x", "jac:ode:u"])
    ode, jacobian = [], []
    for t, x, u in asked["points"]:
        ode.append(np.array(right(t, x, u)).ravel().tolist())
        jacobian.append(np.hstack([np.array(block.full()) for block in slopes(t, x, u)]).tolist())
    pattern = np.hstack([np.array(ca.DM(slopes.sparsity_out(k), 1).full()) for k in range(2)])
    time = [asked["step"] * k for k in range(1, asked["count"] + 1)]
    options = {"reltol": 1e-11, "abstol": 1e-12, "max_num_steps": 100000}
    integrator = ca.integrator("motion", "cvodes", dae.create("dae"), 0, time, options)
    begin, inputs, parameters = asked["points"][0][1], ca.DM(asked["points"][0][2]), ca.DM(dae.start(dae.p()))
    rows = np.array(integrator(x0=begin, u=inputs, p=parameters)["xf"]).T.tolist()
    return {
        "version": ca.__version__,
        "ode": ode,
        "jacobian": jacobian,
        "pattern": pattern.tolist(),
        "time": time,
        "rows": rows,
    }


if __name__ == "__main__":
    answer(client)
