"""Masses and bodies: balls, carts, bars, wheels, blocks, by mass, moments of inertia and points of the bodies."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from operator import itemgetter

import numpy as np

from lagdsl.derivation.scene.drawings import along_axes, mass_centre, on_frame, sum_of
from lagdsl.derivation.scene.looks import CLEAR, RIM, ball, wheel
from lagdsl.derivation.scene.machine import HELD, Machine, anchors_of, constant, fixed, in_axes, number
from lagdsl.derivation.scene.shapes import Numbers, Part, Shape, Size
from lagdsl.foundation.numerics.hull import hull
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.evaluate import Evaluator, Values
from lagdsl.language.flat.quantity import Spans

BALL, CART, BAR = 0.04, 0.04, 0.028
"""Parts of the machine: the radius of the ball of the largest mass, the unit of a cart, the width of a bar."""

_LEAST_SHARE = 1.0 / 64.0  # of the largest mass: a ball has at least a quarter of its radius
_BAR_INERTIA = 1.0 / 12.0
_THIN = 0.02  # of a side that a moment of inertia does not tell
_PULLEY = 0.09  # radius of a wheel without a mass
_AXES = np.eye(3)
_ARM = (Size(0.006), Size(0.006), Size(1.0))
_WHEEL = 0.25  # width over radius of a wheel, and of a body whose moments tell no width


def masses(machine: Machine) -> Iterator[Shape]:
    """A ball at each point mass to which nothing is drawn; a cart for one that slides along a line across gravity."""
    at = machine.positions[0]
    most = max((number(at, item.mass) for item in machine.flat.masses), default=1.0)
    rails: list[Floats] = []
    for k, item in enumerate(machine.flat.masses, 1):
        if machine.is_standing(item.position) or machine.is_drawn(item.spans):
            continue
        numbers = {"at": item.position}
        way = driven(machine, item.position)
        if way is not None:
            yield _cart(f"mass {k}", item.position, way, item.spans)
            yield from _rail(machine, item.position, way, rails, item.spans)
            continue
        share = fx.Binary("/", item.mass, fx.Number(most if most > 0.0 else 1.0))
        bounded = fx.Function("max", (share, fx.Number(_LEAST_SHARE)))
        size = Size(BALL, fx.Binary("^", bounded, fx.Number(1.0 / 3.0)))
        yield Shape(kind="mass", name=f"mass {k}", numbers=numbers, parts=tuple(ball(numbers, size)), spans=item.spans)


def driven(machine: Machine, point: fx.FlatExpression) -> tuple[Floats, Floats] | None:
    """The directions along and up of a point that slides along a line which is not that of gravity; nothing that
    touches a wall by a contact, which lies on it, or that only a constraint keeps on its line."""
    found = machine.straight(point)
    if found is None:
        return None
    name, move = found
    events = machine.flat.events
    told = [*(each.gap for each in events.contacts), *(slip for each in events.frictions for slip in each.slips)]
    if any(name in machine.movers_of(each) for each in told) or _is_framed(machine, point):
        return None
    along = move / np.linalg.norm(move)
    up = np.array([0.0, 0.0, 1.0]) if machine.down is None else -machine.down
    if machine.down is None and abs(along[2]) <= HELD:
        up = np.array([-along[1], along[0], 0.0])
        up = -up if up[1] < 0.0 else up
    up = up - (up @ along) * along
    size = float(np.linalg.norm(up))
    return (along, up / size) if size > HELD else None


def _is_framed(machine: Machine, point: fx.FlatExpression) -> bool:
    """Is the point the corner of something that is drawn by lines and slides with it?"""
    own = machine.places(point)
    for drawing in machine.flat.drawings:
        if drawing.place == "between":
            one, other = (machine.places(end) for end in anchors_of(drawing))
            if constant(other - one) and min(np.abs(own - each).max() for each in (one, other)) <= HELD:
                return True
    return False


def _on(point: fx.FlatExpression, way: tuple[Floats, Floats]) -> Numbers:
    """At a point, along and up."""
    return {"at": point, "x": fixed(way[0]), "z": fixed(way[1])}


def _cart(name: str, point: fx.FlatExpression, way: tuple[Floats, Floats], spans: Spans) -> Shape:
    numbers = _on(point, way)
    cart, wheels = (Part(form=form, numbers=numbers, sizes=(Size(CART),) * 3) for form in ("cart", "cart wheels"))
    parts = (cart, replace(wheels, color=RIM))
    return Shape(kind="mass", name=name, numbers={"at": point}, parts=parts, spans=spans)


def _rail(
    machine: Machine, point: fx.FlatExpression, way: tuple[Floats, Floats], known: list[Floats], spans: Spans
) -> Iterator[Shape]:
    """The hatched line that carts stand on, once for all on one line."""
    along = way[0]
    at = machine.positions[0].vector(point)
    line = np.concatenate([at - (at @ along) * along, np.outer(along, along).ravel()])
    if any(np.abs(line - other).max() <= HELD for other in known):
        return
    known.append(line)
    across = fx.Binary("-", point, fx.Binary("*", fx.Dot(point, fixed(along)), fixed(along)))
    part = Part(form="rail", numbers=_on(across, way), still=True, offset=-CART)
    yield Shape(kind="rail", name="rail", numbers={}, parts=(part,), spans=spans)


def bodies(machine: Machine) -> Iterator[Shape]:
    """A body to whose frame nothing is drawn, by its inertia and the points that are fixed in it."""
    for k, item in enumerate(machine.flat.bodies, 1):
        if machine.is_standing(fx.FrameOrigin(item.frame)) or machine.is_drawn(item.spans):
            continue
        parts = tuple(_Body(machine, item).parts())
        name, numbers = item.label or f"body {k}", on_frame(item.frame)
        yield Shape(kind="body", name=name, numbers=numbers, parts=parts, spans=item.spans)


def have_inertia(flat: fm.FlatModel) -> frozenset[Spans]:
    """The instances of classes that hold a body with moments of inertia."""
    at = Evaluator(flat, Values())
    return frozenset(body.spans[1:] for body in flat.bodies if any(number(at, each) != 0.0 for each in body.inertia))


def levers(machine: Machine, centres: Iterable[fm.Drawing]) -> Iterator[Shape]:
    """A thin arm from the frame of a body to its mass center, one of the `centres` that components draw."""
    frames = {(body.spans[1:], body.frame) for body in machine.flat.bodies}
    at = machine.positions[0]
    for drawing in centres:
        [center] = drawing.anchors
        if isinstance(center, str):
            continue
        for name in sorted(machine.frames_in(center)):
            own = fx.FrameOrigin(name)
            if (drawing.spans[1:], name) in frames and np.linalg.norm(at.vector(center) - at.vector(own)) > HELD:
                ends = {"at": own, "to": center}
                yield Shape(kind="rope", name="to the mass center", numbers=ends, spans=drawing.spans)


def radius_of(machine: Machine, body: fm.RigidBody) -> fx.FlatExpression | None:
    """Of a body that is a disc, a hoop or a ball about the origin of its frame: the parameter behind its moments."""
    at = machine.positions[0]
    if any(number(at, part) != 0.0 for part in body.com) or not number(at, body.mass) > 0.0:
        return None
    largest = max(body.inertia[:3], key=lambda each: number(at, each))
    found = machine.length_behind(largest, body.mass)
    return found[0] if found is not None and found[1] > _BAR_INERTIA * (1.0 + HELD) else None


class _Body:
    """Chooses the look of one body. `corners` are points that are fixed in it, with their components (3,) along its
    axes: `points`, its mass center and, if that is elsewhere, the origin of its frame."""

    def __init__(self, machine: Machine, item: fm.RigidBody) -> None:
        self.machine, self.item = machine, item
        at = machine.positions[0]
        self.mass = number(at, item.mass)
        self.com = np.array([number(at, part) for part in item.com])
        self.moments = np.array([number(at, part) for part in item.inertia])
        self.points = machine.fixed_points(item.frame)
        self.origin: fx.FlatExpression = fx.FrameOrigin(item.frame)
        self.center = mass_centre(item) if self.com.any() else self.origin
        self.corners = [*self.points, (self.center, self.com)]
        self.corners += [(self.origin, np.zeros(3))] if self.com.any() else []

    def parts(self) -> list[Part]:
        """A point by a ball; a body that is held away from its mass center, or at several points, by bars between them;
        any other one by its inertia."""
        if not self.moments.any():
            arm = Part(form="cylinder", numbers={"at": self.origin, "to": self.center}, sizes=_ARM)
            return [*ball({"at": self.center}, Size(BALL)), *([arm] if self.com.any() else [])]
        if self.mass <= 0.0 or not np.isfinite(self.moments).all():
            return self._wheel(Size(_PULLEY))
        planar = not self.moments[[0, 1, 3, 4, 5]].any()
        rank = _rank(np.array([each for _, each in self.corners]))
        if self.points and (rank > 1 or (rank == 1 and not planar)):
            return self._frame()
        if planar and (rank > 0 or self._is_bar()):
            return [self._bar()]
        lever = [self._beam(self.origin, self.center, 0.3 * BAR)] if self.com.any() else []
        return [*(self._disc() if planar else self._spatial()), *lever]

    # ---- pieces ------------------------------------------------------------------------------------------------------

    def _place(self, turn: Floats = _AXES) -> Numbers:
        """At the mass center, along the axes of the frame, or of those that are the columns of `turn`."""
        x, z = (in_axes(self.item.frame, turn[:, k]) for k in (0, 2))
        return {"at": self.center, "x": x, "z": z}

    def _root(self, moment: fx.FlatExpression) -> fx.FlatExpression:
        return fx.Function("sqrt", (fx.Binary("/", moment, self.item.mass),))

    def _length(self, moment: fx.FlatExpression) -> Size:
        """sqrt(moment / mass)."""
        return Size(1.0, self._root(moment), False)

    def _wheel(self, radius: Size) -> list[Part]:
        return wheel(self._place(), radius, replace(radius, factor=_WHEEL * radius.factor))

    def _beam(self, start: fx.FlatExpression, end: fx.FlatExpression, width: float = BAR) -> Part:
        return Part(form="beam", numbers={"at": start, "to": end}, sizes=(Size(width), Size(width), Size(1.0)))

    # ---- plane bodies ------------------------------------------------------------------------------------------------

    def _is_bar(self) -> bool:
        behind = self.machine.length_behind(self.item.inertia[2], self.item.mass)
        return behind is not None and abs(behind[1] - _BAR_INERTIA) <= HELD

    def _disc(self) -> list[Part]:
        """About the normal of the plane: of the radius of a parameter, if one is behind the moment."""
        radius = radius_of(self.machine, self.item)
        moment = fx.Binary("*", fx.Number(2.0), self.item.inertia[2])
        return self._wheel(Size(1.0, radius, False) if radius is not None else self._length(moment))

    def _frame(self) -> list[Part]:
        """Bars around the points of the body, seen across the plane that they lie in or near."""
        places = np.array([own for _, own in self.corners])
        axes = np.linalg.svd(places - places.mean(axis=0))[2][:2]
        rim = hull((places - places.mean(axis=0)) @ axes.T)
        ends = zip(rim, rim[1:] + rim[:1], strict=True) if len(rim) > 2 else [(rim[0], rim[-1])]
        return [self._beam(self.corners[i][0], self.corners[j][0]) for i, j in ends]

    def _bar(self) -> Part:
        """I = m l^2/12 about the mass center; one that is held at two points ends there."""
        ways = [self.com, *(place for _, place in self.points), np.array([1.0, 0.0, 0.0])]
        along = next(way / np.linalg.norm(way) for way in ways if np.linalg.norm(way) > HELD)
        half = float(np.sqrt(3.0 * self.moments[2] / self.mass))
        direction = along_axes(self.item.frame, [fx.Number(float(part)) for part in along])
        way = fx.Binary("*", self._root(fx.Binary("*", fx.Number(3.0), self.item.inertia[2])), direction)
        ends: list[fx.FlatExpression] = [fx.Binary(sign, self.center, way) for sign in "-+"]  # type: ignore[arg-type]
        # Along the bar from its middle.
        held = sorted(((float((own - self.com) @ along), point) for point, own in self.corners), key=itemgetter(0))
        outer = (held[0], held[-1]) if self.points and held[-1][0] - held[0][0] > HELD else ()
        for k, (place, point) in enumerate(outer):
            if HELD < abs(place) <= half * (1.0 + 1e-6):
                ends[k] = point
        return self._beam(ends[0], ends[1])

    # ---- bodies in space ---------------------------------------------------------------------------------------------

    def _spatial(self) -> list[Part]:
        """Three equal moments are a ball, two a cylinder about the axis of the third one, others a cuboid."""
        xx, yy, zz, xy, xz, yz = self.moments
        values, turn = np.linalg.eigh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        if not np.any([xy, xz, yz]):
            values, turn = self.moments[:3], np.eye(3)
        same = [abs(values[(k + 1) % 3] - values[(k + 2) % 3]) <= HELD * values.max() for k in range(3)]
        if all(same):
            return ball(self._place(turn), self._moment_length(turn, np.array([2.5, 0.0, 0.0])))
        if any(same):
            return self._cylinder(values, turn, same.index(True))
        # a^2 = 6 (I_b + I_c - I_a)/m; a side that the moments do not tell is thin.
        told = ((row, row @ values > HELD * values.max()) for row in 6.0 - 12.0 * np.eye(3))
        x, y, z = (self._moment_length(turn, row) if known else Size(_THIN) for row, known in told)
        own = turn if np.linalg.det(turn) > 0.0 else -turn
        return [Part(form="cube", numbers=self._place(own), sizes=(x, y, z), opacity=CLEAR)]

    def _cylinder(self, values: Floats, turn: Floats, axis: int) -> list[Part]:
        """r^2 = 2 I_axis/m and l^2 = 12 I_across/m - 3 r^2, from the moments of a homogeneous cylinder."""
        axial, across = np.eye(3)[axis], np.eye(3)[(axis + 1) % 3]
        thin = axial @ values <= HELD * (across @ values)
        radius = Size(_THIN) if thin else self._moment_length(turn, 2.0 * axial)
        square = 12.0 * across - 6.0 * axial
        flat = replace(radius, factor=_WHEEL * radius.factor)
        length = self._moment_length(turn, square) if square @ values > 0.0 else flat
        place = self._place(np.roll(turn, 2 - axis, axis=1))
        drum = Part(form="drum", numbers=place, sizes=(radius, radius, length), opacity=CLEAR)
        return [drum, replace(drum, form="marks", opacity=1.0, color="#f8fafc")]

    def _moment_length(self, turn: Floats, weights: Floats) -> Size:
        """sqrt(sum_k weights_k I_k / m) with the moments I_k about the axes that are the columns of `turn`."""
        tensor = turn @ np.diag(weights) @ turn.T
        factors = [*np.diag(tensor).tolist(), *(2.0 * tensor[[0, 0, 1], [1, 2, 2]]).tolist()]
        pairs = zip(factors, self.item.inertia, strict=True)
        return self._length(sum_of([fx.Binary("*", fx.Number(f), moment) for f, moment in pairs if abs(f) > 1e-12]))


def _rank(rows: Floats) -> int:
    found = rows - rows[0]
    return int(np.linalg.matrix_rank(found, tol=1e-9 * max(float(np.abs(found).max()), 1e-30)))
