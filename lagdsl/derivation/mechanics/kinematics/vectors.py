"""Geometric vectors as three nodes, world components."""

from __future__ import annotations

from typing import TypeAlias

from lagdsl.algebra.graph.graph import Graph

Vector: TypeAlias = tuple[int, int, int]
Axes: TypeAlias = tuple[Vector, Vector, Vector]
"""World components of the unit vectors x, y, z: the columns of a rotation matrix."""


def add(graph: Graph, a: Vector, b: Vector) -> Vector:
    return (graph.add(a[0], b[0]), graph.add(a[1], b[1]), graph.add(a[2], b[2]))


def subtract(graph: Graph, a: Vector, b: Vector) -> Vector:
    return (graph.subtract(a[0], b[0]), graph.subtract(a[1], b[1]), graph.subtract(a[2], b[2]))


def negate(graph: Graph, a: Vector) -> Vector:
    return (graph.negate(a[0]), graph.negate(a[1]), graph.negate(a[2]))


def scale(graph: Graph, factor: int, a: Vector) -> Vector:
    return (graph.multiply(factor, a[0]), graph.multiply(factor, a[1]), graph.multiply(factor, a[2]))


def divide(graph: Graph, a: Vector, divisor: int) -> Vector:
    return (graph.divide(a[0], divisor), graph.divide(a[1], divisor), graph.divide(a[2], divisor))


def cross(graph: Graph, a: Vector, b: Vector) -> Vector:
    def component(i: int, j: int) -> int:
        return graph.subtract(graph.multiply(a[i], b[j]), graph.multiply(a[j], b[i]))

    return (component(1, 2), component(2, 0), component(0, 1))


def to_world(graph: Graph, axes: Axes, own: Vector) -> Vector:
    """World components of a vector given in the axes of a frame."""
    x, y, z = (scale(graph, component, axis) for component, axis in zip(own, axes, strict=True))
    return add(graph, add(graph, x, y), z)


def to_own(graph: Graph, axes: Axes, world: Vector) -> Vector:
    """Components along the axes of a frame of a vector given in world components."""
    return (graph.dot(axes[0], world), graph.dot(axes[1], world), graph.dot(axes[2], world))
