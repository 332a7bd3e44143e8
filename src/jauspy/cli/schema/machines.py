"""State machines as trees: states, and what makes them change."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from rich.text import Text
from rich.tree import Tree

from jauspy.schema.differences import trigger
from jauspy.schema.model import Action, Behavior, State, Transition
from jauspy.schema.state_tree import short_name


def machine_trees(behavior: Behavior) -> Iterator[Tree]:
    """One tree per state machine."""
    starts = {start.machine: start.state for start in behavior.start}
    for machine in behavior.machines:
        start = starts.get(machine.name)
        label = Text.assemble((short_name(machine.name), "bold"), f" starts in {start}" if start else "")
        tree = Tree(label, guide_style="dim")
        _add_transitions(tree, machine.default_transitions, "by default ")
        for state in machine.states:
            _add_state(tree, state)
        yield tree


def _add_state(tree: Tree, state: State) -> None:
    initial = state.initial if state.initial != state.name else None
    branch = tree.add(Text.assemble((state.name, "cyan"), (f"  starts in {initial}" if initial else "", "dim")))
    for what, actions in (("entry", state.entry), ("exit", state.exit)):
        if actions:
            branch.add(Text.assemble((f"on {what}: ", "dim"), _actions(actions)))
    _add_transitions(branch, state.transitions, "")
    _add_transitions(branch, state.default_transitions, "by default ")
    for child in state.states:
        _add_state(branch, child)


def _add_transitions(tree: Tree, transitions: Iterable[Transition], prefix: str) -> None:
    for transition in transitions:
        tree.add(transition_text(transition, prefix))


def transition_text(transition: Transition, prefix: str = "") -> Text:
    """`RequestControl [isDefaultAuthorityGreater]: Send RejectControl -> Ready.Controlled`."""
    text = Text.assemble((prefix, "dim"), (trigger(transition), "bold"))
    if transition.guard:
        text.append(f" [{transition.guard}]", "yellow")
    if transition.actions:
        text.append(f": {_actions(transition.actions)}")
    if transition.kind == "pop":
        text.append(" -> back", "green")
    if transition.end_state is not None:
        text.append(f" -> {'push ' if transition.kind == 'push' else ''}{transition.end_state}", "green")
    return text


def _actions(actions: Sequence[Action]) -> str:
    return ", ".join(map(_action, actions))


def _action(action: Action) -> str:
    name = short_name(action.name)
    if name == "Send" and action.arguments:
        what, *rest = (argument.strip("'") for argument in action.arguments if argument != "transportData")
        return f"send {what}" + (f" {' '.join(rest)}" if rest else "")
    return f"{name}({', '.join(action.arguments)})"
