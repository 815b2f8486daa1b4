"""An FMU is a zip file; ours depends on its contents only."""

from __future__ import annotations

import zipfile
from collections.abc import Mapping
from pathlib import Path

# The first that the format can tell.
_TIME = (1980, 1, 1, 0, 0, 0)
_UNIX = 3
_FILE, _PROGRAM = 0o100644, 0o100755
_LEVEL = 3  # zlib's default takes twice as long and saves six percent
_FIRST = "modelDescription.xml"
_LIBRARIES = (".so", ".dll", ".dylib")


def write_archive(path: Path, files: Mapping[str, bytes]) -> None:
    """The description first, then by name; neither times nor users are kept."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files, key=lambda name: (name != _FIRST, name)):
            entry = zipfile.ZipInfo(name, _TIME)
            entry.create_system = _UNIX
            entry.external_attr = (_PROGRAM if name.endswith(_LIBRARIES) else _FILE) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, files[name], compresslevel=_LEVEL)
