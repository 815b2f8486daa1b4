"""sources/buildDescription.xml: how an importer compiles the FMU by itself (FMI 3.0, section 2.5.1).

There are neither definitions nor options: any compiler of C11 does. On some platforms the mathematical functions are
a library of their own; the configuration without a platform is for all others.
"""

from __future__ import annotations

from collections.abc import Sequence
from xml.sax.saxutils import quoteattr

_WITH_LIBM = ("x86_64-linux", "aarch64-linux", "x86_64-darwin", "aarch64-darwin")


def build_description(identifier: str, files: Sequence[str]) -> str:
    """`files` are relative to the folder of this one."""
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<fmiBuildDescription fmiVersion="3.0">']
    for platform in (*_WITH_LIBM, None):
        lines += _configuration(identifier, platform, files)
    return "\n".join([*lines, "</fmiBuildDescription>", ""])


def _configuration(identifier: str, platform: str | None, files: Sequence[str]) -> list[str]:
    where = "" if platform is None else f" platform={quoteattr(platform)}"
    return [
        f"  <BuildConfiguration modelIdentifier={quoteattr(identifier)}{where}>",
        '    <SourceFileSet language="C11">',
        *(f"      <SourceFile name={quoteattr(name)}/>" for name in files),
        '      <IncludeDirectory name="."/>',
        "    </SourceFileSet>",
        *(['    <Library name="m" external="true"/>'] if platform is not None else []),
        "  </BuildConfiguration>",
    ]
