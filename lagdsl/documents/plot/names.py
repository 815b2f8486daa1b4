"""Names of columns in a text: `theta, der(theta), q`, as `--show` and `show=` have them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from lagdsl.language.settings.arrays import columns_among, names_in

# Besides the columns: the energy of the rows.
ENERGY = "energy"


def columns_in(text: str, known: Collection[str]) -> list[str]:
    """The columns that `text` names, as `columns_among`. Raises ValueError for a text without a name, too."""
    found = columns_among(names_in(text), known)
    if not found:
        raise ValueError("a plot needs the name of a column, as in `theta, der(theta)`")
    return found


def panels_of(show: str | Sequence[str] | None, known: Collection[str]) -> list[list[str]]:
    """The columns of every panel: one text is one panel. Raises as `columns_in`."""
    texts: Iterable[str] = () if show is None else (show,) if isinstance(show, str) else show
    return [columns_in(text, known) for text in texts]


def paths_of(
    xy: tuple[str, str] | Sequence[tuple[str, str]] | None, known: Collection[str]
) -> list[list[tuple[str, str]]]:
    """The pairs of columns of every panel: one pair of texts is one panel, `("x1, x2", "y1, y2")` has two paths.
    Raises as `columns_in`, and ValueError for numbers of names that do not fit."""
    if xy is None:
        return []
    pairs = [xy] if len(xy) == 2 and all(isinstance(each, str) for each in xy) else xy
    found = []
    for pair in pairs:
        if len(pair) != 2 or isinstance(pair, str):
            raise ValueError("xy needs pairs of names: what goes to the right, what goes up")
        right, up = (columns_in(str(text), known) for text in pair)
        if len(right) == 1:
            right = right * len(up)
        if len(right) != len(up):
            raise ValueError(f"`{pair[0]}` against `{pair[1]}`: {len(right)} and {len(up)} columns make no pairs")
        found.append(list(zip(right, up, strict=True)))
    return found
