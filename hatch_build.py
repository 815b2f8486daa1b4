"""The build hook: the C runtime as a shared library and as object files of FMUs, in wheels for one platform and in the
tree of editable installs.

`LAGDSL_PLATFORM` names a platform of `runtime/building/platforms.py`, for which ziglang compiles. Without
it the library is for this machine, by its C compiler or, where there is none, by ziglang. The objects of FMUs are
always those of ziglang, for machines among these platforms.
"""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

_ROOT = Path(__file__).resolve().parent
sys.path.insert(0, str(_ROOT))

from lagdsl.engines.runtime.building.build_library import build_library, up_to_date, wheel_tag  # noqa: E402
from lagdsl.engines.runtime.building.compiler import machine_compiler  # noqa: E402
from lagdsl.engines.runtime.building.platforms import PLATFORMS, library_name, platform_of, this_machine  # noqa: E402
from lagdsl.exchange.fmi.package.installed_objects import make_installed_objects  # noqa: E402
from lagdsl.foundation.resources import fmi_objects_folder, runtime_library_folder  # noqa: E402


class RuntimeLibraryHook(BuildHookInterface[Any]):
    """Compiles the runtime where a wheel is made."""

    PLUGIN_NAME = "custom"

    def dependencies(self) -> list[str]:
        """What the build needs beside hatchling."""
        needs_zig = self.target_name == "wheel" and (_machine() in PLATFORMS or machine_compiler() is None)
        return ["ziglang>=0.15"] if needs_zig else []

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Put the library into the package: `version` is "standard" or "editable"."""
        if self.target_name != "wheel":
            return
        name = _platform()
        build_data["pure_python"] = False
        build_data["tag"] = wheel_tag(name)
        file_name = library_name(_machine().partition("-")[0])
        if version == "editable":
            up_to_date(runtime_library_folder() / file_name)
            _make_objects(fmi_objects_folder(), [this_machine()])  # the others are compiled when they are wanted
            return
        self._made = tempfile.TemporaryDirectory(prefix="lagdsl-")
        objects = runtime_library_folder() / "objects"  # of an editable install: what is the same is not compiled again
        kept = objects if name is None and objects.is_dir() else None
        library = build_library(Path(self._made.name), name, kept)
        build_data["force_include"][str(library)] = f"lagdsl/engines/runtime/lib/{file_name}"
        own = fmi_objects_folder().is_dir()  # those of an editable install, for any platform
        for path in _make_objects(fmi_objects_folder() if own else Path(self._made.name) / "objects", PLATFORMS):
            build_data["force_include"][str(path)] = f"lagdsl/exchange/fmi/lib/{path.name}"

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        """The wheel has its copy."""
        if hasattr(self, "_made"):
            self._made.cleanup()


def _platform() -> str | None:
    return os.environ.get("LAGDSL_PLATFORM") or None


def _machine() -> str:
    return _platform() or this_machine()


def _make_objects(folder: Path, platforms: Iterable[str]) -> list[Path]:
    """For these platforms; none for a machine that is no platform of FMUs."""
    return make_installed_objects(folder, list(map(platform_of, platforms))) if _machine() in PLATFORMS else []
