"""The linter's rules about state machines. What is wrong is in the lines marked `here`."""

from __future__ import annotations

import pytest

HERE = "<!-- here -->"
START = '<start state_machine_name="M" state_name="A"/>'
EVENT = '<event_def name="Timeout"><header name="H"/><body name="B"/><footer name="F"/></event_def>'
TRANSPORT = '<references><inherits_from name="events" id="urn:jaus:jss:core:Events" version="1.1"/></references>'


def machine(inner: str, states: str = "") -> str:
    return f'{START}\n<state_machine name="M">\n<state name="A">\n{inner}\n</state>\n{states}\n</state_machine>'


def transition(name: str, inner: str = "<internal/>", here: str = "", parameter: str = "") -> str:
    wanted = f'<parameter type="{parameter}" value="msg"/>' if parameter else ""
    return f'<transition name="{name}">{here}{wanted}{inner}</transition>'


def goes(state: str) -> str:
    return f'<simple><end_state state="{state}"/></simple>'


def send(message: str) -> str:
    return f'<internal/><action name="events.transport.Send"><argument value="{message}"/></action>'


TRIGGERS = {
    "no such message": (
        transition("events.transport.Receive", here=HERE, parameter="Mgs"),
        "Mgs is not an input of the service or its ancestors; did you mean Msg?; nothing fires this",
    ),
    "no such event": (
        transition("Timedout", here=HERE),
        "no internal event 'Timedout' in the service or its ancestors; did you mean Timeout?; nothing fires this",
    ),
    "an ancestor's message as an event": (
        transition("QueryEvents", here=HERE),
        (
            "QueryEvents is a message of an ancestor: the trigger is Receive with a parameter of type QueryEvents; "
            "only inputs of the service itself are triggers by their name"
        ),
    ),
    "its own message as an event": (transition("Msg"), None),
    "its own output as an event": (
        transition("Out", here=HERE),
        (
            "no internal event 'Out' in the service or its ancestors; known: BroadcastGlobal, BroadcastLocal, "
            "CommandCompleted, CommandExpired, EventError, EventOccurred, Receive, Send, Timeout; nothing fires this"
        ),
    ),
    "its own message": (transition("events.transport.Receive", parameter="Msg"), None),
    "an ancestor's message": (transition("events.transport.Receive", parameter="QueryEvents"), None),
    "any message": (transition("events.transport.Receive"), None),
    "its own event": (transition("Timeout"), None),
    "an ancestor's event": (transition("events.transport.BroadcastLocal"), None),
    "anything else": ("<default_transition><internal/></default_transition>", None),
}


@pytest.mark.parametrize(("inner", "message"), TRIGGERS.values(), ids=TRIGGERS.keys())
def test_triggers(jsidl, inner, message):
    outputs = jsidl.message("", name="Out", code="4444")
    jsidl.service(behavior=machine(inner), events=EVENT, references=TRANSPORT, outputs=outputs)
    assert jsidl.lint("dead-trigger") == ([message] if message else [])


@pytest.mark.parametrize(("parameter", "here"), [("Out", HERE), ("Msg", "")])
def test_transitions_on_outputs(jsidl, parameter, here):
    inner = transition("events.transport.Receive", here=here, parameter=parameter)
    jsidl.service(behavior=machine(inner), references=TRANSPORT, outputs=jsidl.message("", name="Out", code="4444"))
    assert all("Out is an output: only another" in message for message in jsidl.lint("output-trigger"))


def test_triggers_are_not_checked_if_an_ancestor_is_missing(jsidl):
    gone = TRANSPORT.replace("Events", "Gone")
    jsidl.service(behavior=machine(transition("Timedout")), references=gone)
    assert jsidl.lint("dead-trigger") == []


SENDS = {
    "no such output": ("'Ouch'", HERE, 1),
    "an input": ("'Msg'", HERE, 1),
    "its own output": ("'Out'", "", 0),
    "an ancestor's output": ("'ReportEvents'", "", 0),
    "what a variable holds": ("msg", "", 0),
}


@pytest.mark.parametrize(("message", "here", "count"), SENDS.values(), ids=SENDS.keys())
def test_sends(jsidl, message, here, count):
    outputs = jsidl.message("", name="Out", code="4444")
    inner = transition("Timeout", send(message), here)
    jsidl.service(behavior=machine(inner), events=EVENT, references=TRANSPORT, outputs=outputs)
    found = jsidl.lint("unknown-send")
    assert len(found) == count
    assert all("which is not an output of the service or its ancestors" in message for message in found)


RECEIVE = "events.transport.Receive"
GUARD = '<guard condition="isOpen({})"/>'
SHADOWS = {
    "no guard": (
        [transition("T", goes("A")), transition("T", goes("A"), HERE)],
        "the transition on T in line N has no guard and is always taken before this one; give that one",
    ),
    "behind a guard": (
        [transition("T", goes("A")), transition("T", GUARD.format("") + goes("A"), HERE)],
        "the transition on T in line N has no guard",
    ),
    "the same guard": (
        [transition("T", GUARD.format("") + goes("A")), transition("T", GUARD.format(" ") + goes("A"), HERE)],
        "the transition on T in line N has the same guard",
    ),
    "the same message": (
        [transition(RECEIVE, parameter="Msg"), transition(RECEIVE, here=HERE, parameter="Msg")],
        "the transition on Msg in line N has no guard",
    ),
    "any message": (
        [transition(RECEIVE), transition(RECEIVE, here=HERE, parameter="Msg")],
        "the transition on Receive in line N has no guard",
    ),
    "two defaults": (
        [f"<default_transition>{here}<internal/></default_transition>" for here in ("", HERE)],
        "the transition on everything else in line N has no guard",
    ),
    "another trigger": ([transition("T"), transition("U")], None),
    "another message": ([transition(RECEIVE, parameter="Msg"), transition(RECEIVE, parameter="QueryEvents")], None),
    "another guard": (
        [transition("T", GUARD.format("") + goes("A")), transition("T", GUARD.format("msg") + goes("A"))],
        None,
    ),
    "a guard before": ([transition("T", GUARD.format("") + goes("A")), transition("T", goes("A"))], None),
    "a default behind": ([transition("T"), "<default_transition><internal/></default_transition>"], None),
    "another state": ([transition("T"), f'<state name="B">{transition("T")}</state>'], None),
}


@pytest.mark.parametrize(("inner", "message"), SHADOWS.values(), ids=SHADOWS.keys())
def test_shadowed_transitions(jsidl, inner, message):
    jsidl.service(behavior=machine("\n".join(inner)), references=TRANSPORT)
    found = jsidl.lint("shadowed-transition")
    expected = [message.replace("line N", f"line {line - 1}") for _, line in jsidl.marked()]
    assert [each.startswith(start) for each, start in zip(found, expected, strict=True)] == [True] * len(expected)


STATES = {
    "end state": (machine(transition("T", goes("A.B"), HERE)), "end state 'A.B' does not exist"),
    "start state": (machine("").replace(START, START.replace('"A"', '"B"') + HERE), "start state 'B' does not exist"),
    "initial state": (
        machine('<state name="B"/>').replace('<state name="A">', f'<state name="A" initial_state="C">{HERE}'),
        "initial state 'A.C' does not exist; did you mean",
    ),
    "two at once": (
        machine(f"{transition('T', goes('X'), HERE)}\n{transition('T', goes('Y'), HERE)}"),
        "end state 'X' does not exist",
    ),
}


@pytest.mark.parametrize(("behavior", "message"), STATES.values(), ids=STATES.keys())
def test_unknown_states(jsidl, behavior, message):
    jsidl.service(behavior=behavior)
    assert any(message in found for found in jsidl.lint("unknown-state"))


def test_states_of_a_replaced_parent(jsidl):
    """The built-in Management 1.1 has a state Standby; the one beside the service, which replaces it, has not."""
    access = CONTROL.replace('"access"', '"accessControl"')
    fsm = "accessControl.events.transport.ReceiveFSM"
    ready = '<state name="Receiving"><state name="Ready">{}</state></state>'
    start = f'<start state_machine_name="{fsm}" state_name="Receiving.Ready"/>'
    own = ready.format('<state name="Controlled"><state name="Idle"/></state>')
    management = {"name": "Management", "urn": "urn:jaus:jss:core:Management", "version": "1.1"}
    jsidl.service(**management, references=access, behavior=f'{start}<state_machine name="{fsm}">{own}</state_machine>')
    derived = ready.format(f"""<state name="Controlled"><state name="Available" initial_state="Standby">{HERE}
<state name="Ready"/></state></state>""")
    jsidl.service(
        references='<references><inherits_from name="management" id="{urn}" version="{version}"/></references>'.format(
            **management
        ),
        behavior=f"""{start.replace(fsm, f"management.{fsm}")}
<state_machine name="management.{fsm}">{derived}</state_machine>""",
    )
    assert jsidl.lint("unknown-state") == [
        (
            "initial state 'Receiving.Ready.Controlled.Available.Standby' does not exist, and would with the built-in "
            f"Management 1.1, which {jsidl.paths[0]} replaces with other states; use the built-in one, or correct the "
            "path"
        )
    ]


def test_known_states(jsidl):
    inner = f'{transition("T", goes("Receiving"))}\n{transition("T", goes("A.B"))}<state name="B"/>'
    fsm = "events.transport.ReceiveFSM"
    jsidl.service(references=TRANSPORT, behavior=machine(inner).replace('"M"', f'"{fsm}"'))
    assert jsidl.lint("unknown-state") == []


def test_unreachable_states(jsidl):
    inner = f"""{transition("T", goes("A.C"))}
<state name="B"/>
<state name="C"><state name="D"/></state>
<state name="E">{HERE}
<state name="F"/></state>"""
    behavior = machine(inner).replace('<state name="A">', '<state name="A" initial_state="B">')
    jsidl.service(behavior=behavior)
    [message] = jsidl.lint("unreachable-state")
    assert message.startswith("nothing leads to state A.E")


def test_state_reached_only_by_a_derived_service_is_no_finding(jsidl):
    behavior = machine('<state name="B"/><state name="C"/>').replace('name="A"', 'name="A" initial_state="B"')
    jsidl.service(behavior=behavior)
    parent = '<references><inherits_from name="t" id="urn:test:Test" version="1.0"/></references>'
    child = machine(transition("T", goes("A.C"))).replace('"M"', '"t.M"')
    jsidl.service(name="Child", urn="urn:test:Child", references=parent, behavior=child)
    assert jsidl.lint("unreachable-state") == []


WRONG_GUARD = (
    "guard 'isReady(mgs)' names the parameter mgs, and the transition has msg and transportData; did you mean msg?"
)


def guarded(condition: str, here: str, action: str = "") -> str:
    return (
        f'<transition name="events.transport.Receive">{here}<parameter type="Msg" value="msg"/>'
        '<parameter type="Receive.Body.ReceiveRec" value="transportData"/>'
        f'<guard condition="{condition}"/><internal/>{action}</transition>'
    )


@pytest.mark.parametrize(
    ("condition", "message"),
    [
        ("isReady(mgs)", WRONG_GUARD),
        ("isReady(msg) &amp;&amp; !isOpen('mgs') &amp;&amp; isFull(transportData)", None),
        ("isReady()", None),
    ],
)
def test_parameters_of_guards(jsidl, condition, message):
    jsidl.service(behavior=machine(guarded(condition, HERE if message else "")), references=TRANSPORT)
    assert jsidl.lint("guard-parameter") == ([message] if message else [])


CONTROL = '<references><inherits_from name="access" id="urn:jaus:jss:core:AccessControl" version="1.1"/></references>'


@pytest.mark.parametrize(
    ("condition", "references", "found"),
    [
        ("isReady(msg)", CONTROL, True),
        ("isControllingClient(transportData)", CONTROL, False),
        ("isReady(msg)", TRANSPORT, False),
    ],
)
def test_commands_without_control(jsidl, condition, references, found):
    body = machine(guarded(condition, HERE if found else "", '<action name="move"/>'))
    jsidl.service(behavior=body, references=references)
    warnings = jsidl.lint("uncontrolled-command")
    assert [each.startswith("the command Msg is carried out for any client") for each in warnings] == [True] * found
