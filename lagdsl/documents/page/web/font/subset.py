"""Makes `math.woff2` anew: `python subset.py STIXMath-Regular.otf`, which needs fonttools and brotli.

STIX 1.1.1 (SIL Open Font License 1.1, its text is in the font) with the characters of formulas, under another name, as the license asks.
"""

from __future__ import annotations

import sys
from pathlib import Path

# Latin and Greek; letters, italic, bold, script and Fraktur ones among the mathematical alphabets; signs.
RANGES = (
    (0x20, 0x7E), (0xA0, 0xBF), (0xD7, 0xD7), (0xF7, 0xF7), (0x2C6, 0x2DC), (0x300, 0x30F), (0x391, 0x3C9), (0x3D1, 0x3F5), (0x2010, 0x2015),
    (0x2032, 0x2034), (0x20D7, 0x20DC), (0x2102, 0x2134), (0x2190, 0x2194), (0x2200, 0x2212), (0x2215, 0x2223), (0x222B, 0x222B), (0x2248, 0x2265),
    (0x22C5, 0x22C5), (0x27E8, 0x27E9), (0x1D400, 0x1D4CF), (0x1D51E, 0x1D537), (0x1D6A4, 0x1D6A5), (0x1D6E2, 0x1D755),
)  # fmt: skip
FAMILY = "lagdsl Math"


def main(source: Path) -> None:
    from fontTools import subset
    from fontTools.ttLib import TTFont

    font = TTFont(source)
    options = subset.Options(flavor="woff2", layout_features=["ssty", "dtls", "flac"], hinting=False, name_IDs=[0, 1, 2, 4, 6, 13, 14])
    maker = subset.Subsetter(options)
    maker.populate(unicodes=[code for first, last in RANGES for code in range(first, last + 1)])
    maker.subset(font)
    for each in font["name"].names:
        if each.nameID in (1, 4, 6):
            each.string = FAMILY.replace(" ", "") if each.nameID == 6 else FAMILY
    subset.save_font(font, str(Path(__file__).with_name("math.woff2")), options)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
