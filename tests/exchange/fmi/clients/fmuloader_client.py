"""Co-simulation by fmuloader, which calls the functions of both standards by their names."""

from importlib.metadata import version
from typing import Any

from fmuloader.fmi2 import Fmi2Slave, Fmi2Type
from fmuloader.fmi3 import Fmi3Slave
from request import answer


def client(asked: dict[str, Any]) -> dict[str, Any]:
    references, step = asked["references"], asked["step"]
    slave: Any
    if asked["version"] == 2:
        slave = Fmi2Slave(asked["fmu"], model_identifier=asked["stem"])
        own_memory = {
            "cannot_use_memory_management_functions": True
        }  # its function of memory cuts addresses to 32 bits
        slave.instantiate("one", Fmi2Type.CO_SIMULATION, guid=asked["token"], **own_memory)
        slave.setup_experiment(0.0, None, 1e-8)
        slave.enter_initialization_mode()
        get = slave.get_real
    else:
        slave = Fmi3Slave(asked["fmu"], model_identifier=asked["stem"])
        slave.instantiate_co_simulation("one", instantiation_token=asked["token"])
        slave.enter_initialization_mode(0.0, None, 1e-8)
        get = slave.get_float64
    slave.exit_initialization_mode()
    time, rows = [], []
    for k in range(asked["count"]):
        slave.do_step(k * step, step)
        time.append((k + 1) * step)
        rows.append(get(references))
    slave.terminate()
    slave.free_instance()
    return {"version": version("fmuloader"), "time": time, "rows": rows}


if __name__ == "__main__":
    answer(client)
