"""Makes the plan of a schema: names, owners, shared classes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from jauspy.codec.names import (
    attribute,
    attributes,
    class_name,
    members,
    module_alias,
    set_package,
    unique,
    version_package,
)
from jauspy.codec.plan import (
    Allowed,
    BitPlan,
    BlobPlan,
    ClassPlan,
    EnumPlan,
    GridPlan,
    ItemPlan,
    ModulePlan,
    NumberPlan,
    ObjectPlan,
    RepeatPlan,
    SlotPlan,
    TextPlan,
    UnionPlan,
)
from jauspy.codec.planner_sharing import mark_called, share_messages
from jauspy.codec.scaling import Scaling
from jauspy.codec.wire import CODES, FLOATS, SIZES, as_sent, limits
from jauspy.errors import SchemaError
from jauspy.schema.model import (
    Array,
    BitField,
    Composite,
    FixedField,
    FixedString,
    List,
    Message,
    Node,
    Record,
    Scalar,
    Scale,
    Schema,
    Sequence as SequenceNode,
    Service,
    TypeChoice,
    ValueSet,
    VariableField,
    VariableFormatField,
    VariableLengthField,
    VariableString,
    Variant,
)

JAUS_MESSAGE = "jaus message"
_OWN_NAMES = frozenset({"CODE", "NAME", "SERVICE", "VERSION", "IS_COMMAND", "IS_QUERY", "REPORT"})


QUERIES: Final = range(0x2000, 0x4000)
REPORTS: Final = range(0x4000, 0x6000)
ANSWERS: Final = ("Report", "Confirm", "Reject")

MOST_LOOPS: Final = 16
"""Python takes 20 blocks, one inside the other."""


def plan(schema: Schema) -> list[ModulePlan]:
    """The modules of a schema: one per service, and one per set and version for declared types."""
    services = {service.id for service in schema.services}
    shared = SharedTypes(services)
    own: dict[str, ModulePlan] = {}
    for service in schema.services:
        if service.messages:
            # Services of two vendors may have one set, name and version; their URNs differ.
            name = unique(_module_name(service), own.__contains__)
            own[name] = _service_module(service, name, shared)
    modules = list(own.values())
    share_messages(modules, services)
    modules += shared.modules()
    mark_called(modules)
    return modules


def _module_name(service: Service) -> str:
    return f"{set_package(service.id)}.{version_package(service.version)}.{attribute(service.name)}"


def _service_module(service: Service, name: str, shared: SharedTypes) -> ModulePlan:
    module = ModulePlan(name, f"{service.id} {service.version}.", service.id, service.version)
    taken: set[str] = set()
    for message in service.messages:
        if message.name not in taken:
            taken.add(message.name)
            owner = Owner(class_name(message.name), shared)
            made = _located(owner, message)
            made.is_query = asks(message, service)
            module.classes.append(made)
    for made in module.classes:
        if made.is_query:
            made.answer = next((each for each in module.classes if answers(made.message, each.message)), None)
    return module


def _located(owner: Owner, message: Message) -> ClassPlan:
    """The class of a message; a `SchemaError` says where the message is."""
    try:
        return owner.message(message)
    except SchemaError as error:
        file, line = (message.where.file, message.where.line) if message.where else (None, None)
        raise SchemaError(f"message {message.name}: {error.reason}", file=file, line=line) from None


def asks(message: Message, service: Service) -> bool:
    """True for a query: by its id below 6000h (AS5710), else an input that is no command.

    Clients of a service have its outputs as inputs, so names that say what they are go first.
    """
    if message.code < REPORTS.stop:
        return message.code in QUERIES
    if message.is_command or message.name.startswith(ANSWERS):
        return False
    is_input = message in service.inputs and message not in service.outputs
    return is_input or message.name.startswith("Query")


def answers(query: Message | None, report: Message | None) -> bool:
    """True for the report on a query of its service: by its id below 6000h (AS5710), else by its name."""
    if query is None or report is None:
        return False
    if query.code in QUERIES:
        return report.code - query.code == REPORTS.start - QUERIES.start
    return query.name.startswith("Query") and report.name == f"Report{query.name.removeprefix('Query')}"


class SharedTypes:
    """The classes of declared type sets, made when they are first needed."""

    def __init__(self, services: set[str]) -> None:
        self._services = services
        self._modules: dict[str, ModulePlan] = {}
        self._classes: dict[Node, ClassPlan] = {}

    def modules(self) -> list[ModulePlan]:
        """The modules that are needed."""
        return list(self._modules.values())

    def owns(self, node: Node) -> bool:
        """True when a node comes from a type set, not from a service's own declarations.

        A list or variant in an arm of a variant gets a class that is named after its use, so it is never shared.
        """
        return (
            not isinstance(node, (List, Variant))
            and node.declared is not None
            and node.declared.set_id not in self._services
        )

    def use(self, node: Node) -> ClassPlan:
        """The class of a declared node."""
        assert node.declared is not None
        key = _bare(replace(node, name=node.declared.name))
        name = f"{set_package(node.declared.set_id)}.{version_package(node.declared.version)}.types"
        module = self._modules.setdefault(name, ModulePlan(name, "Declared types that several messages share."))
        if key not in self._classes:
            taken = {plan.name for plan in module.classes}
            owner = Owner(unique(class_name(node.declared.name), taken.__contains__), self, module_name=name)
            made = owner.declared(key)
            self._classes[key] = made
            module.classes.append(made)
        return self._classes[key]


def _bare(node: Node) -> Node:
    return replace(node, optional=False, doc="")


class Owner:
    """Builds one class at module level with everything nested in it."""

    def __init__(self, name: str, shared: SharedTypes, module_name: str = "") -> None:
        self.name = name
        self.path = f"{module_alias(module_name)}.{name}" if module_name else name
        self._shared = shared
        self._nested: list[EnumPlan | ClassPlan] = []
        self._known: dict[object, ClassPlan | EnumPlan] = {}
        self._taken: set[str] = set(_OWN_NAMES)
        self._aliases: dict[str, str] = {}

    def message(self, message: Message) -> ClassPlan:
        """The class of a message; its body's fields become its own attributes."""
        made = ClassPlan("message", self.name, self.path, message.doc, message=message)
        if message.body is not None:
            self._fill(made, message.body)
        made.nested = self._nested
        made.aliases = self._aliases
        return made

    def declared(self, node: Node) -> ClassPlan:
        """The class of a declared record, sequence, bit field, variable field or variable-format field."""
        made = self._class_of(node, self.name, self.path)
        made.nested = self._nested
        return made

    def _fill(self, made: ClassPlan, node: Composite) -> None:
        if isinstance(node, (Record, SequenceNode)):
            parts: Sequence[Node] = node.fields if isinstance(node, Record) else node.items
            made.presence = CODES[node.presence] if node.presence else None
        elif isinstance(node, Variant) and not node.arms:
            made.slots = (SlotPlan("tag", "", NumberPlan(CODES[node.tag.type], "one")),)
            return
        else:
            parts = (replace(node, optional=False),)
        made.slots = self._slots(parts, has_presence=made.presence is not None)
        made.loops = 0 if made.presence else max((loops(slot.item) for slot in made.slots), default=0)

    def _slots(self, nodes: Sequence[Node], *, has_presence: bool) -> tuple[SlotPlan, ...]:
        names = attributes((node.name for node in nodes), "reserved_presence")
        return tuple(
            SlotPlan(name, node.name, self._item(node), node.optional and has_presence, node.doc)
            for name, node in zip(names, nodes, strict=True)
        )

    def _item(self, node: Node) -> ItemPlan:
        match node:
            case FixedField():
                return self._number(node.type, node.units, node.scale, node.values, node.name)
            case FixedString():
                return TextPlan(length=node.length)
            case VariableString():
                return TextPlan(count=node.count)
            case VariableLengthField():
                return self._blob(node)
            case Array():
                return _shallow(node, GridPlan(self._item(node.element), tuple(d.size for d in node.dimensions)))
            case List():
                item = self._item(node.element)
                if not minimum(item):
                    raise SchemaError(f"list {node.name} repeats an item without content; the data cannot bound it")
                return _shallow(node, RepeatPlan(node.count, item))
            case Variant() if node.arms:
                return self._union(node)
            case _:
                return ObjectPlan(self._class(node))

    def _blob(self, node: VariableLengthField) -> BlobPlan:
        if node.format.lower() != JAUS_MESSAGE:
            return BlobPlan(node.count, is_message=False, format=node.format)
        # deployed systems send no message as a count of 0, whatever lower limit the definitions give
        return BlobPlan(replace(node.count, minimum=0), is_message=True, format=node.format)

    def _union(self, node: Variant) -> UnionPlan:
        arms: list[ClassPlan] = []
        for arm in node.arms:
            made = self._class(arm)
            if made in arms:
                made = self._nest(replace(arm, declared=None), key=(arm, len(arms)))
            arms.append(made)
        names = attributes((arm.name for arm in node.arms), "code")
        return UnionPlan(CODES[node.tag.type], tuple(arms), tuple(names))

    def _class(self, node: Node) -> ClassPlan:
        if self._shared.owns(node):
            return self._alias(self._shared.use(node))
        return self._nest(node, key=_bare(node))

    def _alias(self, made: ClassPlan) -> ClassPlan:
        """Also offer a shared class under the message that uses it."""
        if made.name not in self._taken:
            self._taken.add(made.name)
            self._aliases[made.name] = made.path
        return made

    def _nest(self, node: Node, key: object) -> ClassPlan:
        known = self._known.get(key)
        if isinstance(known, ClassPlan):
            return known
        name = self._free(class_name(node.name))
        made = self._class_of(node, name, f"{self.path}.{name}")
        self._known[key] = made
        self._nested.append(made)
        return made

    def _free(self, name: str) -> str:
        name = unique(name, self._taken.__contains__)
        self._taken.add(name)
        return name

    def _class_of(self, node: Node, name: str, path: str) -> ClassPlan:
        match node:
            case BitField():
                return self._bits(node, name, path)
            case VariableField():
                return self._choice(node, name, path)
            case VariableFormatField():
                return self._format(node, name, path)
            case Record() | SequenceNode() | List() | Variant():
                made = ClassPlan("composite", name, path, node.doc)
                self._fill(made, node)
                return made
            case _:
                raise SchemaError(f"{node.name}: a {type(node).__name__} cannot stand here")

    def _bits(self, node: BitField, name: str, path: str) -> ClassPlan:
        made = ClassPlan("bits", name, path, node.doc, code=CODES[node.type])
        names = attributes((sub.name for sub in node.subfields), "reserved_bits")
        bits = []
        for attr, sub in zip(names, node.subfields, strict=True):
            mask = (1 << (sub.last - sub.first + 1)) - 1
            allowed = self._allowed(sub.values, sub.name, made.code)
            clipped = tuple((max(low, 0), min(high, mask)) for low, high in allowed.intervals if low <= mask)
            bits.append(BitPlan(attr, sub.first, mask, replace(allowed, intervals=clipped), sub.doc))
        made.bits = tuple(bits)
        return made

    def _choice(self, node: VariableField, name: str, path: str) -> ClassPlan:
        made = ClassPlan("choice", name, path, node.doc)
        names = [(choice.index, choice.name or choice.units) for choice in node.choices]
        made.allowed = Allowed(self._enum(self._part(name, "Choice"), tuple(names)))
        made.choices = tuple((c.index, self._choice_number(c, name)) for c in node.choices)
        return made

    def _part(self, name: str, part: str) -> str:
        """`Choice` in a declared class, `ZPositionChoice` where other classes are beside it."""
        return part if name == self.name else f"{name}{part}"

    def _choice_number(self, choice: TypeChoice, name: str) -> NumberPlan:
        return self._number(choice.type, choice.units, choice.scale, choice.values, f"{name}{class_name(choice.name)}")

    def _format(self, node: VariableFormatField, name: str, path: str) -> ClassPlan:
        made = ClassPlan("format", name, path, node.doc, count=node.count)
        made.allowed = Allowed(self._enum(self._part(name, "Format"), tuple((f.index, f.name) for f in node.formats)))
        made.message_formats = tuple(f.index for f in node.formats if f.name.lower() == JAUS_MESSAGE)
        return made

    def _number(
        self, scalar: Scalar, units: str, scale: Scale | None, values: ValueSet | None, name: str
    ) -> NumberPlan:
        code = CODES[scalar]
        if scale is not None and code not in FLOATS:
            scaling = Scaling(float(scale.lower), float(scale.upper), limits(code)[1], scale.function)
            if not scaling.lower < scaling.upper:
                raise SchemaError(f"{name}: the range {scale.lower}..{scale.upper} is empty")
            return NumberPlan(code, units, scaling)
        return NumberPlan(code, units, None, self._allowed(values, name, code))

    def _allowed(self, values: ValueSet | None, name: str, code: str) -> Allowed:
        if values is None or not (values.enums or values.ranges):
            return Allowed()
        enum = self._enum(class_name(name), tuple((e.value, e.name) for e in values.enums))
        return Allowed(enum, intervals(values, code))

    def _enum(self, name: str, values: tuple[tuple[int, str], ...]) -> EnumPlan | None:
        if not values:
            return None
        known = self._known.get((name, values))
        if isinstance(known, EnumPlan):
            return known
        free = self._free(name)
        made = EnumPlan(free, f"{self.path}.{free}", tuple(members(values).items()))
        self._known[name, values] = made
        self._nested.append(made)
        return made


def intervals(values: ValueSet, code: str) -> tuple[tuple[float, float], ...]:
    """The ranges with both ends included, integers for integer codes."""
    made: list[tuple[float, float]] = []
    for r in values.ranges:
        if code in FLOATS:
            lower, upper = as_sent(r.lower, code), as_sent(r.upper, code)
            low = lower if r.lower_inclusive else math.nextafter(lower, math.inf)
            high = upper if r.upper_inclusive else math.nextafter(upper, -math.inf)
        else:
            low = math.ceil(r.lower) if r.lower_inclusive else math.floor(r.lower) + 1
            high = math.floor(r.upper) if r.upper_inclusive else math.ceil(r.upper) - 1
        if low <= high:
            made.append((low, high))
    return tuple(made)


def loops(item: ItemPlan) -> int:
    """How many loops its code has one inside the other; what has a method of its own begins anew."""
    match item:
        case RepeatPlan():
            return 1 + loops(item.item)
        case GridPlan():
            return len(item.sizes) + loops(item.item)
        case ObjectPlan():
            return item.cls.loops
        case _:
            return 0


def _shallow(node: Node, item: ItemPlan) -> ItemPlan:
    """The item, if Python takes its code."""
    if loops(item) > MOST_LOOPS:
        raise SchemaError(f"'{node.name}' has more than {MOST_LOOPS} lists and arrays one inside the other; flatten it")
    return item


def minimum(item: ItemPlan) -> int:
    """The fewest bytes an item takes."""
    match item:
        case NumberPlan():
            return SIZES[item.code]
        case TextPlan():
            return SIZES[CODES[item.count.type]] if item.count else item.length
        case BlobPlan() | RepeatPlan():
            return SIZES[CODES[item.count.type]]
        case UnionPlan():
            return SIZES[item.code] + min((class_minimum(arm) for arm in item.arms), default=0)
        case GridPlan():
            return minimum(item.item) * math.prod(item.sizes)
        case ObjectPlan():
            return class_minimum(item.cls)


def class_minimum(made: ClassPlan) -> int:
    """The fewest bytes a class takes, without the id bytes of a message."""
    if made.kind == "bits":
        return SIZES[made.code]
    if made.kind == "choice":
        return 1 + min((SIZES[number.code] for _, number in made.choices), default=0)
    if made.kind == "format":
        return 1 + (SIZES[CODES[made.count.type]] if made.count else 0)
    vector = SIZES[made.presence] if made.presence else 0
    return vector + sum(minimum(slot.item) for slot in made.slots if not slot.optional)
