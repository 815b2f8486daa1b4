"""The step loop of a simulation and its parts."""

from lagdsl.simulate.motion.loop import Motion
from lagdsl.simulate.motion.task import Task

__all__ = ["Motion", "Task"]
