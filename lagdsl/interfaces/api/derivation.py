"""The derivation of a model: the document of `lag derive`, and the terms of the equations with their sources."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

if TYPE_CHECKING:
    from lagdsl.derivation.textbook.provenance import Source
    from lagdsl.derivation.textbook.recipe import Recipe
    from lagdsl.derivation.textbook.small_motions.steady import Steady
    from lagdsl.derivation.textbook.small_motions.study import Equilibrium, Study

Form: TypeAlias = Literal["text", "markdown", "latex", "html", "json"]
ENDINGS: dict[str, Form] = {
    ".txt": "text",
    ".md": "markdown",
    ".tex": "latex",
    ".html": "html",
    ".htm": "html",
    ".json": "json",
}


@dataclass(frozen=True, slots=True)
class DerivedTerm:
    """A term of the equation of `coordinate`, with its sign, on the `left` or `right` side; `value` is SymPy's.

    `sources` are the statements that it comes from: `.kind`, `.name`, `.spans`.
    """

    coordinate: str
    side: Literal["left", "right"]
    value: Any
    sources: tuple[Source, ...]


class Derivation:
    """The result of `model.derive()`; `str` gives the text."""

    def __init__(self, recipe: Recipe) -> None:
        self._recipe = recipe

    def to(self, form: Form, *, units: bool = False) -> str:
        """The document in the form `text`, `markdown`, `latex`, `html` or `json`; `md`, `tex` and `txt` mean theirs.

        `units` adds those of all symbols and equations; JSON always has those of the symbols."""
        form = ENDINGS.get(f".{form}", form)
        if form == "json":
            from lagdsl.documents.report.listing import listing

            return listing(self._recipe)
        from lagdsl.documents.report.derivation import FORMATS, render

        if form not in FORMATS:
            raise ValueError(f"form must be one of {', '.join([*FORMATS, 'json'])}, not {form!r}")
        return render(self._recipe, form, units=units)

    def write(self, path: Path | str, *, units: bool = False) -> None:
        """Write the document to a .txt, .md, .tex, .html or .json file. Raises ValueError for another ending."""
        target = Path(path)
        if target.suffix not in ENDINGS:
            raise ValueError(f"the name must end with one of {', '.join(ENDINGS)}, not {target.suffix!r}")
        target.write_text(self.to(ENDINGS[target.suffix], units=units), encoding="utf-8")

    @property
    def sources(self) -> Sequence[Source]:
        """The statements that the equations come from: masses, bodies, gravity, energies, loads, constraints."""
        from lagdsl.derivation.textbook.provenance import sources

        return sources(self._recipe.flat)

    @cached_property
    def terms(self) -> Sequence[DerivedTerm]:
        """The terms of the printed equations in their order; none where the model is too large to be written out."""
        found = self._recipe.derivation
        if found is None:
            return ()
        names = [coordinate.name for coordinate in self._recipe.flat.coordinates]
        return tuple(
            DerivedTerm(names[t.equation], t.side, t.value, tuple(found.sources[i] for i in t.sources))
            for t in found.terms
        )

    def terms_of(self, line: int) -> Sequence[DerivedTerm]:
        """The terms that a line of the model text, from 1, contributes to."""
        return tuple(
            term
            for term in self.terms
            if any(span.first.line <= line <= span.last.line for source in term.sources for span in source.spans[-1:])
        )

    @cached_property
    def _study(self) -> Study | None:
        from lagdsl.derivation.textbook.small_motions.study import study

        found = self._recipe.derivation
        return None if found is None or not self._recipe.flat.coordinates else study(self._recipe.flat, found)

    @property
    def accelerations(self) -> Mapping[Any, Any]:
        """Accelerations, then multipliers of constraints, as SymPy symbols, each with what it is equal to in SymPy.

        Long solutions are left out, and all of a model that is too large to be written out."""
        return {} if self._study is None else dict(self._study.accelerations.values)

    @property
    def equilibria(self) -> Sequence[Equilibrium]:
        """Equilibria in SymPy: `.at`, `.arbitrary`, `.conditions`, `.exists`, and `.linear`, the linear equations
        about it with `.mass .damping .stiffness` and `.frequencies`, whose `.square` is that of a natural frequency;
        `.damped` has the damping ratio and the square of the damped frequency.

        Some or none where `no_equilibria_because` is not None: no short roots, constraints, events.
        """
        return () if self._study is None else self._study.equilibria

    @property
    def steady(self) -> Steady | None:
        """Steady motions in SymPy: `.rates` of ignorable coordinates are constant and free, `.places` have values `.at`
        of the other coordinates, with `.conditions` to be real. None where there are none with short roots."""
        return None if self._study is None else self._study.steady

    @property
    def no_equilibria_because(self) -> str | None:
        """The reason, in words, why `equilibria` are none or not all: not looked for, no short roots; None if they are
        all."""
        return "The model is too large to be written out." if self._study is None else self._study.not_all_because

    def __str__(self) -> str:
        return self.to("text")

    def _repr_markdown_(self) -> str:
        return self.to("markdown")
