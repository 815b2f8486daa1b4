"""Makes `math.woff2` anew: `python subset.py STIXMath-Regular.otf`, which needs fonttools and brotli.

STIX 1.1.1 (SIL Open Font License 1.1, its text is in the font) with the characters of formulas, under another name, as
the license asks.
"""

from __future__ import annotations

import sys
from pathlib import Path

from fontTools import subset
from fontTools.ttLib import TTFont

LETTERS = "".join(map(chr, range(0x20, 0x7F))) + "ΓΔΘΛΞΠΣΥΦΨΩαβγδεζηθικλμνξπρστυφχψω"
SIGNS = "₀₁₂₃₄₅₆₇₈₉°±·½×˙¨…‖ℎ←→∂∇∑−√∞≈≠≤≥"
ITALIC = [chr(code) for code in (*range(0x1D434, 0x1D468), *range(0x1D6E2, 0x1D715))]
VECTORS = "𝒓𝒗𝑭𝑴𝝎𝐫𝐯𝐅𝛚𝐠"  # as lagdsl.documents.report.notation has them
FAMILY = "lagdsl Math"
# Of a letter, in thousandths: with those of the tallest bracket the rows of a formula would lie over each other, and a
# pointer on one would find the next.
ASCENT, DESCENT = 800, 220


def main(source: Path) -> None:
    font = TTFont(source)
    names = [0, 1, 2, 4, 6, 13, 14]
    options = subset.Options(flavor="woff2", layout_features=[], hinting=False, name_IDs=names)
    maker = subset.Subsetter(options)
    maker.populate(text=LETTERS + SIGNS + VECTORS + "".join(ITALIC))
    maker.subset(font)
    for each in font["name"].names:
        if each.nameID in (1, 4, 6):
            each.string = FAMILY.replace(" ", "") if each.nameID == 6 else FAMILY
    font["hhea"].ascent, font["hhea"].descent, font["hhea"].lineGap = ASCENT, -DESCENT, 0
    size = font["OS/2"]
    size.sTypoAscender, size.sTypoDescender, size.sTypoLineGap = ASCENT, -DESCENT, 0
    size.usWinAscent, size.usWinDescent = ASCENT, DESCENT
    subset.save_font(font, str(Path(__file__).with_name("math.woff2")), options)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
