"""A motion as a function with derivatives: closed form of a thrown ball through its bounce, and the same numbers in JAX
and in PyTorch where these are installed."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from math import sqrt
from typing import Any

import numpy as np
import pytest

import lagdsl

BALL = """
model Ball
  parameter Real e = 0.8;
  input Force u = 0 N;
  coordinate Length h(start = 1 m), x(der(start = 1 m/s));
  mass 1 kg at {x, h};
  force u on x;
  gravity = {0, -9.81 m/s2};
  contact floor: h >= 0 with restitution = e;
end Ball;
"""
FREE, OF, G = ["h.start", "e", "u"], ["h", "x"], 9.81
OPTIONS: dict[str, Any] = {"stop": 0.6, "interval": 0.3, "tolerance": 1e-10}
POINTS = np.array([[1.0, 0.8, 0.0], [1.1, 0.7, 0.2]])


@cache
def model() -> lagdsl.Model:
    return lagdsl.compile(BALL, engine="tape")


def closed(point: np.ndarray) -> np.ndarray:
    """(rows, of, free) at 0, 0.3 and 0.6 s, the bounce being at sqrt(2 h/g)."""
    height, e, _ = point.tolist()
    since, v = 0.6 - sqrt(2.0 * height / G), sqrt(2.0 * G * height)
    behind = e * G / v * since - (e * v - G * since) / v
    of_height = [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [behind, v * since, 0.0]]
    of_x = [[0.0, 0.0, 0.5 * t * t] for t in (0.0, 0.3, 0.6)]
    return np.stack([of_height, of_x], axis=1)


def test_the_jacobian_is_that_of_the_closed_form() -> None:
    function = model().as_function(free=FREE, of=OF, **OPTIONS)
    assert function.here.tolist() == [1.0, 0.8, 0.0]
    assert function.time.tolist() == [0.0, 0.3, 0.6]
    y, jacobian = function.differentiate(POINTS)
    assert y.shape == (2, 3, 2)
    assert np.abs(y - function(POINTS)).max() < 1e-11
    for k in range(2):
        assert np.abs(jacobian[k] - closed(POINTS[k])).max() < 1e-10
    single = function(POINTS[1])
    assert np.array_equal(single, function(POINTS)[1])


def test_products_with_the_jacobian_agree() -> None:
    """dy . (J dx) = (J^T dy) . dx"""
    function = model().as_function(free="h.start, e, u", of=OF, **OPTIONS)
    random = np.random.default_rng(3)
    dx, dy = random.normal(size=(2, 3)), random.normal(size=(2, 3, 2))
    along, gradient = function.jvp(POINTS, dx)[1], function.vjp(POINTS, dy)[1]
    assert gradient.shape == (2, 3)
    assert np.sum(dy * along, axis=(1, 2)) == pytest.approx(np.sum(gradient * dx, axis=1), rel=1e-12)


def test_settings_stay_beside_what_is_free() -> None:
    given: dict[str, Any] = {"parameters": {"e": 0.5}, "start": {"x": "20 cm"}, "inputs": {"u": 0.1}}
    function = model().as_function(free=["h.start"], of=["x", "h"], **OPTIONS, **given)
    motion = model().simulate(stop=0.6, interval=0.3, tolerance=1e-10, **given)
    assert function(function.here)[-1] == pytest.approx([motion["x"][-1], motion["h"][-1]], abs=1e-12)


@pytest.mark.parametrize(
    ("call", "error", "text"),
    [
        (lambda: model().as_function(free="g", of="h"), KeyError, "E0874"),
        (lambda: model().as_function(free="e", of="g"), KeyError, "E0874"),
        (lambda: model().as_function(free="e", of="h", parameters={"e": 0.5}), ValueError, "`e` is free"),
        (lambda: model().as_function(free="h.start", of="h", start={"h": 1.0}), ValueError, "`h.start` is free"),
        (lambda: model().as_function(free="e", of="h", step=0.1), TypeError, "`step`"),
        (lambda: model().as_function(free="e", of="h")([0.5, 0.6]), ValueError, r"\(\.\.\., 1\)"),
        (lambda: model().as_function(free="e", of="h", **OPTIONS)([-0.5]), lagdsl.CompilationFailed, "restitution"),
    ],
)
def test_what_does_not_fit_is_told(call: Callable[[], object], error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=text):
        call()


@pytest.mark.parametrize("package", ["jax", "torch"])
def test_a_missing_package_is_named(package: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("lagdsl.interfaces.api.motions.find_spec", lambda name: None)
    with pytest.raises(ModuleNotFoundError, match=f"pip install {package}"):
        getattr(model(), f"as_{package}")(free="e", of="h")


def test_jax_transforms_it() -> None:
    jax = pytest.importorskip("jax", reason="needs the extra `jax`, too large for `dev`")
    function = model().as_function(free=FREE, of=OF, **OPTIONS)
    motion = model().as_jax(free=FREE, of=OF, **OPTIONS)
    assert np.array_equal(motion(POINTS[0]), function(POINTS[0]))
    assert np.array_equal(jax.jit(jax.vmap(motion))(POINTS), function(POINTS))
    for derivative in (jax.jacfwd, jax.jacrev):
        found = np.asarray(jax.jit(jax.vmap(derivative(motion)))(POINTS))
        assert np.abs(found - function.differentiate(POINTS)[1]).max() < 1e-13
    y, jacobian = function.differentiate(POINTS[0])
    found = jax.jit(jax.grad(lambda point: (motion(point) ** 2).sum()))(POINTS[0])
    assert np.asarray(found) == pytest.approx(np.sum(2.0 * y[..., None] * jacobian, axis=(0, 1)), rel=1e-13)


@pytest.mark.filterwarnings("ignore::FutureWarning")  # PyTorch 2.15 warns of parts of its own
def test_pytorch_transforms_it() -> None:
    torch = pytest.importorskip("torch", reason="needs the extra `torch`, too large for `dev`")
    function = model().as_function(free=FREE, of=OF, **OPTIONS)
    motion, points = model().as_torch(free=FREE, of=OF, **OPTIONS), torch.tensor(POINTS)
    jacobian = function.differentiate(POINTS)[1]
    assert np.array_equal(motion(points), function(POINTS))
    for derivative in (torch.func.jacfwd, torch.func.jacrev):
        assert np.abs(torch.func.vmap(derivative(motion))(points).numpy() - jacobian).max() < 1e-13
    leaf = points.clone().requires_grad_()
    motion(leaf).sum().backward()
    assert np.abs(leaf.grad.numpy() - jacobian.sum(axis=(1, 2))).max() < 1e-12
    batches = {"check_forward_ad": True, "check_batched_grad": True, "check_batched_forward_grad": True}
    point = points[1].clone().requires_grad_()
    assert torch.autograd.gradcheck(motion, (point,), rtol=1e-5, **batches)
