"""The machines that binaries are made for, and what the two standards call them."""

from __future__ import annotations

import platform
import sys

from lagdsl.foundation.record import record


@record()
class Platform:
    """`target` is what the cross compiler calls it, `tuple` what FMI 3 does, `wheel` what tags of wheels do; `suffix`
    is that of its libraries."""

    name: str
    target: str
    tuple: str
    suffix: str
    wheel: str

    @property
    def system(self) -> str:
        return self.name.split("-")[0]


# glibc of 2012 (CentOS 7): what is linked against it runs on everything newer.
_LINUX = "linux-gnu.2.17"

_ALL = (
    Platform("linux-x86_64", f"x86_64-{_LINUX}", "x86_64-linux", ".so", "manylinux_2_17_x86_64"),
    Platform("linux-aarch64", f"aarch64-{_LINUX}", "aarch64-linux", ".so", "manylinux_2_17_aarch64"),
    Platform("windows-x86_64", "x86_64-windows-gnu", "x86_64-windows", ".dll", "win_amd64"),
    Platform("macos-x86_64", "x86_64-macos.11.0", "x86_64-darwin", ".dylib", "macosx_11_0_x86_64"),
    Platform("macos-aarch64", "aarch64-macos.11.0", "aarch64-darwin", ".dylib", "macosx_11_0_arm64"),
)
_BY_NAME = {each.name: each for each in _ALL}
PLATFORMS: tuple[str, ...] = tuple(_BY_NAME)

_LIBRARY_NAMES = {"windows": "lag.dll", "macos": "liblag.dylib"}
_SYSTEMS = {"linux": "linux", "win32": "windows", "darwin": "macos"}
_PROCESSORS = {"x86_64": "x86_64", "AMD64": "x86_64", "aarch64": "aarch64", "arm64": "aarch64"}


def platform_of(name: str) -> Platform:
    """Raises ValueError where there is none of that name."""
    if name not in _BY_NAME:
        raise ValueError(f"there is no platform `{name}`; there are {', '.join(PLATFORMS)}")
    return _BY_NAME[name]


def this_machine() -> str:
    """The name of the platform that runs this; one that is not among PLATFORMS where nobody makes binaries for it."""
    system = _SYSTEMS.get(sys.platform, sys.platform)
    machine = platform.machine()
    return f"{system}-{_PROCESSORS.get(machine, machine)}"


def library_name(system: str) -> str:
    """The file name of the runtime's library on "linux", "macos", "windows" or another system."""
    return _LIBRARY_NAMES.get(system, "liblag.so")


if __name__ == "__main__":
    print(*PLATFORMS, sep="\n")
