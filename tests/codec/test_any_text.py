"""Any text anywhere in a definition: it is refused in one line, or what is made of it are declarations that work."""

from __future__ import annotations

import sys
import tempfile
from importlib import import_module
from inspect import getdoc
from itertools import count
from pathlib import Path

import pytest
from hypothesis import example, given, settings, strategies as st
from tests.helpers.definitions import (
    HOLES,
    assert_declares_only,
    assert_is_stub,
    assert_loads_only,
    assert_types_only,
    definition,
    loaded,
)
from tests.helpers.stubs import assert_agree

import jauspy
from jauspy.cli.new.component import package
from jauspy.codec.codegen import identifier
from jauspy.codec.names import attribute, class_name, constant, method, set_package, version_package
from jauspy.codec.registry import MessageEntry
from jauspy.codec.source import generate
from jauspy.codec.stubs import make_stubs
from jauspy.errors import JausError, SchemaError
from jauspy.schema.loader import load_beside_builtin, load_own

_FRAGMENTS = (
    *('"', "'", '"""', "'''", "\\", "{", "}", "%s", "#", "\n", "\r", "\t", "\x85", "\u2028", "\u202e", "\xa0", "\x9b"),
    *(
        "²",
        "ﬁ",
        "ß",
        "ŉ",
        "ΐ",
        "·",
        "ᄀ",
        "ᅡ",
        "\u0301",
        "\U0001d7cf",
        "٣",
        "ⅷ",
        "class",
        "None",
        "self",
        "registry",
        "types",
    ),
    *("IntEnum", "Any", "jd", "__init__", "mro", "REPORT", "layout", "a.b", "1", "_", ":", "-", " "),
)
_XML = st.characters(exclude_categories=["Cs"], exclude_characters=[*map(chr, range(32)), "\ufffe", "\uffff"])
_TEXTS = st.lists(st.one_of(st.sampled_from(_FRAGMENTS), _XML), max_size=6).map("".join)
_numbers = count()


@pytest.mark.slow
@given(st.dictionaries(st.sampled_from(HOLES), _TEXTS, min_size=1, max_size=3))
@settings(max_examples=30)
@example(dict.fromkeys(["field", "message", "service", "type", "enum", "action"], "²"))
@example({"doc": '"', "units": '"', "format": '"', "literal": "\\"})
@example({"urn": ":class:2d"})
@example({"urn": ":registry:x", "service": "ŉ", "message": "ΐ"})
@example({"version": "²"})
@example({"number": "9" * 400})
def test_any_text_anywhere(texts: dict[str, str]) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder, module = Path(name), f"any_text_{next(_numbers)}"
        file = folder / "any.xml"
        file.write_text(definition(**texts), encoding="utf-8")
        registry = loaded(file)
        if registry is None:
            return
        stubs = make_stubs(load_own([file]), [file.name])
        assert_loads_only(stubs.module)
        assert_types_only(stubs.stub)
        assert_agree(stubs, folder)
        for path, source in generate(load_own([file]), module, "jauspy.messages").items():
            assert_declares_only(source, module)
            target = folder / module / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(source, encoding="utf-8")
        try:
            sys.path.insert(0, name)
            written = import_module(module).registry
            for entry in registry.entries:
                if (entry.service, entry.version) in registry.files:
                    _assert_same(entry, next(each for each in written.entries_of(entry.code) if each.cls == entry.cls))
        finally:
            sys.path.remove(name)
            for each in [each for each in sys.modules if each.split(".")[0] == module]:
                del sys.modules[each]


def _assert_same(one: MessageEntry, other: MessageEntry) -> None:
    """Both decode and encode alike, on the fast path and on the slow one."""
    data = one.code.to_bytes(2, "little") + bytes(40)
    made, _ = one.load().decode(data, strict=False)
    again, _ = other.load().decode(data, strict=False)
    assert made.to_dict() == again.to_dict()
    assert repr(made) == repr(again)
    assert made.encode(strict=False) == again.encode(strict=False)
    assert (made.NAME, made.SERVICE, getdoc(made)) == (again.NAME, again.SERVICE, getdoc(again))


def _component(file: Path) -> dict[str, str | bytes]:
    schema = load_beside_builtin([file])
    own = next(each for each in schema.services if each.where and each.where.file == str(file))
    return package("it", own, schema, file, jauspy.JausID(1, 1, 1))


@pytest.mark.slow
@given(st.dictionaries(st.sampled_from(HOLES), _TEXTS, min_size=1, max_size=3))
@settings(max_examples=20)
@example(dict.fromkeys(["message", "service", "event", "action"], '"""\nx\n'))
@example({"action": "class", "event": "²", "service": "DEFINITIONS"})
def test_any_text_in_a_component(texts: dict[str, str]) -> None:
    """Its methods do nothing, whatever things are called, and all its files are Python."""
    with tempfile.TemporaryDirectory() as name:
        file = Path(name, "any.xml")
        file.write_text(definition(**texts), encoding="utf-8")
        files, problem = {}, ""
        try:
            files = _component(file)
        except JausError as error:
            problem = str(error)
    assert problem.isprintable()
    if files:
        assert_is_stub(str(files["services.py"]))
        assert_loads_only(str(files["messages.py"]))
        assert_types_only(str(files["messages.pyi"]))
        for name in ("__init__.py", "__main__.py", "test_it.py"):
            compile(files[name], name, "exec")


@given(st.text())
@example("ŉ")
@example("²")
@example("\u0301a")
def test_names_are_identifiers(name: str) -> None:
    for make in (attribute, class_name, constant, method, set_package, version_package):
        assert identifier(make(name)) == make(name)


_TYPE_SET = '<declared_type_set_ref name="core" id="urn:jauspy:core:Types" version="1.0"/>'
_EMPTY_BODY = '<body name="Body"/>'
_RECORD = (
    "<record name='Leaf'><fixed_field name='Value' field_type='unsigned byte' field_units='one' optional='false'/>"
    "</record>"
)


def _written(folder: Path, body: str, types: str = "") -> Path:
    """The definition with this as the content of its query, and these declared types."""
    file = folder / "own.xml"
    text = definition().replace(_EMPTY_BODY, f"<body name='Body'>{body}</body>", 1)
    file.write_text(text.replace(_TYPE_SET, f"{_TYPE_SET}{types}"), encoding="utf-8")
    return file


def _nested(levels: int, start: str, end: str) -> str:
    return "".join(start.format(level) for level in range(levels)) + _RECORD + end * levels


def _declared(levels: int, uses: int) -> str:
    """Types that each use the one before it, this many times."""
    used = "".join(f"<declared_sequence name='P{use}' declared_type_ref='T{{0}}'/>" for use in range(uses))
    types = (f"<sequence name='T{level + 1}'>{used.format(level)}</sequence>" for level in range(levels))
    return f"<sequence name='T0'>{_RECORD}</sequence>{''.join(types)}"


_CONTAINERS = {
    "sequence": "<sequence name='S{}'>",
    "variant": "<variant name='S{}'><vtag_field field_type_unsigned='unsigned byte' min_count='0' max_count='0'/>",
    "list": "<list name='S{}'><count_field field_type_unsigned='unsigned byte' min_count='0' max_count='9'/>",
}


@pytest.mark.parametrize(("tag", "start"), _CONTAINERS.items())
def test_deep_messages_are_refused(tmp_path: Path, tag: str, start: str) -> None:
    file = _written(tmp_path, _nested(200, start, f"</{tag}>"))
    with pytest.raises(SchemaError, match="more than 64 levels of nested elements; flatten them"):
        load_own([file])


@pytest.mark.parametrize(
    ("levels", "uses", "reason"),
    [
        (70, 1, "'T62' has more than 64 nested levels"),
        (5000, 1, "'T62' has more than 64 nested levels"),
        (40, 2, "has more than 20000 fields; divide it into several messages"),
    ],
)
def test_types_that_multiply_are_refused(tmp_path: Path, levels: int, uses: int, reason: str) -> None:
    file = _written(tmp_path, f"<declared_sequence name='All' declared_type_ref='T{levels}'/>", _declared(levels, uses))
    with pytest.raises(SchemaError, match=reason):
        load_own([file])


def test_types_that_are_declared_backwards_are_refused(tmp_path: Path) -> None:
    types = _declared(3000, 1)
    backwards = "".join(reversed(types.replace("</sequence><seq", "</sequence>\n<seq").splitlines()))
    file = _written(tmp_path, "<declared_sequence name='All' declared_type_ref='T9'/>", backwards)
    with pytest.raises(SchemaError, match="refers to declared types too deeply"):
        load_own([file])


def test_messages_as_deep_as_is_allowed_work(tmp_path: Path) -> None:
    file = _written(tmp_path, "<declared_sequence name='All' declared_type_ref='T61'/>", _declared(61, 1))
    registry = jauspy.load(file)
    data = b"\x12\xd0\x07"
    message = registry.decode(data)
    assert message.encode() == data
    assert registry.from_dict({"message": "QueryThing", "fields": message.to_dict()}) == message
    assert registry.decode(data + b"!", strict=False)[0].encode() == data
    for source in generate(load_own([file]), "deep", "jauspy.messages").values():
        compile(source, "deep", "exec")


def test_long_names_are_refused(tmp_path: Path) -> None:
    with pytest.raises(SchemaError, match="name: longer than 1000 characters"):
        load_own([_written(tmp_path, _RECORD.replace("Leaf", "A" * 100_000))])
