"""A file author sends a definition whose texts are Lua: in the dissector made of it they stay texts."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Final

import pytest
from tests.helpers.definitions import HOLES, definition, loaded
from tests.helpers.tshark import capture_of, tshark
from typer.testing import CliRunner

from jauspy.cli.main import app
from jauspy.inspection.dissector import engine, make_dissector

CALL: Final = "os.execute('touch written')"
WAYS: Final = {
    "end of a string": f'"}} {CALL} local x = {{"',
    "end of a string in single quotes": f"'}} {CALL} local x = {{'",
    "end of a long string": f"]] {CALL} --[[",
    "end of a long string with marks": f"]==] {CALL} --[==[",
    "backslash before the end": f'\\" .. {CALL} .. \\"',
    "line after a comment": f"\n{CALL}\n--",
    "line after an escaped line break": f"\\\n{CALL}\n--",
    "escapes": "\\z \\x22 \\34 \\u{22}" + CALL,
    "lines that others end": f"\u2028{CALL}\x85{CALL}\r{CALL}",
    "formats": f"%s%n%p%99999d{CALL}",
    "letters beyond ASCII": f"ü€\U0001f600{CALL}",
}
CHECKED: Final = ("urn", "version", "number", "guard", "const", "state", "type")
"""Places where most of this is refused."""
LITERAL: Final = re.compile(r'"(?:[ !#-\[\]-~]|\\\d{3})*"')
TABLES: Final = re.compile(
    r"(?:local [A-Z]+ = |[a-z_]+=|\[-?\d+\]=|[-{},\s]|\d+(?:\.\d+)?(?:e[+-]\d+)?|math\.huge|true|S)*"
)
"""What is left of tables when each string literal is S."""


def made_of(way: str, holes: list[str], folder: Path) -> str | None:
    file = folder / "thing.xml"
    file.write_text(definition(**dict.fromkeys(holes, WAYS[way])), encoding="utf-8")
    registry = loaded(file)
    return None if registry is None else make_dissector(registry).text


def assert_tables_only(text: str) -> None:
    """Behind the head's comments there are tables of numbers and strings, then the engine as it is."""
    assert text.endswith(engine())
    head = text.removesuffix(engine())
    assert head.isascii()
    lines = [line for line in head.splitlines() if not line.startswith("--")]
    assert TABLES.fullmatch(LITERAL.sub("S", "\n".join(lines)))


@pytest.mark.slow
@pytest.mark.parametrize("way", WAYS)
def test_texts_of_a_definition_stay_texts(way: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = made_of(way, [hole for hole in HOLES if hole not in CHECKED], tmp_path)
    assert text is not None
    assert_tables_only(text)
    assert "os.execute" in text, "it is there, as a text"
    if shutil.which("tshark"):
        monkeypatch.chdir(tmp_path)
        lua = tmp_path / "jaus.lua"
        lua.write_text(text, encoding="utf-8")
        payloads = [
            code.to_bytes(2, "little") + bytes([fill] * 40) for code in (0xD011, 0xD013) for fill in (0, 1, 255)
        ]
        datagrams = [b"\x02\0" + (len(p) + 14).to_bytes(2, "little") + bytes(9) + p + b"\0\0" for p in payloads]
        assert "jaus." in tshark(lua, capture_of(datagrams, tmp_path / "thing.pcapng"), "-T", "pdml")
        assert not (tmp_path / "written").exists()


@pytest.mark.slow
@pytest.mark.parametrize("hole", CHECKED)
def test_texts_in_checked_places_stay_texts(hole: str, tmp_path: Path) -> None:
    for way in WAYS:
        text = made_of(way, [hole], tmp_path)
        if text is not None:
            assert_tables_only(text)


def test_the_name_of_the_file_is_printed_safely(tmp_path: Path) -> None:
    done = CliRunner().invoke(app, ["dissector", "-o", str(tmp_path / "a\x1b[31m.lua")])
    assert done.exit_code == 0
    assert "\x1b[31m" not in done.output
