"""The C text of rolled code: a function per kernel, tables of what differs, and the calls."""

from __future__ import annotations

from collections.abc import Sequence
from typing import cast

from lagdsl.algebra.graph.operation import Op
from lagdsl.engines.backends.c.column import Index, Tables
from lagdsl.engines.backends.c.dialect import SCRATCH, Dialect
from lagdsl.engines.backends.c.literal import number
from lagdsl.engines.backends.c.reroll import Kernel, Rolled, columns, laps
from lagdsl.engines.backends.c.statement import Gather
from lagdsl.engines.backends.c.straight import gathering
from lagdsl.engines.backends.expression import fused_arguments

_INFIX = {Op.ADD: "+", Op.SUBTRACT: "-", Op.MULTIPLY: "*", Op.DIVIDE: "/"}
# More calls than these are made in a loop over a table of them.
_MOST_CALLS = 24
_ENTRIES_PER_LINE = 24


class KernelText:
    """Body of one kernel; `tables` are filled while it is written."""

    def __init__(self, rolled: Rolled, kernel: Kernel, dialect: Dialect) -> None:
        self._rolled = rolled
        self._kernel = kernel
        self._dialect = dialect
        self._used: dict[str, str | None] = {}
        self._pointers: dict[tuple[str, str, str], tuple[str, int]] = {}
        self._pointing: list[str] = []
        self.tables = Tables()
        lines = [line for index in range(len(kernel.body)) for line in self._statement(index)]
        self.lines = self._framed(lines)

    def _framed(self, lines: list[str]) -> list[str]:
        declarations = [line for line in self._used.values() if line is not None]
        lines = [*self._pointing, *lines]
        if all(run.count == 1 for run in self._kernel.runs):
            row = [f"const int *const row = head + {len(self.tables.head)};"] if self.tables.rows else []
            return [*declarations, *row, *lines]
        advance = "".join(
            f", {name} += {len(entries)}"
            for name, entries in (("row", self.tables.rows), ("value", self.tables.values))
            if entries
        )
        row = [f"const int *row = head + {len(self.tables.head)};"] if self.tables.rows else []
        loop = f"for (ptrdiff_t lap = 0; lap < laps; ++lap{advance}) {{"
        return [*declarations, *row, loop, *(f"    {line}" for line in lines), "}"]

    def _statement(self, index: int) -> list[str]:
        parts = self._rolled.shapes.parts[self._kernel.body[index]]
        leaves = _Counter()
        if parts[0] == "gather":
            return [gathering(cast(Gather, parts[1]), self._dialect)]
        if parts[0] == "store":
            text = self._expression(index, cast(int, parts[2]), leaves)
            target = self._entry(cast(str, parts[1]), self._place(index, leaves.next()), "")
            return [f"{target} = {text};"]
        text = self._expression(index, self._kernel.body[index], leaves)
        lines = [f"const {self._dialect.real} v{index} = {text};"]
        if index in self._kernel.exports:
            own = [[self._rolled.slot[at] for at in laps(run, index)] for run in self._kernel.runs]
            lines.append(f"{self._scratch(self.tables.index(own))} = v{index};")
        return lines

    def _expression(self, index: int, shape: int, leaves: _Counter) -> str:
        kind, *rest = self._rolled.shapes.parts[shape]
        if kind == "variable":
            leaf = leaves.next()
            local = self._kernel.local[index][leaf]
            return f"v{local}" if local >= 0 else self._scratch(self._place(index, leaf))
        if kind == "place":
            array = cast(str, rest[0])
            declaration = self._used.setdefault(array, self._dialect.declaration(array))
            only_read = "" if declaration is None else "const "
            return self._dialect.value(array, self._entry(array, self._place(index, leaves.next()), only_read))
        if kind == "constant":
            values = cast(list[list[float]], columns(self._rolled, self._kernel, index, leaves.next()))
            found = self.tables.value(values)
            return self._dialect.literal(found) if isinstance(found, float) else self._dialect.splatted(found)
        if kind == "fused":
            op, which = cast(tuple[Op, int], rest[0])
            x, y, z = (self._expression(index, cast(int, shape), leaves) for shape in rest[1:])
            return f"{self._dialect.fused}({fused_arguments(op, which, x, y, z)})"
        op = cast(Op, kind)
        arguments = [self._expression(index, cast(int, argument), leaves) for argument in rest]
        if op is Op.NEGATE:
            return f"(-{arguments[0]})"
        if op in _INFIX:
            return f"({arguments[0]} {_INFIX[op]} {arguments[1]})"
        return f"{self._dialect.functions[op]}({', '.join(arguments)})"

    def _place(self, index: int, leaf: int) -> Index:
        return self.tables.index(cast(list[list[int]], columns(self._rolled, self._kernel, index, leaf)))

    def _scratch(self, index: Index) -> str:
        return self._entry(SCRATCH, index, "")

    def _entry(self, array: str, index: Index, only_read: str) -> str:
        """The text of an entry: what moves alike from lap to lap is found from one pointer, at constant distances."""
        if not index.base and not index.slope:
            return f"{array}[{index.offset}]"
        key = (array, index.base, index.slope)
        if key not in self._pointers:
            name = f"{array}_{len(self._pointers)}"
            self._pointers[key] = (name, index.offset)
            terms = [array, *([index.base] if index.base else []), *([str(index.offset)] if index.offset else [])]
            kind = f"{only_read}{self._dialect.kind(array)}"
            self._pointing.append(f"{kind} *const {name} = {' + '.join(terms)}{index.slope};")
        name, first = self._pointers[key]
        return f"{name}[{index.offset - first}]"


class _Counter:
    """Leaves in the order of reading."""

    def __init__(self) -> None:
        self._count = 0

    def next(self) -> int:
        self._count += 1
        return self._count - 1


def rolled_code(
    rolled: Rolled, dialect: Dialect, name: str, parameters: Sequence[str], arguments: Sequence[str]
) -> tuple[str, list[str]]:
    """Definitions of tables and kernels, and the statements that call them in turn."""
    texts = [KernelText(rolled, kernel, dialect) for kernel in rolled.kernels]
    heads: list[int] = []
    values: list[float] = []
    steps: list[tuple[int, int, int, int]] = []
    for which, run in rolled.order:
        tables, count = texts[which].tables, rolled.kernels[which].runs[run].count
        steps.append((which, len(heads), len(values), count))
        heads += [column[run] for column in tables.head]
        for lap in range(count):
            heads += [column[run][lap] for column in tables.rows]
            values += [column[run][lap] for column in tables.values]
    definitions = [
        _table("int", f"{name}_head", [str(x) for x in heads]),
        _table("double", f"{name}_value", [number(x) for x in values]),
        *(_function(f"{name}_{which}", dialect, parameters, arguments, text) for which, text in enumerate(texts)),
    ]
    calls = [_call(name, which, arguments, f"{head}", f"{value}", f"{count}") for which, head, value, count in steps]
    if len(steps) > _MOST_CALLS:
        rows = [f"{{{which}, {count}, {head}, {value}}}" for which, head, value, count in steps]
        definitions.append(_table("lag_step", f"{name}_step", rows))
        definitions.append(_pointers(name, dialect, parameters, len(texts)))
        rest = f"{name}_head + step->head, {name}_value + step->value, step->laps"
        calls = [
            f"for (size_t i = 0; i < {len(steps)}; ++i) {{",
            f"    const lag_step *const step = {name}_step + i;",
            f"    {name}_kernel[step->kernel]({', '.join(arguments)}, {SCRATCH}, {rest});",
            "}",
        ]
    return "".join(definitions), calls


def _pointers(name: str, dialect: Dialect, parameters: Sequence[str], kernels: int) -> str:
    """The table of kernels by number."""
    kinds = ", ".join([*parameters, *_tables(dialect)])
    entries = ", ".join(f"{name}_{which}" for which in range(kernels))
    return f"static void (*const {name}_kernel[])({kinds}) = {{{entries}}};\n\n"


def _call(name: str, which: int, arguments: Sequence[str], head: str, value: str, laps: str) -> str:
    return f"{name}_{which}({', '.join(arguments)}, {SCRATCH}, {name}_head + {head}, {name}_value + {value}, {laps});"


def _function(
    name: str, dialect: Dialect, parameters: Sequence[str], arguments: Sequence[str], text: KernelText
) -> str:
    unused = [f"(void){argument};" for argument in (*arguments, SCRATCH, "head", "value", "laps")]
    lines = [f"static LAG_APART void {name}({', '.join([*parameters, *_tables(dialect)])})", "{"]
    return "\n".join([*lines, *(f"    {line}" for line in (*unused, *text.lines)), "}", "", ""])


def _tables(dialect: Dialect) -> list[str]:
    """The parameters that all kernels have."""
    return [f"{dialect.memory} *{SCRATCH}", "const int *head", "const double *value", "int laps"]


def _table(kind: str, name: str, entries: Sequence[str]) -> str:
    """Never empty: C has no empty arrays."""
    rows = entries or (["0"] if kind != "lag_step" else ["{0, 0, 0, 0}"])
    lines = [", ".join(rows[start : start + _ENTRIES_PER_LINE]) for start in range(0, len(rows), _ENTRIES_PER_LINE)]
    return f"static const {kind} {name}[] = {{\n" + "".join(f"    {line},\n" for line in lines) + "};\n\n"
