"""A program whose rows are multiplied is that of the text that multiplies them."""

from __future__ import annotations

import numpy as np

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.arrange import arrange
from lagdsl.derivation.mechanics.equations import Equations, form_equations, with_row_factors
from lagdsl.derivation.mechanics.named import with_names
from lagdsl.derivation.program.passes import row_factors
from lagdsl.derivation.program.verify import verify
from lagdsl.derivation.structure.functions import ProgramFunctions
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion import pipeline

# Forces read multipliers as the text has them, so that a factor of a row stands before its multiplier, too.
TEXT = """model M
  annotation(units = "none");
  coordinate Real x(start = 1), y, h(start = 0.5), s;
  kinetic 1/2*(der(x)^2 + der(y)^2 + der(h)^2 + der(s)^2) + x*der(h)*der(s);
  constraint wire: {wire}*(y - x^2*h) = 0;
  constraint wheel: {wheel}*(der(s) - h*der(x)) = 0;
  contact floor: {floor}*(h + x*s) >= 0 with restitution = 0.5, v_stick = 0.01*{floor};
  friction pad: {{{pad}*der(x), {pad}*(der(h) + x*der(s))}} with limit = (0.1 + 0.3*x^2)/{pad};
  friction brake: der(s) with limit = 0.1 + 0.3*{floor}*multiplier(floor);
  force -0.2*{wire}*multiplier(wire) on h;
  Real pull = {wire}*multiplier(wire)*x + {wheel}*multiplier(wheel);
  output Real n = pull^2;
  when pull > 2 then
    reinit(der(x), 0.5*der(x));
  end when;
end M;
"""
FACTORS = {"wire": 2.0**40, "wheel": 0.125, "floor": 1024.0, "pad": 2.0**-20, "brake": 1.0}
ONE = dict.fromkeys(FACTORS, 1.0)
GROUPS = [group for group in Group if group not in (Group.RELEASE, Group.RELEASE_RATE)]


def formed(factors: dict[str, float]) -> Equations:
    sink = Sink()
    flat = pipeline.flatten_file(SourceFile("m.lag", TEXT.format(**factors)), sink)
    assert flat is not None, sink.diagnostics
    return form_equations(flat)


def test_multiplied_rows_are_those_of_the_text() -> None:
    """Every function, also of values that are lowered after the factors are known."""
    written, plain = formed(FACTORS), formed(ONE)
    expected = with_names(written, arrange(written))
    program = arrange(plain)
    factors = [FACTORS[slot.name.partition("[")[0]] for slot in program.layout.constraints]
    ours = with_names(with_row_factors(plain, factors), row_factors.with_row_factors(program, factors))
    verify(ours)
    layout = ours.layout
    assert [layout.row_factor(row) for row in range(len(factors))] == factors
    assert {f.name for f in ours.functions} == {f.name for f in expected.functions}
    assert {"friction", "load", "contact", "definition_tangent"} <= {f.name for f in ours.functions}
    rng = np.random.default_rng(3)
    for _ in range(3):
        given = {group: rng.uniform(0.2, 1.2, layout.size(group)) for group in GROUPS}
        for function in expected.functions:
            arguments = [given[group][0] if group is Group.TIME else given[group] for group in function.arguments]
            found, wanted = (ProgramFunctions(each).evaluate(function.name, *arguments) for each in (ours, expected))
            for block, one, two in zip(function.results, found, wanted, strict=True):
                size = float(np.max(np.abs(two), initial=1e-300))
                np.testing.assert_allclose(one, two, rtol=1e-12, atol=1e-12 * size, err_msg=function.name + block.name)
