"""Run in the peers' environment: CVODES by CasADi, CVODE by scikit-sundae, SciPy's DOP853 with Numba."""

import time

import numpy as np
from in_peers import casadi_function
from problems import GOAL, PROBLEMS, Problem
from serial import ARMS

TOLERANCES = [10.0 ** (-k / 2) for k in range(6, 27)]
# Absolute tolerances as parts of the relative one; the best counts.
PARTS = (1.0, 1e-2, 1e-4)
REPEATS = 7
# The Test Set for Initial Value Problem Solvers (Mazzia and Magherini 2008), problem vdpol.
VAN_DER_POL = np.array([1.706167732170483, -0.8928097010247975])


def measure(name):
    """Reference, how near CVODES comes to it, and a row for every run: way, tolerance, error,
    evaluations, jacobians, seconds."""
    problem = PROBLEMS[name]
    start = np.array(problem.start)
    state, rates = equations(problem)
    if problem.stiff:
        reference = exact(problem, state, rates, start)
        assert name != "oscillator" or distance(reference[-1], VAN_DER_POL) < 1e-10
        rows = [*cvodes(problem, state, rates, start, reference, {}), *cvode(problem, state, rates, start, reference)]
    else:
        right = numba_chain(problem.n)
        reference = scipy_run(right, start, problem.stop, 3e-14).y[:, -1:].T
        adams = {"linear_multistep_method": "adams", "nonlinear_solver_iteration": "functional"}
        rows = [
            *cvodes(problem, state, rates, start, reference, {}),
            *cvodes(problem, state, rates, start, reference, adams),
            *numba_rows(problem, right, start, reference),
        ]
    apart = min(row["error"] for row in rows if row["way"].startswith("CVODES"))
    return {"reference": reference.tolist(), "apart": apart, "rows": rows}


def distance(x, reference):
    """Largest difference; relative where a number is larger than 1."""
    return float(np.max(np.abs(x - reference) / np.maximum(1.0, np.abs(reference))))


def equations(problem: Problem):
    """x and dx/dt as CasADi's expressions, energies typed by hand."""
    import casadi as ca

    if problem.model == "stiff_oscillator":
        x = ca.SX.sym("x", 2)
        return x, ca.vertcat(x[1], ((1 - x[0] ** 2) * x[1] - x[0]) / 1e-6)
    if problem.model == "stiff_slider_crank":
        return slider_crank()
    n = problem.n
    x = ca.SX.sym("x", 2 * n)
    return x, ca.vertcat(x[n:], casadi_function(ARMS[problem.model](n), "plane")(x[:n], x[n:]))


def slider_crank():
    """models/stiff_slider_crank.lag, with angles from the vertical."""
    import casadi as ca

    r, length, rod, piston, shaft, about = 0.045, 0.15, 0.6, 0.4, 5e-3, 2e-3
    k, c, drive, drag = 1e9, 1e6, 3.0, 20.0
    x = ca.SX.sym("x", 4)
    q, v = x[:2], x[2:]

    def speed(part):
        """Of the point at this part of the rod."""
        across = -r * ca.cos(q[0]) * v[0] - part * length * ca.cos(q[1]) * v[1]
        return ca.vertcat(across, -r * ca.sin(q[0]) * v[0] - part * length * ca.sin(q[1]) * v[1])

    kinetic = shaft / 2 * v[0] ** 2 + rod / 2 * ca.sumsqr(speed(0.5)) + about / 2 * v[1] ** 2
    kinetic += piston / 2 * ca.sumsqr(speed(1.0))
    potential = k / 2 * (r * ca.sin(q[0]) + length * ca.sin(q[1])) ** 2
    lost = c / 2 * speed(1.0)[0] ** 2 + drag / 2 * speed(1.0)[1] ** 2
    momentum = ca.gradient(kinetic, v)
    rest = ca.gradient(kinetic - potential, q) - ca.jtimes(momentum, q, v) - ca.gradient(lost, v) + ca.vertcat(drive, 0)
    return x, ca.vertcat(v, ca.solve(ca.jacobian(momentum, v), rest))


def cvodes(problem, state, rates, start, reference, options):
    """SUNDIALS as CasADi has it, exact Jacobian; time without making the integrator."""
    import casadi as ca

    rows = []
    way = "CVODES by CasADi" + (", Adams" if options else "")
    for part in PARTS if problem.stiff else PARTS[:1]:
        for tolerance in TOLERANCES:
            own = {"reltol": tolerance, "abstol": part * tolerance, "max_num_steps": 10_000_000, **options}
            integrator = ca.integrator("i", "cvodes", {"x": state, "ode": rates}, 0.0, problem.times, own)
            seconds, states = timed(lambda made=integrator: np.array(made(x0=start)["xf"]).T, problem.stiff)
            told = integrator.stats()
            rows.append(
                {
                    "way": way,
                    "tolerance": tolerance,
                    "error": distance(states, reference),
                    "evaluations": int(told["nfevals"]),
                    "jacobians": None,
                    "seconds": seconds,
                }
            )
    return rows


def cvode(problem, state, rates, start, reference):
    """The newest SUNDIALS there is, exact Jacobian; counts only, as Python is called for every evaluation."""
    try:
        from sksundae.cvode import CVODE
    except ImportError:
        return []
    import casadi as ca

    right = ca.Function("f", [state], [rates])
    matrix = ca.Function("j", [state], [ca.densify(ca.jacobian(rates, state))])

    def slopes(t, x, xd):
        xd[:] = np.array(right(x)).ravel()

    def jacobian(t, x, xd, jj):
        jj[:, :] = np.array(matrix(x))

    rows = []
    for part in PARTS[:2]:
        for tolerance in TOLERANCES[:13:2]:
            own = {"rtol": tolerance, "atol": part * tolerance, "jacfn": jacobian, "max_num_steps": 10_000_000}
            found = CVODE(slopes, method="BDF", **own).solve(np.array([0.0, *problem.times]), start)
            rows.append(
                {
                    "way": "CVODE by scikit-sundae",
                    "tolerance": tolerance,
                    "error": distance(found.y[1:], reference),
                    "evaluations": int(found.nfev),
                    "jacobians": int(found.njev),
                    "seconds": None,
                }
            )
    return rows


def exact(problem, state, rates, start):
    """States at problem.times, each the end of a run from the one before, as dense output is less exact: by SciPy's
    explicit DOP853, which stability, not accuracy, makes take short steps; of the oscillator, for which these are too
    many, by its Radau with an exact Jacobian."""
    import casadi as ca
    from scipy.integrate import solve_ivp

    right = called(ca.Function("f", [state], [rates]), (len(start),))
    slope = called(ca.Function("j", [state], [ca.densify(ca.jacobian(rates, state)).T]), (len(start), len(start)))
    explicit = problem.model != "stiff_oscillator"
    own = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-12}
    own = own if explicit else {"method": "Radau", "jac": slope, "rtol": 1e-13, "atol": 1e-15}
    found, t, x = [], 0.0, start
    for until in problem.times:
        x = solve_ivp(right, (t, until), x, **own).y[:, -1]
        t = until
        found.append(x)
    return np.array(found)


def called(function, shape):
    """Of a state, through CasADi's buffers; CasADi stores by columns, so a matrix is that of the transpose."""
    buffer, call = function.buffer()
    given, found = np.zeros(function.size1_in(0)), np.zeros(shape)
    buffer.set_arg(0, memoryview(given))
    buffer.set_res(0, memoryview(found.reshape(-1)))

    def value(_, x, _kept=buffer):
        given[:] = x
        call()
        return found.copy()

    return value


def scipy_run(right, start, stop, tolerance):
    from scipy.integrate import solve_ivp

    return solve_ivp(right, (0.0, stop), start, method="DOP853", rtol=max(tolerance, 2.3e-14), atol=tolerance)


def numba_rows(problem, right, start, reference):
    rows = []
    for tolerance in TOLERANCES[:19]:
        seconds, found = timed(lambda by=tolerance: scipy_run(right, start, problem.stop, by), problem.stiff)
        rows.append(
            {
                "way": "SciPy DOP853, Numba",
                "tolerance": tolerance,
                "error": distance(found.y[:, -1:].T, reference),
                "evaluations": int(found.nfev),
                "jacobians": None,
                "seconds": seconds,
            }
        )
        if rows[-1]["error"] < 1e-3 * GOAL:
            break
    return rows


def numba_chain(n):
    """models/planar_chain.lag by the textbook's matrices in absolute angles, compiled."""
    from numba import njit

    m, length, g = 1.3, 0.7, 9.81
    i = np.arange(n)
    beyond = (n - 1 - np.maximum.outer(i, i)) + 0.5
    beyond[i, i] = (n - 1 - i) + 1 / 3
    beyond = m * length**2 * beyond
    weight = m * g * length * ((n - 1 - i) + 0.5)

    @njit(fastmath=False)
    def right(t, x):
        angle, rate = np.cumsum(x[:n]), np.cumsum(x[n:])
        matrix, force = np.empty((n, n)), np.empty(n)
        for a in range(n):
            total = -weight[a] * np.sin(angle[a])
            for b in range(n):
                matrix[a, b] = beyond[a, b] * np.cos(angle[a] - angle[b])
                total -= beyond[a, b] * np.sin(angle[a] - angle[b]) * rate[b] ** 2
            force[a] = total
        solved = np.linalg.solve(matrix, force)
        out = np.empty(2 * n)
        out[:n] = x[n:]
        out[n] = solved[0]
        out[n + 1 :] = solved[1:] - solved[:-1]
        return out

    right(0.0, np.zeros(2 * n))
    return right


def timed(work, once):
    """Least seconds of several runs, and what it gives."""
    least = np.inf
    for _ in range(1 if once else REPEATS):
        start = time.perf_counter()
        result = work()
        least = min(least, time.perf_counter() - start)
    return least, result
