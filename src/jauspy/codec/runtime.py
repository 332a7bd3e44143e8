"""What generated message modules use, under one name."""

from __future__ import annotations

from jauspy.codec.base import Message, Reject, Struct
from jauspy.codec.items import ANY, Bit, Bits, Blob, Choice, Count, Formatted, Item, Number, Real, Text, Values
from jauspy.codec.layout import Composite, Grid, Repeat, Slot, Union
from jauspy.codec.scaling import Scaling

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
    "Message",
    "Number",
    "Real",
    "Reject",
    "Repeat",
    "Scaling",
    "Slot",
    "Struct",
    "Text",
    "Union",
    "Values",
]
