"""Changes to linked libraries: remove time stamps, and merge the libraries of two processors into one."""

from __future__ import annotations

import struct
from collections.abc import Sequence

_PE_AT = 0x3C  # where a DLL tells where its headers begin
_PE_MARK = b"PE\0\0"
_TIME = 8  # of the time, behind that mark

_FAT = 0xCAFEBABE
_PAGE = 14  # 16 kB, those of arm64: slices begin at a multiple of it


def without_timestamps(library: bytes) -> bytes:
    """A DLL whose header says nothing of when it was linked; any other library as it is."""
    if not library.startswith(b"MZ"):
        return library
    (at,) = struct.unpack_from("<I", library, _PE_AT)
    if library[at : at + 4] != _PE_MARK:
        return library
    return library[: at + _TIME] + bytes(4) + library[at + _TIME + 4 :]


def universal(libraries: Sequence[bytes]) -> bytes:
    """One Mach-O file with libraries for several processors: a big-endian table, then each at a page of its own."""
    head = struct.pack(">II", _FAT, len(libraries))
    place = 1 << _PAGE
    body = b""
    for library in libraries:
        processor, kind = struct.unpack_from("<II", library, 4)
        head += struct.pack(">IIIII", processor, kind, place + len(body), len(library), _PAGE)
        body += library + bytes(-len(library) % place)
    return head.ljust(place, b"\0") + body
