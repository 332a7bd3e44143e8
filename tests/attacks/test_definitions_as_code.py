"""A file author sends a definition whose texts are Python: nothing that reads or generates ever runs them."""

from __future__ import annotations

import logging
import subprocess
import sys
from pathlib import Path
from typing import Final

import pytest
from tests.helpers.definitions import HOLES, assert_declares_only, assert_is_stub, definition, loaded
from typer.testing import CliRunner

from jauspy.cli.main import app

run = CliRunner()
SOURCES: Final = Path(__file__).parents[2] / "src"
CALL: Final = "__import__('pathlib').Path('written').touch()"
WIDE: Final = "".join(chr(ord(letter) + 0xFEE0) for letter in "import")
WAYS: Final = {
    "end of a docstring": f'"""\n{CALL}\n"""',
    "end of a docstring in single quotes": f"'''\n{CALL}\n'''",
    "end of a string": f'", {CALL}, "',
    "end of a string in single quotes": f"', {CALL}, '",
    "backslash before the end": f'\\" + {CALL} + \\"',
    "line after a comment": f"\n{CALL}\n#",
    "lines that only Python ends": f"\u2028{CALL}\x85{CALL}\r{CALL}",
    "placeholder of a template": f"{{{CALL}}}{{0.__class__}}%({CALL})s",
    "expression": f" + {CALL} + 0",
    "body of a class": f'(): pass\n{CALL}\nclass X("',
    "coding of the file": f"\n# -*- coding: unicode_escape -*-\n\\x22\\x22\\x22\\n{CALL}",
    "letters that Python makes others of": f"__{WIDE}__('pathlib').Path('written').touch()",
}
CHECKED: Final = ("urn", "version", "number", "guard", "const", "state", "type")
"""Places where most of this is refused; the others take any text, all at once."""

USE: Final = """
import importlib, pkgutil, sys
for name in sys.argv[1:]:
    package = importlib.import_module(name)
    for each in pkgutil.walk_packages(package.__path__, f"{name}."):
        if "__main__" not in each.name and ".test_" not in each.name:
            module = importlib.import_module(each.name)
            [getattr(module, key) for key in getattr(module, "__all__", ())]
            getattr(module, "services", list)()
    for entry in getattr(package, "registry", ()) and package.registry.entries:
        if entry.service.startswith("urn:example"):
            kind = entry.load()
            kind.decode(kind.CODE.to_bytes(2, "little") + bytes(40), strict=False)[0].encode(strict=False)
"""


@pytest.fixture(autouse=True)
def _here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture) -> None:
    monkeypatch.chdir(tmp_path)
    caplog.set_level(logging.ERROR, "jauspy.codec")


@pytest.mark.slow
def test_texts_of_a_definition_never_run() -> None:
    """Wherever a definition takes any text, in each way: loaded, decoded with, generated, imported, a component."""
    everywhere = [hole for hole in HOLES if hole not in CHECKED]
    made = [name for way in WAYS for name in _used(way, everywhere)]
    assert len(made) == 2 * len(WAYS), "all of them load"
    made += [name for hole in CHECKED for name in _used("expression", [hole])]
    _assert_harmless(made)


@pytest.mark.slow
@pytest.mark.long
def test_texts_of_a_definition_never_run_in_any_single_place() -> None:
    made = [name for way in WAYS for hole in HOLES for name in _used(way, [hole])]
    assert len(made) > len(WAYS) * len(HOLES)
    _assert_harmless(made)
    for file in sorted(Path().glob("*.xml"))[::7]:
        _command("schema", "lint", file)
        _command("schema", "show", "--schemas", file, "D011")
    assert not list(Path().rglob("written"))


def _used(way: str, holes: list[str]) -> list[str]:
    """Do everything with a definition that has this in these places; the packages that came of it."""
    number = f"{list(WAYS).index(way)}_{holes[0]}"
    file = Path(f"{number}.xml")
    file.write_text(definition(**dict.fromkeys(holes, WAYS[way])), encoding="utf-8")
    registry = loaded(file)
    if registry is None:
        return []
    for entry in registry.entries:
        if entry.service.startswith("urn:example"):
            kind = entry.load()
            kind.decode(kind.CODE.to_bytes(2, "little") + bytes(40), strict=False)[0].encode(strict=False)
    urn = next(iter(registry.files))[0]
    stub = _command("new", "component", f"stub{number}", "--service", urn, "--schemas", file)
    package = _command("schema", "generate", file, "-o", f"package{number}")
    return [*([f"stub{number}"] if stub else []), *([f"package{number}"] if package else [])]


def _assert_harmless(made: list[str]) -> None:
    for name in made:
        if not name.startswith("stub"):
            for file in Path(name).rglob("*.py"):
                assert_declares_only(file.read_text("utf-8"), name)
    for file in Path().glob("stub*/services.py"):
        assert_is_stub(file.read_text("utf-8"), file.parent.name)
    subprocess.run([sys.executable, "-c", USE, *made], env={"PYTHONPATH": f".:{SOURCES}"}, check=True)
    assert not list(Path().rglob("written"))


def _command(*arguments: object) -> bool:
    """True if it succeeds; otherwise it says why in a sentence."""
    done = run.invoke(app, list(map(str, arguments)))
    assert done.exception is None or isinstance(done.exception, SystemExit)
    return done.exit_code == 0
