"""All kinds of layout items, for those who walk over layouts."""

from __future__ import annotations

from jauspy.codec.item import Item
from jauspy.codec.items_bits import Bit, Bits, Choice
from jauspy.codec.items_bytes import Blob, Count, Formatted, Text, message_to_dict
from jauspy.codec.items_numbers import ANY, Number, Real, Values, real
from jauspy.codec.layout import Composite, Grid, Repeat, Slot, Union, composite

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
    "Number",
    "Real",
    "Repeat",
    "Slot",
    "Text",
    "Union",
    "Values",
    "composite",
    "message_to_dict",
    "real",
]
