"""One JSIDL document (AS5684): safe parsing of XML, checks of the grammar, and readers of attributes.

Document type declarations are refused, so nothing in a document can be expanded or fetched. Errors name file and line.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import Final, TypeVar

from lxml import etree
from lxml.etree import _Element as Element

from jauspy.errors import SchemaError
from jauspy.ids import service_set
from jauspy.printable import printable
from jauspy.schema.model import SourceLocation

Value = TypeVar("Value")

MAX_DEPTH: Final = 64
"""Levels of nested elements, and of a message; the deepest public definitions have 13 and 9."""

MAX_ATTRIBUTE: Final = 1000
"""Characters of an attribute; the longest guard of a public definition has 203. Descriptions may be longer."""


def file_of(element: Element) -> str:
    """The path that the document of this element was read from."""
    return element.getroottree().docinfo.URL or "<unknown>"


def line_of(element: Element) -> int:
    """The line of the start tag; 0 if libxml2 has none."""
    line: object = element.sourceline
    return line if isinstance(line, int) else 0


def location(element: Element) -> SourceLocation:
    """File and line of an element, for the model."""
    return SourceLocation(file_of(element), line_of(element))


def wrong(element: Element, message: str) -> SchemaError:
    """The error to raise about this element."""
    return SchemaError(message, file=file_of(element), line=line_of(element))


def suggestion(name: str, known: Iterable[str]) -> str:
    """End of an error about an unknown name: the closest known names, or all if there are few."""
    names = sorted(set(known))
    close = get_close_matches(name, names, n=3, cutoff=0.5)
    if close:
        return f"; did you mean {' or '.join(close)}?"
    if not names:
        return "; there are none"
    return f"; known: {', '.join(names[:12])}{', ...' if len(names) > 12 else ''}"


def give_its_file(urn: str) -> str:
    """Advice for when a definition of another file is missing."""
    return f"give its file, too, or the folder of its set, {service_set(urn)}"


def required(element: Element, name: str) -> str:
    """The text of a mandatory attribute."""
    text = element.get(name)
    if text is None:
        raise wrong(element, f"<{element.tag}> needs the attribute '{name}'")
    return text


_NOT_IN_URIS: Final = re.compile(r'[\s<>"{}|\\^`]')
"""RFC 3986 and RFC 3987 exclude them."""


def identity(element: Element) -> tuple[str, str]:
    """Id (URN) and version, without surrounding blanks, which are insignificant (xsd:anyURI)."""
    id, version = required(element, "id").strip(), required(element, "version").strip()
    if not id or _NOT_IN_URIS.search(id):
        raise wrong(element, f"id: expected a URI, as in urn:example:Battery, got {id!r}")
    return id, version


def child(element: Element, tag: str) -> Element:
    """The mandatory child with this tag."""
    found = element.find(tag)
    if found is None:
        raise wrong(element, f"<{element.tag}> needs <{tag}>")
    return found


def choice(element: Element, name: str, values: Mapping[str, Value], default: str | None = None) -> Value:
    """A mandatory attribute (unless there is a default) with a fixed vocabulary, translated."""
    text = required(element, name) if default is None else element.get(name, default)
    try:
        return values[" ".join(text.split())]
    except KeyError:
        raise wrong(element, f"{name}: expected one of {', '.join(map(repr, values))}, got {text!r}") from None


def whole_number(element: Element, name: str) -> int:
    """A mandatory decimal integer."""
    text = required(element, name)
    try:
        return int(text)
    except ValueError:
        raise wrong(element, f"{name}: expected a whole number, got {text!r}") from None


def bounded(element: Element, name: str, lower: int, upper: int) -> int:
    """A mandatory decimal integer from `lower` to `upper`."""
    number = whole_number(element, name)
    if not lower <= number <= upper:
        raise wrong(element, f"{name}: expected a whole number from {lower} to {upper}, got {number}")
    return number


_TRUTH: Mapping[str, bool] = {"true": True, "1": True, "false": False, "0": False}


def flag(element: Element, name: str) -> bool:
    """An optional xsd:boolean; false by default."""
    return choice(element, name, _TRUTH, default="false")


def prose(element: Element) -> str:
    """The interpretation of an element as one line."""
    return _one_line(element.get("interpretation"))


def text_of(parent: Element, tag: str) -> str:
    """The text of a child element as one line; empty if there is none."""
    return _one_line(parent.findtext(tag))


def _one_line(text: str | None) -> str:
    return printable(" ".join((text or "").split()))


class ChildGroup:
    """Alternative children, and their permitted total number."""

    def __init__(self, names: tuple[str, ...], minimum: int, maximum: int | None) -> None:
        self.names = names
        self.minimum = minimum
        self.maximum = maximum

    def __str__(self) -> str:
        return " or ".join(f"<{name}>" for name in self.names)


def _exactly_one(*names: str) -> ChildGroup:
    return ChildGroup(names, 1, 1)


def _optional(*names: str) -> ChildGroup:
    return ChildGroup(names, 0, 1)


def _at_least_one(*names: str) -> ChildGroup:
    return ChildGroup(names, 1, None)


def _any_number(*names: str) -> ChildGroup:
    return ChildGroup(names, 0, None)


class ElementRule:
    """Required and permitted attributes and children of an element; every element may have an `interpretation`."""

    def __init__(self, required: str, optional: str, *groups: ChildGroup) -> None:
        self.required = tuple(required.split())
        self.attributes = frozenset((*self.required, *optional.split(), "interpretation"))
        self.groups = groups
        self.group_of = {name: index for index, group in enumerate(groups) for name in group.names}


_SIMPLE = (
    "fixed_field",
    "variable_field",
    "bit_field",
    "fixed_length_string",
    "variable_length_string",
    "variable_length_field",
    "variable_format_field",
)
_DECLARED_SIMPLE = tuple(f"declared_{name}" for name in _SIMPLE)
_FIELDS = (*_SIMPLE, "array", *_DECLARED_SIMPLE, "declared_array")
_COMPOSITES = ("record", "list", "variant", "sequence")
_ANY_COMPOSITE = (*_COMPOSITES, *(f"declared_{name}" for name in _COMPOSITES))
_MESSAGES = ("message_def", "declared_message_def")
_PARTS = ("header", "body", "footer")
_VALUES = ("value_set", "declared_value_set")
_KINDS = ("simple", "internal", "push", "pop")
_ACTIONS = _any_number("action", "send_action")
_PART_GROUPS = tuple(_exactly_one(part, f"declared_{part}") for part in _PARTS)

_DECLARABLE = (*_COMPOSITES, "array", *_SIMPLE, *_PARTS, "value_set", "message_def", "event_def")
DECLARED = {f"declared_{name}": name for name in _DECLARABLE}
"""The elements that refer to a declared type, and the element that each must refer to."""

_REFERENCE = ElementRule("name id version", "")
_PART = ElementRule("name", "", _optional(*_ANY_COMPOSITE))
_COUNT = ElementRule("field_type_unsigned", "min_count max_count")

RULES: dict[str, ElementRule] = {
    "service_def": ElementRule(
        "name id version",
        "deprecated",
        _optional("description"),
        _optional("assumptions"),
        _optional("references"),
        _optional("declared_const_set"),
        _optional("declared_type_set"),
        _exactly_one("message_set"),
        _optional("internal_events_set"),
        _optional("protocol_behavior"),
    ),
    "description": ElementRule("", ""),
    "assumptions": ElementRule("", ""),
    "references": ElementRule("", "", _optional("inherits_from"), _any_number("client_of")),
    "inherits_from": _REFERENCE,
    "client_of": _REFERENCE,
    # constants and declared types
    "declared_const_set": ElementRule("name", "id version", _any_number("declared_const_set_ref", "const_def")),
    "declared_const_set_ref": _REFERENCE,
    "const_def": ElementRule("name const_type const_value", "field_units"),
    "declared_type_set": ElementRule(
        "name",
        "id version",
        _any_number("declared_const_set_ref", "declared_type_set_ref", *_DECLARABLE, *DECLARED),
    ),
    "declared_type_set_ref": _REFERENCE,
    **{name: ElementRule("name declared_type_ref", "optional") for name in DECLARED},
    # messages
    "message_set": ElementRule("", "", _exactly_one("input_set"), _exactly_one("output_set")),
    "input_set": ElementRule("", "", _any_number(*_MESSAGES)),
    "output_set": ElementRule("", "", _any_number(*_MESSAGES)),
    "internal_events_set": ElementRule("", "", _any_number("event_def", "declared_event_def")),
    "message_def": ElementRule("name message_id", "is_command deprecated", _optional("description"), *_PART_GROUPS),
    "event_def": ElementRule("name", "deprecated", _optional("description"), *_PART_GROUPS),
    "header": _PART,
    "body": _PART,
    "footer": _PART,
    # composites
    "record": ElementRule("name", "optional", _optional("presence_vector"), _at_least_one(*_FIELDS)),
    "list": ElementRule("name", "optional", _exactly_one("count_field"), _exactly_one(*_ANY_COMPOSITE)),
    "variant": ElementRule("name", "optional", _exactly_one("vtag_field"), _any_number(*_ANY_COMPOSITE)),
    "sequence": ElementRule("name", "optional", _optional("presence_vector"), _at_least_one(*_ANY_COMPOSITE)),
    "presence_vector": ElementRule("field_type_unsigned", ""),
    "count_field": _COUNT,
    "vtag_field": _COUNT,
    # fields
    "array": ElementRule("name", "optional", _exactly_one(*_SIMPLE, *_DECLARED_SIMPLE), _at_least_one("dimension")),
    "dimension": ElementRule("name size", ""),
    "fixed_field": ElementRule("name field_type field_units", "optional", _optional("scale_range", *_VALUES)),
    "bit_field": ElementRule("name field_type_unsigned", "optional", _at_least_one("sub_field")),
    "sub_field": ElementRule("name", "", _exactly_one("bit_range"), _optional(*_VALUES)),
    "bit_range": ElementRule("from_index to_index", ""),
    "variable_field": ElementRule("name", "optional", _exactly_one("type_and_units_field")),
    "type_and_units_field": ElementRule("", "", _at_least_one("type_and_units_enum")),
    "type_and_units_enum": ElementRule("index field_type field_units", "name", _optional("scale_range", *_VALUES)),
    "fixed_length_string": ElementRule("name string_length", "optional"),
    "variable_length_string": ElementRule("name", "optional", _exactly_one("count_field")),
    "variable_length_field": ElementRule("name field_format", "optional", _exactly_one("count_field")),
    "variable_format_field": ElementRule("name", "optional", _exactly_one("format_field"), _exactly_one("count_field")),
    "format_field": ElementRule("", "", _at_least_one("format_enum")),
    "format_enum": ElementRule("index field_format", ""),
    "scale_range": ElementRule("real_lower_limit real_upper_limit integer_function", ""),
    "value_set": ElementRule("", "name offset_to_lower_limit", _at_least_one("value_range", "value_enum")),
    "value_range": ElementRule("lower_limit lower_limit_type upper_limit upper_limit_type", ""),
    "value_enum": ElementRule("enum_index enum_const", ""),
    # protocol behaviour
    "protocol_behavior": ElementRule("", "is_stateless", _any_number("start"), _any_number("state_machine")),
    "start": ElementRule("state_machine_name state_name", ""),
    "state_machine": ElementRule("name", "", _at_least_one("state"), _optional("default_state")),
    "state": ElementRule(
        "name",
        "initial_state",
        _optional("entry"),
        _optional("exit"),
        _any_number("transition"),
        _any_number("default_transition"),
        _any_number("state"),
        _optional("default_state"),
    ),
    "default_state": ElementRule("", "", _any_number("transition", "default_transition")),
    "entry": ElementRule("", "", _ACTIONS),
    "exit": ElementRule("", "", _ACTIONS),
    "transition": ElementRule(
        "name", "", _any_number("parameter"), _optional("guard"), _exactly_one(*_KINDS), _ACTIONS
    ),
    "default_transition": ElementRule("", "", _optional("guard"), _exactly_one(*_KINDS), _ACTIONS),
    "parameter": ElementRule("type value", ""),
    "guard": ElementRule("condition", ""),
    "simple": ElementRule("", "", _optional("end_state")),
    "internal": ElementRule("", ""),
    "push": ElementRule("", "", _exactly_one("end_state"), _optional("simple")),
    "pop": ElementRule("", "transition", _any_number("argument")),
    "end_state": ElementRule("state", ""),
    "action": ElementRule("name", "", _any_number("argument")),
    "send_action": ElementRule("name", "", _any_number("argument")),
    "argument": ElementRule("value", ""),
}


def check(root: Element) -> None:
    """Raise `SchemaError` for the first unknown, missing or surplus element, attribute or child."""
    for _, error in problems(root):
        raise error


def problems(root: Element) -> Iterator[tuple[Element, SchemaError]]:
    """All violations of the grammar, in the order of the file; the content of unknown elements is not checked."""
    waiting = [root]
    while waiting:
        element = waiting.pop()
        rule = RULES[element.tag]  # the parent's rule allows it
        yield from _check_attributes(element, rule)
        yield from _check_children(element, rule)
        waiting += [child for child in reversed(element) if child.tag in rule.group_of]


def is_unexpected(element: Element) -> bool:
    """True for an element that its parent must not have; its content has not been checked."""
    parent = element.getparent()
    return parent is not None and element.tag not in RULES[parent.tag].group_of


def _check_attributes(element: Element, rule: ElementRule) -> Iterator[tuple[Element, SchemaError]]:
    for name in map(str, element.keys()):
        if name not in rule.attributes and not name.startswith("{"):
            known = suggestion(name, rule.attributes)
            yield element, wrong(element, f"<{element.tag}> has an unknown attribute '{name}'{known}")
    for name in rule.required:
        if element.get(name) is None:
            yield element, wrong(element, f"<{element.tag}> needs the attribute '{name}'")


def _check_children(element: Element, rule: ElementRule) -> Iterator[tuple[Element, SchemaError]]:
    counts: Counter[int] = Counter()
    for child in element:
        index = rule.group_of.get(child.tag)
        if index is None:
            known = suggestion(child.tag, rule.group_of)
            yield child, wrong(child, f"unexpected <{child.tag}> in <{element.tag}>{known}")
            continue
        counts[index] += 1
        maximum = rule.groups[index].maximum
        if maximum is not None and counts[index] > maximum:
            yield child, wrong(child, f"<{element.tag}> has more than {maximum} of {rule.groups[index]}")
    for index, group in enumerate(rule.groups):
        if counts[index] < group.minimum:
            yield element, wrong(element, f"<{element.tag}> needs {group}")


NAMESPACES = {"urn:jaus:jsidl:1.0": "1.0", "urn:jaus:jsidl:1.1": "1.1"}
ROOTS = ("service_def", "declared_type_set", "declared_const_set")

_DOCTYPE = re.compile(rb"<!(DOCTYPE|ENTITY)")


def read(data: bytes, path: Path) -> tuple[Element, str]:
    """The root element of a document that follows the grammar (tags without namespace), and its JSIDL version."""
    root, version = parse(data, path)
    check(root)
    return root, version


def parse(data: bytes, path: Path) -> tuple[Element, str]:
    """Same as `read`, but only the root is checked against the grammar."""
    root = _parse(data, path)
    if root.getroottree().docinfo.doctype:  # type: ignore[attr-defined]  # lxml-stubs lacks it
        raise wrong(root, "a document type declaration is not allowed")
    version = NAMESPACES.get(etree.QName(root).namespace or "")
    if version is None:
        raise wrong(root, f"expected a JSIDL document (xmlns {' or '.join(NAMESPACES)}), got <{root.tag}>")
    _refuse_deep(root)
    for element in root.iter():
        _strip_namespace(element)
        _normalize_attributes(element)
    if root.tag not in ROOTS:
        raise wrong(root, f"expected {' or '.join(f'<{tag}>' for tag in ROOTS)} as the root, got <{root.tag}>")
    return root, version


def is_jsidl(data: bytes, path: Path) -> bool:
    """False for well-formed XML of another kind, such as a package manifest; malformed XML counts as JSIDL."""
    try:
        root = _parse(data, path)
    except SchemaError:
        return True
    name = etree.QName(root)
    return name.namespace in NAMESPACES or name.localname in ROOTS


def _refuse_doctype(data: bytes, path: Path) -> None:
    """Raise `SchemaError` for a document type declaration.

    This is done before parsing, because libxml2 expands entities in attributes while it reads. NUL bytes are ignored,
    so that declarations in UTF-16 are found, too.
    """
    plain = data.replace(b"\0", b"")
    found = _DOCTYPE.search(plain)
    if found:
        line = plain.count(b"\n", 0, found.start()) + 1
        raise SchemaError("a document type declaration is not allowed", file=path, line=line)


def _parse(data: bytes, path: Path) -> Element:
    _refuse_doctype(data, path)
    parser = etree.XMLParser(
        resolve_entities=False,
        no_network=True,
        load_dtd=False,
        dtd_validation=False,
        huge_tree=False,
        remove_comments=True,
        remove_pis=True,
    )
    try:
        return etree.fromstring(data, parser, base_url=str(path))
    except etree.XMLSyntaxError as error:
        raise SchemaError(f"not well-formed XML: {error.msg}", file=path, line=error.lineno) from error


_TOO_DEEP: Final = "/".join("*" * MAX_DEPTH)
"""The path from a root to an element that is one level too deep."""


def _refuse_deep(root: Element) -> None:
    """Raise `SchemaError` for elements that are nested too deeply, because the readers are recursive."""
    element = root.find(_TOO_DEEP)
    if element is not None:
        raise wrong(element, f"more than {MAX_DEPTH} levels of nested elements; flatten them")


def _strip_namespace(element: Element) -> None:
    """`{urn:jaus:jsidl:1.1}record` becomes `record`; both versions may be mixed, as public files do."""
    namespace, _, name = str(element.tag).rpartition("}")
    if namespace[1:] not in NAMESPACES:
        raise wrong(element, f"unknown element <{element.tag}>; it is in no JSIDL namespace")
    element.tag = name


def _normalize_attributes(element: Element) -> None:
    """Line breaks become blanks, as XML does with those that are not escaped; nothing else may be invisible."""
    for key in map(str, element.keys()):
        text = element.get(key, "")
        if key == "interpretation":
            continue
        if len(text) > MAX_ATTRIBUTE:
            raise wrong(element, f"{key}: longer than {MAX_ATTRIBUTE} characters")
        if not text.isprintable():
            plain = " ".join(text.split())
            if not plain.isprintable():
                raise wrong(element, f"{key}: {printable(plain)!r} has characters that are not printable")
            element.set(key, plain)
