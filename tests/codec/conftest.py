"""A made-up service that uses every kind of field, and strategies that make messages from layouts."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest
from hypothesis import strategies as st

import jauspy
from jauspy.codec import declare as rt
from jauspy.codec.build import load_schema
from jauspy.codec.registry import Registry
from jauspy.codec.scalars import FLOATS, SIZES, limits
from jauspy.schema import model as m


def number(name: str, kind: m.Scalar = "u8", **more: Any) -> m.FixedField:
    return m.FixedField(name=name, type=kind, **more)


def value_set(*ranges: tuple[float, float], **names: int) -> m.ValueSet:
    enums = tuple(m.ValueEnum(value, name) for name, value in names.items())
    return m.ValueSet(enums, tuple(m.ValueRange(low, high) for low, high in ranges))


def counted(kind: m.Unsigned = "u8", low: int = 0, high: int = 255) -> m.Count:
    return m.Count(kind, low, high)


STAMP = m.BitField(
    name="Stamp",
    type="u16",
    optional=True,
    subfields=(
        m.SubField("Low", 0, 2, value_set((0, 5))),
        m.SubField("Mode", 4, 5, value_set(Off=0, On=1)),
        m.SubField("Flag", 15, 15),
    ),
)
DEPTH = m.VariableField(
    name="Depth",
    choices=(
        m.TypeChoice(1, "u16", "meter", m.Scale(-10.0, 10.0), name="Near"),
        m.TypeChoice(2, "i32", "one"),
        m.TypeChoice(7, "f32", "one"),
    ),
)
POINT = m.Record(name="PointRec", fields=(number("X", "i16"), number("Y", "u32", scale=m.Scale(0.0, 1.0))))
OPTIONS = m.Record(
    name="OptionsRec",
    presence="u16",
    fields=(
        number("A", "u32", optional=True, scale=m.Scale(-327.68, 327.67), units="meter"),
        number("B", "u16"),
        STAMP,
        m.VariableString(name="Title", optional=True, count=counted(high=20)),
        number("Kind", optional=True, values=value_set((10, 20), RED=1, GREEN=2)),
        m.FixedString(name="Code", length=6, optional=True),
    ),
)
NOTHING = m.Record(name="NothingRec", fields=())
SHAPE = m.Variant(
    name="Shape",
    tag=counted(high=4),
    arms=(
        POINT,
        NOTHING,
        m.List(name="PointList", count=counted("u16", high=9), element=POINT),
        m.Variant(name="Empty", tag=counted(), arms=()),
        OPTIONS,
    ),
)
EVERYTHING = m.Sequence(
    name="EverythingSeq",
    presence="u32",
    items=(
        OPTIONS,
        m.Record(
            name="ValuesRec",
            fields=(
                number("Ratio", "f64"),
                number("Small", "f32", values=value_set((-1.0, 1.0))),
                DEPTH,
                m.Array(
                    name="Matrix", element=number("Cell", "i8"), dimensions=(m.Dimension("R", 2), m.Dimension("C", 3))
                ),
                m.VariableFormatField(
                    name="Data",
                    formats=(m.Format(0, "JAUS MESSAGE"), m.Format(1, "User defined")),
                    count=counted("u16"),
                ),
                m.VariableLengthField(name="Inner", format="JAUS MESSAGE", count=counted("u32", 2, 400)),
                m.VariableLengthField(name="Blob", format="user defined", count=counted(high=9)),
            ),
        ),
        m.List(name="Shapes", optional=True, count=counted(high=5), element=SHAPE),
        m.Variant(name="Choice", optional=True, tag=counted(), arms=(POINT, NOTHING)),
        m.List(
            name="Rows",
            optional=True,
            count=counted("u16", high=4),
            element=m.List(name="Row", count=counted(), element=POINT),
        ),
        m.Record(
            name="TailRec",
            optional=True,
            fields=(number("Last", "u64"), number("Signed", "i16", scale=m.Scale(-1.0, 1.0))),
        ),
    ),
)
ROUNDED = m.Record(
    name="RoundedRec",
    fields=(
        number("Down", "u16", scale=m.Scale(-6.283185307179586, 1.5707963267948966, "floor")),
        number("Up", "u32", scale=m.Scale(-90.0, 90.0, "ceiling")),
        number("Signed", "i32", scale=m.Scale(3.14, 12.57, "floor")),
    ),
)
MESSAGES = (
    m.MessageDefinition(name="Everything", code=0xF001, is_command=False, body=EVERYTHING),
    m.MessageDefinition(name="Options", code=0xF002, is_command=True, body=OPTIONS),
    m.MessageDefinition(name="Nothing", code=0xF003, is_command=True, body=None),
    m.MessageDefinition(name="Shapes", code=0xF004, is_command=False, body=SHAPE),
    m.MessageDefinition(
        name="Points", code=0xF005, is_command=False, body=m.List(name="P", count=counted(), element=POINT)
    ),
    m.MessageDefinition(name="Rounded", code=0xF006, is_command=False, body=ROUNDED),
)
SERVICE = m.ServiceDefinition(name="Odds", id="urn:example:test:Odds", version="1.0", jsidl="1.1", outputs=MESSAGES)
SCHEMA = m.Schema(services=(SERVICE,))


@pytest.fixture(scope="session")
def odd() -> Registry:
    """The registry of the made-up service."""
    return load_schema(SCHEMA)


@pytest.fixture(scope="session")
def odd_models() -> dict[str, m.MessageDefinition]:
    """The models of its messages."""
    return {message.name: message for message in MESSAGES}


@pytest.fixture(scope="session")
def values_of() -> Any:
    """A function from a layout to a strategy of valid values."""
    return strategy


def strategy(item: rt.Item) -> st.SearchStrategy[Any]:
    match item:
        case rt.Composite():
            return composite(item)
        case rt.Real():
            return st.integers(0, item.scaling.top).map(item.scaling.real)
        case rt.Number():
            return numbers(item.code, item.values)
        case rt.Bits():
            parts = {bit.name: bits(bit) for bit in item.bits}
            reserved = st.integers(0, 2**64).map(lambda raw: raw & item.reserved)
            return st.fixed_dictionaries({**parts, **({"reserved_bits": reserved} if item.reserved else {})}).map(
                lambda values: item.cls(**values)
            )
        case rt.Choice():
            kinds = [
                strategy(number).map(lambda value, index=index: item.cls(choice=index, value=value))  # type: ignore[call-arg]
                for index, number in item.items.items()
            ]
            return st.one_of(kinds)
        case rt.Formatted():
            return st.builds(
                item.cls, format=st.sampled_from(list(item.formats.enum or ())), data=st.binary(max_size=9)
            )
        case rt.Text():
            most = min(item.count.maximum, 12) if item.count else item.length
            text = st.text(st.characters(max_codepoint=255), max_size=most)
            return text if item.count else text.map(lambda value: value.rstrip("\0"))
        case rt.Blob():
            return st.binary(min_size=item.count.minimum, max_size=min(item.count.maximum, max(item.count.minimum, 12)))
        case rt.Repeat():
            return st.lists(strategy(item.item), min_size=item.count.minimum, max_size=min(item.count.maximum, 4))
        case rt.Union():
            return st.one_of([strategy(arm) for arm in item.arms.values()])
        case rt.Grid():
            inner = rt.Grid(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item
            return st.lists(strategy(inner), min_size=item.sizes[0], max_size=item.sizes[0])
        case _:
            raise TypeError(item)


def composite(item: rt.Composite) -> st.SearchStrategy[Any]:
    parts: dict[str, st.SearchStrategy[Any]] = {}
    bits_left = 8 * SIZES[item.presence] if item.presence else 0
    for slot in item.slots:
        kind = strategy(slot.item)
        if slot.optional:
            kind = st.none() | kind if bits_left > 0 else st.none()
            bits_left -= 1
        parts[slot.name] = kind
    if item.undefined:
        parts["reserved_presence"] = st.integers(0, 2**32).map(lambda raw: raw & item.undefined)
    return st.fixed_dictionaries(parts).map(lambda values: item.cls(**values))


def bits(bit: rt.Bit) -> st.SearchStrategy[int]:
    allowed = [value for value in range(bit.mask + 1) if bit.values.allows(value)]
    return st.sampled_from(allowed)


def numbers(code: str, values: rt.Values) -> st.SearchStrategy[Any]:
    if code in FLOATS:
        width = 32 if code == "f" else 64
        low, high = values.intervals[0] if values.intervals else (None, None)
        return st.floats(low, high, allow_nan=False, allow_infinity=False, width=width)
    low_limit, high_limit = limits(code)
    kinds = [st.sampled_from(list(values.enum))] if values.enum else []
    for low, high in values.intervals:
        kinds.append(st.integers(max(math.ceil(low), low_limit), min(math.floor(high), high_limit)))
    return st.one_of(kinds) if kinds else st.integers(low_limit, high_limit)


SERVICE_FILE = """<?xml version="1.0" encoding="UTF-8"?>
<service_def xmlns="urn:jaus:jsidl:{jsidl}" name="{name}" id="{urn}" version="{version}">
  <description>A thing.</description>
  <assumptions/>
  <message_set>
    <input_set>
{messages}    </input_set>
    <output_set/>
  </message_set>
  <internal_events_set/>
  <protocol_behavior is_stateless="true"/>
</service_def>
"""
MESSAGE = """      <message_def name="{message}" message_id="{code}" is_command="true">
        <description>Sets it.</description>
        <header name="Header"><record name="HeaderRec" optional="false">
          <fixed_field name="MessageID" field_type="unsigned short integer" field_units="one" optional="false"/>
        </record></header>
        <body name="Body"><record name="Rec" optional="false">
          <fixed_field name="Level" field_type="{type}" field_units="{units}" optional="false"/>
        </record></body>
        <footer name="Footer"/>
      </message_def>
"""


class Folder:
    """A folder of somebody else's JSIDL."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def add(self, name: str, vendor: str = "acme", **more: str) -> Path:
        """One service with one message, and with those of `again`; what is not said is as in all others."""
        values = {"version": "1.0", "jsidl": "1.1", "message": "SetLevel", "code": "D001", "type": "unsigned byte"}
        values |= {"urn": f"urn:{vendor}:things:{name}", "units": "one", **more}
        path = self.path / f"{vendor}-{name}-{values['version']}.xml"
        names = (values["message"], *more.get("again", "").split())
        messages = "".join(MESSAGE.format(**{**values, "message": each}) for each in names)
        path.write_text(SERVICE_FILE.format(name=name, messages=messages, **values), encoding="utf-8")
        return path

    def load(self) -> Registry:
        return jauspy.load(self.path)


@pytest.fixture
def folder(tmp_path: Path) -> Folder:
    return Folder(tmp_path)
