"""Three users with different roles log in by TLS in a real browser, and hand control over; the audit log has them."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, WAIT, chromium, console_for, new_page, sync_api
from tests.helpers.command_line import JAUSPY, shared_robot

pytestmark = BROWSER_MARKS
PASSWORD = "correct horse battery"
TRIES = 4
ROLES = {"olga": "observer", "anna": "operator", "sam": "supervisor"}


@pytest.fixture
def files(tmp_path: Path) -> Path:
    """The folder with users, certificate and key."""
    for name, role in ROLES.items():
        add = [*JAUSPY, "console", "user", "add", name, "--role", role]
        subprocess.run(add, cwd=tmp_path, input=f"{PASSWORD}\n", text=True, check=True, capture_output=True)
    subprocess.run([*JAUSPY, "console", "certificate", "127.0.0.1"], cwd=tmp_path, check=True, capture_output=True)
    return tmp_path


@pytest.fixture
def url(files: Path) -> Iterator[str]:
    names = ("users.toml", "certificate.pem", "key.pem")
    users, certificate, key = (str(files / f"console-{name}") for name in names)
    with shared_robot(few_pictures=True) as robot:
        options = ("--users", users, "--certificate", certificate, "--key", key)
        with console_for(robot.local, *options) as (address, _):
            yield address


def log_in(page: Any, name: str, password: str) -> None:
    page.locator("input[name=name]").fill(name)
    page.locator("input[name=password]").fill(password)
    page.keyboard.press("Enter")


def button(page: Any, name: str) -> Any:
    return page.get_by_role("button", name=name, exact=True).first


def repeat(act: Callable[[], None], page: Any, text: str | re.Pattern[str]) -> None:
    """Act until the page has this text, as an operator does: on a loaded machine a robot may not answer in time."""
    for _ in range(TRIES):
        with suppress(sync_api.TimeoutError):
            act()
            page.get_by_text(text).first.wait_for(timeout=WAIT / TRIES)
            return
    pytest.fail(f"the page does not say {text!r} after {TRIES} tries")


def test_users_log_in_and_hand_over(url: str, files: Path) -> None:
    with chromium() as browser:
        with pytest.raises(sync_api.Error, match="ERR_CERT_AUTHORITY_INVALID"):
            browser.new_page().goto(url)
        pages = []
        for name in ROLES:
            page = new_page(browser, ignore_https_errors=True)
            page.goto(url)
            log_in(page, name, "a wrong password")
            page.get_by_text("Name or password is wrong.").wait_for()
            log_in(page, name, PASSWORD)
            page.get_by_text("101 inc1").first.wait_for()
            pages.append(page)
        olga, anna, sam = pages

        olga.get_by_text("observing (observer)", exact=True).wait_for()
        assert button(olga, "take").is_disabled()
        repeat(button(anna, "take").click, anna, "you operate this robot")
        sam.get_by_text("anna operates it").wait_for()
        repeat(lambda: button(sam, "ask").click(timeout=WAIT / TRIES), anna, "sam asks for control")
        button(anna, "hand over").click()
        sam.get_by_text("you operate this robot").wait_for()
        anna.get_by_text("sam operates it").wait_for()
        button(sam, "release").click()
        anna.get_by_text("observing", exact=True).wait_for()
        repeat(button(anna, "take").click, sam, "anna operates it")
        sam.get_by_label("authority").fill("200")
        repeat(button(sam, "take over").click, sam, "you operate this robot")

        repeat(lambda: olga.keyboard.press("Escape"), olga, "components stopped")
        button(olga, "clear emergency").click()
        olga.get_by_text("olga may stop robots, and not release them (observer)").wait_for()
        repeat(button(sam, "clear emergency").click, sam, re.compile(r"\b(\d+) of \1 components released"))
        button(sam, "sign out").click()
        sam.locator("input[name=password]").wait_for()

    lines = [json.loads(line) for line in (files / "console-users.toml.audit").read_text().splitlines()]
    given = {(line["operator"], line["role"], line["message"]) for line in lines if line.get("message")}
    assert {
        ("anna", "operator", "RequestControl"),
        ("sam", "supervisor", "RequestControl"),
        ("olga", "observer", "SetEmergency"),
        ("sam", "supervisor", "ClearEmergency"),
    } <= given
    assert ("olga", "observer", "RequestControl") not in given
    assert [line for line in lines if "message" in line and not line.get("operator")] == []
