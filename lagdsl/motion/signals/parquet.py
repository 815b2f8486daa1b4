"""Parquet files whose metadata have units: `unit` of each field, and `attrs["units"]` of the data frame that pandas
reads."""

from __future__ import annotations

import json
from collections.abc import Hashable, Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas as pd

# Key of the `attrs` of a data frame in the metadata of a file, as pandas writes and reads them.
_ATTRIBUTES = "PANDAS_ATTRS"


def attributes(model: str, units: Mapping[str, str]) -> dict[Hashable | None, Any]:
    """`attrs` of a data frame with columns of these units."""
    return {"model": model, "units": dict(units)}


def require_parquet() -> None:
    """Raise ModuleNotFoundError where nothing can write Parquet."""
    if find_spec("pyarrow") is None:
        raise ModuleNotFoundError("writing Parquet needs pyarrow: pip install pyarrow")


def write_columns(columns: Mapping[str, Any], units: Mapping[str, str], model: str, path: Path) -> None:
    """Columns by name as numbers (rows,). Raises OSError."""
    import pyarrow

    _write(pyarrow.table(dict(columns)), units, model, path)


def write_frame(frame: pd.DataFrame, units: Mapping[str, str], model: str, path: Path) -> None:
    """The columns of a data frame without its index; texts have no unit. Raises OSError."""
    import pyarrow

    _write(pyarrow.Table.from_pandas(frame, preserve_index=False), units, model, path)


def _write(table: Any, units: Mapping[str, str], model: str, path: Path) -> None:
    import pyarrow
    import pyarrow.parquet

    own = {name: units[name] for name in table.column_names if name in units}
    fields = [each.with_metadata({"unit": own[each.name]}) if each.name in own else each for each in table.schema]
    metadata = {**(table.schema.metadata or {}), _ATTRIBUTES: json.dumps(attributes(model, own))}
    schema = pyarrow.schema(fields, metadata=metadata)
    pyarrow.parquet.write_table(pyarrow.Table.from_arrays(table.columns, schema=schema), path)
