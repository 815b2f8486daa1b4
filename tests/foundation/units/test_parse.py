"""Unit texts, and the way out of mistakes."""

from fractions import Fraction

import pytest
from choice import together
from hypothesis import given
from hypothesis import strategies as st

from lagdsl.foundation.units.dimension import Dimension, dimension
from lagdsl.foundation.units.naming import base_text, unit_text
from lagdsl.foundation.units.parse import UnknownUnit, parse_unit
from lagdsl.foundation.units.vocabulary import UNITS


@together(
    ("text", "exponents"),
    [
        ("kg.m2", {"kg": 1, "m": 2}),
        ("m/s^2", {"m": 1, "s": -2}),
        ("m/s2", {"m": 1, "s": -2}),
        ("N.m.s/rad", {"kg": 1, "m": 2, "s": -1}),
        ("J/kg.K", {"m": 2, "s": -2, "K": -1}),
        ("J/(kg.K)", {"m": 2, "s": -2, "K": -1}),
        ("(N.m)/rad", {"kg": 1, "m": 2, "s": -2}),
        ("s-1", {"s": -1}),
        ("s^-1", {"s": -1}),
        ("1/s", {"s": -1}),
        ("/s", {"s": -1}),
        ("1", {}),
        ("", {}),
        (" m ", {"m": 1}),
        ("m^(1/2)", {"m": Fraction(1, 2)}),
        ("m12", {"m": 12}),
    ],
)
def test_dimension_of_text(text, exponents):
    assert parse_unit(text).dimension == dimension(**exponents)
    assert parse_unit(text).factor == 1.0


def test_factor_of_products():
    assert parse_unit("km/h").exact_factor == Fraction(1000, 3600)
    assert parse_unit("mm3").exact_factor == Fraction(1, 10**9)
    assert parse_unit("kN/mm").factor == 1e6
    assert parse_unit("deg/s").pi_power == 1
    assert parse_unit("N.m/deg").pi_power == -1


@together(
    ("text", "fault", "name", "suggestion"),
    [
        ("Nm", "name", "Nm", "N.m"),
        ("Nm/rad", "name", "Nm", "N.m/rad"),
        ("Nms", "name", "Nms", "N.m.s"),
        ("kgm2", "name", "kgm", "kg.m2"),
        ("Kg", "name", "Kg", "kg"),
        ("KN", "name", "KN", "kN"),
        ("PSI", "name", "PSI", "psi"),
        ("pounds", "name", "pounds", "lb"),
        ("degree", "name", "degree", "deg"),
        ("m/sec", "name", "sec", "m/s"),
        ("degs", "name", "degs", "deg"),
        ("kgms", "name", "kgms", "kg.ms"),
        ("hNmbar", "name", "hNmbar", "h.N.mbar"),
        ("foo", "name", "foo", None),
        ("slug", "name", "slug", None),
        ("m/s/s", "slash", "/", "m/s.s"),
        ("m/(s/s)", "form", "/s)", None),
        ("N*m", "form", "*m", "N.m"),
        ("N m", "form", " m", "N.m"),
        ("m**2", "form", "**2", "m^2"),
        ("m//s", "form", "/s", "m/s"),
        ("m.", "form", "", None),
        ("(m", "form", "", None),
        ("m)", "form", ")", None),
        ("m^0", "form", "^0", None),
        ("m200", "form", "200", None),
        ("km^(1/2)", "form", "^(1/2)", None),
        ("/", "form", "", None),
        ("m" * 300, "form", "m" * 300, None),
    ],
)
def test_faults(text, fault, name, suggestion):
    with pytest.raises(UnknownUnit) as caught:
        parse_unit(text)
    error = caught.value
    assert (error.fault, error.name, error.suggestion) == (fault, name, suggestion)
    assert text in str(error)
    if suggestion is not None:
        parse_unit(suggestion)
        assert suggestion in str(error)


@given(st.text(alphabet="kgmsNradJ0123456789./^()-*° ", max_size=120))
def test_any_text_is_a_unit_or_a_fault(text):
    try:
        parse_unit(text)
    except UnknownUnit as error:
        assert 0 <= error.start <= len(text)
        assert error.suggestion is None or parse_unit(error.suggestion)


_EXPONENTS = st.integers(-6, 6) | st.sampled_from([Fraction(1, 2), Fraction(-3, 2)])
_DIMENSIONS = st.lists(_EXPONENTS, min_size=7, max_size=7).map(lambda es: Dimension(tuple(Fraction(e) for e in es)))


@given(_DIMENSIONS)
def test_text_of_a_dimension_reads_back(value):
    for text in (unit_text(value), base_text(value)):
        assert parse_unit(text).dimension == value
        assert parse_unit(text).factor == 1.0


@given(
    st.lists(st.tuples(st.sampled_from(sorted(UNITS)), st.integers(1, 9)), min_size=2, max_size=5), st.integers(1, 4)
)
def test_parse_is_a_product(factors, split):
    above, below = factors[:split], factors[split:]
    text = ".".join(f"{n}{e}" for n, e in above) + ("/" + ".".join(f"{n}^{e}" for n, e in below) if below else "")
    expected = Fraction(1)
    power = dimension()
    for sign, group in ((1, above), (-1, below)):
        for name, exponent in group:
            expected *= UNITS[name].exact_factor ** (sign * exponent)
            power = power * UNITS[name].dimension ** (sign * exponent)
    unit = parse_unit(text)
    assert unit.exact_factor == pytest.approx(expected, rel=1e-30)
    assert unit.dimension == power
