"""What generated message modules use, under one name."""

from __future__ import annotations

from struct import Struct as Packer

from jauspy.codec.base import Message, Reject, Struct
from jauspy.codec.fast import Masks, message_bytes, plain_bytes
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
)
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
    "Number",
    "Packer",
    "Real",
    "Reject",
    "Repeat",
    "Scaling",
    "Slot",
    "Struct",
    "Text",
    "Union",
    "Values",
    "exact_raw",
    "message_bytes",
    "plain_bytes",
]
