"""The engine alone, over tiny definitions made by hand."""

from __future__ import annotations

import logging
from dataclasses import replace

import pytest

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import ReportTime
from jauspy.protocol.counters import Counters
from jauspy.schema import model
from jauspy.schema.state_tree import merge_machines
from jauspy.services.binding import Binder
from jauspy.services.service import Service
from jauspy.services.state_machine import MAX_PUSHED, STAY, ActionErrors, MachineInstance, Trigger, TriggerOutcome

CLIENT = JausID(42, 1, 1)
CODES = {"Go": 1, "Back": 2, "Ask": 3, "Other": 4}


def on(
    what: str, kind: str = "internal", end: str | None = None, *, do: str = "", guard: str = "", event: bool = False
):
    """A transition; `do`: actions separated by blanks."""
    return model.Transition(
        trigger=what and f"x.{what}" if event else "x.Receive",
        parameters=() if event else (model.Parameter(what, "msg"),),
        kind=kind,
        end_state=end,
        guard=guard,
        actions=tuple(model.ActionCall(name) for name in do.split()),
    )


def state(name: str, *states: model.State, **more) -> model.State:
    more = {k: tuple(model.ActionCall(a) for a in v.split()) if k in ("entry", "exit") else v for k, v in more.items()}
    return model.State(name=name, states=states, **more)


def definition(name: str, *states: model.State, start: str, parent: str | None = None) -> model.ServiceDefinition:
    prefix = f"{parent}." if parent else ""
    return model.ServiceDefinition(
        name=name,
        id=name,
        version="1.0",
        jsidl="1.1",
        inherits_from=model.Reference(parent, parent, "1.0") if parent else None,
        inputs=tuple(model.MessageDefinition(name=n, code=c, is_command=True, body=None) for n, c in CODES.items()),
        behavior=model.Behavior(
            machines=(model.StateMachine(name=f"{prefix}ReceiveFSM", states=states),),
            start=(model.Start(f"{prefix}ReceiveFSM", start),),
        ),
    )


class Actions(Service):
    """Logs every action by its name."""

    def __init__(self) -> None:
        self.log: list[str] = []
        self.allowed = True

    def is_allowed(self) -> bool:
        return self.allowed

    def is_broken(self) -> bool:
        raise RuntimeError("predicate")

    def fail(self) -> None:
        raise RuntimeError("action")

    def veto(self):
        return STAY


for _name in ("a", "b", "c", "in_top", "out_top", "in_a", "out_a", "in_b", "out_b"):
    setattr(Actions, _name, lambda self, _name=_name: self.log.append(_name))


class Rig:
    def __init__(self, *definitions: model.ServiceDefinition, **services: Service) -> None:
        self.counters = Counters(logging.getLogger("test"))
        self.sent: list[tuple[object, bool]] = []
        self.service = Actions()
        by_urn = {d.id: services.get(d.id, self.service) for d in definitions}
        binder = Binder(
            {d.id: d for d in definitions},
            by_urn,
            lambda result, trigger, to_source: self.sent.append((result, to_source)),
        )
        merged = merge_machines(definitions)["ReceiveFSM"]
        merged.check_initials()
        bound = binder.states(merged.root)
        binder.raise_problems()
        self.machine = MachineInstance(
            bound,
            merged.start(),
            ActionErrors(self.counters),
        )

    def get(self, what: str) -> TriggerOutcome:
        return self.machine.handle(Trigger(CODES.get(what, what), what, CLIENT))

    @property
    def log(self) -> list[str]:
        taken, self.service.log = self.service.log, []
        return taken


def two_states(*, a=(), b=(), top=(), defaults=(), start="Top.A") -> model.ServiceDefinition:
    return definition(
        "S",
        state(
            "Top",
            state("A", transitions=a, entry="inA", exit="outA"),
            state("B", transitions=b, entry="inB", exit="outB"),
            initial="A",
            entry="inTop",
            exit="outTop",
            transitions=top,
            default_transitions=defaults,
        ),
        start=start,
    )


def test_start_enters_outer_states_first() -> None:
    rig = Rig(two_states(start="Top"))
    rig.machine.start()
    assert rig.machine.state == "Top.A"
    assert rig.log == ["in_top", "in_a"]


def test_simple_transition_runs_actions_exit_and_entry() -> None:
    rig = Rig(two_states(a=(on("Go", "simple", "Top.B", do="a b"),)))
    assert rig.get("Go") is TriggerOutcome.TAKEN
    assert rig.log == ["a", "b", "out_a", "in_b"]
    assert rig.machine.state == "Top.B"


def test_transition_to_an_active_state_reenters_it() -> None:
    rig = Rig(two_states(a=(on("Go", "simple", "Top"), on("Back", "simple", "Top.A"))))
    rig.get("Go")
    assert rig.log == ["out_a", "out_top", "in_top", "in_a"]
    rig.get("Back")
    assert rig.log == ["out_a", "in_a"]


def test_transitions_are_searched_from_the_innermost_state() -> None:
    everything = {"a": (on("Ask", do="a"),), "defaults": (on("Ask", do="b"),), "top": (on("Ask", do="c"),)}
    for missing, expected in (((), "a"), (("a",), "b"), (("a", "defaults"), "c")):
        rig = Rig(two_states(**{k: v for k, v in everything.items() if k not in missing}))
        rig.get("Ask")
        assert rig.log == [expected]


def test_false_guard_continues_with_the_next_transition() -> None:
    rig = Rig(two_states(a=(on("Ask", do="a", guard="isAllowed()"), on("Ask", do="b")), top=(on("Ask", do="c"),)))
    rig.get("Ask")
    rig.service.allowed = False
    rig.get("Ask")
    assert rig.log == ["a", "b"]


def test_simple_transition_without_end_state_keeps_the_state() -> None:
    rig = Rig(two_states(a=(on("Ask", "simple", do="a"),)))
    assert rig.get("Ask") is TriggerOutcome.TAKEN
    assert (rig.machine.state, rig.log) == ("Top.A", ["a"])


def test_internal_transition_without_actions_ignores_the_trigger() -> None:
    rig = Rig(two_states(a=(on("Ask"),), top=(on("Ask", do="c"),)))
    assert rig.get("Ask") is TriggerOutcome.IGNORED
    assert rig.log == []
    assert rig.get("Other") is TriggerOutcome.IGNORED


def test_receive_without_parameters_matches_any_message_last() -> None:
    rest = model.Transition(trigger="Receive", kind="internal", actions=(model.ActionCall("c"),))
    rig = Rig(two_states(a=(on("Ask", do="a"),), top=(rest,)))
    rig.get("Ask")
    rig.get("Other")
    assert rig.get("Timedout") is TriggerOutcome.IGNORED
    assert rig.log == ["a", "c"]


def test_internal_events_match_by_short_name() -> None:
    rig = Rig(two_states(a=(on("Timedout", "simple", "Top.B", event=True),)))
    rig.get("Timedout")
    assert rig.machine.state == "Top.B"


def test_push_runs_exit_and_entry_and_pop_returns() -> None:
    rig = Rig(two_states(a=(on("Go", "push", "Top.B", do="a"),), b=(on("Back", "pop", do="b"),)))
    rig.get("Go")
    assert (rig.machine.state, rig.machine.pushed, rig.log) == ("Top.B", ("Top.A",), ["a", "out_a", "in_b"])
    rig.get("Back")
    assert (rig.machine.state, rig.machine.pushed, rig.log) == ("Top.A", (), ["b", "out_b", "in_a"])


def test_pushing_the_active_state_does_not_stack() -> None:
    rig = Rig(two_states(defaults=(on("Go", "push", "Top.B", do="a"),), b=(on("Back", "pop"),)))
    for _ in range(3):
        rig.get("Go")
    assert rig.log == ["a", "out_a", "in_b", "a", "a"]
    rig.get("Back")
    assert rig.machine.state == "Top.A"


def test_push_depth_is_bounded() -> None:
    rig = Rig(two_states(a=(on("Go", "push", "Top.B"),), b=(on("Go", "push", "Top.A"),)))
    for _ in range(10 * MAX_PUSHED):
        rig.get("Go")
    assert len(rig.machine.pushed) == MAX_PUSHED


def test_pop_without_push_keeps_the_state() -> None:
    rig = Rig(two_states(a=(on("Back", "pop", do="a"),)))
    assert rig.get("Back") is TriggerOutcome.TAKEN
    assert (rig.machine.state, rig.log) == ("Top.A", ["a"])


def test_action_can_veto_the_change_of_state() -> None:
    rig = Rig(two_states(a=(on("Go", "simple", "Top.B", do="veto a"),)))
    rig.get("Go")
    assert (rig.machine.state, rig.log) == ("Top.A", ["a"])


def test_a_failing_action_keeps_the_state_and_skips_the_rest() -> None:
    rig = Rig(two_states(a=(on("Go", "simple", "Top.B", do="a fail b"),)))
    assert rig.get("Go") is TriggerOutcome.FAILED
    assert (rig.machine.state, rig.log, rig.counters["action_failed"]) == ("Top.A", ["a"], 1)


def test_a_failing_exit_action_does_not_stop_the_change() -> None:
    top = state(
        "Top", state("A", exit="fail outA", transitions=(on("Go", "simple", "Top.B"),)), state("B"), initial="A"
    )
    rig = Rig(definition("S", top, start="Top.A"))
    rig.get("Go")
    assert (rig.machine.state, rig.log, rig.counters["action_failed"]) == ("Top.B", ["out_a"], 1)


@pytest.mark.parametrize("guard", ["isBroken()", "!isBroken()", "isAllowed() && !isBroken()"])
def test_a_failing_predicate_makes_its_guard_false(guard: str) -> None:
    rig = Rig(two_states(a=(on("Ask", do="a", guard=guard), on("Ask", do="b"))))
    rig.get("Ask")
    assert (rig.log, rig.counters["action_failed"]) == (["b"], 1)


def test_ask_does_not_change_the_state() -> None:
    rig = Rig(two_states(a=(on("Go", "simple", "Top.B", do="a"), on("Ask", do="b"))))
    assert rig.machine.ask(Trigger(CODES["Go"])) is TriggerOutcome.IGNORED
    assert rig.machine.ask(Trigger(CODES["Ask"])) is TriggerOutcome.TAKEN
    assert (rig.machine.state, rig.log) == ("Top.A", ["b"])


# --- several services


def child(*, start: str = "Top.A.Inner") -> model.ServiceDefinition:
    top = state(
        "Top",
        state("A", state("Inner", transitions=(on("Ask", do="b"),)), initial="Inner", exit="b", entry="b"),
        state("B", exit="b"),
        initial="A",
    )
    return definition("Child", top, start=start, parent="S")


def test_states_of_parent_and_child_are_merged_child_first() -> None:
    parent = two_states(a=(on("Ask", do="a"), on("Go", "simple", "Top.B")), b=(on("Back", "simple", "Top.A"),))
    rig = Rig(child(), parent)
    assert rig.machine.state == "Top.A.Inner"
    rig.get("Ask")
    assert rig.log == ["b"]
    rig.get("Go")
    assert rig.log == ["b", "out_a", "in_b"]
    rig.get("Back")
    assert (rig.machine.state, rig.log) == ("Top.A.Inner", ["b", "out_b", "in_a", "b"])


def test_deepest_start_is_used_and_contradictions_are_rejected() -> None:
    assert Rig(child(start="Top"), two_states(start="Top.A")).machine.state == "Top.A.Inner"
    with pytest.raises(ConfigError, match=r"Child starts ReceiveFSM in Top\.A\.Inner, but S in Top\.B"):
        Rig(child(), two_states(start="Top.B"))
    other = definition("Other", state("Top", state("C"), state("D"), initial="C"), start="Top")
    with pytest.raises(
        ConfigError, match=r"starts ReceiveFSM in Top\.A.*in Top\.C: they cannot share it; nest the states"
    ):
        Rig(two_states(start="Top"), other)


def test_all_missing_methods_are_reported_at_once() -> None:
    parent = two_states(
        a=(on("Go", "simple", "Top.Nowhere", do="doThis"), on("Ask", guard="isThere(msg)"), on("Nothing")),
        b=(on("Go", "push"),),
    )
    with pytest.raises(ConfigError) as caught:
        Rig(parent)
    text = str(caught.value)
    for expected in (
        "S, state Top.A: action doThis needs a method of Actions: def do_this(self, ",
        "S, state Top.A: predicate isThere needs a method of Actions: def is_there(self, ",
        "S, state Top.A: goes to Top.Nowhere, which is not a state",
        "S, state Top.A: receives Nothing, which is no message of S or its parents",
        "S, state Top.B: a push transition without an end state",
    ):
        assert expected in text


def test_inherited_hooks_are_no_actions() -> None:
    class Written(Actions):
        def leaving(self) -> None:
            self.log.append("leaving")

    one = definition("Machine", state("A", transitions=(on("Go", do="leaving"),)), start="A")
    for kind, problems in ((Actions, 1), (Written, 0)):
        binder = Binder({one.id: one}, {one.id: kind()}, lambda *_: None)
        binder.states(merge_machines([one])["ReceiveFSM"].root)
        assert len(binder.problems) == problems


def test_private_parent_provides_no_actions() -> None:
    class Private(Actions, private=True):
        pass

    class Own(Service):
        pass

    parent = two_states()
    asks = definition("Child", state("Top", state("A", transitions=(on("Ask", do="a"),))), start="Top", parent="S")
    assert Rig(asks, parent, Child=Own()).get("Ask") is TriggerOutcome.TAKEN
    with pytest.raises(ConfigError, match=r"Child, state Top\.A: action a needs a method of Own: def a\("):
        Rig(asks, parent, Child=Own(), S=Private())


REPORT = ReportTime()


class Sends(Service):
    def __init__(self) -> None:
        self.got: list[tuple[object, ...]] = []
        self.answer: object = None

    def report_time(self, query: str, source: JausID, code: str | None, extra: int = 5) -> ReportTime:
        self.got.append((query, source, code))
        return REPORT

    def report_status(self) -> object:
        return self.answer

    def wrong(self, message: str) -> None: ...

    async def report_later(self) -> None: ...


def sending(*arguments: str) -> model.ServiceDefinition:
    transition = model.Transition(
        trigger="Receive",
        parameters=(model.Parameter("Ask", "msg"),),
        kind="internal",
        actions=(model.ActionCall("transport.Send", arguments),),
    )
    return definition("S", state("Top", transitions=(transition,)), start="Top")


@pytest.mark.parametrize(
    ("arguments", "code", "to_source"),
    [
        (("'ReportTime'", "transportData"), None, True),
        (("'ReportTime'", "msg", "transportData"), None, True),
        (("'ReportTime'", "'A_CODE'"), "A_CODE", False),
        (("'ReportTime'", "'A_CODE'", "'transportData'"), "A_CODE", True),
    ],
)
def test_send_calls_the_report_method_by_name(arguments: tuple[str, ...], code: str | None, to_source: bool) -> None:
    service = Sends()
    rig = Rig(sending(*arguments), S=service)
    rig.get("Ask")
    assert service.got == [("Ask", CLIENT, code)]
    assert rig.sent == [(REPORT, to_source)]


def test_an_unknown_parameter_is_refused() -> None:
    with pytest.raises(ConfigError, match="parameter `message` is not one of msg, query, source, code"):
        Rig(sending("'Wrong'"), S=Sends())


@pytest.mark.parametrize("answer", [REPORT, ReportTime, {"status": 1}, True])
def test_report_of_a_wrong_class_is_an_error(answer: object) -> None:
    service = Sends()
    service.answer = answer
    rig = Rig(sending("'ReportStatus'", "transportData"), S=service)
    assert rig.get("Ask") is TriggerOutcome.FAILED
    assert rig.sent == []


def test_a_coroutine_is_refused() -> None:
    with pytest.raises(ConfigError, match=r"state Top: Send of ReportLater: Sends\.report_later is `async def`"):
        Rig(sending("'ReportLater'", "transportData"), S=Sends())


def test_default_transition_matches_the_remaining_triggers() -> None:
    rig = Rig(
        two_states(
            a=(on("", do="a", event=True), on("Go", do="b")),
            top=(on("Ask", do="c"),),
        )
    )
    assert [rig.get(what) for what in ("Go", "Ask", "Other", "Tick")] == [TriggerOutcome.TAKEN] * 4
    assert rig.log == ["b", "a", "a", "a"]


def test_default_transitions_of_the_machine_come_last() -> None:
    one = two_states(a=(on("Go", do="a"),), defaults=(on("Ask", do="b"),))
    machine = replace(one.behavior.machines[0], default_transitions=(on("", "simple", "Top.B", event=True),))
    rig = Rig(replace(one, behavior=replace(one.behavior, machines=(machine,))))
    rig.get("Go")
    rig.get("Ask")
    assert (rig.log, rig.machine.state) == (["a", "b"], "Top.A")
    rig.get("Other")
    assert rig.machine.state == "Top.B"


@pytest.mark.parametrize(
    ("transitions", "found"),
    [
        ((on("Ask", do="a"),), True),
        ((on("Ask", do="a"), on("Ask", do="b", guard="isAllowed()")), True),
        ((on("Ask", do="b", guard="isAllowed()"), on("Ask", do="a")), False),
        ((on("Ask", do="a b"),), False),
        ((on("Ask"),), False),
        ((on("Other", do="a"),), False),
        ((on("Ask", "simple", "Next", do="a"),), False),
    ],
    ids=["one action", "first wins", "guarded", "two actions", "ignored", "another message", "changes the state"],
)
def test_sole_action_requires_an_unconditional_internal_transition(transitions, found) -> None:
    rig = Rig(definition("S", state("Now", transitions=transitions), state("Next"), start="Now"))
    step = rig.machine.sole_action(CODES["Ask"])
    assert (step is not None) is found
    if step is not None:
        step.call(Trigger(CODES["Ask"]))
        assert rig.log == ["a"]


def test_sole_action_depends_on_the_state() -> None:
    now = state("Now", transitions=(on("Ask", do="a"), on("Go", "simple", "Next")))
    later = state("Next", transitions=(on("Ask", do="b"), on("Back", "simple", "Now")))
    rig = Rig(definition("S", now, later, start="Now"))
    for move, action in (("", "a"), ("Go", "b"), ("Back", "a")):
        if move:
            rig.get(move)
        step = rig.machine.sole_action(CODES["Ask"])
        assert step is not None
        step.call(Trigger(CODES["Ask"]))
        assert rig.log == [action]
