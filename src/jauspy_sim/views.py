"""MuJoCo's arrays, for those who need single numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    Numbers = memoryview[float]


def view(array: NDArray[np.float64]) -> Numbers:
    """The same memory; a number is read or written three times faster than through the array."""
    return cast("Numbers", array.data)
