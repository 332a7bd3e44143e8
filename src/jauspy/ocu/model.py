"""What discovery finds, as frozen values: subsystems, their nodes, components and services."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from jauspy.ids import JausID, is_called
from jauspy.messages.core import ReportIdentification


@dataclass(frozen=True, slots=True, order=True)
class ServiceInfo:
    """A service that a component offers: its URN, and the version as `"1.1"`."""

    urn: str
    version: str

    def is_called(self, name: str) -> bool:
        """True for the whole URN or its end: `mobility:PrimitiveDriver`, `PrimitiveDriver`; case does not matter."""
        return is_called(self.urn, name)

    @property
    def short(self) -> str:
        """The URN without what all of the standard's have in common."""
        return self.urn.removeprefix("urn:jaus:jss:")

    def __str__(self) -> str:
        return f"{self.short} {self.version}"


@dataclass(frozen=True, slots=True)
class ComponentInfo:
    """A component; `name` and `type` as it reports them, empty and 0 when it did not."""

    id: JausID
    name: str = ""
    type: int = 0
    services: tuple[ServiceInfo, ...] = ()

    @property
    def kind(self) -> str:
        """The type in words."""
        return kind_of(self.type)

    def find(self, name: str) -> ServiceInfo | None:
        """The service of this name, newest version first; None when it is not offered."""
        return max((each for each in self.services if each.is_called(name)), default=None)


@dataclass(frozen=True, slots=True)
class NodeInfo:
    """A node (a computer) of a subsystem."""

    id: int
    name: str = ""
    type: int = 0
    components: tuple[ComponentInfo, ...] = ()


@dataclass(frozen=True, slots=True)
class SubsystemInfo:
    """A robot, an operator control unit or another unit that can work alone."""

    id: int
    name: str = ""
    type: int = 0
    nodes: tuple[NodeInfo, ...] = ()

    @property
    def kind(self) -> str:
        """The type in words."""
        return kind_of(self.type)

    @property
    def components(self) -> tuple[ComponentInfo, ...]:
        """The components of all nodes, in the order of their ids."""
        return tuple(each for node in self.nodes for each in node.components)

    def offering(self, name: str) -> Iterator[ComponentInfo]:
        """The components with a service of this name."""
        return (each for each in self.components if each.find(name))


def kind_of(type: int) -> str:
    """What a type number of ReportIdentification means; numbers between the named ones are kinds of the lower one."""
    if type <= 0:
        return "unknown"
    named = max((each for each in ReportIdentification.Type if each <= type), default=None)
    if not named:
        return f"type {type}"
    return "OCU" if named is ReportIdentification.Type.OCU else named.name.lower().replace("_", " ")
