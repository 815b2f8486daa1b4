"""Motions of files of Modelica by Rumoca: `rumoca_motion.py JOBS RESULTS`.

JOBS is a list of jobs in JSON: file, class or whole name of the model, start, stop and interval [s], inputs (constants
by identifier), tolerance, seconds for one run. RESULTS is a list in the same order: a table of values by identifier, or
the message of Rumoca.
"""

import json
import sys
from pathlib import Path

import rumoca


def simulated(model, job, solver):
    """None where the explicit method takes too long: the model is stiff."""
    tolerance, seconds = job["tolerance"], job["seconds"]
    config = rumoca.SimConfig(solver=solver, rtol=tolerance, atol=tolerance * 1e-2, max_wall_seconds=seconds)
    try:
        return model.simulate((job["start"], job["stop"]), dt=job["interval"], config=config)
    except rumoca.SimulationError:
        if solver == "bdf":
            raise
        return None


def motion(job):
    text = Path(job["file"]).read_text(encoding="utf-8")
    name = job.get("model") or f"{job['class']}.{job['class']}"
    given = ", ".join(f"{key} = {json.dumps(value)}" for key, value in job["inputs"].items())
    if given:
        text += f"\nmodel Driven\n  {name} driven({given});\nend Driven;\n"
    model = rumoca.Session().loads(text, model="Driven" if given else name)
    result = simulated(model, job, "rk-like") or simulated(model, job, "bdf")
    names = {each.removeprefix("driven."): each for each in result.names}
    table = {short: [float(x) for x in result[long]] for short, long in names.items() if not short.startswith("'#")}
    return {"time": [float(t) for t in result.time], "values": table}


def answer(job):
    try:
        return motion(job)
    except rumoca.RumocaError as error:
        return {"message": str(error)}


Path(sys.argv[2]).write_text(json.dumps([answer(job) for job in json.loads(Path(sys.argv[1]).read_text())]))
