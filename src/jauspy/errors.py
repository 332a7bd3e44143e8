"""All errors that jauspy raises, as one tree under `JausError`.

JausError
├── SchemaError            a JSIDL file is wrong: file, line, what was expected
├── CodecError
│   ├── EncodeError        a value does not fit its field: field path, value, allowed range
│   └── DecodeError        bytes are not the message: offset, field path, reason
├── ProtocolError          a packet breaks AS5669A
├── TransportError         a socket cannot be opened or used
├── RequestError           a peer did not do what it was asked
│   ├── ResponseTimeout    it did not answer in time
│   ├── ControlRejected    it refused, took back, or never gave access control
│   ├── EventRejected      it refused a subscription
│   └── ElementRejected   it refused a change of its list
└── ConfigError            a configuration file, option or robot name is wrong
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from jauspy.printable import printable_lines

if TYPE_CHECKING:
    from jauspy.ids import JausID


class JausError(Exception):
    """Base class of all errors that jauspy raises.

    Quoted texts of peers and files contain printable characters only.
    """

    def __str__(self) -> str:
        return printable_lines(super().__str__())


class SchemaError(JausError):
    """A JSIDL definition is wrong; names the place and what was expected."""

    def __init__(self, message: str, *, file: str | Path | None = None, line: int | None = None) -> None:
        self.reason = message
        self.file = None if file is None else str(file)
        self.line = line
        where = self.file or ""
        if line is not None:
            where += f":{line}"
        super().__init__(f"{where}: {message}" if where else message)


class CodecError(JausError):
    """A message cannot be converted between values and bytes."""


class EncodeError(CodecError):
    """A value does not fit its field; names field, value and range."""

    def __init__(self, reason: str, *, path: str = "") -> None:
        self.reason = reason
        self.path = path
        super().__init__(f"{path}: {reason}" if path else reason)


class DecodeError(CodecError):
    """Bytes are not a valid message; `offset` counts from the first byte of the message id."""

    def __init__(self, reason: str, *, offset: int = 0, path: str = "") -> None:
        self.reason = reason
        self.offset = offset
        self.path = path
        super().__init__(f"byte {offset}: {path + ': ' if path else ''}{reason}")


class ProtocolError(JausError):
    """A packet or stream breaks AS5669A; `reason` is a short name that counters use."""

    def __init__(self, reason: str, detail: str = "") -> None:
        self.reason = reason
        super().__init__(f"{reason}: {detail}" if detail else reason)


class TransportError(JausError):
    """A socket cannot be opened, bound or used; the text contains what to do."""


class RequestError(JausError):
    """A peer did not do what it was asked."""


class ResponseTimeout(RequestError):
    """No answer arrived in time."""


class ControlRejected(RequestError):
    """Access control was refused, taken back or lost. `holder` has it instead, with `authority`; None if not known."""

    def __init__(self, message: str, *, holder: JausID | None = None, authority: int | None = None) -> None:
        self.holder = holder
        self.authority = authority
        super().__init__(message)


class EventRejected(RequestError):
    """A peer refused a subscription."""


class ElementRejected(RequestError):
    """A peer refused to change its list of elements."""


class ConfigError(JausError):
    """A configuration file, option or robot name is wrong; names the key and the allowed values."""
