"""Messages and their classes as users hand them in: one for the other is a mistake that is easily made."""

from __future__ import annotations

from jauspy.arguments import described
from jauspy.codec.message import Message


def check_message(value: object, use: str, example: str = "QueryStatus()") -> None:
    """Raise `TypeError` unless it is a message; `use` is what takes it, as in `query()`."""
    if isinstance(value, Message):
        return
    if isinstance(value, type) and issubclass(value, Message):
        raise TypeError(f"{use} takes a message, and {value.NAME} is only its class; write {value.NAME}(...)")
    raise TypeError(f"{use} takes a message, as in {example}, not {described(value)}")


def check_class(value: object, use: str) -> None:
    """Raise `TypeError` unless it is the class of a message, or None."""
    if value is None or (isinstance(value, type) and issubclass(value, Message)):
        return
    what = f"a message; write {value.NAME} without brackets" if isinstance(value, Message) else described(value)
    raise TypeError(f"{use} takes the class of a message, as in ReportStatus, not {what}")
