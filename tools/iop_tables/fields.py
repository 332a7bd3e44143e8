"""Composites and fields of tables as elements of JSIDL."""

from __future__ import annotations

import re

from .table import SIZES, Bits, NamedRange, Node
from .xml_text import Xml

NAMES = {
    "i8": "byte", "i16": "short integer", "i32": "integer", "i64": "long integer", "u8": "unsigned byte",
    "u16": "unsigned short integer", "u32": "unsigned integer", "u64": "unsigned long integer",
    "f32": "float", "f64": "long float",
}  # fmt: skip
MOST = {"u8": 2**8 - 1, "u16": 2**16 - 1, "u32": 2**31 - 1}
"""Greatest count of a field of each type; that of four bytes is as in the definitions of the core set."""


def words_of(name: str) -> str:
    """A name as words: `TransmitPower` is `transmit power`."""
    if name.isupper() and "_" in name:
        return name.replace("_", " ").lower()
    parts = re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+", name)
    return " ".join(part if part.isupper() and len(part) > 1 else part.lower() for part in parts)


def sentence_of(name: str) -> str:
    """A name as a sentence, for parts whose name says all."""
    text = words_of(re.sub(r"(Rec|Record|Seq|List|Var|Variant)$", "", name) or name)
    if re.match(r"reserved\b", text):
        return "Sent as 0, ignored when received."
    return text[:1].upper() + text[1:] + "."


def constant(name: str) -> str:
    """A named value as constant: `Point_to_Point` is `POINT_TO_POINT`."""
    split = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name) if not name.isupper() else name
    text = re.sub(r"[^A-Za-z0-9]+", "_", split).strip("_").upper()
    return text if text[:1].isalpha() else f"VALUE_{text}"


def limit(value: float) -> str:
    """A limit as written in definitions."""
    return str(int(value)) if value == int(value) and abs(value) < 1e16 else repr(value)


def _value_set(values: list[NamedRange]) -> Xml:
    named = [
        value
        for value in values
        if value.name and value.low == value.high and not value.name.lower().startswith("reserved")
    ]
    names = [constant(value.name) for value in named]
    result = Xml("value_set", {"offset_to_lower_limit": "false"})
    for value, name in zip(named, names, strict=True):
        unique = name if names.count(name) == 1 else f"{name}_{value.low}"
        result.children.append(Xml("value_enum", {"enum_index": str(value.low), "enum_const": unique}))
    for value in values:
        if value not in named:
            result.children.append(
                Xml(
                    "value_range",
                    {
                        "lower_limit": str(value.low),
                        "lower_limit_type": "inclusive",
                        "upper_limit": str(value.high),
                        "upper_limit_type": "inclusive",
                    },
                )
            )
    return result


def _scale(scale: tuple[float, float]) -> Xml:
    low, high = scale
    limits = {"real_lower_limit": limit(low), "real_upper_limit": limit(high)}
    return Xml("scale_range", {**limits, "integer_function": "round"})


def _count(kind: str, tag: str = "count_field") -> Xml:
    limits = {"min_count": "0", "max_count": str(MOST[kind])}
    return Xml(tag, {"field_type_unsigned": NAMES[kind], **limits})


def _presence(kind: str) -> list[Xml]:
    return [Xml("presence_vector", {"field_type_unsigned": NAMES[kind]})] if kind else []


def _subfield(bits: Bits) -> Xml:
    last = 2 ** (bits.last - bits.first + 1) - 1
    values = [NamedRange(value.low, min(value.high, last), value.name) for value in bits.values]
    inner = [Xml("bit_range", {"from_index": str(bits.first), "to_index": str(bits.last)})]
    if values:
        inner.append(_value_set(values))
    return Xml("sub_field", {"name": bits.name, "interpretation": bits.doc or sentence_of(bits.name)}, inner)


def xml_of(node: Node) -> Xml:
    """A composite or field, written out."""
    common = {"name": node.name, "optional": "true" if node.optional else "false"}
    doc = node.doc or sentence_of(node.name)
    told = {**common, "interpretation": doc}
    inner = [xml_of(child) for child in node.children]
    match node.kind:
        case "record":
            return Xml("record", told if node.doc else common, [*_presence(node.presence), *inner])
        case "sequence":
            return Xml("sequence", told if node.doc else common, [*_presence(node.presence), *inner])
        case "list":
            return Xml("list", told, [_count(node.type), *inner])
        case "variant":
            tag = {"field_type_unsigned": NAMES[node.type], "min_count": "0", "max_count": str(max(len(inner) - 1, 0))}
            return Xml("variant", told, [Xml("vtag_field", tag), *inner])
        case "bits":
            typed = {"name": node.name, "field_type_unsigned": NAMES[node.type], "optional": common["optional"]}
            return Xml("bit_field", {**typed, "interpretation": doc}, [_subfield(bits) for bits in node.subfields])
        case "string":
            return Xml("variable_length_string", told, [_count(node.type)])
        case "fixedstring":
            length = {"string_length": str(node.length)}
            return Xml(
                "fixed_length_string",
                {"name": node.name, **length, "optional": common["optional"], "interpretation": doc},
            )
        case "blob" if node.formats:
            formats = [Xml("format_enum", {"index": str(f.low), "field_format": f.name}) for f in node.formats]
            return Xml("variable_format_field", told, [Xml("format_field", {}, formats), _count(node.type)])
        case "blob" | "message":
            form = {"field_format": "JAUS MESSAGE" if node.kind == "message" else "octets"}
            return Xml(
                "variable_length_field",
                {"name": node.name, **form, "optional": common["optional"], "interpretation": doc},
                [_count(node.type)],
            )
        case "array":
            element = Node("number", f"{node.name}Element", node.type, node.units, node.scale, doc="One value.")
            size = Xml("dimension", {"name": f"{node.name}Dimension", "size": str(node.length)})
            return Xml("array", told, [xml_of(element), size])
        case "variable":
            return Xml(
                "variable_field", told, [Xml("type_and_units_field", {}, [_choice(choice) for choice in node.choices])]
            )
        case _:
            typed = {"name": node.name, "field_type": NAMES[node.type], "field_units": node.units}
            limits = [_scale(node.scale)] if node.scale else [_value_set(node.values)] if node.values else []
            return Xml("fixed_field", {**typed, "optional": common["optional"], "interpretation": doc}, limits)


def _choice(choice: Node) -> Xml:
    name = re.sub(r" (\w)", lambda match: match[1].upper(), choice.units)
    attributes = {"name": name if name != "one" else f"option{choice.index}", "index": str(choice.index)}
    attributes |= {"field_type": NAMES[choice.type], "field_units": choice.units}
    doc = choice.doc or f"In {choice.units}." if choice.units != "one" else choice.doc or "Without a unit."
    return Xml(
        "type_and_units_enum", {**attributes, "interpretation": doc}, [_scale(choice.scale)] if choice.scale else []
    )


assert set(NAMES) == set(SIZES)
