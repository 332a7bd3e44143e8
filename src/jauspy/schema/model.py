"""The immutable model of JSIDL definitions (SAE AS5684), made by the loader.

Everything here is a frozen value. References between files are already resolved: a `Record` from a declared type has
the content of the declaration, and `declared` names the declaration.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, TypeAlias

Scalar: TypeAlias = Literal["u8", "u16", "u32", "u64", "i8", "i16", "i32", "i64", "f32", "f64"]
Unsigned: TypeAlias = Literal["u8", "u16", "u32", "u64"]


@dataclass(frozen=True, slots=True)
class SourceLocation:
    """Place of a definition in a file, for error messages."""

    file: str
    line: int


@dataclass(frozen=True, slots=True)
class DeclaredType:
    """Names a declared type: the id (URN) and version of its type set or service, and its name there."""

    set_id: str
    version: str
    name: str


@dataclass(frozen=True, slots=True)
class Scale:
    """A real value sent as an integer: real = lower + raw * (upper - lower) / (2**bits - 1)."""

    lower: float
    upper: float
    function: Literal["round", "floor", "ceiling"] = "round"


@dataclass(frozen=True, slots=True)
class ValueEnum:
    """One named value of a value set."""

    value: int
    name: str


@dataclass(frozen=True, slots=True)
class ValueRange:
    """One allowed interval of a value set."""

    lower: float
    upper: float
    lower_inclusive: bool = True
    upper_inclusive: bool = True


@dataclass(frozen=True, slots=True)
class ValueSet:
    """The allowed values of a number: names and intervals; empty means any.

    `offset_to_lower_limit` is kept as written; the loader accepts it only where the lowest value is 0,
    so that it has no effect.
    """

    enums: tuple[ValueEnum, ...] = ()
    ranges: tuple[ValueRange, ...] = ()
    offset_to_lower_limit: bool = False


@dataclass(frozen=True, slots=True)
class Count:
    """A count on the wire: its unsigned type and its limits."""

    type: Unsigned
    minimum: int
    maximum: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Node:
    """Common attributes of fields and composites."""

    name: str
    optional: bool = False
    doc: str = ""
    declared: DeclaredType | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class FixedField(Node):
    """A number; scaled to a real when `scale` is set."""

    type: Scalar
    units: str = "one"
    scale: Scale | None = None
    values: ValueSet | None = None


@dataclass(frozen=True, slots=True)
class SubField:
    """Bits `first`..`last` (inclusive, 0 is the least significant) of a bit field."""

    name: str
    first: int
    last: int
    values: ValueSet | None = None
    doc: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class BitField(Node):
    """An unsigned integer with sub-fields; other bits are reserved."""

    type: Unsigned
    subfields: tuple[SubField, ...]


@dataclass(frozen=True, slots=True)
class TypeChoice:
    """One alternative of a variable field: the index byte on the wire, then a number of this type."""

    index: int
    type: Scalar
    units: str = "one"
    scale: Scale | None = None
    values: ValueSet | None = None
    name: str = ""
    doc: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class VariableField(Node):
    """A u8 index that chooses type and units, then the number."""

    choices: tuple[TypeChoice, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class FixedString(Node):
    """A string of exactly `length` bytes, NUL padded."""

    length: int


@dataclass(frozen=True, slots=True, kw_only=True)
class VariableString(Node):
    """A counted string."""

    count: Count


@dataclass(frozen=True, slots=True, kw_only=True)
class VariableLengthField(Node):
    """Counted bytes of one format, such as `JAUS MESSAGE`, `JPEG` or `user defined`."""

    format: str
    count: Count


@dataclass(frozen=True, slots=True)
class Format:
    """One format a variable-format field may carry."""

    index: int
    name: str


@dataclass(frozen=True, slots=True, kw_only=True)
class VariableFormatField(Node):
    """A u8 format index, a count, then the bytes."""

    formats: tuple[Format, ...]
    count: Count


SimpleField: TypeAlias = (
    FixedField | BitField | VariableField | FixedString | VariableString | VariableLengthField | VariableFormatField
)


@dataclass(frozen=True, slots=True)
class Dimension:
    """One dimension of an array; the first varies slowest."""

    name: str
    size: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Array(Node):
    """A fixed number of equal fields."""

    element: SimpleField
    dimensions: tuple[Dimension, ...]


Field: TypeAlias = SimpleField | Array


@dataclass(frozen=True, slots=True, kw_only=True)
class Record(Node):
    """Fields one after the other; `presence` is the type of the presence vector, bit i = i-th optional field."""

    fields: tuple[Field, ...]
    presence: Unsigned | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class List(Node):
    """A counted repetition of one composite."""

    count: Count
    element: Composite


@dataclass(frozen=True, slots=True, kw_only=True)
class Variant(Node):
    """A tag (index of the arm, from 0), then that arm. An arm without content is an empty `Record`."""

    tag: Count
    arms: tuple[Composite, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Sequence(Node):
    """Composites one after the other; `presence` as for records."""

    items: tuple[Composite, ...]
    presence: Unsigned | None = None


Composite: TypeAlias = Record | List | Variant | Sequence


@dataclass(frozen=True, slots=True, kw_only=True)
class MessageDefinition:
    """A message: two bytes of `code`, then `body` (None if there is no body)."""

    name: str
    code: int
    is_command: bool
    body: Composite | None
    doc: str = ""
    declared: DeclaredType | None = None
    where: SourceLocation | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class InternalEvent:
    """An input of the state machine that does not come from the wire, such as `Timedout`."""

    name: str
    body: Composite | None = None
    doc: str = ""


# --- protocol behaviour -------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter of a trigger: its type (a message or a record) and the name guards and actions use."""

    type: str
    name: str


@dataclass(frozen=True, slots=True)
class ActionCall:
    """A named action with its arguments; a literal keeps its single quotes, as in `'ReportStatus'`."""

    name: str
    arguments: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Transition:
    """A transition: `kind` is the kind of change, `end_state` (dotted path) the target.

    A simple transition without `end_state` stays where it is. An empty `trigger` (JSIDL's `default_transition`)
    stands for every trigger that no other transition of the state handles.
    """

    trigger: str
    kind: Literal["simple", "internal", "push", "pop"]
    parameters: tuple[Parameter, ...] = ()
    guard: str = ""
    end_state: str | None = None
    actions: tuple[ActionCall, ...] = ()
    where: SourceLocation | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class State:
    """A state, its nested states, and the default transitions for all of them."""

    name: str
    initial: str | None = None
    entry: tuple[ActionCall, ...] = ()
    exit: tuple[ActionCall, ...] = ()
    transitions: tuple[Transition, ...] = ()
    states: tuple[State, ...] = ()
    default_transitions: tuple[Transition, ...] = ()
    where: SourceLocation | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class StateMachine:
    """A state machine; its name contains the path to the parent that it extends (`events.transport.ReceiveFSM`)."""

    name: str
    states: tuple[State, ...]
    default_transitions: tuple[Transition, ...] = ()


@dataclass(frozen=True, slots=True)
class Start:
    """The state (dotted path) in which a machine starts."""

    machine: str
    state: str
    where: SourceLocation | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Behavior:
    """The protocol behaviour of a service."""

    machines: tuple[StateMachine, ...]
    start: tuple[Start, ...] = ()
    stateless: bool = False


# --- services ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Reference:
    """A reference to another service: the local name used in dotted paths, and which service that is."""

    name: str
    id: str
    version: str

    @property
    def key(self) -> tuple[str, str]:
        """Id and version, as `ServiceDefinition.key`."""
        return self.id, self.version


@dataclass(frozen=True, slots=True, kw_only=True)
class ServiceDefinition:
    """One service definition. `id` is its URN, as in `urn:jaus:jss:mobility:PrimitiveDriver`."""

    name: str
    id: str
    version: str
    jsidl: str
    doc: str = ""
    assumptions: str = ""
    inherits_from: Reference | None = None
    client_of: tuple[Reference, ...] = ()
    inputs: tuple[MessageDefinition, ...] = ()
    outputs: tuple[MessageDefinition, ...] = ()
    internal_events: tuple[InternalEvent, ...] = ()
    behavior: Behavior | None = None
    where: SourceLocation | None = None

    def __hash__(self) -> int:
        return hash((self.id, self.version))  # a service has thousands of parts

    @property
    def key(self) -> tuple[str, str]:
        """Id and version; unique in a schema."""
        return self.id, self.version

    @property
    def messages(self) -> tuple[MessageDefinition, ...]:
        """Inputs, then outputs."""
        return self.inputs + self.outputs


@dataclass(frozen=True, slots=True, kw_only=True)
class Schema:
    """All services that were loaded together, in the order of their ids and versions."""

    services: tuple[ServiceDefinition, ...]
    files: tuple[str, ...] = field(default=(), compare=False)
    """The user's files that they were loaded from, sets of types included; built-in ones are not listed."""

    def service(self, id: str, version: str | None = None) -> ServiceDefinition:
        """The service with this URN (newest when `version` is None); `KeyError` when there is none."""
        found = [s for s in self.services if s.id == id and version in (None, s.version)]
        if not found:
            raise KeyError(f"{id} {version or ''}".strip())
        return max(found, key=lambda s: tuple(int(part) for part in s.version.split(".")))
