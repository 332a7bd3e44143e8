"""Every byte of a message: where it is, which field it belongs to, and what it means."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, Final

from rich.text import Text

from jauspy.capture.dissect import Content
from jauspy.codec import reference
from jauspy.codec.message import Message
from jauspy.errors import DecodeError
from jauspy.schema import model

_BYTES_SHOWN: Final = 8


def explanation(content: Content, model_of: Callable[[type[Message]], model.Message]) -> Iterator[Text]:
    """A table of the fields of a message, without rules so that it can be searched; nothing where nothing is known."""
    if content.message is None:
        return
    try:
        rows = reference.explain(model_of(type(content.message)), content.payload)
    except DecodeError as error:
        yield Text(": ".join(filter(None, ("not explained", error.path, error.reason))), style="yellow")
        return
    cells = [("offset", "bytes", "field", "raw", "value")]
    cells += [
        (
            f"{row.offset}",
            _hex(content.payload[row.offset :][: row.length]),
            row.path,
            _raw(row.raw),
            _value(row.value),
        )
        for row in rows
    ]
    widths = [max(len(line[column]) for line in cells) for column in range(4)]
    for number, (offset, data, path, raw, value) in enumerate(cells):
        yield Text.assemble(
            (f"{offset:>{widths[0]}}  ", "dim"),
            f"{data:<{widths[1]}}  ",
            (f"{path:<{widths[2]}}  ", "cyan"),
            f"{raw:>{widths[3]}}  ",
            value,
            style="" if number else "dim",
        )


def _hex(data: bytes) -> str:
    return data[:_BYTES_SHOWN].hex(" ") + (" ..." if len(data) > _BYTES_SHOWN else "")


def _raw(raw: float | bytes) -> str:
    """Numbers as they are sent; the bytes of a string have a column of their own."""
    return "" if isinstance(raw, bytes) else str(raw) if isinstance(raw, int) else f"{raw:.9g}"


def _value(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.9g}"
    if isinstance(value, list | tuple):
        return ", ".join(map(_value, value)) or "none"
    return "" if value is None else str(value)
