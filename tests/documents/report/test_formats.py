"""Rules of every format: inert text, balanced markup, one page that stands alone."""

from __future__ import annotations

import re
from collections.abc import Callable
from html.parser import HTMLParser
from xml.etree import ElementTree

import pytest
from choice import chosen
from textbook import models
from textbook.build import (
    X,
    call,
    coordinate,
    der,
    energy,
    generalized,
    less,
    mass,
    model,
    output,
    parameter,
    state,
    v,
    vec,
    when,
)

from lagdsl.derivation.textbook.recipe import recipe
from lagdsl.documents.report.boxes import (
    Bracket,
    Call,
    Cases,
    Column,
    Derivative,
    Dotted,
    Fraction,
    Matrix,
    Name,
    Number,
    Operator,
    Power,
    Root,
    Row,
    Subscript,
    Sum,
    Upright,
)
from lagdsl.documents.report.broken import lines, sign_and_rest
from lagdsl.documents.report.derivation import FORMATS, render
from lagdsl.documents.report.document import (
    Bullets,
    Code,
    Document,
    Equation,
    Equations,
    Paragraph,
    Strong,
    Table,
    Text,
    text,
)
from lagdsl.documents.report.latex_math import escape, tex
from lagdsl.documents.report.mathml import mathml
from lagdsl.documents.report.notation import name_box
from lagdsl.documents.report.unicode_math import line
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.model import FlatModel

HOSTILE = "<script>alert(1)</script> $x$ \\input{/etc/passwd} %{ [a](javascript:b) `c` | \x1b[31m _d_ \u202e ∫"


class Balance(HTMLParser):
    """Collects elements; every element but the void ones must be closed in order."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.seen: set[str] = set()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.seen.add(tag)
        assert all(not name.startswith("on") and name not in ("src", "href") for name, _ in attrs)
        if tag not in ("meta", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def hostile() -> FlatModel:
    """Names that no lexer would let through, and a text that means harm in every format."""
    names = ["<b>&x", "a$b", "\\input{x}", "__import__('os')"]
    return model(
        "<i>Evil</i> \\name_1 & $y$",
        doc=HOSTILE,
        parameters=[parameter(name, 1.5, doc=HOSTILE) for name in names],
        coordinates=[coordinate("x%"), coordinate("theta")],
        energies=[
            energy("kinetic", v(names[0]) * der(v("x%")) ** 2 + v(names[1]) * der(v("theta")) ** 2),
            energy("potential", v(names[2]) * v("x%") * v(names[3]) * v("theta")),
        ],
    )


@pytest.mark.parametrize("make", [*chosen(models.ALL, models.ALL[:3]), hostile], ids=lambda make: make.__name__)
def test_html_is_balanced_and_alone(make: Callable[[], FlatModel]) -> None:
    page = render(models.recipe_of(make), "html")
    balance = Balance()
    balance.feed(page)
    assert not balance.open
    assert not balance.seen & {"script", "img", "link", "iframe", "i", "b", "object"}
    assert "http" not in page.replace("http-equiv", "")
    for formula in re.findall(r"<math.*?</math>", page, re.DOTALL):
        ElementTree.fromstring(formula)


@pytest.mark.parametrize("make", [*chosen(models.ALL, models.ALL[:6]), hostile], ids=lambda make: make.__name__)
def test_latex_is_balanced(make: Callable[[], FlatModel]) -> None:
    source = render(models.recipe_of(make), "latex")
    bare = re.sub(r"\\[\\{}$%&#_]", "", source)
    depth = 0
    for character in bare:
        depth += {"{": 1, "}": -1}.get(character, 0)
        assert depth >= 0
    assert depth == 0
    assert bare.count("$") % 2 == 0
    environments: list[str] = []
    for kind, name in re.findall(r"\\(begin|end)\{([a-z]+\*?)\}", source):
        if kind == "begin":
            environments.append(name)
        else:
            assert environments.pop() == name
    assert not environments
    assert r"\input" not in source
    assert source.count(r"\left") == source.count(r"\right")
    assert all(ord(character) < 256 for character in source)


def test_markdown_and_text_are_inert() -> None:
    page = render(models.recipe_of(hostile), "markdown")
    assert "<script" not in page
    assert "](javascript" not in page.replace("\\]", "")
    assert "\x1b" not in page
    plain = render(models.recipe_of(hostile), "text")
    assert "\x1b" not in plain
    assert "\u202e" not in plain


def test_escape_keeps_words() -> None:
    assert escape("50 % of A & B_1") == r"50 \% of A \& B\_1"
    assert escape("θ ∫\n") == r"\ensuremath{\theta} [U+222B] "


FORMULA = Row(
    (
        Sum((("-", Name("gap")), ("+", Sum((("+", Number("1")), ("-", Name("θ"))))))),
        Operator("≤"),
        Fraction(Number("1"), Number("2")),
        Power(Bracket(Name("x")), Number("-2")),
        Power(Name("y"), Name("n")),
        Subscript(Name("m"), Upright("rod")),
        Root(Sum((("+", Name("a")), ("+", Name("b"))))),
        Dotted(Name("gap"), 2),
        Dotted(Name("ψ"), 1),
        Derivative("∂", Name("L"), Name("q")),
        Call(Upright("atan2"), (Name("y"), Name("x"))),
        Cases(Name("a"), Row((Name("x"), Operator("<"), Number("0"))), Name("b")),
        Column((Name("a"), Name("b"))),
        Matrix(((Name("a"), Name("b")), (Name("c"), Name("d")))),
        Upright("∞"),
    )
)


def test_every_box_in_every_format() -> None:
    assert line(FORMULA) == (
        "−gap + (1 − θ) ≤ ½ (x)⁻² y^n m_rod √(a + b) der(der(gap)) ψ̇ ∂L/∂q atan2(y, x) "
        "(if x < 0 then a else b) (a, b) [a, b; c, d] ∞"
    )
    assert tex(FORMULA) == (
        r"-\mathit{gap} + \left(1 - \theta\right) \le \tfrac{1}{2}\, \left(x\right)^{-2}\, y^{n}\, m_{\mathrm{rod}}\, "
        r"\sqrt{a + b}\, \ddot{\mathit{gap}}\, \dot{\psi}\, \frac{\partial L}{\partial q}\, "
        r"\operatorname{atan2}\left(y, x\right)\, "
        r"\begin{cases} a & \text{if } x < 0 \\ b & \text{otherwise} \end{cases}\, "
        r"\begin{pmatrix} a \\ b \end{pmatrix}\, \begin{bmatrix} a & b \\ c & d \end{bmatrix}\, \infty"
    )
    root = ElementTree.fromstring(mathml(FORMULA, display=True))
    tags = {element.tag for element in root.iter()}
    assert {"mfrac", "msup", "msub", "msqrt", "mover", "mtable", "mi", "mn", "mo"} <= tags


def test_every_block_in_every_format() -> None:
    blocks = (
        Paragraph((Text("words "), Strong("strong"), Code("co`de | x"))),
        Bullets((text("item"),)),
        Table(("a", "b"), ((text("1"), text("")),)),
        Equations((Equation(Name("x"), Number("1"), final=True),)),
    )
    document = Document(title="T", subtitle=None, blocks=blocks)
    for to, setter in FORMATS.items():
        page = setter(document)
        assert "words" in page, to
        assert "strong" in page, to
        assert page.endswith("\n"), to


@pytest.mark.parametrize(
    ("name", "shown"),
    [
        ("theta", "θ"),
        ("Omega", "Ω"),
        ("a1", "a₁"),
        ("m_rod", "m_rod"),
        ("q[2]", "q₂"),
        ("P[3,4]", "P_3,4"),
        ("arm.q", "q_arm"),
        ("arm.q[1]", "q_arm,1"),
        ("phi_dot2", "φ_dot2"),
        ("theta_1", "θ₁"),
        ("_", "_"),
        ("gap", "gap"),
        ("x_theta", "x_θ"),
    ],
)
def test_names(name: str, shown: str) -> None:
    assert line(name_box(name)) == shown


def test_odd_corners() -> None:
    """No parameters but a switch, a charge beside a mass, numbers that are none, logic, and a state."""
    x, z = v("x"), v("z")
    no_number = call("sqrt", X(fx.Number(float("inf")))) * x
    relations = when(X(fx.Binary("and", less(x, 1).e, less(z, 2).e)), 1, X(fx.Binary("<>", x.e, z.e)))
    flat = model(
        "Corners",
        parameters=[parameter("on", 1.0, kind="Boolean"), parameter("off", 0.0, kind="Boolean")],
        coordinates=[coordinate("x"), coordinate("charge")],
        states=[state("z", -z * v("on"))],
        masses=[mass(2, vec(x, 0))],
        energies=[
            energy("kinetic", 0.0375 * der(v("charge")) ** 2),
            energy("lagrangian", x * der(v("charge"))),
            energy("dissipation", 0.01 * der(x) ** 2),
        ],
        loads=[generalized(relations, x), generalized(1e15 * z ** (2 / 3), v("charge"))],
        outputs=[output("o", no_number), output("n", call("exp", X(fx.Number(1.0))) + call("sign", x))],
    )
    page = render(recipe(flat), "text")
    assert "Besides, one coordinate moves no mass" in page
    assert "on      true" in page
    assert "\u017c = −on z" in page
    assert "L_x = x ẋ_charge" in page
    assert "o = ∞ x" in page
    assert "if (x < 1) and (z < 2) then" in page
    bare = model("Bare", coordinates=[coordinate("x")], energies=[energy("kinetic", der(x) ** 2)])
    assert "Parameters" not in render(recipe(bare), "markdown")


def test_long_left_sides_are_broken_on_their_own() -> None:
    terms = tuple((("-" if i % 3 == 0 else "+"), Name("x" * 12 + str(i))) for i in range(12))
    parts = lines(Equation(Sum(terms), Sum(terms)), 60)  # type: ignore[arg-type]
    assert parts[0].left is None
    assert not parts[0].continued
    assert any(sign_and_rest(part.right)[0] == "-" for part in parts[1:])
    assert sign_and_rest(Row((Sum(terms[3:5]), Operator("="), Number("0"))))[0] == "-"  # type: ignore[arg-type]
    assert sign_and_rest(Name("x")) == ("+", Name("x"))


def test_long_products_are_broken_inside_their_bracket() -> None:
    """In every format: a line ends with the bracket open, the next one starts with its sign."""
    names = [Name("x" * 12 + str(i)) for i in range(6)]
    inside = Bracket(Sum(tuple(("-" if i else "+", Row((name, Name("y")))) for i, name in enumerate(names))))
    product = Row((Name("m"), inside, Name("z")))
    parts = lines(Equation(Name("T"), Sum((("-", product),))), 40)
    assert len(parts) > 2
    assert line(parts[0].right) == "−m (xxxxxxxxxxxx0 y − xxxxxxxxxxxx1 y"
    assert sign_and_rest(parts[1].right)[0] == "-"
    assert line(parts[-1].right).endswith(") z")
    assert tex(parts[0].right).endswith(r"\right.")
    assert mathml(parts[0].right).count("<mo>)</mo>") == 0
    plain = Row(tuple(names))
    assert len(lines(Equation(Name("T"), plain), 40)) == 1
