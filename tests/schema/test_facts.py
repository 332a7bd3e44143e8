"""Every shipped service equals the facts of the standard, element by element, except for what `correct` lists.

The facts are kept beside the repository; where they are not, the golden vectors still hold the bytes.
docs/adr/0004-public-definitions.md gives the reasons for the corrections.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
import yaml
from tests.helpers.sampling import sampled
from tools.iop_tables.table import read_all

from jauspy.schema import load_builtin, model as m

FACTS = Path(__file__).parents[2].parent / "shared" / "facts" / "jsidl"
LARGEST = {"u8": 2**8 - 1, "u16": 2**16 - 1, "u32": 2**32 - 1, "u64": 2**64 - 1}
CONSTANT = re.compile(r"[A-Z][A-Z0-9_]*")

OURS = {"EventsClient", "AccessControlClient"}
"""Services that the facts only name as parents."""

ELEMENTS = {"SetGlobalPathSegment": "GlobalPathSegmentDriver", "SetLocalPathSegment": "LocalPathSegmentDriver"}
"""Messages that no service of the facts has, and those whose lists are made of them."""

REWRITTEN = {"MissionSpooler"}
"""Services whose guards and actions make no sense as they stand; their states and triggers are those of the facts."""

pytestmark = pytest.mark.skipif(not FACTS.is_dir(), reason=f"no facts in {FACTS}")


# --- the model as plain values --------------------------------------------------------------------------------------


def plain(node):
    """A node of the model as (kind, name, optional, ...)."""
    match node:
        case None:
            return None
        case m.FixedField():
            rest = ("fixed_field", *number(node))
        case m.BitField(type=type_, subfields=parts):
            rest = ("bit_field", type_, [(part.name, part.first, part.last, values(part.values)) for part in parts])
        case m.VariableField(choices=choices):
            rest = ("variable_field", [(choice.index, choice.name, *number(choice)) for choice in choices])
        case m.FixedString(length=length):
            rest = ("fixed_length_string", length)
        case m.VariableString():
            rest = ("variable_length_string", count(node.count))
        case m.VariableLengthField(format=format_):
            rest = ("variable_length_field", format_, count(node.count))
        case m.VariableFormatField(formats=formats):
            names = {choice.index: choice.name for choice in formats}
            rest = ("variable_format_field", names, count(node.count))
        case m.Array(element=element, dimensions=dimensions):
            rest = ("array", plain(element), [(dimension.name, dimension.size) for dimension in dimensions])
        case m.Record(presence=presence, fields=fields):
            rest = ("record", presence, [plain(field) for field in fields])
        case m.List(element=element):
            rest = ("list", count(node.count), plain(element))
        case m.Sequence(presence=presence, items=items):
            rest = ("sequence", presence, [plain(item) for item in items])
        case m.Variant(tag=tag, arms=arms):
            rest = ("variant", count(tag), [plain(arm) for arm in arms])
    return (node.name, node.optional, *rest)


def number(node):
    scale = node.scale and (node.scale.lower, node.scale.upper, node.scale.function)
    return node.type, node.units, scale, values(node.values)


def values(value_set):
    if value_set is None:
        return None
    ranges = [(r.lower, r.lower_inclusive, r.upper, r.upper_inclusive) for r in value_set.ranges]
    return {enum.value: enum.name for enum in value_set.enums}, ranges, value_set.offset_to_lower_limit


def count(limits):
    return limits.type, limits.minimum, limits.maximum


def behavior(service):
    machines = [(machine.name, [state(part) for part in machine.states]) for machine in service.behavior.machines]
    starts = [(start.machine, start.state) for start in service.behavior.start]
    return service.behavior.stateless, starts, machines


def state(node):
    return (
        node.name,
        node.initial,
        [(action.name, list(action.arguments)) for action in node.entry],
        [(action.name, list(action.arguments)) for action in node.exit],
        [transition(part) for part in node.transitions],
        [state(part) for part in node.states],
        [transition(part) for part in node.default_transitions],
    )


def transition(node):
    return (
        node.trigger,
        node.kind,
        [(parameter.type, parameter.name) for parameter in node.parameters],
        "".join(node.guard.split()),
        node.end_state,
        [(action.name, list(action.arguments)) for action in node.actions],
    )


# --- the facts as the same plain values -----------------------------------------------------------------------------


class AnyConstant:
    """Equals every constant: the facts have a phrase there, and we write a name of our own."""

    def __eq__(self, other):
        return isinstance(other, str) and CONSTANT.fullmatch(other) is not None

    __hash__ = None


def fact(node):
    if node is None:
        return None
    match node["kind"]:
        case "fixed_field":
            rest = fact_number(node)
        case "bit_field":
            parts = [(part["name"], *part["bits"], fact_values(part.get("values"))) for part in node["subfields"]]
            rest = (node["type"], parts)
        case "variable_field":
            rest = ([(choice["index"], choice.get("name", ""), *fact_number(choice)) for choice in node["types"]],)
        case "fixed_length_string":
            rest = (node["length"],)
        case "variable_length_string":
            rest = (fact_count(node["count"]),)
        case "variable_length_field":
            rest = (node["format"], fact_count(node["count"]))
        case "variable_format_field":
            rest = (node["formats"], fact_count(node["count"]))
        case "array":
            rest = (fact(node["element"]), [(part["name"], part["size"]) for part in node["dimensions"]])
        case "record":
            rest = (node.get("presence_vector"), [fact(field) for field in node["fields"]])
        case "list":
            rest = (fact_count(node["count"]), fact(node["element"]))
        case "sequence":
            rest = (node.get("presence_vector"), [fact(item) for item in node["items"]])
        case "variant":
            tag = fact_count(node["vtag"])
            empty = [(f"Empty{index}", False, "record", None, []) for index in range(tag[2] + 1)]
            rest = (tag, [fact(arm) for arm in node["arms"]] or empty)
        case kind:
            raise ValueError(kind)
    return (node["name"], node.get("optional", False), node["kind"], *rest)


def fact_number(node):
    scale = node.get("scale")
    limits = scale and (scale["lower"], scale["upper"], scale["function"])
    return node["type"], node["units"], limits, fact_values(node.get("values"))


def fact_values(node):
    if node is None:
        return None
    enums = node.get("enum", {})
    names = list(enums.values())
    kept = {
        value: name if CONSTANT.fullmatch(name) and names.count(name) == 1 else AnyConstant()
        for value, name in enums.items()
    }
    ranges = [
        (r["lower"], r["lower_type"] == "inclusive", r["upper"], r["upper_type"] == "inclusive")
        for r in node.get("range", [])
    ]
    return kept, ranges, node.get("offset_to_lower_limit", False)


def fact_count(node):
    return node["type"], node.get("min", 0), node.get("max", LARGEST[node["type"]])


def fact_behavior(node):
    machines = [(machine["name"], [fact_state(part) for part in machine["states"]]) for machine in node["machines"]]
    starts = [(start["machine"], start["state"]) for start in node["start"]]
    return node.get("stateless", False), starts, machines


def fact_state(node):
    return (
        node["name"],
        node.get("initial"),
        fact_actions(node.get("entry")),
        fact_actions(node.get("exit")),
        [fact_transition(part) for part in node.get("transitions", [])],
        [fact_state(part) for part in node.get("states", [])],
        [fact_transition(part) for part in node.get("default_state", {}).get("transitions", [])],
    )


def fact_transition(node):
    return (
        node["trigger"],
        node["kind"],
        [(parameter["type"], parameter["name"]) for parameter in node.get("params", [])],
        "".join(node.get("guard", "").split()),
        node.get("end_state"),
        fact_actions(node.get("actions")),
    )


def fact_actions(nodes):
    return [(node["name"], node.get("args", [])) for node in nodes or []]


# --- corrections of the facts ---------------------------------------------------------------------------------------


def correct(facts):
    """Make messages, events and behaviour as we write them."""
    for node in dicts((facts["messages"], facts["events"])):
        correct_content(node)
    for message in facts["messages"]:
        for entry in facts["services"]:
            if entry["name"] == ELEMENTS.get(message["name"]):
                entry["inputs"].insert(0, f"{message['code']} {message['name']}")
                message["used_by"].append(f"{entry['id']} v{entry['version']}")
    for entry in facts["services"]:
        inputs = {line.split(" ", 1)[1] for line in entry["inputs"]}
        for machine in entry["behavior"]["machines"]:
            for node in dicts(machine):
                correct_behavior(node, machine["name"], inputs)


def correct_content(node):
    if node.get("name") == "rename_me":  # what an editor puts in for a name that nobody gives
        del node["name"]
    if node.get("name") == "WrenchEffortRec":  # percent in 1.1, the same bytes
        for field in node["fields"]:
            field["units"] = "percent"


def correct_behavior(node, machine, inputs):
    if node.get("trigger") in inputs:  # a message is no event; it comes with one
        node["trigger"] = machine.replace("ReceiveFSM", "Receive")
    if "args" in node and node["name"].endswith(".Send"):
        node["args"] = [argument.replace("'sendReport", "'Report") for argument in node["args"]]
        if node["args"][0] == "msg":  # of NavigationState: the query cannot be the answer
            node["args"][0] = "'ReportNavigation'"
        if node["args"][-1] == "'transportData'":  # a constant by mistake
            node["args"][-1] = "transportData"


def dicts(node) -> Iterator[dict]:
    if isinstance(node, dict):
        yield node
        node = list(node.values())
    if isinstance(node, list | tuple):
        for part in node:
            yield from dicts(part)


def outline(states):
    """What is left of the states of a rewritten service: no guards, no actions of transitions."""
    return [
        (name, initial, entry, leave, [rule[:3] + rule[4:5] for rule in (*own, *defaults)], outline(inner))
        for name, initial, entry, leave, own, inner, defaults in states
    ]


# --- finding a service in the facts ---------------------------------------------------------------------------------


@cache
def document(path: Path):
    facts = yaml.load(path.read_text(encoding="utf-8"), Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    correct(facts)
    return facts


@cache
def candidates(urn: str, version: str):
    """The documents and entries of a service; some services stand in the facts of several sets."""
    wanted = re.compile(rf"^  id: '? *{re.escape(urn)}'?$", re.MULTILINE)
    paths = [path for path in sorted(FACTS.glob("*.yaml")) if wanted.search(path.read_text(encoding="utf-8"))]
    return [
        (document(path), entry)
        for path in paths
        for entry in document(path)["services"]
        if (entry["id"].strip(), entry["version"]) == (urn, version)
    ]


def fact_messages(facts, entry, direction):
    user = f"{entry['id']} v{entry['version']}"
    listed = [tuple(line.split(" ", 1)) for line in entry[direction]]
    found = {(message["code"], message["name"]): message for message in facts["messages"] if user in message["used_by"]}
    return [
        (name, int(code, 16), found[code, name]["is_command"], fact(found[code, name]["body"].get("content")))
        for code, name in listed
    ]


def fact_events(facts, entry):
    found = {event["name"]: event for event in facts["events"] if event["service"] == entry["id"]}
    return [(name, fact(found[name]["body"].get("content"))) for name in entry["events"]]


def messages(found):
    return [(message.name, message.code, message.is_command, plain(message.body)) for message in found]


def reference(node):
    return node and {"name": node.name, "id": node.id, "version": node.version}


TABLES = {(table.id, table.version) for table in read_all()}
"""Services from message tables, which `tests/golden/test_iop_v3.py` compares."""

SERVICES = [
    service
    for service in load_builtin().services
    if not service.id.startswith("urn:jauspy:") and (service.id, service.version) not in TABLES
]
"""Without those that are no part of a standard."""


def name_of(service):
    return f"{service.id.removeprefix('urn:jaus:jss:')}-{service.version}"


@pytest.mark.parametrize("service", sampled([s for s in SERVICES if s.name not in OURS], 50), ids=name_of)
def test_definitions_equal_the_facts(service):
    found = candidates(service.id, service.version)
    assert found, f"the facts have no {service.id} {service.version}"
    facts, entry = found[0]
    assert (service.name, service.jsidl) == (entry["name"], entry["jsidl"])
    assert reference(service.inherits_from) == entry.get("inherits_from")
    assert [reference(client) for client in service.client_of] == entry.get("client_of", [])
    assert messages(service.inputs) == fact_messages(facts, entry, "inputs")
    assert messages(service.outputs) == fact_messages(facts, entry, "outputs")
    assert [(event.name, plain(event.body)) for event in service.internal_events] == fact_events(facts, entry)
    ours, theirs = behavior(service), fact_behavior(entry["behavior"])
    if service.name in REWRITTEN:
        ours, theirs = rewritten(ours), rewritten(theirs)
    assert ours == theirs


def rewritten(found):
    stateless, starts, machines = found
    return stateless, starts, [(name, outline(states)) for name, states in machines]


def test_all_services_of_the_facts_are_shipped():
    wanted = {
        (entry["id"].strip(), entry["version"]) for path in FACTS.glob("*.yaml") for entry in document(path)["services"]
    }
    shipped = {(service.id, service.version) for service in SERVICES}
    assert shipped - wanted == {(f"urn:jaus:jss:core:{name}", "1.1") for name in OURS}
    assert wanted - shipped == set()


def test_all_messages_of_the_facts_belong_to_a_service():
    messages = [message for path in FACTS.glob("*.yaml") for message in document(path)["messages"]]
    assert [message["name"] for message in messages if not message["used_by"]] == []
    assert len({(message["code"], message["name"]) for message in messages}) > 400


@pytest.mark.parametrize("name", ["Events", "AccessControl"])
def test_clients_mirror_their_services(name):
    service, client = (load_builtin().service(f"urn:jaus:jss:core:{end}", "1.1") for end in (name, f"{name}Client"))
    assert (client.inputs, client.outputs) == (service.outputs, service.inputs)
