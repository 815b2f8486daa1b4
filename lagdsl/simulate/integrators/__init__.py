"""The integrators by name: one method, one file. SciPy and SUNDIALS are loaded only when one is started."""

from lagdsl.simulate.integrators.bdf import BDF
from lagdsl.simulate.integrators.cvode import CVODE
from lagdsl.simulate.integrators.dop853 import DOP853
from lagdsl.simulate.integrators.fixed import LEAPFROG, RK4, ROS2, with_steps
from lagdsl.simulate.integrators.method import Method
from lagdsl.simulate.integrators.radau import RADAU
from lagdsl.simulate.integrators.rk45 import RK45

METHODS: dict[str, Method] = {method.name: method for method in (DOP853, RK45, RADAU, BDF, RK4, LEAPFROG, ROS2, CVODE)}

__all__ = ["METHODS", "Method", "with_steps"]
