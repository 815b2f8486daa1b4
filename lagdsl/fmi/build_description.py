"""sources/buildDescription.xml: how an importer compiles the FMU by itself (FMI 3.0, section 2.5.3).

One configuration for each platform, as the standard wants it; they differ in whether the mathematical functions are
a library of their own. There are neither definitions nor options: any compiler of C11 does.
"""

from __future__ import annotations

from collections.abc import Sequence
from xml.sax.saxutils import quoteattr

_WITH_LIBM = ("x86_64-linux", "aarch64-linux", "x86-linux", "aarch32-linux", "x86_64-darwin", "aarch64-darwin")
_WITHOUT = ("x86_64-windows", "aarch64-windows", "x86-windows")


def build_description(identifier: str, files: Sequence[str]) -> str:
    """`files` are relative to the folder of this one."""
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<fmiBuildDescription fmiVersion="3.0">']
    for platform in (*_WITH_LIBM, *_WITHOUT):
        lines += _configuration(identifier, platform, files)
    return "\n".join([*lines, "</fmiBuildDescription>", ""])


def _configuration(identifier: str, platform: str, files: Sequence[str]) -> list[str]:
    return [
        f"  <BuildConfiguration modelIdentifier={quoteattr(identifier)} platform={quoteattr(platform)}>",
        '    <SourceFileSet language="C11">',
        *(f"      <SourceFile name={quoteattr(name)}/>" for name in files),
        '      <IncludeDirectory name="."/>',
        "    </SourceFileSet>",
        *(['    <Library name="m" external="true"/>'] if platform in _WITH_LIBM else []),
        "  </BuildConfiguration>",
    ]
