"""Andrews' squeezing mechanism: the published equations of the IVP Test Set, integrated by themselves."""

from collections.abc import Mapping

import numpy as np

from models.references.integrate import Floats, solve

START = (
    -0.0617138900142764496358948458001,
    0.0,
    0.455279819163070380255912382449,
    0.222668390165885884674473185609,
    0.487364979543842550225598953530,
    -0.222668390165885884674473185609,
    1.23054744454982119249735015568,
)
PINS = ("O.q", "P.q", "B.q", "E.q", "A5.q", "H.q", "A7.q")
"""The pins whose angles are beta, Theta, gamma, Phi, delta, Omega and epsilon."""


def andrews_squeezer(_: Mapping[str, float], t: Floats) -> dict[str, Floats]:
    """Mass matrix, forces and constraint Jacobian as printed, accelerations by the index-1 system.

    No stabilization: at this tolerance the constraints drift by less than 1e-12 m. The data are the published ones,
    not those of the model.
    """

    def rates(_: float, x: Floats) -> Floats:
        q, v = x[:7], x[7:]
        mass, force, jacobian, gamma = _equations(q, v)
        matrix = np.block([[mass, jacobian.T], [jacobian, np.zeros((6, 6))]])
        return np.concatenate([v, np.linalg.solve(matrix, np.concatenate([force, gamma]))[:7]])

    x = solve(rates, [*START, *(7 * [0.0])], t, tolerance=1e-13)
    return dict(zip(PINS, x[:7], strict=True))


def _equations(q: Floats, v: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """M, f, G and -d(G)/dt v of Hairer and Wanner, Solving Ordinary Differential Equations II, section VII.7."""
    m1, m2, m3, m4, m5, m6, m7 = 0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498
    i1, i2, i3, i4, i5, i6, i7 = 2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5
    xb, yb, xc, yc = -0.03635, 0.03273, 0.014, 0.072
    d, da, e, ea = 0.028, 0.0115, 0.02, 0.01421
    rr, ra, ss, sa, sb, sc, sd = 0.007, 0.00092, 0.035, 0.01874, 0.01043, 0.018, 0.02
    ta, tb, u, ua, ub = 0.02308, 0.00916, 0.04, 0.01228, 0.00449
    zf, zt, fa, moment, stiffness, rest = 0.02, 0.04, 0.01421, 0.033, 4530.0, 0.07785

    be, th, ga, ph, de, om, ep = q
    vb, vt, vg, vp, vd, vo, ve = v
    bt, pd, oe = be + th, ph + de, om + ep
    wbt, wpd, woe = vb + vt, vp + vd, vo + ve
    sin, cos = np.sin, np.cos

    mass = np.zeros((7, 7))
    mass[0, 0] = m1 * ra**2 + m2 * (rr**2 - 2 * da * rr * cos(th) + da**2) + i1 + i2
    mass[0, 1] = mass[1, 0] = m2 * (da**2 - da * rr * cos(th)) + i2
    mass[1, 1] = m2 * da**2 + i2
    mass[2, 2] = m3 * (sa**2 + sb**2) + i3
    mass[3, 3] = m4 * (e - ea) ** 2 + i4
    mass[3, 4] = mass[4, 3] = m4 * ((e - ea) ** 2 + zt * (e - ea) * sin(ph)) + i4
    mass[4, 4] = m4 * (zt**2 + 2 * zt * (e - ea) * sin(ph) + (e - ea) ** 2) + m5 * (ta**2 + tb**2) + i4 + i5
    mass[5, 5] = m6 * (zf - fa) ** 2 + i6
    mass[5, 6] = mass[6, 5] = m6 * ((zf - fa) ** 2 - u * (zf - fa) * sin(om)) + i6
    mass[6, 6] = m6 * ((zf - fa) ** 2 - 2 * u * (zf - fa) * sin(om) + u**2) + m7 * (ua**2 + ub**2) + i6 + i7

    xd, yd = sd * cos(ga) + sc * sin(ga) + xb, sd * sin(ga) - sc * cos(ga) + yb
    length = np.hypot(xd - xc, yd - yc)
    fx, fy = -stiffness * (1 - rest / length) * np.array([xd - xc, yd - yc])
    force = np.array([
        moment - m2 * da * rr * vt * (vt + 2 * vb) * sin(th),
        m2 * da * rr * vb**2 * sin(th),
        fx * (sc * cos(ga) - sd * sin(ga)) + fy * (sd * cos(ga) + sc * sin(ga)),
        m4 * zt * (e - ea) * vd**2 * cos(ph),
        -m4 * zt * (e - ea) * vp * (vp + 2 * vd) * cos(ph),
        -m6 * u * (zf - fa) * ve**2 * cos(om),
        m6 * u * (zf - fa) * vo * (vo + 2 * ve) * cos(om),
    ])  # fmt: skip

    x = np.array([-rr * sin(be) + d * sin(bt), d * sin(bt)])
    y = np.array([rr * cos(be) - d * cos(bt), -d * cos(bt)])
    jacobian = np.zeros((6, 7))
    jacobian[0::2, :2], jacobian[1::2, :2] = x, y
    jacobian[0:2, 2] = -ss * cos(ga), -ss * sin(ga)
    jacobian[2:4, 3] = -e * cos(pd), -e * sin(pd)
    jacobian[2:4, 4] = -e * cos(pd) + zt * sin(de), -e * sin(pd) - zt * cos(de)
    jacobian[4:6, 5] = zf * sin(oe), -zf * cos(oe)
    jacobian[4:6, 6] = zf * sin(oe) - u * cos(ep), -zf * cos(oe) - u * sin(ep)

    tip = np.array([-rr * cos(be) * vb**2 + d * cos(bt) * wbt**2, -rr * sin(be) * vb**2 + d * sin(bt) * wbt**2])
    bends = np.concatenate([
        tip + np.array([ss * sin(ga) * vg**2, -ss * cos(ga) * vg**2]),
        tip + np.array([e * sin(pd) * wpd**2 + zt * cos(de) * vd**2, -e * cos(pd) * wpd**2 + zt * sin(de) * vd**2]),
        tip + np.array([zf * cos(oe) * woe**2 + u * sin(ep) * ve**2, zf * sin(oe) * woe**2 - u * cos(ep) * ve**2]),
    ])  # fmt: skip
    return mass, force, jacobian, -bends
