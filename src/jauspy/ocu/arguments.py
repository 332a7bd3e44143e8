"""What users hand in is looked at where they do: a value of a wrong type is one sentence, no surprise further down."""

from __future__ import annotations

from numbers import Integral, Real

from jauspy.codec.base import Message


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


def check_number(value: object, use: str, *, whole: bool = False, optional: bool = False) -> None:
    """Raise `TypeError` unless it is a number, or, if it is `optional`, None; those of numpy are fine."""
    if not isinstance(value, Integral if whole else Real) and not (optional and value is None):
        raise TypeError(f"{use} is {'a whole number' if whole else 'a number'}, not {described(value)}")


def check_text(value: object, use: str) -> None:
    """Raise `TypeError` unless it is text."""
    if not isinstance(value, str):
        raise TypeError(f"{use} is text, not {described(value)}")


def described(value: object) -> str:
    """A value in a sentence."""
    return "None" if value is None else f"the {type(value).__name__} {value!r}"
