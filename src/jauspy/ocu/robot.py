"""A discovered subsystem that can be talked to."""

from __future__ import annotations

from jauspy.arguments import check_text
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.ocu.connection import Connection
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.subsystems import ComponentInfo, NodeInfo, SubsystemInfo


class ComponentClient:
    """One discovered component."""

    def __init__(self, link: Connection, info: ComponentInfo) -> None:
        self.info = info
        self._link = link

    def __repr__(self) -> str:
        return f"<{self.info.name or 'component'} {self.id}>"

    @property
    def id(self) -> JausID:
        """Its id."""
        return self.info.id

    def service(self, name: str) -> ServiceClient:
        """The service of this URN, or end of one; `ConfigError` that lists what the component offers."""
        check_text(name, "a service's name")
        found = self.info.find(name)
        if found is None:
            raise ConfigError(f"{self.id} does not offer {name}; it offers {_listed(self.info)}")
        return ServiceClient(self._link, self.id, found)


class Robot:
    """A subsystem as it was when it was discovered; `info` has it as plain values."""

    def __init__(self, link: Connection, info: SubsystemInfo) -> None:
        self.info = info
        self._link = link

    def __repr__(self) -> str:
        return f"<{self.info.kind} {self.id} {self.name!r} with {len(self.components)} components>"

    @property
    def id(self) -> int:
        """The subsystem's number."""
        return self.info.id

    @property
    def name(self) -> str:
        """What it calls itself."""
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
        """By number (102) or by whole id ("101.1.102"); `ConfigError` that lists the components."""
        if isinstance(which, str):
            which = JausID.parse(which)
        found = [each for each in self.components if which in (each.id, each.id.component)]
        if len(found) == 1:
            return ComponentClient(self._link, found[0])
        if found:
            raise ConfigError(f"subsystem {self.id} has several components {which}; choose by whole id: {_ids(found)}")
        raise ConfigError(f"subsystem {self.id} has no component {which}; it has {_ids(self.components)}")

    def service(self, name: str) -> ServiceClient:
        """The service of this URN, or end of one, as in `mobility:PrimitiveDriver`.

        Raises `ConfigError` when none offers it, which lists what there is, or when several components do.
        """
        check_text(name, "a service's name")
        offering = list(self.info.offering(name))
        if len(offering) == 1:
            return ComponentClient(self._link, offering[0]).service(name)
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
