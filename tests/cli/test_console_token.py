"""The token of a console without a login: from a file, and never in the arguments of the browser."""

from __future__ import annotations

import webbrowser
from pathlib import Path

import pytest
from tests.helpers.command_line import jauspy

pytest.importorskip("nicegui", reason="needs the extra 'console'")

from jauspy.cli import operator_console

TOKEN = "0123456789abcdef"


@pytest.mark.parametrize(
    ("content", "mode", "said"),
    [
        (TOKEN, 0o640, "other users may read or change this token; do: chmod 600"),
        ("short", 0o600, "a token has 16 to 256 letters, digits, - and _; make one: openssl rand -hex 32"),
        (f"{TOKEN} {TOKEN}", 0o600, "a token has 16 to 256 letters"),
        ("x" * 300, 0o600, "a token has 16 to 256 letters"),
        (None, 0, "cannot be read: No such file"),
    ],
)
def test_a_file_that_is_no_token(tmp_path: Path, content: str | None, mode: int, said: str) -> None:
    path = tmp_path / "token"
    if content is not None:
        path.write_text(content)
        path.chmod(mode)
    refused = jauspy("console", "--no-browser", "--token-file", str(path), status=1)
    assert said in " ".join(refused.stderr.split())


def test_users_need_no_token() -> None:
    refused = jauspy("console", "--no-browser", "--token-file", "token", "--users", "users.toml", status=1)
    assert "leave out one" in " ".join(refused.stderr.split())


def test_a_token_for_bookmarks_is_read_from_its_file(tmp_path: Path) -> None:
    path = tmp_path / "token"
    path.write_text(f"{TOKEN}\n")
    path.chmod(0o600)
    assert operator_console._read_token(path) == TOKEN


def test_the_arguments_of_the_browser_do_not_contain_the_token(monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[str] = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    with operator_console._browser_at(f"http://127.0.0.1:8101/?token={TOKEN}"):
        assert TOKEN not in opened[0]
        page = Path(opened[0].removeprefix("file://"))
        assert f"url=http://127.0.0.1:8101/?token={TOKEN}" in page.read_text()
        assert page.parent.stat().st_mode & 0o777 == 0o700
    assert not page.exists()
    with operator_console._browser_at("https://ground:8101"):
        assert opened[1] == "https://ground:8101"
