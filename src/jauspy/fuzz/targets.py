"""The messages that are tested: for each its generated class, and the model that the reference codec goes by."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from jauspy.codec.base import Message
from jauspy.codec.items import Composite
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.schema import model as m


@dataclass(frozen=True, slots=True)
class Target:
    """One message of one service version."""

    cls: type[Message]
    model: m.Message
    layout: Composite

    @property
    def id(self) -> bytes:
        """The two bytes every message of this kind starts with."""
        return self.cls.CODE.to_bytes(2, "little")

    @property
    def title(self) -> str:
        """Service and name, as in `core:Discovery 1.1 ReportServices`."""
        return f"{self.cls.SERVICE.removeprefix('urn:jaus:jss:')} {self.cls.VERSION} {self.cls.NAME}"


def targets(registry: Registry, schema: m.Schema, names: Iterable[str] = ()) -> tuple[Target, ...]:
    """All messages of a registry that the schema has, or those of these names; `ConfigError` for an unknown name."""
    wanted = {registry.by_name(name).NAME for name in names}
    found = []
    models = {(s.id, s.version, msg.name): msg for s in schema.services for msg in s.messages}
    for cls in registry:
        model = models.get((cls.SERVICE, cls.VERSION, cls.NAME))
        if model is not None and (not wanted or cls.NAME in wanted):
            layout = cls.layout()
            assert isinstance(layout, Composite)
            found.append(Target(cls, model, layout))
    if not found:
        raise ConfigError("there is no message to test")
    return tuple(found)
