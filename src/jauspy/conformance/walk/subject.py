"""The component under test: its definitions, its merged machine, and the classes of its messages."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from jauspy.codec.base import Message
from jauspy.codec.registry import Registry
from jauspy.conformance.offers import ServiceKey
from jauspy.conformance.tester import Tester
from jauspy.conformance.walk.machine import Machine
from jauspy.conformance.walk.walker import Walker
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.schema import model
from jauspy.schema.inheritance import most_derived_first, parents_among
from jauspy.schema.needed import load_needed

TRANSPORT: Final = "urn:jaus:jss:core:Transport"
"""Has no messages, and so is not in the registry."""


@dataclass(frozen=True)
class Subject:
    """The component under test, as its definitions say it is."""

    component: JausID
    definitions: tuple[model.Service, ...]
    machine: Machine
    registry: Registry

    def walker(self, tester: Tester) -> Walker:
        """The one walker of this component in this run."""
        known: dict[JausID, Walker] = tester.memory.setdefault("walkers", {})
        if self.component not in known:
            services = frozenset(each.id for each in self.definitions)
            known[self.component] = Walker(tester, self.component, services, self.machine.start)
        return known[self.component]

    def transition(self, rule: str) -> str:
        """A transition of this component, as reports name it."""
        return f"{self.component} {rule}"

    def kind(self, name: str) -> type[Message]:
        """The class of an output, of the version that the component runs."""
        for definition in self.definitions:
            for message in (*definition.outputs, *definition.inputs):
                if message.name == name:
                    for kind in self.registry.by_code(message.code):
                        if definition.key == (kind.SERVICE, kind.VERSION):
                            return kind
        return self.registry.by_name(name)


def subject_of(id: JausID, offered: frozenset[ServiceKey]) -> Subject:
    """The component with everything known that it offers, most derived first."""
    known = {(each.service, each.version) for each in registry.entries} | {(TRANSPORT, "1.0"), (TRANSPORT, "1.1")}
    schema = load_needed(frozenset(offered & known))
    services = [schema.service(*key) for key in sorted(offered & known)]
    ordered = most_derived_first(services, parents_among(schema.services))
    return Subject(id, ordered, Machine(ordered), registry)
