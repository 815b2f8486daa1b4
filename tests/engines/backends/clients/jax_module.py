"""Compares a module for JAX with values: run by an interpreter that has JAX.

jax_module.py FOLDER MODULE VALUES.npz: prints the largest error of each function, relative to the largest value or to
1, and under `jacobian` that of the derivative of the rates of the state by the state, forward, and of one state in
reverse.
"""

import importlib
import json
import sys

import jax
import jax.numpy as jnp
import numpy as np


def main(folder: str, module: str, values: str) -> None:
    sys.path.insert(0, folder)
    model = importlib.import_module(module)
    given = np.load(values)
    worst: dict[str, float] = {}
    for name in given["functions"].tolist():
        arguments = [given[f"{name}/in/{k}"] for k in range(int(given[f"{name}/inputs"]))]
        function = jax.jit(jax.vmap(called(model, name)))
        for k, block in enumerate(function(*arguments)):
            worst[name] = max(worst.get(name, 0.0), error(np.array(block), given[f"{name}/out/{k}"]))
    state = [given[f"forward_dynamics/in/{k}"] for k in range(7)]
    forward, total = (np.array(found) for found in jacobians(model, state))
    expected = given["jacobian"]
    worst["jacobian"] = max(error(forward, expected), error(total, expected[0].sum(axis=0)))
    print(json.dumps(worst))


def called(model, name):
    """A function of the table, or the solution of the equations of motion."""
    if name == "forward_dynamics":
        return lambda *state: (model.forward_dynamics(*state), model.multipliers(*state))
    return lambda *arguments: model.evaluate(name, *arguments)


def jacobians(model, state):
    t, q, qd, z, u, w, p = state
    n = q.shape[1]

    def rates(x, t, u, w, p):
        return jnp.concatenate(model.rates(t, x[:n], x[n : 2 * n], x[2 * n :], u, w, p))

    x = np.concatenate([q, qd, z], axis=1)
    forward = jax.jit(jax.vmap(jax.jacfwd(rates)))(x, t, u, w, p)
    total = jax.jit(jax.grad(lambda *given: rates(*given).sum()))(x[0], t[0], u[0], w[0], p[0])
    return forward, total


def error(found: np.ndarray, wanted: np.ndarray) -> float:
    finite = np.isfinite(wanted)
    if not np.array_equal(np.isfinite(found), finite):
        return float("inf")
    size = max(1.0, float(np.abs(wanted[finite]).max(initial=0.0)))
    return float(np.abs(found - wanted)[finite].max(initial=0.0)) / size


main(*sys.argv[1:])
