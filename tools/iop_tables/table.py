"""Message tables: one text file a service, transcribed from the public HTML reference of IOP v3.

Two blanks are a level; what follows ` -- ` is the description in our own words, `#` starts a remark:

    service CommsLostPolicyManager
    id urn:jaus:jss:iop:CommsLostPolicyManager
    version 1.1
    inherits AccessControl 1.1
    -- Description of the service.

    event 8D10 CommsLost -- Description of an internal event.

    input C401 SetCommsLostPolicy command -- Description of a message; `output` for what the service sends.
      record NAME [presence u8|u16|u32]
        [optional] TYPE NAME UNITS [scaled LOW HIGH] [values [LOW..HIGH]] -- Interpretation.
          VALUE[..VALUE] NAME                            a named value, or a range
        bits NAME TYPE
          FROM[..TO] NAME [LOW..HIGH]                    a sub-field, and below it its named values
        string NAME count TYPE
        fixedstring NAME length NUMBER
        blob NAME count TYPE [format u8 values VALUE NAME ...]
        variable NAME type_units
          INDEX TYPE UNITS scaled LOW HIGH
        message NAME count TYPE
        array NAME length NUMBER TYPE UNITS [scaled LOW HIGH]
      sequence NAME [presence TYPE]
      list NAME count TYPE [presence TYPE]               the presence vector is that of its element
      variant NAME tag TYPE
        TAG record|sequence|list NAME

    transitions
      loop NAME
        TRIGGER [GUARD] ACTION, ACTION                   END STATE after `->`
    actions
      NAME -- Description.
      NAME sends MESSAGE

TYPE is i8, u8, i16, u16, i32, u32, i64, u64, f32 or f64. Fields directly below a message or list belong to a record
that the reference does not name.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

FOLDER = Path(__file__).parent / "services"
SIZES = {"i8": 1, "u8": 1, "i16": 2, "u16": 2, "i32": 4, "u32": 4, "i64": 8, "u64": 8, "f32": 4, "f64": 8}
COMPOSITES = frozenset({"record", "sequence", "list", "variant"})


class TableError(Exception):
    """A line that is not of the notation."""


@dataclass
class NamedRange:
    """Values of a field from `low` to `high`; `name` is empty for an anonymous range."""

    low: int
    high: int
    name: str = ""


@dataclass
class Bits:
    """A sub-field of a bit field: bits `first` to `last`, and its values."""

    first: int
    last: int
    name: str
    doc: str = ""
    values: list[NamedRange] = field(default_factory=list)


@dataclass
class Node:
    """A composite or a field of a message."""

    kind: str
    """record, sequence, list, variant, number, bits, string, fixedstring, blob, variable, array or message."""
    name: str
    type: str = ""
    """Type of a number, bit field or choice, of the count of a list, string or blob, or of the tag of a variant."""
    units: str = "one"
    scale: tuple[float, float] | None = None
    values: list[NamedRange] | None = None
    subfields: list[Bits] = field(default_factory=list)
    choices: list[Node] = field(default_factory=list)
    length: int = 0
    formats: list[NamedRange] = field(default_factory=list)
    optional: bool = False
    presence: str = ""
    doc: str = ""
    index: int = 0
    """Tag of an arm of a variant, or index of a choice of a variable field."""
    children: list[Node] = field(default_factory=list)


@dataclass
class Message:
    """A message; its body is None when it has no content."""

    code: str
    name: str
    kind: str
    """command, query, report, confirm, response or request."""
    is_input: bool
    doc: str
    body: Node | None = None
    presence: str = ""
    parts: list[Node] = field(default_factory=list)


@dataclass
class Row:
    """A transition: in a loop of the reference, what triggers it, its guard and its actions."""

    loop: str
    trigger: str
    guard: str
    actions: list[str]
    end: str = ""


@dataclass
class Table:
    """A service."""

    name: str
    id: str = ""
    version: str = ""
    inherits: tuple[str, str] = ("", "")
    doc: str = ""
    assumptions: str = ""
    events: list[tuple[str, str]] = field(default_factory=list)
    messages: list[Message] = field(default_factory=list)
    rows: list[Row] = field(default_factory=list)
    sends: dict[str, str] = field(default_factory=dict)
    states: dict[str, str] = field(default_factory=dict)
    """Loops whose state does not follow from their name."""


@dataclass
class _Line:
    number: int
    indent: int
    words: list[str]
    text: str
    doc: str
    below: list[_Line] = field(default_factory=list)


def _lines(path: Path) -> list[_Line]:
    """The lines of the file as a tree."""
    top: list[_Line] = []
    open_lines: list[_Line] = []
    for number, raw in enumerate(path.read_text("utf-8").splitlines(), 1):
        body = raw.rstrip()
        if not body.strip() or body.strip().startswith("#"):
            continue
        indent = (len(body) - len(body.lstrip())) // 2
        text, _, doc = f"{body.strip()} ".partition("-- ")
        line = _Line(number, indent, text.split(), text.strip(), doc.strip())
        del open_lines[indent:]
        if len(open_lines) < indent:
            raise TableError(f"{path}:{number}: indented too far")
        (open_lines[-1].below if open_lines else top).append(line)
        open_lines.append(line)
    return top


def _range(word: str) -> tuple[int, int] | None:
    match = re.fullmatch(r"(-?\d+)(?:\.\.(-?\d+))?", word)
    return None if match is None else (int(match[1]), int(match[2] or match[1]))


def _values(lines: list[_Line]) -> list[NamedRange]:
    found = []
    for line in lines:
        limits = _range(line.words[0])
        if limits is None:
            raise TableError(f"line {line.number}: {line.text!r} is not a value")
        name = "_".join(line.words[1:])
        found.append(NamedRange(*limits, name))
    return found


def _node(line: _Line) -> Node:
    words = list(line.words)
    index = 0
    if words[0].isdigit():
        index = int(words.pop(0))
    optional = words[0] == "optional"
    if optional:
        words.pop(0)
    kind, name = words[0], words[1] if len(words) > 1 else "?"
    node = Node(kind, name, optional=optional, doc=line.doc, index=index)
    if "presence" in words:
        node.presence = words[words.index("presence") + 1]
    if kind in COMPOSITES:
        if kind in ("list", "variant"):
            node.type = words[words.index("count" if kind == "list" else "tag") + 1]
        node.children = [_node(below) for below in line.below]
    elif kind == "bits":
        node.type = words[2]
        for below in line.below:
            limits = _range(below.words[0])
            if limits is None:
                raise TableError(f"line {below.number}: {below.text!r} is not a sub-field")
            values = _values(below.below)
            spans = [span for word in below.words[2:] if (span := _range(word.strip(",;")))]
            values += [NamedRange(*span) for span in spans]
            node.subfields.append(Bits(*limits, below.words[1], below.doc, values))
    elif kind in ("string", "blob", "message"):
        node.type = words[words.index("count") + 1]
        if "format" in words:
            pairs = words[words.index("values") + 1 :]
            node.formats = [NamedRange(int(a), int(a), b) for a, b in zip(pairs[::2], pairs[1::2], strict=True)]
    elif kind == "fixedstring":
        node.length = int(words[words.index("length") + 1])
    elif kind == "array":
        node.length, node.type = int(words[3]), words[4]
        _quantity(node, words[5:], line)
    elif kind == "variable":
        for below in line.below:
            choice = Node("number", "", below.words[1], index=int(below.words[0]), doc=below.doc)
            _quantity(choice, below.words[2:], line)
            node.choices.append(choice)
    elif kind in SIZES:
        node.kind, node.type = "number", kind
        _quantity(node, words[2:], line)
        if line.below:
            node.values = (node.values or []) + _values(line.below)
    else:
        raise TableError(f"line {line.number}: {kind!r} is neither a composite nor a type")
    return node


def _quantity(node: Node, words: list[str], line: _Line) -> None:
    units = []
    while words and words[0] not in ("scaled", "values"):
        units.append(words.pop(0))
    node.units = " ".join(units) or "one"
    if words and words[0] == "scaled":
        node.scale = float(words[1]), float(words[2])
        words = words[3:]
    if words and words[0] == "values":
        node.values = []
        for word in words[1:]:
            limits = _range(word)
            if limits is None:
                raise TableError(f"line {line.number}: {word!r} is not a range")
            node.values.append(NamedRange(*limits))


def _wrapped(message: Message) -> Node | None:
    """The body of a message: fields below it make a record, several composites a sequence."""
    parts = message.parts
    if not parts:
        return None
    stem = re.sub(r"^(Query|Report|Set)(?=[A-Z])", "", message.name) or message.name
    if len(parts) == 1 and parts[0].kind in COMPOSITES and not message.presence:
        return parts[0]
    if all(part.kind not in COMPOSITES for part in parts):
        return Node("record", f"{message.name}Rec", presence=message.presence, children=parts)
    composites = [
        part if part.kind in COMPOSITES else Node("record", f"{part.name}Rec", children=[part]) for part in parts
    ]
    return Node("sequence", f"{stem}Seq", presence=message.presence, children=composites)


def _complete_lists(node: Node) -> None:
    """Name the elements that the reference does not name."""
    for child in node.children:
        _complete_lists(child)
    if node.kind != "list":
        return
    stem = re.sub(r"List$", "", node.name)
    stem = re.sub(r"ies$", "y", stem) if stem.endswith("ies") else re.sub(r"(?<=[a-z])s$", "", stem)
    plain = all(child.kind not in COMPOSITES for child in node.children)
    if plain:
        node.children = [Node("record", f"{stem}Rec", presence=node.presence, children=node.children)]
        node.presence = ""
    elif len(node.children) > 1:
        node.children = [Node("sequence", f"{stem}Seq", presence=node.presence, children=node.children)]
        node.presence = ""
    (element,) = node.children
    if node.presence:
        element.presence, node.presence = node.presence, ""
    if element.name == "?":
        element.name = f"{stem}{'Seq' if element.kind == 'sequence' else 'Rec'}"


def read(path: Path) -> Table:
    """The table in a file; raises `TableError`, with the line, for one that is not of the notation."""
    try:
        return _read(_lines(path))
    except TableError as error:
        raise TableError(f"{path}: {error}") from None
    except (ValueError, IndexError) as error:
        raise TableError(f"{path}: {error!r}") from error


def _read(lines: list[_Line]) -> Table:
    table = Table("")
    for line in lines:
        word = line.words[0] if line.words else ""
        match word:
            case "":
                table.doc = f"{table.doc} {line.doc}".strip()
            case "service":
                table.name = line.words[1]
            case "id":
                table.id = line.words[1]
            case "version":
                table.version = line.words[1]
            case "inherits":
                table.inherits = (line.words[1], line.words[2])
            case "assumes":
                table.assumptions = line.doc
            case "event":
                table.events.append((line.words[2], line.doc))
            case "input" | "output":
                table.messages.append(_message(line))
            case "transitions":
                table.rows = [row for loop in line.below for row in _rows(loop, table)]
            case "actions":
                for action in line.below:
                    if "sends" in action.words:
                        table.sends[action.words[0]] = action.words[2]
            case _:
                raise TableError(f"line {line.number}: {line.text!r}")
    return table


def _message(line: _Line) -> Message:
    words = line.words
    message = Message(words[1], words[2], words[3], words[0] == "input", line.doc)
    if "presence" in words:
        message.presence = words[words.index("presence") + 1]
    message.parts = [_node(below) for below in line.below]
    body = _wrapped(message)
    if body is not None:
        _complete_lists(body)
    message.body = body
    return message


def _rows(loop: _Line, table: Table) -> Iterator[Row]:
    name = loop.words[1]
    if "in" in loop.words:
        table.states[name] = loop.words[loop.words.index("in") + 1]
    for line in loop.below:
        match = re.fullmatch(r"(\w+)\s*\[(.*?)\]\s*(.*?)(?:\s*->\s*(\S+))?", line.text)
        if match is None:
            raise TableError(f"line {line.number}: {line.text!r} is not a transition")
        actions = [action.strip() for action in match[3].split(",") if action.strip()]
        yield Row(name, match[1], match[2].strip(), actions, match[4] or "")


def read_all(folder: Path = FOLDER) -> list[Table]:
    """All tables of a folder, by file name."""
    return [read(path) for path in sorted(folder.glob("*.txt"))]
