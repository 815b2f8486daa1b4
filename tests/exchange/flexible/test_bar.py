"""A bar of solid elements against CalculiX, the formulas of beams, `Lag.Flexible.Beam` and the laws of conservation."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from choice import repeats

import lagdsl
from flexible.bar import CLAMPED, FILES, FREE, HEIGHT, LENGTH, MODULUS, SPUN, WIDTH, carried
from lagdsl.exchange.flexible.deck import read_deck
from lagdsl.exchange.flexible.files import read_file
from lagdsl.exchange.flexible.matrices import read_matrices
from lagdsl.exchange.flexible.solid import solid_body


def frequencies(path: Path) -> np.ndarray:
    """Of a `.dat` file, in Hz."""
    rows = re.findall(r"^ +\d+ +\S+ +\S+ +(\S+) +0\.0000000E\+00$", path.read_text(), re.MULTILINE)
    return np.array([float(row) for row in rows])


def test_clamped_frequencies_are_those_of_calculix() -> None:
    expected = frequencies(FILES / "bar_clamped.dat")
    assert len(expected) == 8
    file = FILES / "bar.inp"
    deck = read_deck(read_file(file).source)
    body = solid_body(deck, read_matrices(file, None), ["ROOT", "TIP"], 20, 1.0)
    found = np.sqrt(np.diag(body.K) / np.diag(body.M)) / (2 * np.pi)
    assert np.allclose(found[:8], expected, rtol=1e-3)
    model = lagdsl.compile(carried(0, CLAMPED))
    assert np.allclose(np.unique(model.modes().frequencies.round(6))[:2], expected[:2], rtol=5e-3)


def test_trim_finds_the_deflection_of_a_cantilever() -> None:
    model = lagdsl.compile(carried(0, CLAMPED))
    force = 10.0
    point = model.trim(inputs={"load": force}).point
    assert model.frame("bar.frame_b").position(0.0, point.q)[1] == pytest.approx(
        force * LENGTH**3 / (3 * MODULUS * WIDTH * HEIGHT**3 / 12), rel=0.01
    )


def test_a_free_body_conserves_its_momentum() -> None:
    """Linear and angular momentum by the mass matrix, along the motions that move and turn the whole body."""
    model = lagdsl.compile(carried(0, FREE))
    assert model.coordinates[:7] == [*(f"base.r[{k}]" for k in (1, 2, 3)), *(f"base.e[{k}]" for k in (1, 2, 3, 4))]
    start = {"bar.eta[1]": 2e-3, "bar.eta[2]": -1e-3, "der(bar.eta[1])": 1.0, "der(base.r[2])": 0.5}
    motion = model.simulate(stop=0.004, tolerance=1e-8, start=start)
    names = model.coordinates
    momenta = []
    for k in np.linspace(0, len(motion.time) - 1, 6).astype(int):
        q = np.array([motion[name][k] for name in names])
        qd = np.array([motion[f"der({name})"][k] for name in names])
        momenta.append(rigid_motions(q).T @ model.mass_matrix(0.0, q) @ qd)
    size = np.abs(momenta).max(axis=0)
    assert (np.ptp(momenta, axis=0)[size > 1e-9] < 1e-6 * size.max()).all() and size[1] > 0.1 and size[5] > 0.01


def rigid_motions(q: np.ndarray) -> np.ndarray:
    """Rates of the coordinates in three translations and three turns about the origin of the world."""
    rates = np.zeros((len(q), 6))
    rates[:3, :3] = np.eye(3)
    e = q[3:7]
    for k, axis in enumerate(np.eye(3)):
        rates[:3, 3 + k] = np.cross(axis, q[:3])
        rates[3:7, 3 + k] = 0.5 * np.array([-axis @ e[1:], *(e[0] * axis + np.cross(axis, e[1:]))])
    return rates


def test_a_bar_that_spins_up_bends_as_a_beam_does() -> None:
    """Three times as fast as its lowest frequency: without geometric stiffening it would fail. The root of the solid
    elements cannot contract, which makes them stiffer: the beam takes the modulus with which it has their first
    frequency."""
    beam = SPUN.replace("Bar bar(beta = 0.1 ms)", BEAM).replace("Lag.Spatial", "Lag.Planar")
    models = [lagdsl.compile(carried(2, SPUN)), lagdsl.compile(f"model Model\n{beam}end Model;\n")]
    solid, slender = (model.modes().frequencies for model in models)
    stiffer = 1 + np.abs(solid / slender[slender > 1].min() - 1).min()
    assert 1.004 < stiffer < 1.006
    tips = []
    for model, parameters in zip(models, ({}, {"bar.E": MODULUS * stiffer**2}), strict=True):
        motion = model.simulate(stop=0.11, tolerance=1e-6, interval=0.11 / 60, parameters=parameters)
        tips.append(np.interp(np.linspace(0, 0.11, 61), motion.time, motion["tip"]))
    assert np.abs(tips[1]).max() > 0.01
    assert np.abs(tips[0] - tips[1]).max() < 3e-3 * np.abs(tips[1]).max()


BEAM = """Lag.Flexible.Beam bar(n = 3, L = 0.4 m, A = 200 mm^2, I = 6666.666666666667 mm^4, E = 210 GPa,
      density = 7850 kg/m3, zeta = 0.033)"""


def test_integrals_are_those_of_a_block() -> None:
    text = lagdsl.import_body(FILES / "block.inp", ["LEFT", "EDGE"], length_unit="mm", modes=1)
    assert "m = 7.85, com = {0.05, 0, 0}" in text
    assert f"I = {{{{{7.85 * 0.01 / 6:.10g}, 0, 0}}" in text


@repeats("test_models.py and test_exports.py, which have a blade of one mode")
def test_the_body_passes_verification() -> None:
    """One of the lines of the certificate compares the functions in compiled C, and some are FMUs."""
    certificate = lagdsl.compile(carried(0, CLAMPED)).verify(fmu=True)
    assert certificate.holds, certificate.lines
    assert {"engine c", "power balance"} <= {line.name for line in certificate.lines if line.verdict == "held"}


def test_the_page_draws_the_edges() -> None:
    """Four edges along the bar in parts of two elements, and those of both ends; all of them bend."""
    text = carried(0, CLAMPED).with_name("Bar.lag").read_text()
    assert text.count("draw rod") == 4 * 6 + 8


@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX is not installed")
def test_calculix_writes_matrices_that_are_read(tmp_path: Path) -> None:
    shutil.copy(FILES / "block.inp", tmp_path / "block.inp")
    subprocess.run(["ccx", "block"], cwd=tmp_path, capture_output=True, check=True, timeout=60)
    texts = [
        lagdsl.import_body(folder / "block.inp", ["LEFT", "EDGE"], length_unit="mm", modes=1)
        for folder in (tmp_path, FILES)
    ]
    assert texts[0].split("\nmodel ")[1] == texts[1].split("\nmodel ")[1]
