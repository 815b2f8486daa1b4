"""The planar models that no peer is asked for, in extended precision: beam, and chain of four-bar linkages."""

import numpy as np
from oracle import Extended, apply


def beam(states: np.ndarray) -> np.ndarray:
    """qdd of models/beam.lag: bars in absolute angles, the mass matrix as in textbooks."""
    n = states.shape[1] // 2
    q, qd = np.asarray(states[:, :n], Extended), np.asarray(states[:, n:], Extended)
    length, mass, stiffness = Extended(2) / n, Extended("1.2") / n, 3 / (Extended(2) / n)
    i = np.arange(n)
    beyond = (n - 1 - np.maximum.outer(i, i)) + np.where(np.eye(n), Extended(1) / 3, Extended(1) / 2)
    between = q[:, :, None] - q[:, None, :]
    matrix = mass * length**2 * beyond * np.cos(between)
    weight = mass * Extended("9.81") * length * ((n - 1 - i) + Extended(1) / 2) * np.cos(q)
    bend = np.diff(q, axis=1, prepend=0) * stiffness
    elastic = bend - np.hstack([bend[:, 1:], np.zeros((len(q), 1), Extended)])
    force = -apply(mass * length**2 * beyond * np.sin(between), qd**2) - weight - elastic
    return _solved(matrix, force)


def four_bars(states: np.ndarray) -> np.ndarray:
    """qdd of models/four_bars.lag: Newton's and Euler's equations of the bars, with the closures as constraints."""
    size = states.shape[1] // 6
    q, qd = (np.asarray(part, Extended) for part in np.split(states, 2, axis=1))
    lengths, distance, masses = (Extended("0.4"), Extended(1), Extended("0.8")), Extended(1), (1, 2, Extended("1.5"))
    crank, coupler, rocker = (np.arange(size) + k * size for k in range(3))
    # Rows of angles: each bar's angle to the horizontal is a sum of coordinates.
    angles = np.zeros((3 * size, 3 * size), Extended)
    before = np.zeros(3 * size, Extended)
    for i in range(size):
        angles[crank[i]] = angles[rocker[i]] = before
        angles[crank[i], crank[i]] = angles[rocker[i], rocker[i]] = 1
        angles[coupler[i]] = angles[crank[i]]
        angles[coupler[i], coupler[i]] = 1
        before = angles[coupler[i]]
    # Points are sums of vectors fixed to bars; base[i] is the coupler before, seen from its origin.
    origin = np.zeros(3 * size, Extended)
    forms: list[tuple[np.ndarray, int, Extended]] = []
    closures = []
    for i in range(size):
        a, b, c = crank[i], coupler[i], rocker[i]
        foot = origin.copy()
        if i:
            foot[coupler[i - 1]] += distance
        head = origin.copy()
        head[a] += lengths[0]
        middle = [point.copy() for point in (origin, head, foot)]
        for point, bar, length in zip(middle, (a, b, c), lengths, strict=True):
            point[bar] += length / 2
        forms += [(point, bar, mass) for point, bar, mass in zip(middle, (a, b, c), masses, strict=True)]
        end, top = head.copy(), foot.copy()
        end[b] += lengths[1]
        top[c] += lengths[2]
        closures.append(end - top)
        origin = head
    return _planar(q, qd, angles, forms, closures, np.array(lengths), size)


def _planar(
    q: np.ndarray,
    qd: np.ndarray,
    angles: np.ndarray,
    forms: list[tuple[np.ndarray, int, Extended]],
    closures: list[np.ndarray],
    lengths: np.ndarray,
    size: int,
) -> np.ndarray:
    """qdd where points are sums of `forms[k] * (cos, sin)` of the bars' angles."""
    angle, rate = q @ angles.T, qd @ angles.T
    cosine, sine, square = np.cos(angle), np.sin(angle), rate**2

    def point(form: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Jacobian (states, 2, nq) and acceleration at qdd = 0 (states, 2)."""
        jacobian = np.stack([-(sine * form) @ angles, (cosine * form) @ angles], axis=1)
        return jacobian, np.stack([-(square * cosine) @ form, -(square * sine) @ form], axis=1)

    matrix = np.zeros((len(q), q.shape[1], q.shape[1]), Extended)
    force = np.zeros_like(q)
    for form, bar, mass in forms:
        jacobian, drift = point(form)
        turn = angles[bar]
        matrix += mass * np.swapaxes(jacobian, 1, 2) @ jacobian
        matrix += mass * lengths[bar // size] ** 2 / 12 * np.outer(turn, turn)
        drift[:, 1] += Extended("9.80665")
        force -= mass * np.sum(jacobian * drift[:, :, None], axis=1)
    rows = [point(form) for form in closures]
    return _constrained(
        matrix, force, np.concatenate([j for j, _ in rows], 1), -np.concatenate([d for _, d in rows], 1)
    )


def _constrained(matrix: np.ndarray, force: np.ndarray, rows: np.ndarray, gamma: np.ndarray) -> np.ndarray:
    count, m, n = rows.shape
    whole = np.zeros((count, n + m, n + m), Extended)
    whole[:, :n, :n] = matrix
    whole[:, :n, n:] = np.swapaxes(rows, 1, 2)
    whole[:, n:, :n] = rows
    return _solved(whole, np.hstack([force, gamma]))[:, :n]


def four_bar_states(size: int, count: int, seed: int = 1) -> np.ndarray:
    """q and qd of closed loops, shape (count, 6 size): cranks near their start, couplers and rockers after them."""
    generator = np.random.default_rng(seed)
    a = np.deg2rad(60) + generator.uniform(-0.5, 0.5, (count, size))
    speed = generator.uniform(-1.0, 1.0, (count, size))
    b, c = np.full_like(a, np.deg2rad(-33.38)), np.full_like(a, np.deg2rad(83.25))
    for _ in range(50):
        x = 0.4 * np.cos(a) + np.cos(a + b) - 1.0 - 0.8 * np.cos(c)
        y = 0.4 * np.sin(a) + np.sin(a + b) - 0.8 * np.sin(c)
        db, dc = _turns(a, b, c, -x, -y)
        b, c = b + db, c + dc
    rates = _turns(a, b, c, (0.4 * np.sin(a) + np.sin(a + b)) * speed, -(0.4 * np.cos(a) + np.cos(a + b)) * speed)
    return np.hstack([a, b, c, speed, *rates])


def _turns(a: np.ndarray, b: np.ndarray, c: np.ndarray, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Turns of coupler and rocker that change the gap of the loop by x and y."""
    xb, xc, yb, yc = -np.sin(a + b), 0.8 * np.sin(c), np.cos(a + b), -0.8 * np.cos(c)
    determinant = xb * yc - xc * yb
    return (yc * x - xc * y) / determinant, (xb * y - yb * x) / determinant


def _solved(matrix: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Gaussian elimination with row pivots, all states at once: LAPACK has no extended precision."""
    a, b = matrix.copy(), right.copy()
    states, n = np.arange(len(a)), a.shape[1]
    for k in range(n):
        best = k + np.argmax(np.abs(a[:, k:, k]), axis=1)
        for array in (a, b):
            kept = array[states, best].copy()
            array[states, best] = array[:, k]
            array[:, k] = kept
        share = a[:, k + 1 :, k] / a[:, k, k][:, None]
        a[:, k + 1 :] -= share[:, :, None] * a[:, k][:, None, :]
        b[:, k + 1 :] -= share * b[:, k][:, None]
    x = np.zeros_like(b)
    for k in reversed(range(n)):
        x[:, k] = (b[:, k] - np.sum(a[:, k, k + 1 :] * x[:, k + 1 :], axis=1)) / a[:, k, k]
    return x
