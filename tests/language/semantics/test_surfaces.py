"""`table(x, y, xs, ys, zs)` against SciPy and against functions that it meets exactly."""

from __future__ import annotations

import numpy as np
import pytest
from flattening import run
from scipy.interpolate import RegularGridInterpolator

import lagdsl
from lagdsl.language.flat.evaluate import Values, evaluate

XS, YS = [0.0, 0.5, 2.0, 3.0], [-1.0, 0.0, 0.25, 2.0, 4.0]
TEXT = """model M
  structural parameter Length at[:] = {0, 0.5, 2, 3};
  parameter Force f[4, 5] = {FORCES};
  coordinate Length x; coordinate Angle y;
  kinetic 1/2*(1 kg)*der(x)^2 + 1/2*(1 kg.m2)*der(y)^2;
  force z on x;
  output Force z = table(x, y, at, {-1, 0, 0.25, 2, 4}*(1 rad), f, "METHOD");
end M;
"""


def text(method: str, values: np.ndarray) -> str:
    rows = ", ".join("{" + ", ".join(f"{value!r}" for value in row) + "}" for row in values.tolist())
    return TEXT.replace("FORCES", rows).replace("METHOD", method)


def surface_of(method: str, values: np.ndarray, x: np.ndarray, y: np.ndarray) -> list[float]:
    flat, sink = run(text(method, values))
    assert flat is not None, sink.diagnostics
    (output,) = flat.outputs
    assert output.unit == "N"
    names = {f"f[{i + 1},{k + 1}]": value for (i, k), value in np.ndenumerate(values)}
    places = zip(x.tolist(), y.tolist(), strict=True)
    return [evaluate(flat, output.value, Values(variables={**names, "x": a, "y": b})) for a, b in places]


def test_linear_is_bilinear() -> None:
    """Outside, it goes on with the slopes of the ends, as SciPy extrapolates."""
    random = np.random.default_rng(3)
    values, x, y = random.normal(size=(4, 5)), random.uniform(-1, 4, 200), random.uniform(-2, 5, 200)
    other = RegularGridInterpolator((XS, YS), values, bounds_error=False, fill_value=None)
    np.testing.assert_allclose(surface_of("linear", values, x, y), other((x, y)), rtol=1e-10, atol=1e-12)
    corners = np.array(np.meshgrid(XS, YS, indexing="ij")).reshape(2, -1)
    np.testing.assert_allclose(surface_of("linear", values, *corners), values.ravel(), rtol=1e-14)


def test_cubic_meets_products_of_parabolas() -> None:
    """Bessel's slopes are exact for quadratic functions, so the surface is for their products."""
    random = np.random.default_rng(4)
    x, y = random.uniform(0, 3, 200), random.uniform(-1, 4, 200)

    def exact(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return (1 - 2 * x + x**2) * (3 + y - 0.5 * y**2)

    values = exact(np.array(XS)[:, None], np.array(YS))
    np.testing.assert_allclose(surface_of("cubic", values, x, y), exact(x, y), rtol=1e-10, atol=1e-12)


def test_rows_share_their_corners() -> None:
    """Two borders of x and three of y, told by two distances each, however many rows there are."""
    flat, _ = run(text("linear", np.arange(20.0).reshape(4, 5) ** 2))
    assert flat is not None and len(flat.events.corners) == 4


@pytest.mark.parametrize("method", ["linear", "cubic"])
def test_a_motion_over_a_saddle(method: str) -> None:
    """V = x*y is met exactly in every cell: (x + y) swings, (x - y) grows as cosh."""
    at = "{-3, -1, 0.5, 3}"
    rows = ", ".join("{" + ", ".join(str(a * b) for b in (-3, -1, 0.5, 3)) + "}" for a in (-3, -1, 0.5, 3))
    model = lagdsl.compile(
        f"""model Saddle
          coordinate Length x(start = 0.9 m), y(start = 0.1 m);
          kinetic 1/2*(1 kg)*(der(x)^2 + der(y)^2);
          potential table(x, y, {at}*(1 m), {at}*(1 m), {{{rows}}}*(1 J), "{method}");
        end Saddle;""",
        engine="tape",
    )
    motion = model.simulate(stop=1.5, interval=0.1, tolerance=1e-10)
    np.testing.assert_allclose(motion["x"] + motion["y"], np.cos(motion.time), atol=1e-7)
    np.testing.assert_allclose(motion["x"] - motion["y"], 0.8 * np.cosh(motion.time), rtol=1e-7)


@pytest.mark.parametrize(
    ("change", "code"),
    [
        (('"METHOD"', '"monotone"'), "E0312"),
        (("table(x, y,", "table(x, at,"), "E0312"),
        (("at, {-1", "f, {-1"), "E0312"),
        (("f, ", "at, "), "E0312"),
        (("{-1, 0, 0.25, 2, 4}", "{-1, 0, 0.25, 2}"), "E0313"),
        (("{-1, 0, 0.25, 2, 4}*(1 rad)", "{-1, 0, 0.25, 2, 4}*(1 m)"), "E0401"),
        (("0.25, 2, 4}", "0.25, 4, 2}"), "E0362"),
        (("structural parameter Length at[:]", "parameter Length at[4]"), "E0361"),
        ((', "METHOD")', ', "linear", 1)'), "E0315"),
    ],
)
def test_faults(change: tuple[str, str], code: str) -> None:
    changed = text("METHOD", np.ones((4, 5))).replace(*change).replace("METHOD", "linear")
    _, sink = run(changed)
    assert code in [each.code for each in sink.diagnostics], [each.message for each in sink.diagnostics]
