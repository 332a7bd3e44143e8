"""Source for arrays of numbers that need no conversion."""

from __future__ import annotations

import math
from itertools import accumulate

from jauspy.codec.generator_fixed import free
from jauspy.codec.generator_raw import reject_if
from jauspy.codec.plan import GridPlan, NumberPlan
from jauspy.codec.wire import FLOATS


def is_plain(grid: GridPlan) -> bool:
    """True when its numbers are any floats, or integers of which any value may stand there."""
    number = grid.item
    if not isinstance(number, NumberPlan) or number.scaling or not number.allowed.anything:
        return False
    return number.code in FLOATS or free(number)


def grid_codes(grid: GridPlan) -> list[str]:
    """The `struct` codes of all elements."""
    assert isinstance(grid.item, NumberPlan)
    return [grid.item.code] * math.prod(grid.sizes)


def finite(grid: GridPlan, raw: str) -> list[str]:
    """Lines that reject infinities and NaN, which a sum does not lose."""
    assert isinstance(grid.item, NumberPlan)
    return reject_if(f"not rt.isfinite(sum({raw}))") if grid.item.code in FLOATS else []


def grid_values(grid: GridPlan, raw: str, target: str) -> list[str]:
    """Lines that make lists in lists of the tuple `raw`."""
    widths = list(accumulate(reversed(grid.sizes[1:]), lambda width, size: width * size))
    value = f"list({raw})"
    if widths:
        value = f"list({raw}[n0:n0 + {widths[0]}])"
        whole = [*widths[1:], math.prod(grid.sizes)]
        for depth, (width, total) in enumerate(zip(widths, whole, strict=True)):
            last = depth == len(widths) - 1
            start, end = ("0", str(total)) if last else (f"n{depth + 1}", f"n{depth + 1} + {total}")
            value = f"[{value} for n{depth} in range({start}, {end}, {width})]"
    return [*finite(grid, raw), f"{target} = {value}"]
