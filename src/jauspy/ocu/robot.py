"""Clients of a discovered subsystem and of its components."""

from __future__ import annotations

from jauspy.arguments import check_text
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.ocu.connection import Connection
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.subsystems import ComponentInfo, NodeInfo, SubsystemInfo
from jauspy.printable import printable


class ComponentClient:
    """The client of one discovered component; `info` describes it as it was discovered."""

    def __init__(self, connection: Connection, info: ComponentInfo) -> None:
        self.info = info
        self._connection = connection

    def __repr__(self) -> str:
        return f"<{printable(self.info.name) or 'component'} {self.id}>"

    @property
    def id(self) -> JausID:
        """Its id."""
        return self.info.id

    def service(self, name: str) -> ServiceClient:
        """The client of a service by its URN, or the end of it; `ConfigError` lists what the component offers."""
        check_text(name, "a service's name")
        found = self.info.find(name)
        if found is None:
            raise ConfigError(f"{self.id} does not offer {name}; it offers {_listed(self.info)}")
        return ServiceClient(self._connection, self.id, found)


class Robot:
    """The client of a discovered subsystem; `info` describes it as it was discovered."""

    def __init__(self, connection: Connection, info: SubsystemInfo) -> None:
        self.info = info
        self._connection = connection

    def __repr__(self) -> str:
        return f"<{self.info.kind} {self.id} {self.name!r} with {len(self.components)} components>"

    @property
    def id(self) -> int:
        """The subsystem's number."""
        return self.info.id

    @property
    def name(self) -> str:
        """The name that it reports."""
        return self.info.name

    @property
    def nodes(self) -> tuple[NodeInfo, ...]:
        """Its nodes."""
        return self.info.nodes

    @property
    def components(self) -> tuple[ComponentInfo, ...]:
        """The components of all of its nodes."""
        return self.info.components

    def component(self, which: int | str | JausID) -> ComponentClient:
        """The client of a component by number (102) or by id ("101.1.102"); `ConfigError` lists the components."""
        if isinstance(which, str):
            which = JausID.parse(which)
        found = [each for each in self.components if which in (each.id, each.id.component)]
        if len(found) == 1:
            return ComponentClient(self._connection, found[0])
        if found:
            raise ConfigError(f"subsystem {self.id} has several components {which}; choose by whole id: {_ids(found)}")
        raise ConfigError(f"subsystem {self.id} has no component {which}; it has {_ids(self.components)}")

    def service(self, name: str) -> ServiceClient:
        """The client of a service by its URN, or the end of it, such as `mobility:PrimitiveDriver`.

        Raises `ConfigError`, which lists what is offered, unless exactly one component offers it.
        """
        check_text(name, "a service's name")
        offering = list(self.info.offering(name))
        if len(offering) == 1:
            return ComponentClient(self._connection, offering[0]).service(name)
        if offering:
            first = offering[0].id.component
            raise ConfigError(
                f"several components of subsystem {self.id} offer {name}: {_ids(offering)}; choose one, as in "
                f"robot.component({first}).service({name!r})"
            )
        offers = "; ".join(f"{each.id}: {_listed(each)}" for each in self.components) or "nothing"
        raise ConfigError(f"subsystem {self.id} does not offer {name}; it offers {offers}")


def _ids(components: list[ComponentInfo] | tuple[ComponentInfo, ...]) -> str:
    return ", ".join(str(each.id) for each in components) or "none"


def _listed(component: ComponentInfo) -> str:
    return ", ".join(map(str, component.services)) or "nothing"
