"""Sliders and their numbers keep to `min` and `max`, or say what lies outside."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from page.browser import NEEDED, Opened
from page.pages import Elements, page_of

BOUNDED = """model Bounded
  type Gear = enumeration(low, middle, high);
  parameter Mass m(max = 4 kg) = 1 kg;
  parameter Angle tilt(min = 0, max = 77 deg) = 10 deg;
  parameter Integer teeth(min = 1, max = 9) = 3;
  parameter Boolean stiff = true;
  input Force u(min = -2 N, max = 3 N) = 1 N;
  input Integer step(min = 1, max = 5) = 2;
  input Gear gear = Gear.middle;
  coordinate Length x(start = 0.5 m, min = 0, max = 1 m);
  gravity = 0;
  mass m*teeth at {x, 0};
  force {u*step*sin(tilt)*(if gear == Gear.low then 1 else 2), if stiff then 0 else u} at {x, 0};
  annotation(experiment(StopTime = 0.1));
end Bounded;
"""
ACCEPTED = [
    ("u in N", "5", "5 N is above max = 3 N; the run takes it"),
    ("u in N", "-3", "-3 N is below min = -2 N; the run takes it"),
    ("x.start in m", "1.5", "1.5 m is above max = 1 m; the run takes it"),
]
REFUSED = [
    ("m in kg", "-1", "1", "-1 kg is below min = 0 kg; the value stays 1 kg"),
    ("m in kg", "4.00000001", "1", "4.00000001 kg is above max = 4 kg; the value stays 1 kg"),
    ("m in kg", "", "1", "this is no number; the value stays 1 kg"),
    ("tilt in deg", "78", "10", "78 deg is above max = 77 deg; the value stays 10 deg"),
    ("teeth in SI units", "2.5", "3", "2.5 is no whole number below 2^53; the value stays 3"),
    ("teeth in SI units", "10", "3", "10 is above max = 9; the value stays 3"),
    ("stiff in SI units", "2", "1", "2 is above max = 1; the value stays 1"),
    ("step in SI units", "0", "2", "0 is below min = 1; the value stays 2"),
    ("gear in SI units", "4", "2", "4 is above max = 3; the value stays 2"),
]


def test_the_page_knows_the_bounds() -> None:
    head = Elements(page_of(BOUNDED)).head
    found = {item["name"]: (item["minimum"], item["maximum"]) for item in head["parameters"] + head["inputs"]}
    tilt = found.pop("tilt")
    assert tilt == (0.0, pytest.approx(1.3439035240356338))
    assert found == {
        "m": (0.0, 4.0),
        "teeth": (1.0, 9.0),
        "stiff": (0.0, 1.0),
        "u": (-2.0, 3.0),
        "step": (1.0, 5.0),
        "gear": (1.0, 3.0),
        "x.start": (0.0, 1.0),
        "der(x).start": (None, None),
    }


class TestInABrowser:
    pytestmark = NEEDED

    def test_numbers_outside_are_told(self, browser: Any, tmp_path: Path) -> None:
        path = tmp_path / "page.html"
        path.write_text(page_of(BOUNDED), encoding="utf-8")
        opened = Opened(browser, path)
        told = opened.page.locator(".fault:visible")
        for label, number, words in ACCEPTED:
            field = opened.page.get_by_label(label, exact=True)
            type_number(field, number)
            assert (field.input_value(), told.all_inner_texts()) == (number, [words])
            opened.page.get_by_role("button", name="Reset all").click()
            assert told.count() == 0
        for label, number, kept, words in REFUSED:
            field = opened.page.get_by_label(label, exact=True)
            type_number(field, number)
            assert (field.input_value(), told.all_inner_texts()) == (kept, [words])
            type_number(field, kept)
            assert told.count() == 0
        assert opened.faults == []
        opened.page.close()

    def test_bounds_themselves_are_inside(self, browser: Any, tmp_path: Path) -> None:
        """77 deg comes back from radians as a number next to it; bars end at the bounds."""
        path = tmp_path / "page.html"
        path.write_text(page_of(BOUNDED), encoding="utf-8")
        opened = Opened(browser, path)
        type_number(opened.page.get_by_label("tilt in deg", exact=True), "77")
        for name, field, most in (
            ("tilt", "tilt in deg", "77"),
            ("u", "u in N", "3"),
            ("gear", "gear in SI units", "3"),
        ):
            bar = opened.page.get_by_label(name, exact=True)
            bar.evaluate("bar => { bar.value = 1000; bar.dispatchEvent(new Event('input')); }")
            assert opened.page.get_by_label(field, exact=True).input_value() == most
        assert opened.page.locator(".fault:visible").count() == 0
        opened.page.close()


def type_number(field: Any, number: str) -> None:
    field.fill(number)
    field.dispatch_event("change")
