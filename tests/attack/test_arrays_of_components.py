"""Instances that share a class share no values: what is split over an array of components belongs to the instance whose
text says it. References are oscillators, falls and bounces by hand."""

from __future__ import annotations

from math import cos, sqrt

from attack.rows import Attack, check, rows

CELL = """Cell
  parameter Real m = 1, k = 1, s = 1; coordinate Real x(start = s);
  kinetic 1/2*m*der(x)^2; potential 1/2*k*x^2;"""
FALLING = "Falling parameter Real f = 0; coordinate Real x; kinetic 1/2*der(x)^2; force f on x;"
MASSES = {"a": (1.0, 2.0), "b": (3.0, 4.0)}
HOUSE = "House Row a(m = {1, 2}), b(m = {3, 4});"


def text(*classes: str) -> str:
    """Classes by name and items; the last one is the model."""
    named = [each.split(maxsplit=1) for each in classes]
    return "".join(f'model {name} {items} annotation(units = "none"); end {name};\n' for name, items in named)


def swung(m: float, k: float = 1.0, s: float = 1.0) -> float:
    """An oscillator after a second."""
    return s * cos(sqrt(k / m))


def split(name: str, row: str, house: str = HOUSE, factor: float = 1.0, *more: str) -> Attack:
    """Two rows of two cells with masses of their own."""
    ends = {f"{r}.cell[{i}].x": swung(factor * m) for r, ms in MASSES.items() for i, m in enumerate(ms, 1)}
    return Attack(name, text(CELL, *more, f"Row {row}", house), 1.0, ends)


def pushed(name: str, forces: dict[str, float], *classes: str) -> Attack:
    """Masses of 1, with the forces that act on them."""
    return Attack(name, text(FALLING, *classes), 2.0, {x: 2 * f for x, f in forces.items()})


ARRAYS = [
    split("masses", "parameter Real m[2]; Cell cell[2](m = m);"),
    split("products", "parameter Real m[2]; Cell cell[2](m = 2*m);", HOUSE, 2.0),
    split("sums_of_arrays", "parameter Real m[2], n[2] = 2*m; Cell cell[2](m = m + n);", HOUSE, 3.0),
    split("comprehensions", "parameter Real m[2]; Cell cell[2](m = {3*m[i] for i in 1:2});", HOUSE, 3.0),
    split("elements_in_braces", "parameter Real m[2]; Cell cell[2](m = {m[1], m[2]});"),
    split("branches", "parameter Real m[2]; parameter Boolean c = true; Cell cell[2](m = if c then m else 9*m);"),
    split("elements_by_elements", "parameter Real m[2], n[2] = {1, 1}; Cell cell[2](m = m .* n, k = m ./ m);"),
    split("protected_definitions", "parameter Real m[2]; Cell cell[2](m = n); protected parameter Real n[2] = m;"),
    split(
        "functions",
        "function f(Real a) -> Real = 2*a; parameter Real m[2]; Cell cell[2](m = {f(m[i]) for i in 1:2});",
        HOUSE,
        2.0,
    ),
    split(
        "slices",
        "parameter Real all[4]; Cell cell[2](m = all[2:3]);",
        "House Row a(all = {9, 1, 2, 9}), b(all = {9, 3, 4, 9});",
    ),
    split(
        "columns_of_a_matrix",
        "parameter Real all[2, 2]; Cell cell[2](m = all[:, 2]);",
        "House Row a(all = {{9, 1}, {9, 2}}), b(all = {{9, 3}, {9, 4}});",
    ),
    split("inherited_arrays", "extends Base; Cell cell[2](m = m);", HOUSE, 1.0, "Base parameter Real m[2];"),
    split(
        "inherited_components",
        "extends Base(m = {7, 7});",
        HOUSE,
        1.0,
        "Base parameter Real m[2]; Cell cell[2](m = m);",
    ),
]

SHAPES = [
    Attack(
        "each_beside_split",
        text(
            CELL,
            "Row parameter Real m[2], k; Cell cell[2](m = m, each k = k, each s = 2);",
            "House Row a(m = {1, 2}, k = 5), b(m = {3, 4}, k = 6);",
        ),
        1.0,
        {
            "a.cell[1].x": swung(1, 5, 2),
            "a.cell[2].x": swung(2, 5, 2),
            "b.cell[1].x": swung(3, 6, 2),
            "b.cell[2].x": swung(4, 6, 2),
        },
    ),
    Attack(
        "starts",
        text(CELL, "Row parameter Real s[2]; Cell cell[2](x(start = s));", "House Row a(s = {1, 2}), b(s = {3, -4});"),
        1.0,
        {f"{r}.cell[{i}].x": swung(1, 1, s) for r, i, s in (("a", 1, 1), ("a", 2, 2), ("b", 1, 3), ("b", 2, -4))},
    ),
    Attack(
        "different_sizes",
        text(
            CELL,
            "Row structural parameter Integer n; parameter Real m[n]; Cell cell[n](m = 2*m);",
            "House Row a(n = 1, m = {1}), b(n = 3, m = {2, 3, 4}), c(n = 2, m = {5, 6});",
        ),
        1.0,
        {
            "a.cell[1].x": swung(2),
            "b.cell[1].x": swung(4),
            "b.cell[3].x": swung(8),
            "c.cell[1].x": swung(10),
            "c.cell[2].x": swung(12),
        },
    ),
    Attack(
        "sizes_of_arrays",
        text(CELL, "Row parameter Real m[:]; Cell cell[size(m, 1)](m = m);", "House Row a(m = {1}), b(m = {2, 3, 4});"),
        1.0,
        {"a.cell[1].x": swung(1), "b.cell[1].x": swung(2), "b.cell[2].x": swung(3), "b.cell[3].x": swung(4)},
    ),
    Attack(
        "arrays_in_arrays",
        text(
            CELL,
            "Row parameter Real m[2]; Cell cell[2](m = m);",
            "House parameter Real m[3, 2]; Row row[3](m = m);",
            "Street House one(m = {{1, 2}, {3, 4}, {5, 6}}), two(m = {{7, 8}, {9, 10}, {11, 12}});",
        ),
        1.0,
        {
            f"{h}.row[{i}].cell[{j}].x": swung(b + 2 * i + j - 2)
            for h, b in (("one", 0), ("two", 6))
            for i in (1, 2, 3)
            for j in (1, 2)
        },
    ),
    Attack(
        "short_classes_of_a_size",
        text(CELL, "Row structural parameter Integer n = 1; parameter Real m[n]; Cell cell[n](m = m);")
        + "model Two = Row(n = 2); model Three = Row(n = 3);"
        + text("House Two a(m = {1, 2}), c(m = {6, 7}); Three b(m = {3, 4, 5});"),
        1.0,
        {"a.cell[2].x": swung(2), "b.cell[1].x": swung(3), "b.cell[3].x": swung(5), "c.cell[1].x": swung(6)},
    ),
    Attack(
        "short_classes_of_several",
        text(CELL)
        + "model Pair = Cell[2](m = {1, 2}); "
        + text("House Pair a, b(m = {3, 4}), c[2](k = {{5, 5}, {6, 6}});"),
        1.0,
        {
            "a[1].x": swung(1),
            "a[2].x": swung(2),
            "b[1].x": swung(3),
            "b[2].x": swung(4),
            "c[1,2].x": swung(2, 5),
            "c[2,1].x": swung(1, 6),
        },
    ),
    Attack(
        "replaced_classes_of_a_size",
        text(
            CELL,
            "Soft extends Cell(k = 0.5);",
            "Row structural parameter Integer n = 2; parameter Real m[n]; replaceable model Part = Cell;"
            " Part cell[n](m = m);",
            "House Row a(m = {1, 2}), b(n = 3, m = {3, 4, 5}, redeclare model Part = Soft(s = 2));",
        ),
        1.0,
        {
            "a.cell[1].x": swung(1),
            "a.cell[2].x": swung(2),
            "b.cell[1].x": swung(3, 0.5, 2),
            "b.cell[3].x": swung(5, 0.5, 2),
        },
    ),
    Attack(
        "one_of_an_array",
        text(
            CELL,
            "Row parameter Real m[2]; Cell cell[2](m = m);",
            "House Row a(m = {1, 2}, cell[2](m = 9)), b(m = {3, 4});",
        ),
        1.0,
        {"a.cell[1].x": swung(1), "a.cell[2].x": swung(9), "b.cell[1].x": swung(3), "b.cell[2].x": swung(4)},
    ),
    Attack(
        "components_that_are_not_there",
        text(
            CELL,
            "Row structural parameter Boolean here = true; parameter Real m[2]; Cell cell[2](m = m) if here;"
            " Cell last(m = sum(m));",
            "House Row a(m = {1, 2}, here = false), b(m = {3, 4});",
        ),
        1.0,
        {"a.last.x": swung(3), "b.cell[1].x": swung(3), "b.cell[2].x": swung(4), "b.last.x": swung(7)},
    ),
    Attack(
        "values_of_a_run",
        text(CELL, "Row parameter Real m[2]; Cell cell[2](m = 2*m);", HOUSE),
        1.0,
        {"a.cell[1].x": swung(2), "a.cell[2].x": swung(10), "b.cell[1].x": swung(6), "b.cell[2].x": swung(8)},
        parameters={"a.m[2]": 5.0},
    ),
    Attack(
        "tables",
        text(
            FALLING,
            "Row parameter Real v[2, 3]; Falling part[2](f = {table(1, {0, 1, 2}, v[i, :]) for i in 1:2});",
            "House Row a(v = {{9, 1, 9}, {9, 2, 9}}), b(v = {{9, 3, 9}, {9, 4, 9}});",
        ),
        2.0,
        {"a.part[1].x": 2.0, "a.part[2].x": 4.0, "b.part[1].x": 6.0, "b.part[2].x": 8.0},
    ),
]

PARTS = [
    # springs hang from points of their own: 1/2 v^2 of a mass on each
    Attack(
        "points",
        text(
            "Spring point a; parameter Real k; coordinate Real x(start = 1); Real y = x - a.x; kinetic 1/2*der(x)^2;"
            " potential 1/2*k*y^2;",
            "Leg point feet[2]; parameter Real k[2]; Spring spring[2](a = feet, k = k);",
            "House Leg left(feet = {{0, 0}, {1, 0}}, k = {1, 2}), right(feet = {{3, 0}, {4, 0}}, k = {3, 4});",
        ),
        1.0,
        {
            f"{leg}.spring[{i}].x": foot + (1 - foot) * cos(sqrt(k))
            for leg, i, foot, k in (("left", 1, 0, 1), ("left", 2, 1, 2), ("right", 1, 3, 3), ("right", 2, 4, 4))
        },
    ),
    # along the x-axis of a frame that is turned to the plumb line or away from it
    Attack(
        "frames",
        text(
            "Slide frame at; coordinate Real x; mass 1 at at.point({x, 0, 0});",
            "Row frame ways[2]; Slide slide[2](at = {ways[1], ways[2]});",
            "House Row a(ways = {world, world.rotz(pi/2)}), b(ways = {world.rotz(-pi/2), world.rotz(pi/6)});"
            " gravity = {0, -1, 0};",
        ),
        1.0,
        {"a.slide[1].x": 0.0, "a.slide[2].x": -0.5, "b.slide[1].x": 0.5, "b.slide[2].x": -0.25},
    ),
    pushed(
        "inputs",
        {"a.part[1].x": 1, "a.part[2].x": 2, "b.part[1].x": 3, "b.part[2].x": 8},
        "Driven input Real u; coordinate Real x; kinetic 1/2*der(x)^2; force u on x;",
        "Row input Real u[2]; Driven part[2](u = u);",
        "House Real v = 8; Row a(u = {1, 2}), b(u = {3, v});",
    ),
    pushed(
        "discretes",
        {"a.part[1].x": 1, "a.part[2].x": 2, "b.part[1].x": 3, "b.part[2].x": 4},
        "Driven input Real u; coordinate Real x; kinetic 1/2*der(x)^2; force u on x;",
        "Row parameter Real u[2]; discrete Real f[2](each start = 0); Driven part[2](u = f);"
        " equation when initial() then f = u; end when;",
        "House Row a(u = {1, 2}), b(u = {3, 4});",
    ),
    pushed(
        "starts_of_discretes",
        {"a.part[1].x": 1, "a.part[2].x": 2, "b.part[1].x": 3, "b.part[2].x": 4},
        "Driven coordinate Real x; discrete Real f(start = 0); kinetic 1/2*der(x)^2; force f on x;"
        " equation when time > 9 then f = 7; end when;",
        "Row parameter Real u[2]; Driven part[2](f(start = u));",
        "House Row a(u = {1, 2}), b(u = {3, 4});",
    ),
    pushed(
        "records",
        {"a.part[1].x": 1, "a.part[2].x": 2, "b.part[1].x": 3, "b.part[2].x": 8},
        "Values parameter Real f = 0;",
        "Row Values v[2]; Falling part[2](f = v.f);",
        "House Row a(v(f = {1, 2})), b(v[1](f = 3), v[2](f = 8));",
    ),
    # walls of their own: bounces without loss
    Attack(
        "contacts",
        text(
            "Ball parameter Real wall = 1; coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2;"
            " contact c: x <= wall with restitution = 1;",
            "Row parameter Real wall[2]; Ball ball[2](wall = wall);",
            "House Row a(wall = {0.25, 0.5}), b(wall = {0.75, 2});",
        ),
        1.0,
        {"a.ball[1].x": -0.5, "a.ball[2].x": 0.0, "b.ball[1].x": 0.5, "b.ball[2].x": 1.0},
        counts={("b.ball[1].c", "impact"): 1, ("b.ball[2].c", "impact"): 0},
    ),
    # two masses at a rope of their own ratio: a = (1 - r f)/(1 + r^2) by forces 1 and f
    Attack(
        "constraints",
        text(
            "Pulley parameter Real r = 1; coordinate Real x, y; kinetic 1/2*der(x)^2 + 1/2*der(y)^2; force 1 on x;"
            " constraint rope: y = r*x; output Real pull = multiplier(rope);",
            "Row parameter Real r[2]; Pulley pulley[2](r = r);",
            "House Row a(r = {1, 2}), b(r = {3, 0.5});",
        ),
        1.0,
        {f"{r}.pulley[{i}].x": 0.5 / (1 + q * q) for r, i, q in (("a", 1, 1), ("a", 2, 2), ("b", 1, 3), ("b", 2, 0.5))}
        | {"b.pulley[1].pull": 3 / 10, "a.pulley[2].pull": 2 / 5},
    ),
    # clauses: each part pushes from its own time on
    Attack(
        "clauses",
        text(
            "Part parameter Real at = 1; coordinate Real x; discrete Real f(start = 0); kinetic 1/2*der(x)^2;"
            " force f on x; equation when time >= at then f = 2; end when;",
            "Row parameter Real at[2]; Part part[2](at = at);",
            "House Row a(at = {0.25, 0.5}), b(at = {0.75, 1.5});",
        ),
        1.0,
        {"a.part[1].x": 0.5625, "a.part[2].x": 0.25, "b.part[1].x": 0.0625, "b.part[2].x": 0.0},
    ),
    Attack(
        "springs_of_the_library",
        """model Leg
  import Lag.Translational.*;
  parameter Stiffness k[2];
  Fixed base[2](each s0 = 0);
  Spring spring[2](k = k);
  SlidingMass load[2](each m = 1 kg, each s(start = 1 m));
  for i in 1:2 loop connect(base[i].s, spring[i].s_a); connect(spring[i].s_b, load[i].s); end for;
end Leg;
model House Leg a(k = {1 N/m, 2 N/m}), b(k = {3 N/m, 4 N/m});
  output Length x[4] = {a.load[1].s, a.load[2].s, b.load[1].s, b.load[2].s};
end House;
""",
        1.0,
        {f"x[{i}]": cos(sqrt(i)) for i in (1, 2, 3, 4)},
    ),
]


@rows([*ARRAYS, *SHAPES, *PARTS])
def test_arrays_of_components(row: Attack, engine: str) -> None:
    check(row, engine)
