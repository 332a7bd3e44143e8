"""`jauspy schema lint` and `generate`, in this process; generated packages in one of their own."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest
from typer.testing import CliRunner

from jauspy.cli.main import app

SERVICE = """<service_def xmlns="urn:jaus:jsidl:1.1" name="Lamp" id="urn:acme:things:Lamp" version="1.2">
<description>A lamp.</description>
<assumptions/>
<declared_type_set name="types">
<declared_type_set_ref name="core" id="urn:jauspy:core:Types" version="1.0"/>
</declared_type_set>
<message_set>
<input_set>
<message_def name="SetLamp" message_id="D001" is_command="true">
<description>Sets the brightness.</description>
<declared_header name="Header" declared_type_ref="core.MsgHeader"/>
<body name="Body">
<record name="LampRec" optional="false">
<presence_vector field_type_unsigned="unsigned byte"/>
<fixed_field name="Brightness" field_type="unsigned byte" field_units="percent" interpretation="How bright."/>
<declared_bit_field name="TimeStamp" declared_type_ref="core.TimeStamp" optional="true" interpretation="Since when."/>
</record>
</body>
<footer name="Footer"/>
</message_def>
</input_set>
<output_set/>
</message_set>
<internal_events_set/>
<protocol_behavior is_stateless="true"/>
</service_def>
"""


def run(*arguments, status=0):
    result = CliRunner().invoke(app, ["schema", *map(str, arguments)])
    assert result.exit_code == status, result.output
    return result


@pytest.fixture
def lamp(tmp_path):
    path = tmp_path / "vendor" / "Lamp.xml"
    path.parent.mkdir()
    path.write_text(SERVICE, encoding="utf-8")
    return path


def change(path, old, new):
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new), encoding="utf-8")


# --- lint -----------------------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_lint_of_the_built_in_definitions():
    """They have the mistakes of the published ones: those are on the wire."""
    assert "presence vector of 'CBRNRec' has 8 bits" in run("lint", status=1).stdout


def test_lint_of_a_clean_file(lamp):
    assert run("lint", lamp).stdout == ""


def test_lint_hints_are_no_failure(lamp):
    change(lamp, "<description>A lamp.</description>", "")
    result = run("lint", lamp)
    assert result.stdout == (
        f"{lamp}:1: hint: no-description: service 'Lamp' has no description; describe its purpose\n"
    )
    assert result.stderr == "1 hint\n"


def test_lint_errors_and_warnings_are_failures(lamp):
    change(lamp, 'declared_type_ref="core.TimeStamp"', 'declared_type_ref="core.TimeStump"')
    result = run("lint", lamp.parent, status=1)
    line = next(n for n, text in enumerate(SERVICE.splitlines(), 1) if "core.TimeStamp" in text)
    assert result.stdout.startswith(f"{lamp}:{line}: error: dangling-reference: no declared type 'core.TimeStump'; did")
    [found] = [json.loads(text) for text in run("lint", lamp, "--json", status=1).stdout.splitlines()]
    assert (found["file"], found["line"], found["severity"], found["code"]) == (
        str(lamp), line, "error", "dangling-reference",
    )  # fmt: skip


def test_lint_rules_can_be_ignored(lamp):
    change(lamp, "<description>A lamp.</description>", "")
    assert run("lint", lamp, "--ignore", "no-description").stdout == ""
    assert (
        "there is no rule 'no-descriptions'; did you mean"
        in run("lint", "--ignore", "no-descriptions", status=2).output
    )
    assert "presence-vector  " in run("lint", "--rules").stdout


@pytest.mark.parametrize("text", ["<oops", "<other/>", '<!DOCTYPE a><service_def xmlns="urn:jaus:jsidl:1.1"/>'])
def test_unreadable_file_ends_with_status_2(lamp, text):
    other = lamp.parent / "other.xml"
    other.write_text(text)
    result = run("lint", lamp, other, status=2)
    assert f"{other}:1: error: unreadable: " in result.stdout


def test_missing_file_ends_with_status_2():
    assert run("lint", "nowhere/*.xml", status=2).stderr == "Error: no JSIDL file matches 'nowhere/*.xml'\n"


# --- generate -------------------------------------------------------------------------------------------------------


def python(code, folder):
    path = os.pathsep.join([str(folder), *filter(None, sys.path)])
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


USE = """
from {package} import registry
from {package}.things import SetLamp
from {package}.core.v1_0.types import TimeStamp
assert registry.decode(SetLamp(brightness=7).encode()) == SetLamp(brightness=7)
assert registry.by_name("QueryTime")
print(SetLamp(brightness=7).encode().hex())
"""


def test_generate_a_package_that_can_be_imported(lamp, tmp_path):
    result = run("generate", lamp, "-o", tmp_path / "acme_messages")
    last = result.stdout.splitlines()[-1]
    assert last.endswith(f"Import with {tmp_path} in PYTHONPATH: from acme_messages import registry")
    assert f"{tmp_path}/acme_messages/things/v1_2/lamp.py" in result.stdout
    assert python(USE.format(package="acme_messages"), tmp_path) == "01d00007"


@pytest.mark.slow
def test_collisions_of_a_generated_package_name_files(lamp, tmp_path):
    other = tmp_path / "vendor" / "Other.xml"
    text = lamp.read_text(encoding="utf-8").replace("SetLamp", "SetOther").replace(":Lamp", ":Other")
    other.write_text(text.replace('name="Lamp"', 'name="Other"'), encoding="utf-8")
    run("generate", lamp.parent, "-o", tmp_path / "acme_messages")
    code = "from acme_messages import registry; print([c.files for c in registry.collisions if c.code == 0xD001])"
    assert python(code, tmp_path) == str([(str(lamp), str(other))])


@pytest.mark.parametrize("output", ["src", "src/acme/jaus"])
def test_generate_a_package_inside_another(lamp, tmp_path, output):
    run("generate", lamp, "-o", tmp_path / output, "--package", "acme.jaus")
    assert (tmp_path / "src" / "acme" / "jaus" / "py.typed").exists()
    assert python(USE.format(package="acme.jaus"), tmp_path / "src") == "01d00007"


def test_generating_again_overwrites_generated_files(lamp, tmp_path):
    for _ in range(2):
        run("generate", lamp, "-o", tmp_path / "acme")


def test_foreign_files_are_not_overwritten(lamp, tmp_path):
    mine = tmp_path / "acme" / "__init__.py"
    mine.parent.mkdir()
    mine.write_text("mine = 1\n")
    result = run("generate", lamp, "-o", mine.parent, status=2)
    assert result.stderr.startswith(f"Error: {mine} would be overwritten and was not generated; use --force")
    assert mine.read_text() == "mine = 1\n"
    assert list(mine.parent.iterdir()) == [mine]
    run("generate", lamp, "-o", mine.parent, "--force")
    assert "registry" in mine.read_text()


def test_wrong_usage_causes_one_sentence(lamp, tmp_path):
    assert "is not the name of a Python package" in run("generate", lamp, "-o", tmp_path / "a-b", status=2).output
    (tmp_path / "file").write_text("")
    assert "cannot be written" in run("generate", lamp, "-o", tmp_path / "file" / "acme", status=2).stderr
    change(lamp, "core.TimeStamp", "core.TimeStump")
    assert run("generate", lamp, "-o", tmp_path / "acme", status=2).stderr.startswith(f"Error: {lamp}:")
    assert not (tmp_path / "acme").exists()


# --- generate --stubs -----------------------------------------------------------------------------------------------

USE_STUBS = """
from lamp_messages import SetLamp, registry
assert registry.by_name("SetLamp") is SetLamp
print(SetLamp(brightness=7).encode().hex())
"""


@pytest.mark.slow
@pytest.mark.parametrize("source", ["vendor/Lamp.xml", "vendor", "vendor/*.xml"])
def test_stubs_of_a_module_that_loads_the_definitions(lamp, tmp_path, monkeypatch, source):
    """The module finds them from its own folder, wherever it is imported."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "src").mkdir()
    result = run("generate", source, "--stubs", "-o", "src/lamp_messages.py")
    assert result.stdout.splitlines() == [
        "src/lamp_messages.py",
        "src/lamp_messages.pyi",
        "1 messages. Import with src in PYTHONPATH: from lamp_messages import registry",
    ]
    assert "class SetLamp(jd.Message):" in (tmp_path / "src" / "lamp_messages.pyi").read_text()
    assert python(USE_STUBS, tmp_path / "src") == "01d00007"


def test_stubs_are_written_again_but_foreign_files_are_kept(lamp, tmp_path):
    for _ in range(2):
        run("generate", lamp, "--stubs", "-o", tmp_path / "lamp_messages")
    mine = tmp_path / "lamp_messages.pyi"
    mine.write_text("mine: int\n")
    result = run("generate", lamp, "--stubs", "-o", tmp_path / "lamp_messages.py", status=2)
    assert result.stderr.startswith(f"Error: {mine} would be overwritten and was not generated; use --force")
    assert mine.read_text() == "mine: int\n"


def told(*arguments):
    """The sentence about wrong arguments, which is shown in a box."""
    return " ".join(run(*arguments, status=2).output.replace("│", " ").split())


@pytest.mark.parametrize("output", ["a-b.py", "messages.pyi", "class", "vendor"])
def test_stubs_need_the_file_of_a_module(lamp, tmp_path, monkeypatch, output):
    monkeypatch.chdir(tmp_path)
    reason = f"'{output}' is not the file of a Python module; name it as in battery_messages.py"
    assert reason in told("generate", lamp, "--stubs", "-o", output)


def test_stubs_have_no_package(lamp, tmp_path):
    error = told("generate", lamp, "--stubs", "-o", tmp_path / "messages.py", "--package", "acme")
    assert "--stubs writes a module, which has no package; leave it out" in error


@pytest.mark.slow
def test_paths_of_definitions_are_texts_in_the_module(lamp, tmp_path):
    """Names of folders may have any character."""
    folder = tmp_path / 'a"b\\c[d]{e}\n'
    folder.mkdir()
    (folder / "it's.xml").write_text(lamp.read_text())
    run("generate", folder / "it's.xml", "--stubs", "-o", tmp_path / "lamp_messages.py")
    assert python(USE_STUBS, tmp_path) == "01d00007"
