"""Makes the straight-line `_unpack`, `_pack`, `_read` and `_write` of a class from its layout, when first called.

The source is compiled into the class that declares the layout, so classes derived from it have it, too. Tracebacks show
it, because it is registered in `linecache`. If two threads generate it at the same time, both results are equal and
either one is kept.
"""

from __future__ import annotations

import linecache
from typing import Any, Literal

from jauspy.codec.codegen import Namespace
from jauspy.codec.codegen_decode import read_source, unpack_source
from jauspy.codec.codegen_encode import pack_source, write_source
from jauspy.codec.items import Choice, Formatted
from jauspy.codec.layout import Composite
from jauspy.codec.message import Message, Reject, Struct


def install(cls: type[Struct], method: Literal["_unpack", "_pack", "_read", "_write"]) -> None:
    """Add this method to the class, or to the base class that declares its layout."""
    owner = next(base for base in cls.__mro__ if issubclass(base, Struct) and "_layout" in base.__dict__)
    layout, namespace = owner.layout(), Namespace()
    match method, layout:
        case "_unpack", Composite() if issubclass(owner, Message):
            lines = unpack_source(layout, owner.CODE, namespace)
        case "_pack", Composite() if issubclass(owner, Message):
            lines = pack_source(layout, owner.CODE, namespace)
        case "_read", Composite() | Choice() | Formatted():
            lines = read_source(layout, namespace)
        case "_write", Composite() | Choice() | Formatted():
            lines = write_source(layout, namespace)
        case _:
            raise Reject
    _add(owner, method, "\n".join(lines) + "\n", namespace)


def _add(owner: type[Struct], name: str, source: str, namespace: Namespace) -> None:
    file = f"<{owner.__module__}.{owner.__qualname__}.{name}>"
    linecache.cache[file] = (len(source), None, source.splitlines(keepends=True), file)
    exec(compile(source, file, "exec"), namespace.values)  # noqa: S102 # nosec B102 # numbers and checked identifiers
    function: Any = namespace.values[name]
    function.__qualname__ = f"{owner.__qualname__}.{name}"
    setattr(owner, name, classmethod(function) if name in ("_unpack", "_read") else function)
