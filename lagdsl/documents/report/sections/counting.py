"""The lecture's count in words and numbers."""

from __future__ import annotations

from collections.abc import Callable

from lagdsl.derivation.textbook.counting import Count
from lagdsl.documents.report.boxes import EQUALS, Box, Number, Row, Sum
from lagdsl.documents.report.document import Block, Equation, Equations, Paragraph, text


def count_blocks(count: Count, letter: Callable[[str], Box]) -> list[Block]:
    """`letter` gives a letter that is not the model's."""
    blocks: list[Block] = []
    free = count.placing + count.other
    if not free and not count.in_space:
        return [Paragraph(text("There is no coordinate, and so no equation of motion."))]
    if count.in_space and count.built_in >= 0:
        blocks += _in_space(count, letter)
    else:
        blocks += _coordinates_only(count, letter)
    if not free:
        blocks.append(Paragraph(text("No coordinate is left: the time and inputs determine all positions.")))
    if count.rank > count.position_rank:
        independent = count.rank - count.position_rank
        blocks.append(
            Paragraph(
                text(
                    f"{_some(independent, 'more independent row').capitalize()} restrict{_s(independent)} the rates "
                    f"only (nonholonomic): the velocities have {_some(count.velocity_freedom, 'degree')} of freedom."
                )
            )
        )
    if count.rows > count.rank:
        spare = count.rows - count.rank
        blocks.append(
            Paragraph(text(f"{_some(spare, 'constraint row').capitalize()} of {count.rows} hold{_s(spare)} anyway."))
        )
    return blocks


def _in_space(count: Count, letter: Callable[[str], Box]) -> list[Block]:
    """d = 3N + 6B - k."""
    inertial_elements = " and ".join(
        words
        for number, words in (
            (count.particles, _some(count.particles, "particle")),
            (count.bodies, _some(count.bodies, "rigid body", "rigid bodies")),
        )
        if number
    )
    sentences = [f"{inertial_elements.capitalize()} {'has' if count.particles + count.bodies == 1 else 'have'} "]
    sentences[0] += f"{_some(count.in_space, 'coordinate')} in space."
    sentences.append(f"The choice of coordinates builds in {_some(count.built_in, 'independent restriction')}")
    sentences[-1] += f", the declared constraints add {_number(count.declared)}." if count.declared else "."
    if count.normalisations:
        sentences.append("The unit length of a quaternion makes up for its fourth coordinate and restricts nothing.")
    k = count.built_in + count.declared
    freedom = count.in_space - k
    letters: list[Box] = []
    numbers: list[Box] = []
    for name, size, number in (("N", 3, count.particles), ("B", 6, count.bodies)):
        if number:
            letters.append(Row((Number(str(size)), letter(name))))
            numbers.append(Number(f"{size}·{number}"))
    left = Sum((*(("+", box) for box in letters), ("-", letter("k"))))
    right = Sum((*(("+", box) for box in numbers), ("-", Number(str(k)))))
    equation = Equation(letter("d"), Row((left, EQUALS, right, EQUALS, Number(str(freedom)))), final=True)
    blocks: list[Block] = [Paragraph(text(" ".join(sentences))), Equations((equation,))]
    if count.other:
        verb = "moves" if count.other == 1 else "move"
        blocks.append(
            Paragraph(
                text(
                    f"Besides, {_some(count.other, 'coordinate')} {verb} no mass (a charge, a volume, or energies "
                    f"written by hand): {_some(count.freedom, 'degree')} of freedom in all."
                )
            )
        )
    return blocks


def _coordinates_only(count: Count, letter: Callable[[str], Box]) -> list[Block]:
    """d = n - c, where masses do not tell the count."""
    n = count.placing + count.other
    right = Sum((("+", Number(str(n))), ("-", Number(str(count.position_rank)))))
    why = "Energies are written by hand" if not count.in_space else "Coordinates are more than the masses need"
    words = f"{why}, so the coordinates are counted: {n}, with {_some(count.position_rank, 'independent constraint')}."
    equation = Equation(letter("d"), Row((right, EQUALS, Number(str(count.freedom)))), final=True)
    return [Paragraph(text(words)), Equations((equation,))]


_WORDS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")


def _number(number: int) -> str:
    return _WORDS[number] if number < len(_WORDS) else str(number)


def _some(number: int, noun: str, plural: str | None = None) -> str:
    return f"{_number(number)} {noun if number == 1 else plural or noun + 's'}"


def _s(number: int) -> str:
    """The verb's ending."""
    return "s" if number == 1 else ""
