"""A gamepad in a real browser moves a robot only while its dead-man's button is held and the page has the focus."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import suppress
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, GAMEPAD, HOLD_FOR_ARM, HOLD_TO_DRIVE, console_for, page_at, sync_api
from tests.helpers.command_line import shared_robot

pytestmark = BROWSER_MARKS


@pytest.fixture
def url() -> Iterator[str]:
    with shared_robot(few_pictures=True) as robot, console_for(robot.local) as (address, _):
        yield address


def press(page: Any, button: int, *, down: bool = True) -> None:
    page.evaluate(f"pad.buttons[{button}].pressed = {str(down).lower()}")


def deflection(page: Any) -> list[float]:
    found: list[float] = page.evaluate("jauspy.deflection().map((value) => Math.round(100 * value) / 100 + 0)")
    return found


def take(page: Any) -> None:
    """Take control, again when it is refused: on a busy machine a component may not be Ready in time."""
    for _ in range(6):
        page.get_by_role("button", name="take", exact=True).first.click()
        with suppress(sync_api.TimeoutError):
            page.get_by_text("you operate this robot").wait_for(timeout=15_000)
            return
    pytest.fail("control is not granted")


def test_a_gamepad_drives_while_its_button_is_held(url: str) -> None:
    with page_at(url, GAMEPAD + f"pad.buttons[{HOLD_TO_DRIVE}].pressed = true; pad.axes[1] = -1;") as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.wait_for_function("jauspy.gamepad !== undefined")
        page.bring_to_front()
        assert deflection(page) == [0, 0]  # it was down before
        press(page, HOLD_TO_DRIVE, down=False)
        assert deflection(page) == [0, 0]
        press(page, HOLD_TO_DRIVE)
        assert deflection(page) == [0, 0]  # without control, as the page says
        page.locator("#drive-answer").get_by_text("take control first").wait_for()
        take(page)
        page.wait_for_function("jauspy.operates")
        page.locator("#drive-answer").get_by_text("take control first").wait_for(state="hidden")
        assert deflection(page) == [0, 0]  # it was down when control came
        press(page, HOLD_TO_DRIVE, down=False)
        assert deflection(page) == [0, 0]  # the stick alone
        press(page, HOLD_TO_DRIVE)
        assert deflection(page) == [1, 0]
        press(page, HOLD_FOR_ARM)
        page.evaluate("window.dispatchEvent(new Event('blur'))")
        assert deflection(page) == [0, 0]
        press(page, HOLD_TO_DRIVE, down=False)
        assert deflection(page) == [0, 0]

        page.evaluate("pad.axes[1] = 0")
        assert deflection(page) == [0, 0]
        press(page, HOLD_TO_DRIVE)
        page.evaluate("pad.axes[1] = -1")
        page.wait_for_function("/x ([1-9]|0\\.[2-9])/.test(document.body.innerText)")
        page.evaluate("document.hasFocus = () => false")
        assert deflection(page) == [0, 0]
        page.wait_for_function("jauspy.moving === false")

        page.evaluate("document.hasFocus = () => true")
        press(page, HOLD_TO_DRIVE, down=False)
        assert deflection(page) == [0, 0]
        press(page, HOLD_TO_DRIVE)
        assert deflection(page) == [1, 0]
        page.keyboard.press("F8")
        page.get_by_text("components stopped").first.wait_for()
        assert deflection(page) == [0, 0]
        page.wait_for_function("!jauspy.operates")
        page.evaluate("jauspy.operate(true)")  # as after clearing the emergency and taking control
        assert deflection(page) == [0, 0]  # held through all of it
        press(page, HOLD_TO_DRIVE, down=False)
        assert deflection(page) == [0, 0]
        press(page, HOLD_TO_DRIVE)
        assert deflection(page) == [1, 0]


def test_the_mapping_and_the_calibration_of_a_pad_are_kept(url: str) -> None:
    with page_at(url, GAMEPAD) as page:
        page.locator(".gamepads summary").click()
        page.evaluate("jauspy.operates = true")
        card = page.locator("[data-pad]")
        assert card.locator("b").first.inner_text() == "<b>pad</b> of a test"
        card.get_by_label("hold to drive").select_option("6")
        card.get_by_label("drive forward").select_option("2")
        page.evaluate("pad.axes = [0, 0, 0.1, 0]")
        calibrate = card.locator(".pad-calibrate")
        calibrate.click()
        for end in (0.6, -0.6):
            page.evaluate(f"pad.axes[2] = {end}")
            page.wait_for_function(f"jauspy.gamepad.calibration.ranges[2].includes({end})")
        press(page, 6)
        assert deflection(page) == [0, 0]  # nothing moves during the calibration
        press(page, 6, down=False)
        calibrate.click()
        page.reload()
        page.locator(".gamepads summary").wait_for()
        page.evaluate("jauspy.operates = true")
        page.evaluate("pad.axes[2] = 0.6")
        assert deflection(page) == [0, 0]
        press(page, 6)
        assert deflection(page) == [1, 0]
        page.evaluate("pad.axes[2] = 0.1")
        assert deflection(page) == [0, 0]
        hostile = json.dumps({"map": {"forward": "9999", "driveHold": "x"}, "ranges": 3})
        page.evaluate(f"localStorage.setItem(jauspy.gamepad.key(pad), {json.dumps(hostile)})")
        page.evaluate("pad.axes[2] = 0.6")
        assert deflection(page) == [0, 0]  # what cannot be read counts as not kept


def test_escape_closes_what_is_open_and_f8_stops(url: str) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        take(page)
        page.locator(".arm .q-select").first.click()
        page.locator(".q-menu").wait_for()
        page.keyboard.press("Escape")
        page.locator(".q-menu").wait_for(state="detached")
        assert page.locator("#stop-answer").inner_text() == ""
        page.keyboard.press("F8")
        page.get_by_text("components stopped").first.wait_for()
        page.get_by_role("region", name="Control").get_by_text("STOP ALL by this page has ended it").wait_for()
