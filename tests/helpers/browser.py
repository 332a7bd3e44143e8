"""The console in a real browser: chromium by playwright, and a console in a process of its own."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from tests.helpers.command_line import start, stopped

pytest.importorskip("nicegui", reason="needs the extra 'console'")
sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
BROWSER_MARKS = [
    pytest.mark.slow,
    pytest.mark.alone,
    pytest.mark.skipif(CHROMIUM is None, reason="needs chromium, which Debian has in a package of this name"),
]
WAIT = 90_000
"""Milliseconds for anything to appear on a loaded machine."""
SIZE = {"width": 1440, "height": 900}
OWN_CODE = """if (window.trustedTypes) {
    const create = trustedTypes.createPolicy.bind(trustedTypes);
    const isOwn = () => new Error().stack.includes("at predicate (eval at evaluate (:");
    trustedTypes.createPolicy = (name, rules) => create(name, name !== "default" ? rules : {
        ...rules, createScript: (code, type, sink) => isOwn() ? code : rules.createScript(code, type, sink)
    });
}"""
"""Lets playwright evaluate expressions, as `wait_for_function` does, in a page that evaluates its own code only."""

GAMEPAD = """
window.pad = {
    id: "<b>pad</b> of a test", index: 0, connected: true, axes: [0, 0, 0, 0],
    buttons: Array.from({ length: 8 }, () => ({ pressed: false, value: 0 })),
};
navigator.getGamepads = () => [window.pad, null];
"""
"""A script of a page that then has a gamepad, `pad`, whose axes and buttons a test sets."""
HOLD_TO_DRIVE, HOLD_FOR_ARM, HOLD_FOR_CAMERA = 4, 5, 6
"""Buttons of a gamepad, one of which is held while its sticks move something."""


@contextmanager
def console_for(
    connect: str, *options: str, robot: int | None = 101, **process_options: Any
) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """The address of a console, and its process; its pages show this robot, or none."""
    shown = () if robot is None else ("--robot", str(robot))
    arguments = ("console", "--no-browser", "--port", "0", "--connect", connect, *shown, *options)
    with stopped(start(*arguments, **process_options)) as process:
        assert process.stdout is not None
        yield process.stdout.readline().strip().rpartition(" ")[2], process


_kept: dict[str, Any] = {}
"""Playwright and its browser: of all tests of a module, since their start takes seconds."""


@contextmanager
def chromium() -> Iterator[Any]:
    """A browser without a window; its pages are closed at the end of the block."""
    if "browser" not in _kept or not _kept["browser"].is_connected():
        close_chromium()
        _kept["playwright"] = sync_api.sync_playwright().start()
        options = {"executable_path": CHROMIUM, "args": ["--no-sandbox", "--disable-gpu"]}
        _kept["browser"] = _kept["playwright"].chromium.launch(**options)
    browser = _kept["browser"]
    before = list(browser.contexts)
    try:
        yield browser
    finally:
        for context in browser.contexts:
            if context not in before:
                context.close()


def close_chromium() -> None:
    """End the browser, if there is one."""
    if (browser := _kept.pop("browser", None)) is not None:
        browser.close()
    if (playwright := _kept.pop("playwright", None)) is not None:
        playwright.stop()


def new_page(browser: Any, **options: Any) -> Any:
    """A tab that waits for `WAIT`."""
    page = browser.new_page(**{"viewport": SIZE, **options})
    page.set_default_timeout(WAIT)
    page.add_init_script(OWN_CODE)
    return page


@contextmanager
def page_at(url: str, script: str = "", **options: Any) -> Iterator[Any]:
    """A page in a browser of its own, in which no script may fail and nothing may violate the page's policy.

    `script` runs before those of the page.
    """
    with chromium() as browser:
        page = new_page(browser, **options)
        errors: list[str] = []
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.on("console", lambda said: errors.extend([said.text] * ("Security Policy" in said.text)))
        if script:
            page.add_init_script(script)
        page.goto(url)
        yield page
        assert errors == []
