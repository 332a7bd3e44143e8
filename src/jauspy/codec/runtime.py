"""What generated message modules use, under one name."""

from __future__ import annotations

from math import isfinite
from struct import Struct as Packer
from typing import Final

from jauspy.codec.base import Message, Reject, Struct
from jauspy.codec.fast import Masks, Rows, members, message_bytes, plain_bytes
from jauspy.codec.items import (
    ANY,
    Bit,
    Bits,
    Blob,
    Choice,
    Composite,
    Count,
    Formatted,
    Grid,
    Item,
    Number,
    Real,
    Repeat,
    Slot,
    Text,
    Union,
    Values,
    composite,
    real,
)
from jauspy.codec.nesting import Nesting
from jauspy.codec.scaling import Scaling, exact_raw

__all__ = [
    "ANY",
    "Bit",
    "Bits",
    "Blob",
    "Choice",
    "Composite",
    "Count",
    "Formatted",
    "Grid",
    "Item",
    "Masks",
    "Message",
    "Nesting",
    "Number",
    "Packer",
    "Real",
    "Reject",
    "Repeat",
    "Rows",
    "Scaling",
    "Slot",
    "Struct",
    "Text",
    "Union",
    "Values",
    "composite",
    "exact_raw",
    "isfinite",
    "members",
    "message_bytes",
    "new",
    "plain_bytes",
    "real",
]

new: Final = object.__new__
"""Makes an object without calling its constructor; whoever calls it sets all attributes."""
