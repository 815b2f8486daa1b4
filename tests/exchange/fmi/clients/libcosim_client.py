"""Co-simulation by libcosim (Open Simulation Platform) through libcosimpy; FMI 2."""

from importlib.metadata import version
from typing import Any

from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave
from request import answer


def client(asked: dict[str, Any]) -> dict[str, Any]:
    execution = CosimExecution.from_step_size(round(asked["step"] * 1e9))
    slave = CosimLocalSlave(asked["fmu"], "one")
    index = execution.add_local_slave(slave)
    observer = CosimObserver.create_last_value()
    assert execution.add_observer(observer)
    known = {v.name.decode(): v.reference for v in execution.slave_variables(index)}
    references = [known[name] for name in asked["variables"]]
    time, rows = [], []
    for k in range(asked["count"]):
        assert execution.step(1), execution.status()
        time.append((k + 1) * asked["step"])
        rows.append(list(observer.last_real_values(index, references)))
    return {"version": version("libcosimpy"), "time": time, "rows": rows}


if __name__ == "__main__":
    answer(client)
