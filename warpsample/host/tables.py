"""Columns as a table."""

from collections.abc import Mapping
from typing import Any

import numpy as np


def to_frame(columns: Mapping[str, np.ndarray]) -> Any:
    """A pandas.DataFrame of columns, or these as a dictionary where pandas is not installed."""
    try:
        import pandas as pd
    except ModuleNotFoundError:
        return dict(columns)
    return pd.DataFrame(dict(columns))
