"""Co-simulation by Ecos through ecospy; both versions."""

from typing import Any

from ecospy import EcosLib, EcosSimulation, EcosSimulationStructure
from request import answer


def client(asked: dict[str, Any]) -> dict[str, Any]:
    time, rows = [], []
    with EcosSimulationStructure() as structure:
        structure.add_model("one", asked["fmu"])
        with EcosSimulation(structure=structure, step_size=asked["step"]) as simulation:
            assert simulation.init(), EcosLib.get_last_error()
            for k in range(asked["count"] + 1):
                time.append(simulation.get_time())
                rows.append([simulation.get_real(f"one::{name}") for name in asked["variables"]])
                if k < asked["count"]:
                    simulation.step(1)
            simulation.terminate()
    return {"version": str(EcosLib.version()).removeprefix("v"), "time": time, "rows": rows}


if __name__ == "__main__":
    answer(client)
