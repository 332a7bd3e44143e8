"""A component for every shipped service: it takes the bytes of all its messages, and says what its class lacks."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

import pytest
from tests.helpers.sampling import sampled

from jauspy.codec.names import snake
from jauspy.errors import ConfigError
from jauspy.fuzz.messages import MessageMaker, Style, targets
from jauspy.messages import registry
from jauspy.schema import behavior, load_builtin, model
from jauspy.services.service import Service

SCHEMA = load_builtin()
SERVICES = [each for each in SCHEMA.services if each.behavior]
IDS = [f"{each.id.rpartition(':')[0].rpartition(':')[2]}-{each.name}-{each.version}" for each in SERVICES]
QUERY_STATUS = ("urn:jaus:jss:core:Management", "1.1", 0x2002)
REPORTS = {snake(message.name) for each in SERVICES for message in each.outputs}
TARGETS = {(each.cls.SERVICE, each.cls.VERSION, each.cls.CODE): each for each in targets(registry, SCHEMA)}


class Willing(Service, private=True):
    """Has a method for everything, does and sends nothing and allows everything; lends nothing to those who inherit."""

    def __getattr__(self, name: str):
        return lambda: None if name in REPORTS else True


class Bare(Service):
    """Has no method of its own."""


def lineage(definition: model.ServiceDefinition) -> list[model.ServiceDefinition]:
    found = [definition]
    while (parent := found[-1].inherits_from) is not None:
        found.append(SCHEMA.service(parent.id, parent.version))
    return found


def instance(kind: type[Service], definition: model.ServiceDefinition) -> Service:
    return type(definition.name, (kind,), {}, urn=definition.id, version=definition.version)()


def named(definition: model.ServiceDefinition) -> Iterator[tuple[str, str]]:
    """(state, method) for everything that the behaviour of a definition asks for."""
    waiting = [(state, state.name) for machine in definition.behavior.machines for state in machine.states]
    while waiting:
        state, path = waiting.pop()
        waiting += [(each, f"{path}.{each.name}") for each in state.states]
        transitions = state.transitions + state.default_transitions
        for action in (*state.entry, *state.exit, *(action for each in transitions for action in each.actions)):
            name = action.name.rpartition(".")[2]
            yield path, snake(action.arguments[0].strip("'\"") if name == "Send" else name)
        for each in transitions:
            if each.guard.strip():
                yield from (
                    (path, snake(call.name.rpartition(".")[2])) for call in behavior.calls(behavior.parse(each.guard))
                )


@pytest.mark.parametrize("definition", sampled(SERVICES, 50), ids=IDS)
def test_host_of_every_service_starts_and_accepts_all_messages(make, definition) -> None:
    definitions = lineage(definition)
    rig = make(*(instance(Willing, each) for each in definitions), schema=SCHEMA)
    for each in definitions:
        for message in each.inputs:
            for style in (Style.SHORTEST, Style.FULL):
                target = TARGETS[each.id, each.version, message.code]
                payload = MessageMaker(Random(message.code), style, [TARGETS[QUERY_STATUS]]).message(target)
                rig.host.receive(payload, rig.ID.parse("42.1.1"), 0.0)
    inputs = sum(len(each.inputs) for each in definitions)
    assert rig.host.counters["received"] == 2 * inputs
    assert {name for name in rig.host.counters if name.startswith(("action_failed", "malformed", "unknown"))} == set()


@pytest.mark.parametrize("definition", sampled(SERVICES, 50), ids=IDS)
def test_missing_methods_are_an_error_at_start_up(make, definition) -> None:
    own, *ancestors = lineage(definition)
    wanted = set(named(definition))
    services = [instance(Bare, own), *(instance(Willing, each) for each in ancestors)]
    if not wanted:
        make(*services, schema=SCHEMA)
        return
    with pytest.raises(ConfigError) as error:
        make(*services, schema=SCHEMA)
    lines = str(error.value).splitlines()
    for state, method in wanted:
        assert any(
            f"{definition.name}, state {state}: " in line
            and f"needs a method of {definition.name}: def {method}(" in line
            for line in lines
        ), (state, method)


@pytest.mark.parametrize(
    "version", ["core-1.1", "mobility-1.1", "manipulator-2.0", "environmentSensing-2.0", "ugv-1.0"]
)
def test_services_of_a_set_share_their_parents(make, version) -> None:
    name, _, number = version.partition("-")
    chosen = [each for each in SERVICES if each.id.split(":")[-2] == name and each.version == number]
    chosen = [each for each in chosen if not each.name.endswith("Client")]
    everything = {each.id: each for one in chosen for each in lineage(one)}
    rig = make(*(instance(Willing, each) for each in everything.values()), schema=SCHEMA)
    assert {definition.id for definition in rig.host.definitions.values()} == set(everything)
    assert rig.host.state.count(".") >= 3
