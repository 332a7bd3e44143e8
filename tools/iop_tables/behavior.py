"""Protocol behaviour of a service: the loops of the reference as transitions of states."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

from lxml import etree

from .table import Row, Table
from .xml_text import Xml

GUARD_ARGUMENTS = {"isControllingClient": "transportData", "isRegistered": "transportData"}
"""Arguments of conditions; all others look at the message."""


@dataclass
class _State:
    transitions: list[Xml] = field(default_factory=list)
    defaults: list[Xml] = field(default_factory=list)
    inner: dict[str, _State] = field(default_factory=dict)
    entry: list[str] = field(default_factory=list)

    def at(self, path: str) -> _State:
        state = self
        for name in path.split("."):
            state = state.inner.setdefault(name, _State())
        return state

    def xml(self, name: str, initial: dict[str, str], path: str) -> Xml:
        attributes = {"name": name} | ({"initial_state": initial[path]} if path in initial else {})
        entry = [Xml("entry", {}, [Xml("action", {"name": action}) for action in self.entry])] if self.entry else []
        defaults = [Xml("default_state", {}, self.defaults)] if self.defaults else []
        inner = [state.xml(key, initial, f"{path}.{key}") for key, state in self.inner.items()]
        return Xml("state", attributes, [*entry, *self.transitions, *inner, *defaults])


def behavior(table: Table, reference: str, parent: Path) -> Xml:
    """The protocol behaviour: the loops of the reference as transitions of the states that their names mean."""
    definition = etree.parse(parent).getroot().find("{*}protocol_behavior")
    starts = [
        Xml(
            "start",
            {
                "state_machine_name": f"{reference}.{start.get('state_machine_name')}",
                "state_name": str(start.get("state_name")),
            },
        )
        for start in ([] if definition is None else definition.findall("{*}start"))
    ]
    machine = next(
        start.attributes["state_machine_name"]
        for start in starts
        if start.attributes["state_machine_name"].endswith("ReceiveFSM")
    )
    prefix = machine.removesuffix("ReceiveFSM")
    root = _State()
    ready = "Receiving.Ready" if ".Ready" in starts[0].attributes["state_name"] else "Receiving"
    for row in table.rows:
        _add(root, table, row, ready, prefix)
    for loop, state in table.states.items():
        if loop.startswith("entry:"):
            root.at(state).entry.append(loop.removeprefix("entry:"))
    initial = {"Receiving": "Ready"} if ready != "Receiving" else {}
    if "NotControlled" in starts[0].attributes["state_name"]:
        initial["Receiving.Ready"] = "NotControlled"
    for state in table.states.values():  # a state that the reference adds: the first one named is entered first
        around, _, name = state.rpartition(".")
        initial.setdefault(around, name)
    states = [state.xml(name, initial, name) for name, state in root.inner.items()]
    others = [start.attributes for start in starts if start.attributes["state_machine_name"] != machine]
    machines = [Xml("state_machine", {"name": machine}, states)]
    machines += [
        Xml("state_machine", {"name": start["state_machine_name"]}, [Xml("state", {"name": start["state_name"]})])
        for start in others
    ]
    return Xml("protocol_behavior", {"is_stateless": "false"}, [*starts, *machines])


def _add(root: _State, table: Table, row: Row, ready: str, prefix: str) -> None:
    message = next((m for m in table.messages if m.name == row.trigger), None)
    actions, guard = list(row.actions), row.guard
    silent = message is not None and message.kind == "command" and not actions
    if silent:  # the reference defines an action, and does not say when it is called
        actions = _missing_actions(table, row.trigger)
    controlled = row.loop.endswith(("ControlledLoop", "ReadyLoop")) or (silent and ready != "Receiving")
    if controlled and message is not None and "isControllingClient" not in guard and "isRegistered" not in guard:
        guard = f"isControllingClient && {guard}" if guard else "isControllingClient"
    parameters = []
    if message is not None:
        parameters = [Xml("parameter", {"type": row.trigger, "value": "msg"}),
                      Xml("parameter", {"type": "Receive.Body.ReceiveRec", "value": "transportData"})]  # fmt: skip
    end = [Xml("end_state", {"state": row.end})] if row.end else []
    kind = Xml("simple", {}, end) if end else Xml("internal")
    calls = [_action(table, action, message is not None, prefix) for action in actions]
    guards = [Xml("guard", {"condition": guard_of(guard)})] if guard else []
    trigger = f"{prefix}Receive" if message is not None else row.trigger
    transition = Xml("transition", {"name": trigger}, [*parameters, *guards, kind, *calls])
    if row.loop in table.states:
        root.at(table.states[row.loop]).transitions.append(transition)
    elif row.loop.endswith("ReadyLoop"):
        root.at(f"{ready}.Controlled.Available.Ready").transitions.append(transition)
    elif controlled:
        root.at(f"{ready}.Controlled").defaults.append(transition)
    else:
        root.at(ready).defaults.append(transition)


def _missing_actions(table: Table, trigger: str) -> list[str]:
    outputs = [f"send{m.name}" for m in table.messages if m.name == f"{trigger}Response"]
    return [trigger[:1].lower() + trigger[1:], *outputs]


def _action(table: Table, name: str, received: bool, prefix: str) -> Xml:
    message = table.sends.get(name, "")
    arguments = ["msg", "transportData"] if name.startswith("send") else ["msg"]
    if message and not name.removeprefix("send").startswith(message):
        name, arguments = f"{prefix}Send", [f"'{message}'", "transportData"]
    if not received:
        arguments = []
    return Xml("action", {"name": name}, [Xml("argument", {"value": value}) for value in arguments])


def guard_of(text: str) -> str:
    """A condition of the reference as a guard: each name is called with its argument, no blanks inside parentheses."""
    called = re.sub(r"[A-Za-z]\w*", lambda match: f"{match[0]}({GUARD_ARGUMENTS.get(match[0], 'msg')})", text)
    return re.sub(r"\(\s+|\s+\)|!\s+", lambda match: match[0].strip(), called)
