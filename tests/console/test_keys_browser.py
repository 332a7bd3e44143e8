"""Keys in a real browser: what is open gets them and nothing moves, Escape closes before it stops, letters by layout."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, console_for, page_at
from tests.helpers.command_line import shared_robot

pytestmark = BROWSER_MARKS

NOTE_STOPS = "window.stops = 0; jauspy.stop = () => { stops += 1; }; 0"
"""Counts stops of a page instead of sending them."""
SENT = "[...jauspy.keys].length + jauspy.jog.held.size"
"""How many keys of a page move something."""


@pytest.fixture(scope="module")
def url() -> Iterator[str]:
    with shared_robot(few_pictures=True) as running, console_for(running.local) as (address, _):
        yield address


def stops(page: Any) -> int:
    found: int = page.evaluate("window.stops")
    return found


def test_what_is_open_gets_the_keys(url: str) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.locator(".arm").get_by_text("tool", exact=True).first.click()
        page.locator(".jog[data-component='101.1.104']").wait_for()
        presets = "window.presets = []; const before = emitEvent; emitEvent = (...all) => { presets.push(all[0]); before(...all); }; 0"
        page.evaluate(presets)
        for opens, shown in (("?", "dialog[open]"), ("view", ".q-dialog__inner"), ("layout", ".q-menu")):
            page.locator(".heading", has_text="Control").click()
            page.keyboard.down("KeyW")
            page.keyboard.down("KeyI")
            assert page.evaluate(SENT) == 2
            if opens == "?":
                page.keyboard.press(opens)
            else:
                page.locator("button", has_text=opens).first.click()
            page.locator(shown).first.wait_for()
            page.wait_for_function(f"{SENT} === 0")
            for key in ("KeyW", "KeyI"):
                page.keyboard.up(key)
            for key in ("KeyW", "ArrowUp", "KeyI"):
                page.keyboard.down(key)
                assert page.evaluate(SENT) == 0, (opens, key)
                page.keyboard.up(key)
            for key in ("Digit2", "KeyF", "KeyQ"):
                page.keyboard.press(key)
            assert page.evaluate("presets.concat([...document.body.classList].filter((name) => name === 'full'))") == []
            page.keyboard.press("Escape")
            page.locator(shown).first.wait_for(state="hidden")
        page.get_by_role("tab", name="World").focus()
        page.keyboard.down("ArrowRight")
        assert page.evaluate(SENT) == 0, "a tab has the arrow keys"
        page.keyboard.down("KeyW")
        assert page.evaluate(SENT) == 1
        page.keyboard.up("KeyW")


def test_escape_closes_what_is_open_and_its_second_press_stops(url: str) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.evaluate(NOTE_STOPS)
        page.get_by_role("button", name="settings").click()
        page.locator(".video-settings .heading").first.wait_for()
        page.keyboard.press("Escape")
        page.locator(".video-settings").wait_for(state="hidden")
        assert stops(page) == 0

        page.get_by_role("tab", name="World").click()
        page.wait_for_function("jauspy.world.pose && jauspy.map.toScreen(jauspy.world.pose)")
        page.get_by_role("button", name="mission …").click()
        page.get_by_role("button", name="draw an area").click()
        page.get_by_text("click the corners").wait_for()
        page.locator(".q-dialog").wait_for(state="detached")
        page.keyboard.press("Escape")
        page.get_by_text("click the corners").wait_for(state="hidden")
        assert stops(page) == 0

        field = page.locator(".execution").get_by_label("m/s", exact=True)
        field.fill("0.3")
        page.keyboard.press("Escape")
        assert stops(page) == 0
        assert field.evaluate("(field) => document.activeElement !== field")
        field.fill("")
        page.keyboard.press("Escape")
        assert stops(page) == 1

        page.get_by_role("button", name="layout").click()
        page.locator(".q-menu").wait_for()
        page.wait_for_timeout(500)
        page.keyboard.press("Escape")
        page.wait_for_timeout(100)
        page.keyboard.press("Escape")
        assert stops(page) == 2, "the first closed the menu, the second stops"
        page.locator(".q-menu").wait_for(state="detached")
        page.get_by_role("button", name="axes and units").click()
        page.locator(".q-dialog__inner").wait_for()
        page.wait_for_timeout(500)
        page.keyboard.press("F8")
        assert stops(page) == 3
        page.keyboard.press("Escape")
        page.wait_for_timeout(100)
        page.keyboard.press("Escape")
        assert stops(page) == 4
