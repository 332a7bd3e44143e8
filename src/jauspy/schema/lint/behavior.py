"""Rules about state machines: triggers, sends, states, and transitions that another one precedes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from lxml.etree import _Element as Element

from jauspy.errors import SchemaError
from jauspy.schema.behavior import calls, parse
from jauspy.schema.document import file_of, suggestion
from jauspy.schema.lint.context import LintContext, Problem
from jauspy.schema.model import ActionCall, Behavior, SourceLocation, State, Transition
from jauspy.schema.state_tree import MergedMachine, merge_machines, short_name as short, transitions_of, walk_states

RECEIVE = "Receive"
"""The event of the transport service that carries a message."""


def states_of(behavior: Behavior) -> Iterator[State]:
    """All states, outer ones first."""
    return (state for machine in behavior.machines for _, state in walk_states(machine.states))


def location_of(where: SourceLocation | None) -> SourceLocation:
    """The location of a part of a behaviour, which behaviour read from files always has."""
    return where or SourceLocation("", 0)


@dataclass(frozen=True, slots=True)
class _Known:
    """The inputs and outputs of a service and its ancestors."""

    inputs: set[str]
    outputs: set[str]
    events: set[str]


def _triggers(context: LintContext) -> Iterator[tuple[Transition, _Known]]:
    """Every transition of the checked services whose ancestors are all known."""
    for service in context.services():
        behavior = context.behavior(service)
        line = context.lineage(service)
        if behavior is None or _incomplete(line):
            continue
        known = _Known(
            {element.get("name", "") for ancestor in line for element in context.messages(ancestor, "input_set")},
            {element.get("name", "") for ancestor in line for element in context.messages(ancestor, "output_set")},
            {
                event.get("name", "")
                for ancestor in line
                for part in ancestor.iterfind("internal_events_set")
                for event in part
            },
        )
        yield from ((transition, known) for transition in transitions_of(behavior))


def dead_trigger(context: LintContext) -> Iterator[Problem]:
    """Transitions that no input of the service or its ancestors can trigger."""
    for transition, known in _triggers(context):
        reason = _dead(transition, known)
        if reason:
            yield location_of(transition.where), reason


def _dead(transition: Transition, known: _Known) -> str:
    event = short(transition.trigger)
    if event == RECEIVE and transition.parameters:
        wanted = short(transition.parameters[0].type)
        if wanted in known.inputs | known.outputs | known.events:
            return ""
        hint = suggestion(wanted, known.inputs)
        return f"{wanted} is not an input of the service or its ancestors{hint}; nothing fires this"
    if not event or event in known.events or event == RECEIVE:
        return ""
    if event in known.inputs:
        reason = f"{event} is a message of an ancestor: the trigger is Receive with a parameter of type {event}"
        return f"{reason}; only inputs of the service itself are triggers by their name"
    hint = suggestion(event, known.events)
    return f"no internal event '{event}' in the service or its ancestors{hint}; nothing fires this"


def output_trigger(context: LintContext) -> Iterator[Problem]:
    """Transitions for a message that is an output and no input of the service."""
    for transition, known in _triggers(context):
        if short(transition.trigger) == RECEIVE and transition.parameters:
            wanted = short(transition.parameters[0].type)
            if wanted in known.outputs - known.inputs - known.events:
                reason = f"{wanted} is an output: only another service of this kind can send it"
                yield location_of(transition.where), f"{reason}; add it to the input_set, too, if that is meant"


def _incomplete(line: Sequence[Element]) -> bool:
    """True if an ancestor is missing, so that its inputs and outputs are unknown; its absence is reported."""
    return line[-1].find("references/inherits_from") is not None


def unknown_send(context: LintContext) -> Iterator[Problem]:
    """Sends of messages that are not an output of the service or its ancestors."""
    for service in context.services():
        behavior = context.behavior(service)
        line = context.lineage(service)
        if behavior is None or _incomplete(line):
            continue
        outputs = {element.get("name", "") for ancestor in line for element in context.messages(ancestor, "output_set")}
        for action, where in _actions(behavior):
            wanted = _sent(action)
            if wanted and wanted not in outputs:
                reason = f"Send of {wanted}, which is not an output of the service or its ancestors"
                yield location_of(where), f"{reason}{suggestion(wanted, outputs)}; add it to the output_set"


def _actions(behavior: Behavior) -> Iterator[tuple[ActionCall, SourceLocation | None]]:
    for state in states_of(behavior):
        yield from ((action, state.where) for action in (*state.entry, *state.exit))
    for transition in transitions_of(behavior):
        yield from ((action, transition.where) for action in transition.actions)


def _sent(action: ActionCall) -> str:
    """The message that a Send names; empty if it names a variable."""
    if short(action.name) != "Send":
        return ""
    quoted = [text.strip() for text in action.arguments if text.strip()[:1] in ("'", '"')]
    return short(quoted[0].strip("'\"")) if quoted and action.arguments[0].strip() == quoted[0] else ""


def guard_parameter(context: LintContext) -> Iterator[Problem]:
    """Arguments of guards that are not parameters of their transition."""
    for service in context.services():
        behavior = context.behavior(service)
        for transition in transitions_of(behavior) if behavior is not None else ():
            known = [parameter.name for parameter in transition.parameters]
            for argument in _guard_arguments(transition.guard):
                if argument not in known:
                    available = f"the transition has {' and '.join(known) or 'none'}"
                    reason = f"guard {transition.guard!r} names the parameter {argument}, and {available}"
                    yield location_of(transition.where), f"{reason}{suggestion(argument, known)}"


def _guard_arguments(guard: str) -> Iterator[str]:
    """The arguments that are names; none of a guard that the loader rejects."""
    try:
        found = calls(parse(guard)) if guard.strip() else ()
    except SchemaError:
        return
    for call in found:
        yield from (argument for argument in map(str.strip, call.arguments) if argument.isidentifier())


IS_CONTROLLER: Final = "isControllingClient"
ACCESS_CONTROL: Final = "urn:jaus:jss:core:AccessControl"
CORE: Final = "urn:jaus:jss:core:"
MAX_COMMAND: Final = 0x1FFF
"""Commands have the ids 0000h to 1FFFh, and those of vendors D000h to DFFFh (AS5710)."""
VENDOR_COMMANDS: Final = range(0xD000, 0xE000)


def uncontrolled_command(context: LintContext) -> Iterator[Problem]:
    """Commands of services with access control that any client may give while another one is in control."""
    for service in context.services():
        behavior = context.behavior(service)
        line = context.lineage(service)
        if behavior is None or service.get("id", "").startswith(CORE):
            continue
        if not any(ancestor.get("id") == ACCESS_CONTROL for ancestor in line):
            continue
        commands = {
            message.get("name", "")
            for message in context.messages(service, "input_set")
            if _is_command(context, message)
        }
        for transition in transitions_of(behavior):
            wanted = next((parameter.type for parameter in transition.parameters if parameter.type in commands), None)
            if wanted is None or not transition.actions or IS_CONTROLLER in transition.guard:
                continue
            reason = f"the command {wanted} is carried out for any client, also while another one is in control"
            yield location_of(transition.where), f"{reason}; add the guard {IS_CONTROLLER}(transportData)"


def _is_command(context: LintContext, message: Element) -> bool:
    if message.get("name", "").startswith("Query"):
        return False
    try:
        code = int(context.code(message), 16)
    except ValueError:
        return False
    return code <= MAX_COMMAND or code in VENDOR_COMMANDS


# --- states ---------------------------------------------------------------------------------------------------------


def _machines(context: LintContext, line: Iterable[Element]) -> dict[str, MergedMachine]:
    return merge_machines([context.definition(ancestor) for ancestor in line])


def unknown_state(context: LintContext) -> Iterator[Problem]:
    """Start, initial and end states that do not exist."""
    for service in context.services():
        behavior = context.behavior(service)
        if behavior is None or _incomplete(context.lineage(service)):
            continue
        machines = _machines(context, context.lineage(service))
        for machine, path, what, where in _named_states(machines, behavior):
            found = machines.get(short(machine))
            if found is not None and found.root.find(path) is None:
                known = suggestion(path, [str(state) for state in found.root.all() if state.path])
                advice = _replaced_parent(context, service, machine, path)
                advice = advice or f"{known}; correct the path, it starts at the outermost state"
                yield where, f"{what} '{path}' does not exist{advice}"


def _named_states(
    machines: dict[str, MergedMachine], behavior: Behavior
) -> Iterator[tuple[str, str, str, SourceLocation]]:
    """The states that a definition refers to: machine, path, the kind of state and the location."""
    for start in behavior.start:
        yield start.machine, start.state, "start state", location_of(start.where)
    for machine in behavior.machines:
        for path, state in walk_states(machine.states):
            if state.initial is not None and not _names_itself(machines, machine.name, path, state):
                yield machine.name, f"{path}.{state.initial}", "initial state", location_of(state.where)
        for transition in transitions_of(Behavior(machines=(machine,))):
            if transition.end_state is not None:
                yield machine.name, transition.end_state, "end state", location_of(transition.where)


def _replaced_parent(context: LintContext, service: Element, machine: str, path: str) -> str:
    """Names the ancestor that replaces a built-in one whose machine has the state; empty if there is none."""
    line = context.lineage(service)
    for ancestor in line[1:]:
        built_in = context.replaced(ancestor)
        if built_in is not None:
            found = _machines(context, [built_in, *context.lineage(ancestor)[1:]]).get(short(machine))
            if found is not None and found.root.find(path) is not None:
                name = f"{built_in.get('name')} {built_in.get('version')}"
                reason = f", and would with the built-in {name}, which {file_of(ancestor)} replaces with other states"
                return f"{reason}; use the built-in one, or correct the path"
    return ""


def _names_itself(machines: dict[str, MergedMachine], machine: str, path: str, state: State) -> bool:
    """True for a state without children that is its own initial state, as in some definitions; this has no effect."""
    merged = machines[short(machine)].root.find(path)
    return state.initial == state.name and merged is not None and not merged.children


def unreachable_state(context: LintContext) -> Iterator[Problem]:
    """States without a transition to them, neither in the service that introduces them nor in derived ones."""
    checked = set(context.services())
    reached: dict[tuple[Element, str], set[str]] = {}
    for service in context.all_services():
        line = context.lineage(service)
        if checked.isdisjoint(line):
            continue
        for name, machine in _machines(context, line).items():
            reachable = machine.reachable()
            for ancestor in line:
                reached.setdefault((ancestor, name), set()).update(reachable)
    for service in context.services():
        behavior = context.behavior(service)
        line = context.lineage(service)
        if behavior is None or _incomplete(line):
            continue
        inherited = _machines(context, line[1:])
        for introduced in behavior.machines:
            name = short(introduced.name)
            active = reached.get((service, name), set())
            before = inherited.get(name)
            for path, state in walk_states(introduced.states):
                parent = path.rpartition(".")[0]
                is_new = before is None or before.root.find(path) is None
                if path not in active and is_new and (not parent or parent in active):
                    reason = f"nothing leads to state {path}: no start, no initial state and no transition"
                    yield location_of(state.where), f"{reason}; add one or delete it"


Key = tuple[str, str]
"""Trigger, and the message for the trigger Receive; empty for any."""


def shadowed_transition(context: LintContext) -> Iterator[Problem]:
    """Transitions after another one of the same state that matches whenever they do, since the first match is taken."""
    for service in context.services():
        behavior = context.behavior(service)
        for transitions in _lists(behavior) if behavior else ():
            yield from _shadowed(transitions)


def _lists(behavior: Behavior) -> Iterator[Sequence[Transition]]:
    """Lists of competing transitions: those of a state, and its default ones."""
    for machine in behavior.machines:
        yield machine.default_transitions
    for state in states_of(behavior):
        yield state.transitions
        yield state.default_transitions


def _shadowed(transitions: Sequence[Transition]) -> Iterator[Problem]:
    for number, transition in enumerate(transitions):
        first = next((earlier for earlier in transitions[:number] if _covers(earlier, transition)), None)
        if first is not None:
            line = location_of(first.where).line
            why = "has the same guard" if first.guard else "has no guard"
            what = f"the transition on {_what(first)} in line {line} {why} and is always taken before this one"
            yield location_of(transition.where), f"{what}; give that one a guard, or put it behind"


def _covers(first: Transition, other: Transition) -> bool:
    """True if the first matches everything that the other one matches."""
    trigger, message = _key(first)
    its_trigger, its_message = _key(other)
    fits = trigger in ("", its_trigger) and message in ("", its_message)
    return fits and "".join(first.guard.split()) in ("", "".join(other.guard.split()))


def _key(transition: Transition) -> Key:
    trigger = short(transition.trigger)
    message = transition.parameters[0].type if trigger == RECEIVE and transition.parameters else ""
    return trigger, short(message)


def _what(transition: Transition) -> str:
    trigger, message = _key(transition)
    return message or trigger or "everything else"
