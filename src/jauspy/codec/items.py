"""All kinds of layout items, for those who walk over layouts."""

from __future__ import annotations

from jauspy.codec.item import Item
from jauspy.codec.items_bits import Bit, Bits, Choice
from jauspy.codec.items_bytes import Blob, Count, Formatted, Text, message_to_dict
from jauspy.codec.items_numbers import ANY, Number, Real, Values, real

__all__ = [
    "ANY",
    "Bit",
    "Bits",
    "Blob",
    "Choice",
    "Count",
    "Formatted",
    "Item",
    "Number",
    "Real",
    "Text",
    "Values",
    "message_to_dict",
    "real",
]
