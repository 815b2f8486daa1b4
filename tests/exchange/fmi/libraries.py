"""Headers of shared libraries: processor, imports, exports. ELF, PE and Mach-O, 64 bit."""

from __future__ import annotations

import struct
from dataclasses import dataclass


@dataclass(frozen=True)
class Library:
    machine: str
    needed: frozenset[str]  # other libraries
    exported: frozenset[str]
    imported: frozenset[str]
    versions: frozenset[str] = frozenset()  # of symbols of other libraries


def library(content: bytes) -> Library:
    if content.startswith(b"\x7fELF"):
        return _elf(content)
    if content.startswith(b"MZ"):
        return _pe(content)
    return _mach(content)


def _text(content: bytes, at: int) -> str:
    return content[at : content.index(b"\0", at)].decode()


def _elf(content: bytes) -> Library:
    (machine,) = struct.unpack_from("<H", content, 18)
    at, size, count = struct.unpack_from("<Q", content, 40)[0], *struct.unpack_from("<HH", content, 58)
    sections = [struct.unpack_from("<IIQQQQIIQQ", content, at + size * k) for k in range(count)]
    parts = {section[1]: section for section in sections}
    dynamic, symbols, needs = parts[6], parts[11], parts.get(0x6FFFFFFE)
    strings = sections[symbols[6]][4]
    needed = [
        _text(content, strings + value)
        for tag, value in struct.iter_unpack("<QQ", content[dynamic[4] : dynamic[4] + dynamic[5]])
        if tag == 1
    ]
    shown, asked = set(), set()
    for name, info, _, section, _, _ in struct.iter_unpack("<IBBHQQ", content[symbols[4] : symbols[4] + symbols[5]]):
        if name and info >> 4:
            (shown if section else asked).add(_text(content, strings + name))
    versions = set()
    entry = needs[4] if needs else 0
    while entry:
        _, number, _, first, following = struct.unpack_from("<HHIII", content, entry)
        each = entry + first
        for _ in range(number):
            _, _, _, name, more = struct.unpack_from("<IHHII", content, each)
            versions.add(_text(content, strings + name))
            each += more
        entry = entry + following if following else 0
    names = {62: "x86_64", 183: "aarch64"}
    return Library(names[machine], frozenset(needed), frozenset(shown), frozenset(asked), frozenset(versions))


def _pe(content: bytes) -> Library:
    (at,) = struct.unpack_from("<I", content, 0x3C)
    machine, sections = struct.unpack_from("<HH", content, at + 4)
    (optional,) = struct.unpack_from("<H", content, at + 20)
    head = at + 24
    table = [struct.unpack_from("<8sIIII", content, head + optional + 40 * k) for k in range(sections)]

    def place(address: int) -> int:
        _, _, start, _, raw = next(s for s in table if s[2] <= address < s[2] + max(s[1], s[3]))
        return address - start + raw

    exports, imports = (
        struct.unpack_from("<I", content, head + 112)[0],
        struct.unpack_from("<I", content, head + 120)[0],
    )
    (count,) = struct.unpack_from("<I", content, place(exports) + 24)
    (names,) = struct.unpack_from("<I", content, place(exports) + 32)
    shown = [_text(content, place(n)) for (n,) in struct.iter_unpack("<I", content[place(names) :][: 4 * count])]
    needed, asked = set(), set()
    entry = place(imports)
    while any(found := struct.unpack_from("<IIIII", content, entry)):
        needed.add(_text(content, place(found[3])))
        thunk = place(found[0] or found[4])
        while (value := struct.unpack_from("<Q", content, thunk)[0]) != 0:
            asked.add(_text(content, place(value) + 2))
            thunk += 8
        entry += 20
    return Library({0x8664: "x86_64"}[machine], frozenset(needed), frozenset(shown), frozenset(asked))


def _mach(content: bytes) -> Library:
    magic, machine = struct.unpack_from("<II", content)
    assert magic == 0xFEEDFACF, "no library that is known here"
    (count,) = struct.unpack_from("<I", content, 16)
    needed, shown, asked, at = set(), set(), set(), 32
    for _ in range(count):
        command, size = struct.unpack_from("<II", content, at)
        if command == 0xC:  # LC_LOAD_DYLIB
            needed.add(_text(content, at + struct.unpack_from("<I", content, at + 8)[0]))
        if command == 0x2:  # LC_SYMTAB
            symbols, number, strings = struct.unpack_from("<III", content, at + 8)
            for name, kind, *_ in struct.iter_unpack("<IBBHQ", content[symbols : symbols + 16 * number]):
                if kind & 0x01 and not kind & 0xE0:  # external, not for debuggers
                    (shown if kind & 0x0E else asked).add(_text(content, strings + name).removeprefix("_"))
        at += size
    names = {0x01000007: "x86_64", 0x0100000C: "aarch64"}
    return Library(names[machine], frozenset(needed), frozenset(shown), frozenset(asked))
