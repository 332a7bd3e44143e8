"""Declared classes and the code made of them: at first use, for all classes, in threads, whatever a definition says."""

from __future__ import annotations

import copy
import importlib
import inspect
import linecache
import pickle
import subprocess
import sys
import threading
import traceback
from pathlib import Path
from typing import Any

import pytest

import jauspy
from jauspy.codec.build import load_schema
from jauspy.codec.codegen import identifier
from jauspy.codec.fast_path import install
from jauspy.codec.items import Choice, Formatted
from jauspy.codec.layout import Composite
from jauspy.codec.message import Message, Struct
from jauspy.codec.registry import Registry
from jauspy.codec.source import generate
from jauspy.messages import registry
from jauspy.messages.mobility import ReportVelocityState, SetWrenchEffort
from jauspy.schema import model as m

HOSTILE = '\'\'\' """ \\" \\\n"""\nraise SystemExit("run")\n#\u2028${x}{0}%s\x7f'
"""Ends a string literal, a docstring, a comment or a format in every way there is."""


def every_class(cls: type[Any]) -> list[type[Struct]]:
    inside = [
        part
        for part in vars(cls).values()
        if isinstance(part, type) and part.__qualname__.startswith(f"{cls.__qualname__}.")
    ]
    nested = [found for part in inside if issubclass(part, Struct) for found in every_class(part)]
    return [cls, *nested]


@pytest.mark.slow
def test_code_is_generated_for_every_class(odd: Registry) -> None:
    for message in [*registry, *odd]:
        install(message, "_unpack")
        install(message, "_pack")
        for cls in every_class(message)[1:]:
            if isinstance(cls.layout(), Composite | Choice | Formatted):
                install(cls, "_read")
                install(cls, "_write")


def test_code_is_generated_once_at_first_use() -> None:
    program = """
from jauspy.messages.mobility.v1_0.primitive_driver import SetWrenchEffort
assert "_pack" not in vars(SetWrenchEffort)
data = SetWrenchEffort(propulsive_linear_effort_x=5.0).encode()
made = vars(SetWrenchEffort)["_pack"]
assert "_unpack" not in vars(SetWrenchEffort)
assert SetWrenchEffort.decode(data).encode() == data
assert vars(SetWrenchEffort)["_pack"] is made
"""
    subprocess.run([sys.executable, "-c", program], check=True)


@pytest.mark.slow
def test_concurrent_first_use_gives_right_bytes(odd: Registry) -> None:
    schema = odd.schema
    assert schema is not None
    for _ in range(20):
        cls: Any = load_schema(schema).by_name("Options")
        barrier, found = threading.Barrier(4), []

        def use(cls: Any = cls, barrier: threading.Barrier = barrier, found: list[bytes] = found) -> None:
            barrier.wait()
            found.append(cls.decode(b"\x02\xf0\0\0\7\0").encode())

        threads = [threading.Thread(target=use) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert found == [b"\x02\xf0\0\0\7\0"] * 4


def test_tracebacks_show_generated_code() -> None:
    with pytest.raises(Exception, match="unpack") as raised:
        ReportVelocityState._unpack(b"", None)
    assert "S_2H.unpack_from(data)" in "".join(traceback.format_exception(raised.value))
    made = ReportVelocityState._unpack.__code__
    assert "velocity_state_sensor.ReportVelocityState._unpack" in made.co_filename
    linecache.checkcache()
    assert inspect.getsource(made).startswith("def _unpack(cls, data, nesting):")


@pytest.mark.parametrize("text", ["", "a b", "a.b", "class", "1a", "a\n", "a;b", "ﬁ", "x²", 'a"'])
def test_names_that_are_no_identifiers_are_rejected(text: str) -> None:
    with pytest.raises(ValueError, match="is not an identifier"):
        identifier(text)


def hostile_schema() -> m.Schema:
    """Every text of a definition that a class could be made of is hostile."""
    text = HOSTILE
    values = m.ValueSet((m.ValueEnum(1, text), m.ValueEnum(2, text)), (m.ValueRange(5, 9),))
    fields: tuple[m.Node, ...] = (
        m.FixedField(name=text, doc=text, type="u8", units=text, values=values),
        m.FixedField(name=text, doc=text, type="u16", units=text, scale=m.Scale(0.0, 1.0), optional=True),
        m.BitField(name=text, doc=text, type="u8", subfields=(m.SubField(text, 0, 3, values, text),)),
        m.VariableField(
            name=text, doc=text, choices=(m.TypeChoice(0, "u8", text, name=text, values=values, doc=text),)
        ),
        m.VariableFormatField(name=text, doc=text, formats=(m.Format(0, text),), count=m.Count("u8", 0, 9)),
        m.VariableLengthField(name=text, doc=text, format=text, count=m.Count("u8", 0, 9)),
        m.List(
            name=text,
            doc=text,
            count=m.Count("u8", 0, 9),
            element=m.Record(
                name=text, doc=text, fields=(m.VariableString(name=text, doc=text, count=m.Count("u8", 0, 9)),)
            ),
        ),
        m.Variant(name=text, doc=text, tag=m.Count("u8", 0, 1), arms=(m.Record(name=text, fields=()),)),
    )
    record = m.Record(name=text, doc=text, presence="u8", fields=fields)
    message = m.MessageDefinition(name=text, code=0xD001, is_command=True, body=record, doc=text)
    where = m.SourceLocation(text, 1)
    service = m.ServiceDefinition(
        name=text, id=f"urn:{text}:{text}", version=text, jsidl="1.1", inputs=(message,), where=where
    )
    return m.Schema(services=(service,))


def hostile_round_trip(cls: type[Message]) -> bytes:
    data = b"\x01\xd0\x01\x05\xff\xff\x01\0\x05\0\1z\1y\1\1x\0"
    found = cls.decode(data)
    assert found.encode() == data
    assert cls.from_dict(found.to_dict()) == found
    assert cls.decode(data, strict=False) == (found, [])
    return data


def test_loading_executes_no_text_of_a_definition() -> None:
    (cls,) = load_schema(hostile_schema()).by_code(0xD001)
    hostile_round_trip(cls)
    assert HOSTILE in cls.NAME
    for made in every_class(cls):
        for name in ("_unpack", "_pack", "_read", "_write"):
            code = vars(made).get(name)
            function = getattr(code, "__func__", code)
            if function is not None:
                assert "raise SystemExit" not in inspect.getsource(function)


def test_generated_source_executes_no_text_of_a_definition(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for path, text in generate(hostile_schema(), "hostile_written", "jauspy.messages").items():
        file = tmp_path / "hostile_written" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    (cls,) = importlib.import_module("hostile_written").registry.by_code(0xD001)
    hostile_round_trip(cls)
    assert HOSTILE in cls.NAME


HOSTILE_ID = "urn:x:&quot;&quot;&quot;&#10;raise SystemExit(1)&#10;&quot;&quot;&quot;&#39;&#39;&#39;:Lamp"


def test_a_file_with_a_hostile_service_id_loads(folder: Any) -> None:
    folder.add("Lamp", urn=HOSTILE_ID, units="&quot;&quot;&quot;&#10;raise SystemExit&#10;")
    try:
        own = jauspy.load(folder.path)
    except jauspy.SchemaError as error:
        assert "urn:x" in str(error)  # noqa: PT017 - a schema may refuse it; what may not happen is that it runs
        return
    assert own.by_name("SetLevel").decode(b"\x01\xd0\7").encode() == b"\x01\xd0\7"


def test_messages_pickle_copy_and_compare(odd: Registry) -> None:
    message = SetWrenchEffort(propulsive_linear_effort_x=5.0)
    loaded = odd.by_name("Options").decode(b"\x02\xf0\0\0\7\0")
    for one in (message, loaded):
        assert pickle.loads(pickle.dumps(one)) == one
        assert copy.deepcopy(one) == one
        assert copy.copy(one) is not one
        with pytest.raises(TypeError, match="unhashable"):
            hash(one)
    assert repr(message) == "SetWrenchEffort(propulsive_linear_effort_x=5.0)"
    assert not hasattr(message, "__dict__")


def test_written_classes_equal_loaded_ones(odd: Registry, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert odd.schema is not None
    for path, text in generate(odd.schema, "odd_written", "jauspy.messages").items():
        file = tmp_path / "odd_written" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    written = importlib.import_module("odd_written").registry
    names = [entry.name for entry in odd.entries if entry.code >= 0xF000 and "Odds" in entry.service]
    assert len(names) == 6
    for name in names:
        one, other = odd.by_name(name), written.by_name(name)
        assert inspect.getdoc(one) == inspect.getdoc(other)
        assert [cls.__qualname__ for cls in every_class(one)] == [cls.__qualname__ for cls in every_class(other)]
        for mine, theirs in zip(every_class(one), every_class(other), strict=True):
            assert shape(mine) == shape(theirs)


def shape(cls: type[Struct]) -> str:
    return repr(cls.layout()).replace(cls.__module__, "").replace("jauspy_loaded", "")
