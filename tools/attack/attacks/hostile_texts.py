"""A robot whose names, joints, parts and services are programs and markup, in the page of an operator's console.

It needs a browser, since only that shows what a text becomes; without one it says so.
"""

from __future__ import annotations

import contextlib
import shutil
import subprocess
import sys
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Final

from jauspy.testing import LocalNode

from ..arena import Arena
from ..attack import Attack, Attacker, Bounds, Layout, NotPossible, Victims
from ..hostile_robot import PAYLOADS, SUBSYSTEM_ID

ROOT: Final = Path(__file__).parents[3]
BROWSERS: Final = ("chromium", "chromium-browser", "google-chrome")
TABS: Final = ("Video", "World", "Trajectory", "Plots", "Log")
SHOWN: Final = 700
"""Milliseconds for which each tab is shown."""
WAIT: Final = 120_000
"""Milliseconds for anything to appear."""
WATCH: Final = (
    "window.VIOLATIONS = [];"
    "document.addEventListener('securitypolicyviolation', (event) => window.VIOLATIONS.push(event.violatedDirective));"
)


def run(arena: Arena) -> None:
    """Load the page again and again, choose the robot, and open every component and tab."""
    executable = next(filter(None, map(shutil.which, BROWSERS)), None)
    if executable is None or find_spec("playwright") is None or find_spec("nicegui") is None:
        raise NotPossible("it needs chromium, playwright and the extra 'console'")
    from playwright.sync_api import sync_playwright  # noqa: PLC0415 - the other attacks need no browser

    with contextlib.ExitStack() as stack:
        node = stack.enter_context(LocalNode())
        stack.enter_context(_process("ready", "tools.attack.hostile_robot", node.local))
        options = ("console", "--no-browser", "--port", "0", "--connect", node.local)
        url = stack.enter_context(_process("the console is at", "jauspy.cli.main", *options)).rpartition(" ")[2]
        browser = stack.enter_context(sync_playwright()).chromium.launch(
            executable_path=executable, args=["--no-sandbox", "--disable-gpu"]
        )
        stack.callback(browser.close)
        while True:
            page = browser.new_page(viewport={"width": 1440, "height": 900})
            page.set_default_timeout(WAIT)
            page.add_init_script(WATCH)
            page.goto(url)
            visit(arena, page)
            page.close()
            if not arena.left:
                return


def visit(arena: Arena, page: Any) -> None:
    """Look at all that the robot says; it counts as sent what the page then shows."""
    robot = page.locator(".robot .name", has_text=f"{SUBSYSTEM_ID}  ")
    robot.wait_for()
    page.wait_for_timeout(SHOWN)
    shown = page.locator(".bar .title").inner_text()
    arena.require(shown == "", f"the robot of a stranger was chosen by itself: {shown}")
    robot.click()
    page.locator(".bar .title").get_by_text(str(SUBSYSTEM_ID)).wait_for()
    for component in page.locator(".component").all()[: len(PAYLOADS)]:
        component.click()
    for name in TABS:
        page.get_by_role("tab", name=name).click()
        page.wait_for_timeout(SHOWN)
    arena.sent += sum(page.locator("body").inner_text().count(text) for text in PAYLOADS)
    arena.require(page.evaluate("window.PWNED") is None, "a text of a robot ran as a program in the operator's page")
    found = page.evaluate("window.VIOLATIONS")
    arena.require(found == [], f"a text of a robot would have become a program without the policy: {found}")


@contextlib.contextmanager
def _process(first: str, module: str, *arguments: str) -> Iterator[str]:
    """Run a module while the context is open; its first line, which must begin like this."""
    command = [sys.executable, "-m", module, *arguments]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            line = process.stdout.readline().strip()
            if not line.startswith(first):
                raise NotPossible(f"{module} does not start: {line or 'it said nothing'}")
            yield line
        finally:
            process.terminate()


ATTACK: Final = Attack(
    "hostile-texts", Attacker.REMOTE, "texts", run, Bounds(memory=400.0), layout=Layout(Victims.COMMANDS)
)
