"""Frequency responses that draw themselves: what `Model.bode` returns."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING

from lagdsl.motion.analysis.control import frequency_response

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class FrequencyResponse(frequency_response.FrequencyResponse):
    """`.frequencies [Hz] .response .magnitude .phase .transfer .margins`, and `.plot()`."""

    __slots__ = ()

    @classmethod
    def of(cls, found: frequency_response.FrequencyResponse) -> FrequencyResponse:
        return cls(**{field.name: getattr(found, field.name) for field in fields(found)})

    def plot(self, path: Path | str | None = None) -> Figure:
        """Magnitude and phase over the frequency, with margins; written to `path` if given. Needs the extra `plot`."""
        from lagdsl.documents.plot.bode import plot_bode

        return plot_bode(self, path)
