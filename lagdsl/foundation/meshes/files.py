"""Files of meshes: their place, and what lies in them."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

from lagdsl.foundation.meshes.collada import read_collada
from lagdsl.foundation.meshes.obj import read_obj
from lagdsl.foundation.meshes.stl import read_stl
from lagdsl.foundation.meshes.triangles import MeshError, Triangles, thinned

MOST_BYTES = 64_000_000
READERS = {".stl": read_stl, ".obj": read_obj, ".dae": read_collada}
"""By the ending of the name, in small letters."""


def place_of(name: str, folder: Path) -> Path:
    """The mesh that a text in `folder` means by a relative name; raises MeshError."""
    if not is_drawable(name):
        raise MeshError(f"files of meshes end in {', '.join(READERS)}")
    return named_in(name, folder)


def named_in(name: str, folder: Path) -> Path:
    """The file that a text in `folder` means by a relative name; raises MeshError.

    It lies in the package of the text: the nearest folder around it that has a package.xml, else its own. A name never
    leads out of it.
    """
    if Path(name).is_absolute():
        raise MeshError("its name begins at the root of the machine, not at the folder of the text")
    home = folder.resolve()
    return in_folder(home / name, package_of(home))


def is_drawable(name: str) -> bool:
    """True if files that end like this have a reader."""
    return Path(name).suffix.lower() in READERS


def in_folder(file: Path, home: Path) -> Path:
    """The file itself, which lies in `home` when all links are followed; raises MeshError."""
    try:
        file = file.resolve()
        if not file.is_relative_to(home):
            raise MeshError(f"it lies outside of the folder `{home.name}`")
        if file.is_file():
            return file
    except (OSError, ValueError, RuntimeError):  # a name that no file can have, a circle of links
        pass
    raise MeshError(f"the folder `{home.name}` has no such file")


def package_of(folder: Path) -> Path:
    """The nearest folder around `folder` that has a package.xml, else itself."""
    return next((each for each in (folder, *folder.parents) if (each / "package.xml").is_file()), folder)


def read_mesh(file: Path, most: int) -> Triangles:
    """At most so many triangles of a file; raises MeshError."""
    try:
        found = file.stat()
    except OSError as fault:
        raise MeshError(fault.strerror or "it cannot be read") from None
    return _read(file, found.st_mtime_ns, found.st_size, most)


@lru_cache(maxsize=256)
def _read(file: Path, changed: int, size: int, most: int) -> Triangles:
    """Of a file as it was then: `changed` and `size` tell its contents apart."""
    return thinned(_whole(file, changed, size), most)


@lru_cache(maxsize=8)
def _whole(file: Path, _changed: int, size: int) -> Triangles:
    if size > MOST_BYTES:
        raise MeshError(f"it has more than {MOST_BYTES // 1_000_000} MB")
    try:
        with file.open("rb") as opened:
            content = opened.read(MOST_BYTES + 1)
    except OSError as fault:
        raise MeshError(fault.strerror or "it cannot be read") from None
    try:
        return READERS[file.suffix.lower()](content)
    except (ValueError, OverflowError):
        raise MeshError("its numbers do not fit together") from None
