"""The JSIDL of a new service: its messages, and its states in the machine of the core service that it inherits from."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Final

from lxml import etree
from lxml.etree import _Element as Element

JSIDL: Final = "urn:jaus:jsidl:1.1"
_NAMESPACES: Final[Any] = {None: JSIDL}  # lxml-stubs do not know the default namespace


@dataclass(frozen=True, slots=True)
class Field:
    """A number in a message."""

    name: str
    units: str


@dataclass(frozen=True, slots=True)
class Command:
    """A command with its fields; `target` is the state that it leads to, from the state `start` or from any state."""

    name: str
    fields: tuple[Field, ...] = ()
    start: str = ""
    target: str = ""


@dataclass(frozen=True, slots=True)
class Parent:
    """A core service to inherit from."""

    services: tuple[str, ...]
    """Names of the services whose machines it extends, its own first."""
    states: tuple[str, ...]
    """The state in which commands are taken, from the outermost one."""
    initial: str
    """The state in which a component starts."""

    @property
    def machine(self) -> str:
        """The prefix of its state machines."""
        return ".".join(self.services)


PARENTS: Final = {
    "Events": Parent(("events", "transport"), ("Receiving", "Ready"), "Receiving.Ready"),
    "AccessControl": Parent(
        ("accessControl", "events", "transport"), ("Receiving", "Ready", "Controlled"), "Receiving.Ready.NotControlled"
    ),
    "Management": Parent(
        ("management", "accessControl", "events", "transport"),
        ("Receiving", "Ready", "Controlled", "Available", "Ready"),
        "Receiving.Ready.NotControlled.Available.Standby",
    ),
}


_DESCRIPTIONS: Final = {
    (True, False): "Reports its values on request, and as events.",
    (False, True): "Carries out commands.",
    (True, True): "Carries out commands, and reports its values on request and as events.",
}
"""Descriptions by whether there are fields, and commands."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Jsidl:
    """A service, and how it is written."""

    urn: str
    name: str
    parent: str
    """A key of `PARENTS`."""
    fields: Sequence[Field]
    """Fields of the report."""
    commands: Sequence[Command]
    states: Sequence[str]
    codes: Mapping[str, int]
    """The id of each message."""

    def text(self) -> str:
        """The file."""
        parent = PARENTS[self.parent]
        root = _element(
            "service_def",
            _element("description", text=_DESCRIPTIONS[bool(self.fields), bool(self.commands)]),
            _element("assumptions", text="None."),
            _element(
                "references",
                _element(
                    "inherits_from", name=parent.services[0], id=f"urn:jaus:jss:core:{self.parent}", version="1.1"
                ),
            ),
            _element(
                "declared_type_set",
                _element("declared_type_set_ref", name="core", id="urn:jauspy:core:Types", version="1.0"),
                name="Types",
            ),
            _element("message_set", _element("input_set", *self._inputs()), _element("output_set", *self._outputs())),
            _element("internal_events_set"),
            _element(
                "protocol_behavior",
                _element("start", state_machine_name=f"{parent.machine}.ReceiveFSM", state_name=parent.initial),
                _element("start", state_machine_name=f"{parent.machine}.SendFSM", state_name="Sending"),
                _element("state_machine", self._receiving(), name=f"{parent.machine}.ReceiveFSM"),
                _element("state_machine", _element("state", name="Sending"), name=f"{parent.machine}.SendFSM"),
                is_stateless="false",
            ),
            name=self.name,
            id=self.urn,
            version="1.0",
        )
        etree.indent(root)
        return etree.tostring(root, xml_declaration=True, encoding="UTF-8", pretty_print=True).decode()

    # --- messages -------------------------------------------------------------------------------------------------

    def _inputs(self) -> Iterator[Element]:
        if self.fields:
            vector = _element(
                "fixed_field", name="PresenceVector", field_type=self._vector, field_units="one", optional="false"
            )
            purpose = f"Asks for Report{self.name}; bit i of the vector asks for its i-th field."
            yield self._message(f"Query{self.name}", purpose, [vector])
        for command in self.commands:
            purpose = f"Leads to the state {command.target}." if command.target else "Changes what the service does."
            numbers = [self._number(field, optional=False) for field in command.fields]
            yield self._message(command.name, purpose, numbers, is_command=True)

    def _outputs(self) -> Iterator[Element]:
        if self.fields:
            vector = _element("presence_vector", field_type_unsigned=self._vector)
            numbers = [self._number(field, optional=True) for field in self.fields]
            yield self._message(f"Report{self.name}", "The values that were asked for.", [vector, *numbers])

    @property
    def _vector(self) -> str:
        return "unsigned byte" if len(self.fields) <= 8 else "unsigned short integer"

    def _number(self, field: Field, *, optional: bool) -> Element:
        return _element(
            "fixed_field",
            name=field.name,
            field_type="long float",
            field_units=field.units,
            optional=str(optional).lower(),
        )

    def _message(self, name: str, purpose: str, fields: Sequence[Element], *, is_command: bool = False) -> Element:
        record = [_element("record", *fields, name=f"{name}Rec", optional="false")] if fields else []
        return _element(
            "message_def",
            _element("description", text=purpose),
            _element("declared_header", name="MsgHeader", declared_type_ref="core.MsgHeader"),
            _element("body", *record, name="Body"),
            _element("footer", name="Footer"),
            name=name,
            message_id=f"{self.codes[name]:04X}",
            is_command=str(is_command).lower(),
        )

    # --- states ---------------------------------------------------------------------------------------------------

    def _receiving(self) -> Element:
        """The states, from Receiving to the one in which commands are taken; Standby and NotControlled are siblings."""
        names = PARENTS[self.parent].states
        state = self._ready(names[-1])
        for name, inner in reversed(list(pairwise(names))):
            before = self._before(name, inner)
            outer = _element(
                "state", *before, state, name=name, initial_state=str(before[0].attrib["name"]) if before else inner
            )
            if name == "Ready":  # Receiving.Ready; queries are answered in all of its states
                outer.extend(self._default(self._query()))
            state = outer
        return state

    def _before(self, name: str, inner: str) -> list[Element]:
        """The sibling of the state `inner` in `name` in which a component is first."""
        standby = _element("state", name="Standby")
        match name, inner, self.parent:
            case "Available", "Ready", _:
                return [standby]
            case "Ready", "Controlled", "Management":
                available = _element("state", standby, name="Available", initial_state="Standby")
                return [_element("state", available, name="NotControlled", initial_state="Available")]
            case "Ready", "Controlled", _:
                return [_element("state", name="NotControlled")]
        return []

    def _ready(self, name: str) -> Element:
        """The state in which commands are taken, with the service's own states in it."""
        state = _element("state", name=name)
        if self.states:
            state.set("initial_state", self.states[0])
            for state_path in self.states:
                state.append(
                    _element(
                        "state", *(self._transition(c) for c in self.commands if c.start == state_path), name=state_path
                    )
                )
        everywhere = [self._transition(command) for command in self.commands if not command.start]
        if self._is_events:
            everywhere += self._query()
        state.extend(self._default(everywhere) if self.states else everywhere)
        return state

    @property
    def _is_events(self) -> bool:
        return self.parent == "Events"

    def _default(self, transitions: Sequence[Element]) -> list[Element]:
        return [_element("default_state", *transitions)] if transitions else []

    def _receive(self, message: str, *children: Element) -> Element:
        return _element(
            "transition",
            _element("parameter", type=message, value="msg"),
            _element("parameter", type="Receive.Body.ReceiveRec", value="transportData"),
            *children,
            name=f"{PARENTS[self.parent].machine}.Receive",
        )

    def _query(self) -> list[Element]:
        if not self.fields:
            return []
        sent = (_element("argument", value=f"'Report{self.name}'"), _element("argument", value="transportData"))
        answer = _element("action", *sent, name=f"{PARENTS[self.parent].machine}.Send")
        return [self._receive(f"Query{self.name}", _element("internal"), answer)]

    def _transition(self, command: Command) -> Element:
        children = [] if self._is_events else [_element("guard", condition="isControllingClient(transportData)")]
        if command.target:
            end = ".".join((*PARENTS[self.parent].states, command.target))
            children.append(_element("simple", _element("end_state", state=end)))
        else:
            children.append(_element("internal"))
        return self._receive(
            command.name, *children, _element("action", name=command.name[:1].lower() + command.name[1:])
        )


def _element(tag: str, *children: Element, text: str | None = None, **attributes: str) -> Element:
    element = etree.Element(f"{{{JSIDL}}}{tag}", attributes, nsmap=_NAMESPACES)
    element.text = text
    element.extend(children)
    return element
