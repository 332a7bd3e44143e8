"""JAUS ids: subsystem.node.component, with the standard's wildcards (AS5669A); and the names of services."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from jauspy.arguments import described
from jauspy.errors import ConfigError

ANY_SUBSYSTEM: Final = 0xFFFF
ANY_NODE: Final = 0xFF
ANY_COMPONENT: Final = 0xFF


@dataclass(frozen=True, slots=True, order=True)
class JausID:
    """The address of a component: subsystem 0..65535, node 0..255, component 0..255.

    65535, 255 and 255 are wildcards; a zero part means "not assigned yet".
    """

    subsystem: int
    node: int
    component: int

    def __post_init__(self) -> None:
        for name, value, top in (
            ("subsystem", self.subsystem, 0xFFFF),
            ("node", self.node, 0xFF),
            ("component", self.component, 0xFF),
        ):
            if not 0 <= value <= top:
                raise ConfigError(f"{name} {value} of a JAUS id is outside 0..{top}")

    @classmethod
    def parse(cls, text: str) -> JausID:
        """Read `"101.1.102"`; raises `ConfigError` that shows the form."""
        parts = text.split(".")
        if len(parts) != 3 or not all(part.isascii() and part.isdigit() for part in parts):
            raise ConfigError(f"{text!r} is not a JAUS id; write SUBSYSTEM.NODE.COMPONENT, as in 101.1.102")
        subsystem, node, component = map(int, parts)
        return cls(subsystem, node, component)

    @classmethod
    def of(cls, id: str | JausID) -> JausID:
        """The id, also when it is text; raises `ConfigError` as `parse`, and `TypeError` for anything else."""
        if isinstance(id, str):
            return cls.parse(id)
        if not isinstance(id, JausID):
            raise TypeError(f"a JAUS id is text, as in '101.1.102', or a JausID, not {described(id)}")
        return id

    @classmethod
    def from_int(cls, value: int) -> JausID:
        """The id of a 32-bit number, subsystem<<16 | node<<8 | component, as it is sent."""
        return cls(value >> 16 & 0xFFFF, value >> 8 & 0xFF, value & 0xFF)

    def __int__(self) -> int:
        return self.subsystem << 16 | self.node << 8 | self.component

    def __str__(self) -> str:
        return f"{self.subsystem}.{self.node}.{self.component}"

    @property
    def is_wildcard(self) -> bool:
        """True if any part is a wildcard."""
        return self.subsystem == ANY_SUBSYSTEM or self.node == ANY_NODE or self.component == ANY_COMPONENT

    def matches(self, other: JausID) -> bool:
        """True if this id addresses `other`; each part may be a wildcard."""
        return (
            self.subsystem in (other.subsystem, ANY_SUBSYSTEM)
            and self.node in (other.node, ANY_NODE)
            and self.component in (other.component, ANY_COMPONENT)
        )


EVERYONE: Final = JausID(ANY_SUBSYSTEM, ANY_NODE, ANY_COMPONENT)


def component_id(id: str | JausID) -> JausID:
    """The id of one component; raises `ConfigError` for a wildcard and for one without a number of its own."""
    parsed = JausID.of(id)
    if parsed.is_wildcard or not parsed.component:
        raise ConfigError(
            f"{parsed} cannot be a component's id; use 1..65534, 1..254 and 1..254, as in 101.1.120; subsystem and "
            "node may be 0 until they are given"
        )
    return parsed


def service_set(urn: str) -> str:
    """The set of a service or type set: the part after `jss` in a URN, as `core` in `urn:jaus:jss:core:Time`.

    URNs without `jss` have it before the last part, as `vendor` in `urn:example:vendor:Lamp`.
    """
    parts = urn.split(":")
    if "jss" in parts[:-1]:
        return parts[parts.index("jss") + 1]
    return parts[-2] if len(parts) > 1 else parts[0]


def is_called(urn: str, name: str) -> bool:
    """True for a whole URN or its end: `mobility:PrimitiveDriver`, `PrimitiveDriver`; case does not matter."""
    known, wanted = urn.casefold(), name.casefold()
    return bool(wanted) and (known == wanted or known.endswith(f":{wanted}"))


def message_id(payload: bytes, offset: int = 0) -> int:
    """Id of the message that begins at `offset`: 2 bytes, little endian (AS5669A); a shorter one counts as padded."""
    return int.from_bytes(payload[offset : offset + 2], "little")
