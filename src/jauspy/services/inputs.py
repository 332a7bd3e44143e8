"""What a component takes: bytes to messages of the very versions of its services, malformed ones counted."""

from __future__ import annotations

from collections.abc import Mapping

from jauspy.codec.base import Message
from jauspy.codec.registry import Registry
from jauspy.errors import DecodeError
from jauspy.ids import JausID
from jauspy.services.drops import Count


class InputDecoder:
    """Decodes by message code."""

    def __init__(self, kinds: Mapping[int, type[Message]], registry: Registry, count: Count) -> None:
        self._kinds = kinds
        self._registry = registry
        self._count = count

    def decode(self, payload: bytes, source: JausID) -> Message | None:
        """A message from the network; None, and counted, when it is not one that the component takes."""
        if source.is_wildcard:
            self._count("bad_source", str(source))
        elif len(payload) < 2:
            self._count("too_short", payload.hex())
        elif (kind := self._kinds.get(int.from_bytes(payload[:2], "little"))) is None:
            self._count("unknown_message", payload[:2].hex())
        else:
            try:
                return self._registry.decode_as(kind, payload)
            except DecodeError as error:
                return self._forgiven(kind, payload, f"from {source}: {error}")
        return None

    def read(self, content: Message | bytes) -> Message | None:
        """A message inside another one; None when it is not one that the component takes."""
        if isinstance(content, Message):
            if self._kinds.get(content.CODE) is type(content):
                return content
            content = content.encode(strict=False)
        kind = self._kinds.get(int.from_bytes(content[:2], "little"))
        try:
            return self._registry.decode_as(kind, content) if kind and len(content) >= 2 else None
        except DecodeError:
            return None

    def _forgiven(self, kind: type[Message], payload: bytes, detail: str) -> Message | None:
        """Understand values that are merely outside of their sets: an emergency is one, whatever its code."""
        message, deviations = self._registry.decode_as(kind, payload, strict=False)
        if any(deviation.lost for deviation in deviations):
            self._count(f"malformed_{kind.NAME}", detail)
            return None
        self._count(f"deviating_{kind.NAME}", detail)
        return message
