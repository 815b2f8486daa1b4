"""Folders that names in a robot's file may lead to: a file of a stranger opens nothing beyond them."""

from __future__ import annotations

import os
from pathlib import Path

from lagdsl.foundation.meshes.files import package_of
from lagdsl.foundation.meshes.triangles import MeshError
from lagdsl.foundation.record import record


class OutsideError(MeshError):
    """A name leads to a folder that it may not reach; `help` names the option that would let it."""

    def __init__(self, reason: str, help: str) -> None:
        super().__init__(reason)
        self.help = help


@record()
class Reach:
    """`folder` is that of the robot's file; names in it lead to files in one of `homes`, all links followed."""

    folder: Path
    homes: tuple[Path, ...]

    def found(self, place: Path, *more: Path) -> Path:
        """The file itself, in one of the folders or of `more`; raises MeshError."""
        file = self.inside(place, *more)
        if not _is_file(file):
            raise MeshError(f"the folder `{file.parent.name}` has no such file")
        return file

    def inside(self, place: Path, *more: Path) -> Path:
        """The place itself, which may be that of no file; raises OutsideError, or MeshError for a name of no file."""
        try:
            file = place.resolve()
        except (OSError, ValueError, RuntimeError):  # a name that no file can have, a circle of links
            raise MeshError("no file can have this name") from None
        homes = (*more, *self.homes)
        if any(file.is_relative_to(home) for home in homes):
            return file
        raise OutsideError(f"it lies outside of the folder `{homes[0].name}`", self._way_out(file))

    def _way_out(self, file: Path) -> str:
        shared = Path(os.path.commonpath([self.folder, file.parent])) if file.anchor == self.folder.anchor else None
        if shared is None or shared == Path(shared.anchor):
            return f"copy it into the folder `{self.homes[0].name}`"
        here = Path.cwd()
        shown = shared.relative_to(here) if shared.is_relative_to(here) else shared
        return f"let names lead there with `--root {shown.as_posix()}` (in Python `root=`)"


def reach_of(path: Path, root: Path | None) -> Reach:
    """Folders of a robot's file: its package, which is the nearest folder around it with a package.xml; without one the
    parent of its folder, where a robot has its folders of meshes beside that of its file. `root` is one more folder."""
    folder = path.resolve().parent
    package = package_of(folder)
    if package == folder and not (folder / "package.xml").is_file():
        package = folder if folder.parent == Path(folder.anchor) else folder.parent
    return Reach(folder, (package,) if root is None else (package, root.resolve()))


def _is_file(file: Path) -> bool:
    try:
        return file.is_file()
    except (OSError, ValueError):
        return False
