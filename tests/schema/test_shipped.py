"""The service definitions that ship: they load, are documented, and follow `schemas/README.md`."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest
from lxml import etree

from jauspy.ids import service_set
from jauspy.schema import builtin_paths, load_builtin, model as m

SERVICES = load_builtin().services
ROOT = Path(__file__).parents[2] / "schemas"
EXPERIMENTAL = 0xD000
CONSTANT = re.compile(r"[A-Z][A-Z0-9_]*")

PROFILES = {"iop", "exp"}
"""Sets that take codes of all classes for everything."""

SETS = {"HMI": "hmi"}
"""Sets whose folder is not named as in the ids of their services."""

NAMED_OTHERWISE = {"PlatformSpecificationsService": "PlatformSpecifications"}
"""Services whose id ends with something else than their name."""

TWICE = {"CBRNSensor": {0xF932}, "MilitaryIlluminationService": {0xB514}}
"""Codes that two messages with the same content share."""

every_file = pytest.mark.parametrize("path", builtin_paths(), ids=lambda path: str(path.relative_to(ROOT)))
every_service = pytest.mark.parametrize(
    "service", SERVICES, ids=lambda s: f"{s.id.removeprefix('urn:jaus:jss:')}-{s.version}"
)


def nodes(node: m.Composite | m.Field | None) -> Iterator[m.Node]:
    match node:
        case None:
            return
        case m.Record(fields=inside) | m.Sequence(items=inside) | m.Variant(arms=inside):
            pass
        case m.List(element=element) | m.Array(element=element):
            inside = (element,)
        case _:
            inside = ()
    yield node
    for part in inside:
        yield from nodes(part)


def contents(service: m.ServiceDefinition) -> Iterator[m.Node]:
    for part in (*service.messages, *service.internal_events):
        yield from nodes(part.body)


def value_sets(service: m.ServiceDefinition) -> Iterator[tuple[str, m.ValueSet]]:
    for node in contents(service):
        for holder in (node, *getattr(node, "subfields", ()), *getattr(node, "choices", ())):
            values = getattr(holder, "values", None)
            if values is not None:
                yield f"{node.name}.{holder.name}", values


def test_aeodrs_services_are_included():
    core = {"Transport", "Events", "AccessControl", "Management", "Time", "Liveness", "Discovery", "ListManager"}
    mobility = {"PrimitiveDriver", "VelocityStateSensor", "LocalPoseSensor"}
    found = {(service.id, service.version) for service in SERVICES}
    assert {(f"urn:jaus:jss:core:{name}", "1.1") for name in core} <= found
    assert {(f"urn:jaus:jss:mobility:{name}", "1.1") for name in mobility} <= found


def test_services_are_unique_and_loaded_once():
    assert len({(service.id, service.version) for service in SERVICES}) == len(SERVICES)
    assert load_builtin() is load_builtin()


@every_service
def test_file_is_named_after_the_service(service):
    set_name = service_set(service.id)
    assert Path(service.where.file) == ROOT / SETS.get(set_name, set_name) / service.version / f"{service.name}.xml"
    assert service.id.endswith(f":{NAMED_OTHERWISE.get(service.name, service.name)}")


@every_file
def test_layout(path):
    text = path.read_text(encoding="utf-8")
    assert text.endswith(">\n")
    assert not [line for line in text.splitlines() if len(line) > 120 or line != line.rstrip() or "\t" in line]
    root = etree.parse(path).getroot()
    if path.name == "types.xml":
        assert (root.get("id"), root.get("version")) == (f"urn:jauspy:{path.parent.name}:Types", "1.0")


@every_service
def test_all_definitions_are_documented(service):
    assert service.doc
    assert service.assumptions
    assert [part.name for part in (*service.messages, *service.internal_events) if not part.doc] == []
    for node in contents(service):
        assert node.doc or isinstance(node, m.Record | m.Sequence), f"{node.name} has no interpretation"
        assert all(part.doc for part in getattr(node, "subfields", ())), node.name
        assert "\n" not in node.doc


@every_service
def test_message_codes(service):
    """The upper bits of a code say its class, except for experiments and profiles; codes are unique in a service."""
    assert len({message.name for message in service.messages}) == len(service.messages)
    codes = Counter(message.code for message in service.messages)
    assert {code for code, number in codes.items() if number > 1} == TWICE.get(service.name, set())
    for message in service.messages:
        if message.code < EXPERIMENTAL and service_set(service.id) not in PROFILES:
            is_query, is_report = message.code >> 12 in (2, 3), message.code >> 12 in (4, 5)
            assert not (message.is_command and (is_query or is_report)), message.name
            assert is_query == message.name.startswith("Query"), message.name


@every_service
def test_named_values_are_unique_constants(service):
    for where, values in value_sets(service):
        names = [enum.name for enum in values.enums]
        assert all(CONSTANT.fullmatch(name) for name in names), (where, names)
        assert len(set(names)) == len({enum.value for enum in values.enums}) == len(names), (where, names)


@every_service
def test_sent_messages_and_constants_exist(service):
    """`Send('ConfirmControl', 'NOT_AVAILABLE', ...)` names a message of the lineage and one of its constants."""
    lineage = [service]
    while lineage[-1].inherits_from:
        parent = lineage[-1].inherits_from
        lineage.append(load_builtin().service(parent.id, parent.version))
    outputs = {message.name: message for ancestor in lineage for message in ancestor.outputs}
    for action in actions(service):
        if action.name.rpartition(".")[2] != "Send":
            continue
        name, *arguments = action.arguments
        message = outputs[name.strip("'")]
        enums = {enum.name for node in nodes(message.body) for enum in getattr(getattr(node, "values", 0), "enums", ())}
        quoted = {argument.strip("'") for argument in arguments if argument.startswith("'")}
        assert quoted <= enums | {"currentTime"}, (message.name, quoted)


def actions(service: m.ServiceDefinition) -> Iterator[m.ActionCall]:
    waiting = [state for machine in service.behavior.machines for state in machine.states]
    for state in waiting:
        waiting += state.states
        yield from (*state.entry, *state.exit)
        for transition in (*state.transitions, *state.default_transitions):
            yield from transition.actions
