"""JAUS for Python."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from jauspy import messages as messages, ocu as ocu, sync as sync, testing as testing
    from jauspy.codec.build import load as load
    from jauspy.codec.message import Message as Message
    from jauspy.codec.registry import Registry as Registry
    from jauspy.component import Component as Component, run as run
    from jauspy.errors import (
        CodecError as CodecError,
        ConfigError as ConfigError,
        ControlRejected as ControlRejected,
        DecodeError as DecodeError,
        ElementRejected as ElementRejected,
        EncodeError as EncodeError,
        EventRejected as EventRejected,
        JausError as JausError,
        ProtocolError as ProtocolError,
        RequestError as RequestError,
        ResponseTimeout as ResponseTimeout,
        SchemaError as SchemaError,
        TransportError as TransportError,
    )
    from jauspy.ids import JausID as JausID
    from jauspy.ocu import (
        OCU as OCU,
        Robot as Robot,
        ServiceClient as ServiceClient,
        Subscription as Subscription,
    )
    from jauspy.services.service import Service as Service

__version__ = "0.1.0"

_EXPORTS = {
    "CodecError": "jauspy.errors",
    "Component": "jauspy.component.component",
    "ConfigError": "jauspy.errors",
    "ControlRejected": "jauspy.errors",
    "DecodeError": "jauspy.errors",
    "ElementRejected": "jauspy.errors",
    "EncodeError": "jauspy.errors",
    "EventRejected": "jauspy.errors",
    "JausError": "jauspy.errors",
    "JausID": "jauspy.ids",
    "load": "jauspy.codec.build",
    "Message": "jauspy.codec.message",
    "OCU": "jauspy.ocu",
    "ProtocolError": "jauspy.errors",
    "Registry": "jauspy.codec.registry",
    "RequestError": "jauspy.errors",
    "ResponseTimeout": "jauspy.errors",
    "Robot": "jauspy.ocu",
    "run": "jauspy.component.component",
    "SchemaError": "jauspy.errors",
    "Service": "jauspy.services.service",
    "ServiceClient": "jauspy.ocu",
    "Subscription": "jauspy.ocu",
    "TransportError": "jauspy.errors",
}
"""Public names and their modules; imported on first use, so that `import jauspy` is fast."""


_PACKAGES = ("messages", "ocu", "sync", "testing")
"""Packages that are imported on first use, as in `jauspy.sync.OCU`."""


def __getattr__(name: str) -> object:
    if name in _PACKAGES:
        return import_module(f"jauspy.{name}")
    if name not in _EXPORTS:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value: object = getattr(import_module(_EXPORTS[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_EXPORTS, *_PACKAGES})
