"""sources/buildDescription.xml: how an importer compiles the FMU by itself (FMI 3.0, section 2.5.3)."""

from __future__ import annotations

from collections.abc import Sequence
from xml.sax.saxutils import quoteattr

# With them results are those of the order of operations in the text (docs/adr/0011). Compilers that are not named do so
# without being told, on x86-64.
_COMPILERS = {"gcc": "-O2 -ffp-contract=off -fvisibility=hidden", "clang": "-O2 -ffp-contract=off -fvisibility=hidden"}
_WITH_LIBM = ("x86_64-linux", "aarch64-linux", "x86_64-darwin", "aarch64-darwin")


def build_description(identifier: str, files: Sequence[str]) -> str:
    """For any platform; libm is a library of its own on some. `files` are relative to the folder of this one."""
    platforms: list[str | None] = [None, *_WITH_LIBM]
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<fmiBuildDescription fmiVersion="3.0">']
    for platform in platforms:
        lines += _configuration(identifier, platform, files)
    return "\n".join([*lines, "</fmiBuildDescription>", ""])


def _configuration(identifier: str, platform: str | None, files: Sequence[str]) -> list[str]:
    where = "" if platform is None else f" platform={quoteattr(platform)}"
    options = "" if platform is None else f" compilerOptions={quoteattr(_COMPILERS['gcc'])}"
    return [
        f"  <BuildConfiguration modelIdentifier={quoteattr(identifier)}{where}>",
        f'    <SourceFileSet language="C11"{options}>',
        *(f"      <SourceFile name={quoteattr(name)}/>" for name in files),
        '      <IncludeDirectory name="."/>',
        "    </SourceFileSet>",
        *([] if platform is None else ['    <Library name="m" external="true"/>']),
        "  </BuildConfiguration>",
    ]
