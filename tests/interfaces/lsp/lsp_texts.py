"""Texts that editors open: those of README."""

import re
from pathlib import Path

_README = (Path(__file__).parents[3] / "README.md").read_text(encoding="utf-8")
PENDULUM, FOUR_BAR = re.findall(r"```modelica\n(model .*?)```", _README, re.DOTALL)[:2]
