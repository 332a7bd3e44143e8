"""Stubs of messages that are made at run time: they agree with the classes, and type checkers accept them."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from tests.helpers.definitions import HOLES, assert_types_only, definition
from tests.helpers.stubs import assert_agree

import jauspy
from jauspy.codec.stubs import MessageKey, Stubs, make_stubs
from jauspy.schema import builtin_paths
from jauspy.schema.loader import load_own

VENDOR = Path(__file__).parents[1] / "vendor"


def written(folder: Path, name: str, *files: Path) -> Stubs:
    """The module and the stub, written to a folder."""
    stubs = make_stubs(load_own(files), [str(file) for file in files])
    (folder / f"{name}.py").write_text(stubs.module, encoding="utf-8")
    (folder / f"{name}.pyi").write_text(stubs.stub, encoding="utf-8")
    return stubs


def check(folder: Path, *command: str) -> str:
    done = subprocess.run([sys.executable, "-m", *command], cwd=folder, capture_output=True, text=True, check=False)
    return done.stdout + done.stderr


def everything(folder: Path, name: str, **texts: str) -> Path:
    file = folder / f"{name}.xml"
    file.write_text(definition(**texts), encoding="utf-8")
    return file


@pytest.mark.parametrize("files", [[VENDOR], ["everything"]], ids=["vendor", "everything"])
def test_stub_agrees_with_the_classes(tmp_path: Path, files: list[Path]) -> None:
    files = [everything(tmp_path, "all")] if files == ["everything"] else files
    assert_agree(written(tmp_path, "messages", *files), tmp_path)


@pytest.mark.slow
@pytest.mark.long
def test_stubs_of_all_public_definitions(tmp_path: Path) -> None:
    """By our comparison, by mypy's stubtest, which sees aliases of classes as variables, by mypy and ruff."""
    stubs = written(tmp_path, "public_messages", *builtin_paths())
    assert_agree(stubs, tmp_path)
    assert_types_only(stubs.stub)
    (tmp_path / "use.py").write_text(
        "from typing import assert_type\n"
        "from public_messages import ReportLocalPose, SetGlobalPose_v1_0, registry\n"
        'assert_type(registry.by_name("ReportLocalPose"), type[ReportLocalPose])\n'
        "assert_type(ReportLocalPose(x=1.0).x, float | None)\n"
        "assert_type(ReportLocalPose.decode(b''), ReportLocalPose)\n"
    )
    assert "Success" in check(tmp_path, "mypy", "--strict", "use.py", "public_messages.pyi")
    assert "All checks passed!" in check(
        tmp_path, "ruff", "check", "--isolated", "public_messages.py", "public_messages.pyi"
    )
    found = check(tmp_path, "mypy.stubtest", "public_messages")
    errors = [line for line in found.splitlines() if line.startswith("error:")]
    assert [line for line in errors if "differs from runtime type type" not in line] == [
        "error: public_messages.registry variable differs from runtime type jauspy.codec.registry.Registry"
    ]


HOSTILE = {
    "ends of strings": dict.fromkeys(HOLES, "\"\"\"\n'''\\"),
    "code": dict.fromkeys(("message", "type", "field", "enum", "doc", "units"), '"): import os #'),
    "names of the stub": {"message": "Registry", "type": "Registry", "field": "jd", "enum": "typing"},
    "names of types": {"message": "int", "type": "Message", "field": "float", "enum": "mro"},
    "no letters": dict.fromkeys(("message", "type", "field", "enum", "service"), "²·"),
}


@pytest.mark.slow
def test_type_checkers_accept_stubs_of_hostile_definitions(tmp_path: Path) -> None:
    names = []
    for number, texts in enumerate(HOSTILE.values()):
        kept = {
            hole: text for hole, text in texts.items() if hole not in ("number", "version", "const", "guard", "urn")
        }
        file = everything(tmp_path, f"hostile{number}", **kept)
        assert_agree(written(tmp_path, f"messages{number}", file), tmp_path)
        names.append(f"messages{number}.pyi")
    assert "Success" in check(tmp_path, "mypy", "--strict", *names)


def test_messages_of_several_versions_have_names_of_their_own(tmp_path: Path) -> None:
    text = (VENDOR / "Lamp.xml").read_text()
    newer = text.replace('version="1.2">', 'version="1.3">', 1)
    other = text.replace(":Lamp", ":Torch", 1).replace('name="Lamp"', 'name="Torch"', 1)
    files = [tmp_path / f"{number}.xml" for number in range(3)]
    for file, content in zip(files, (text, newer, other), strict=True):
        file.write_text(content)
    stubs = written(tmp_path, "messages", *files)
    assert sorted(name for key, name in stubs.names.items() if key.name == "SetLamp") == [
        "SetLamp",
        "SetLamp_v1_2",
        "Torch_SetLamp_v1_2",
    ]
    found = assert_agree(stubs, tmp_path)
    assert stubs.names[MessageKey("urn:example:vendor:Lamp", "1.3", "SetLamp")] == "SetLamp"
    assert found["SetLamp"].VERSION == "1.3"


def test_a_report_whose_name_a_class_in_the_query_has(tmp_path: Path) -> None:
    """REPORT is the message, not the record of the same name in the query."""
    text = (VENDOR / "Lamp.xml").read_text()
    query = text.index('name="QueryLamp"')
    body = text.index('<body name="Body"', query)
    end = text.index(">", body) + 1
    record = (
        '<body name="Body"><sequence name="S"><record name="ReportLamp" optional="false"><fixed_field name="X" '
        'field_type="unsigned byte" field_units="one" optional="false"/></record></sequence></body>'
    )
    after = end if text[end - 2] == "/" else text.index("</body>", end) + len("</body>")
    file = tmp_path / "lamp.xml"
    file.write_text(text[:body] + record + text[after:])
    stubs = written(tmp_path, "messages", file)
    assert "REPORT = _ReportLamp" in stubs.stub
    assert assert_agree(stubs, tmp_path)["QueryLamp"].REPORT is not None


def test_definitions_without_messages(tmp_path: Path) -> None:
    text = re.sub(r"<message_def.*?</message_def>", "", (VENDOR / "Lamp.xml").read_text(), flags=re.S)
    (tmp_path / "lamp.xml").write_text(re.sub("<protocol_behavior.*</protocol_behavior>", BEHAVIOR, text, flags=re.S))
    stubs = written(tmp_path, "messages", tmp_path / "lamp.xml")
    assert stubs.names == {}
    assert stubs.stub.endswith("\nregistry: jr.Registry\n")
    assert "typing" not in stubs.stub


BEHAVIOR = '<protocol_behavior is_stateless="true"/>'


def test_by_name_prefers_the_spelling_that_was_given(tmp_path: Path) -> None:
    text = (VENDOR / "Lamp.xml").read_text()
    file = tmp_path / "lamp.xml"
    file.write_text(text.replace('name="QueryLamp"', 'name="SETLAMP"'))
    registry = jauspy.load(file)
    assert [registry.by_name(name).NAME for name in ("SetLamp", "SETLAMP")] == ["SetLamp", "SETLAMP"]
    assert registry.by_name("setlamp").NAME in ("SetLamp", "SETLAMP")
