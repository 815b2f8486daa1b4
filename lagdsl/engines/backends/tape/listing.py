"""The instructions on a tape, for people, tests and measurements. The bytes are trusted."""

from __future__ import annotations

from lagdsl.engines.backends.tape.instructions import CODE, FIRST_STRIDED, STRIDED, THREE_PRODUCTS, TWO_PRODUCTS
from lagdsl.engines.backends.tape.one_state import FUNCTIONS
from lagdsl.foundation.record import record

_HEAD = 24
_NAMES = {number: name for name, number in CODE.items()}
_FIRST_BINARY = CODE["MULTIPLY"]
# A place, signs, and place and stride of every operand, behind operation and number.
_STRIDED_WIDTH = {code: 3 + {TWO_PRODUCTS: 9, THREE_PRODUCTS: 13}.get(plain, 4) for plain, code in STRIDED.items()}


@record()
class Instruction:
    """`times`: how often it is done, 1 for those that move arrays; `words` are all behind the operation."""

    name: str
    times: int
    words: tuple[int, ...]


def instructions(tape: bytes, function: str) -> list[Instruction]:
    """Instructions of `function`, or of "prepare"; none where the model lacks it."""
    *_, functions, words = _sections(tape)
    entry = 2 * ("prepare", *FUNCTIONS).index(function)
    at, length = functions[entry : entry + 2]
    end, found = at + length, []
    while at < end:
        code, own = words[at], words[at + 1 : at + 4]
        width = _width(code, own)
        times = own[0] if code >= TWO_PRODUCTS else 1
        found.append(Instruction(_NAMES[code], times, tuple(words[at + 1 : at + width])))
        at += width
    return found


def _sections(tape: bytes) -> list[memoryview]:
    """As words; the first section follows on the lengths of all."""
    lengths: list[int] = []
    end = _HEAD
    while end < len(tape):
        start = _HEAD + 8 * len(lengths)
        lengths.append(int.from_bytes(tape[start : start + 8], "little"))
        end += 8 + (lengths[-1] + 7) // 8 * 8
    found, start = [], _HEAD + 8 * len(lengths)
    for length in lengths:
        found.append(memoryview(tape[start : start + length // 4 * 4]).cast("I"))
        start += (length + 7) // 8 * 8
    return found


def _width(code: int, own: memoryview) -> int:
    """Words of an instruction, of which `own` are the first ones behind the operation."""
    match _NAMES[code]:
        case "END" | "CONSTANTS":
            return 1
        case "LOAD":
            return 5
        case "STORE":
            return 4 + own[2]
        case "SCATTER":
            return 4 + 2 * own[2]
        case "SINCOS":
            return 2 + 3 * own[0]
        case _ if code >= FIRST_STRIDED:
            return _STRIDED_WIDTH[code]
        case _:
            each = {TWO_PRODUCTS: 6, THREE_PRODUCTS: 8, CODE["SELECT"]: 4}.get(code, 3 if code >= _FIRST_BINARY else 2)
            return 2 + own[0] * each
