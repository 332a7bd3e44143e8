"""Keys in a real browser: what is open gets them, Escape closes before it stops, letters are those of the layout."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, console_for, page_at
from tests.helpers.command_line import shared_robot

pytestmark = BROWSER_MARKS

NOTE_STOPS = "window.stops = 0; jauspy.stop = () => { stops += 1; }; 0"
"""Counts stops of a page instead of sending them."""
NOTE_EVENTS = (
    "window.events = []; const send = emitEvent; emitEvent = (...all) => { events.push(all[0]); send(...all); }; 0"
)
"""Notes the names of what a page tells the console."""
SENT = "[...jauspy.keys].length + jauspy.jog.held.size"
"""How many keys of a page move something."""


@pytest.fixture(scope="module")
def url() -> Iterator[str]:
    with shared_robot(few_pictures=True) as running, console_for(running.local) as (address, _):
        yield address


def stops(page: Any) -> int:
    found: int = page.evaluate("window.stops")
    return found


def test_a_key_that_is_held_when_control_comes_moves_nothing(url: str) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.locator(".heading", has_text="Control").click()
        page.keyboard.down("KeyW")
        assert page.evaluate("jauspy.deflection()") == [1, 0]
        page.get_by_role("button", name="take", exact=True).click()
        page.get_by_text("you operate this robot").wait_for()
        page.wait_for_function("jauspy.operates && jauspy.deflection()[0] === 0")
        page.keyboard.down("KeyW")  # as a keyboard repeats what is held
        assert page.evaluate("jauspy.deflection()") == [0, 0]
        page.keyboard.up("KeyW")
        page.keyboard.down("KeyW")
        assert page.evaluate("jauspy.deflection()") == [1, 0]
        page.keyboard.up("KeyW")
        page.get_by_role("button", name="release", exact=True).click()


def test_what_is_open_gets_the_keys(url: str) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.locator(".arm").get_by_text("tool", exact=True).first.click()
        page.locator(".jog[data-component='101.1.104']").wait_for()
        page.evaluate(NOTE_EVENTS)
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
            assert page.evaluate("events.concat([...document.body.classList].filter((name) => name === 'full'))") == []
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


AZERTY = """Object.defineProperty(navigator, "keyboard", { configurable: true, value: {
    getLayoutMap: async () => new Map([["KeyW", "z"], ["KeyA", "q"], ["KeyS", "s"], ["KeyD", "d"], ["KeyQ", "a"]])
} })"""


def test_letters_are_those_of_the_keyboards_layout(url: str) -> None:
    with page_at(url, AZERTY) as page:
        page.get_by_text("Z Q S D, arrows").wait_for()
        assert page.get_by_role("img", name="stick; drive by the keys Z Q S D").count() == 1
        assert page.locator(".acknowledge").get_attribute("title") == "key A; it also ends the sound"
        page.keyboard.press("?")
        page.get_by_role("dialog", name="keyboard help").get_by_text("Z Q S D, arrows").wait_for()
        page.keyboard.press("Escape")
        page.locator(".arm").get_by_text("tool", exact=True).first.click()
        page.locator(".jog[data-component='101.1.104']").wait_for()

        def key(code: str, letter: str, kind: str = "keydown") -> None:
            given = f"{{ code: '{code}', key: '{letter}', bubbles: true }}"
            page.evaluate(f"document.body.dispatchEvent(new KeyboardEvent('{kind}', {given})); 0")

        page.evaluate(NOTE_EVENTS)
        key("KeyA", "q")
        assert page.evaluate("[...jauspy.keys]") == ["KeyA"]
        assert page.evaluate("events") == [], "it drives, and acknowledges nothing"
        key("KeyA", "q", "keyup")
        key("KeyQ", "a")
        assert page.evaluate("events") == ["alarms_acknowledged"]
        key("KeyO", "I")
        assert page.evaluate("[...jauspy.jog.held.values()]") == [[0, 1]]
        key("KeyW", "z")
        key("MetaLeft", "Meta", "keyup")  # macOS has not told that the others were released
        assert page.evaluate(SENT) == 0
        key("KeyY", "f")
        assert page.evaluate("document.body.classList.contains('full')")
        names = (
            "(async () => { document.documentElement.lang = 'fr'; await jauspy.nameKeys(); return jauspy.keyNames; })()"
        )
        page.evaluate("Object.defineProperty(navigator, 'keyboard', { value: undefined }); 0")
        assert page.evaluate(names) == {"W": "Z", "A": "Q", "S": "S", "D": "D", "Q": "A"}
