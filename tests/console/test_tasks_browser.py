"""The view Tasks in a real browser: the way back, following, handoff with another client, listening, announcing."""

from __future__ import annotations

import io
import math
import re
import struct
import wave
from collections.abc import Iterator
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, console_for, page_at
from tests.helpers.command_line import RunningRobot, shared_robot

pytest.importorskip("av", reason="sound needs the extra 'video'")

pytestmark = BROWSER_MARKS
STRICT = "101.1.110"
"""The component with EnhancedAccessControl."""


@pytest.fixture(scope="module")
def robot() -> Iterator[RunningRobot]:
    with shared_robot(few_pictures=True) as running:
        yield running


@pytest.fixture(scope="module")
def url(robot: RunningRobot) -> Iterator[str]:
    with console_for(robot.local) as (address, _):
        yield address


def open_tasks(page: Any) -> None:
    page.get_by_text("101 inc1").first.wait_for()
    page.get_by_role("tab", name="Tasks").click()
    page.locator(".card[aria-label='Way back']").wait_for()


def beep(seconds: float) -> bytes:
    """A WAV file."""
    content = io.BytesIO()
    with wave.open(content, "wb") as file:
        file.setparams((1, 2, 8000, 0, "NONE", ""))
        for number in range(round(8000 * seconds)):
            file.writeframesraw(struct.pack("<h", round(9000 * math.sin(0.5 * number))))
    return content.getvalue()


def test_a_robot_drives_back_the_way_it_came(url: str) -> None:
    with page_at(url) as page:
        open_tasks(page)
        card = page.locator(".card[aria-label='Way back']")
        go = card.get_by_role("button", name="drive back", exact=True)
        assert go.is_disabled()
        card.get_by_text("take control").wait_for()
        page.get_by_role("button", name="take", exact=True).click()
        page.get_by_text("you operate this robot").wait_for()
        page.locator(".heading", has_text="Control").click()
        page.keyboard.down("KeyW")
        page.wait_for_function("parseFloat(document.querySelector('.facts b').innerText.slice(2)) > 0.9")
        page.keyboard.up("KeyW")
        page.wait_for_timeout(700)
        card.get_by_label("distance in m").fill("0.5")
        page.keyboard.press("Tab")
        page.locator(".card[aria-label='Way back'] button:not([disabled])", has_text="drive back").click()
        card.get_by_text(re.compile(r"\d+ % driven")).wait_for()
        card.get_by_text(re.compile(r"drove 0\.\d m back")).wait_for()
        page.wait_for_function("parseFloat(document.querySelector('.facts b').innerText.slice(2)) < 0.75")
        card.get_by_label("distance in m").fill("100")
        page.keyboard.press("Tab")
        card.get_by_role("button", name="drive back", exact=True).click()
        card.get_by_role("button", name="stop driving back").click()
        page.locator(".card[aria-label='Way back'] button:not([disabled])", has_text="drive back").wait_for()
        follow = page.locator(".card[aria-label='Follow']")
        follow.get_by_text("no other robot here tells its pose on the globe").wait_for()
        assert follow.get_by_role("button", name="follow", exact=True).is_disabled()
        follow.get_by_text("follows nobody").wait_for()
        page.get_by_role("button", name="release", exact=True).first.click()


def test_a_component_is_handed_over_to_another_browser(url: str) -> None:
    with page_at(url) as page:
        open_tasks(page)
        card = page.locator(".card[aria-label='Handoff']")
        card.get_by_role("button", name=f"take {STRICT}").click()
        card.get_by_text("you have control").wait_for()
        other = page.context.browser.new_page()
        other.goto(url)
        open_tasks(other)
        other.locator(".card[aria-label='Handoff']").get_by_text("has control, in another browser").wait_for()
        other.close()
        card.get_by_role("button", name=f"release {STRICT}").click()
        card.get_by_text("nobody has control").wait_for()


def test_an_operator_listens_and_announces(url: str) -> None:
    with page_at(url) as page:
        open_tasks(page)
        card = page.locator(".card[aria-label='Sound']")
        page.mouse.click(5, 500)
        card.get_by_role("button", name="listen").click()
        card.get_by_text(re.compile(r"-\d+ dB")).wait_for()
        page.locator(".card audio").wait_for()
        page.wait_for_function("document.querySelector('.card audio').currentTime > 0.2")
        card.get_by_role("button", name="mute").click()
        page.locator(".card audio").wait_for(state="detached")
        card.get_by_role("button", name="listen").wait_for()
        for _ in range(5):  # on a busy machine the robot may not answer in time, which the card says
            page.locator(".sound input[type=file]").set_input_files(
                {"name": "beep.wav", "mimeType": "audio/wav", "buffer": beep(0.5)}
            )
            card.get_by_text("plays beep.wav").wait_for()
            card.get_by_text("plays beep.wav").wait_for(state="detached")
            if re.search(r"played 0\.\d s of beep.wav", card.inner_text()):
                break
        else:
            pytest.fail(card.inner_text())
        page.locator(".sound input[type=file]").set_input_files(
            {"name": "noise.wav", "mimeType": "audio/wav", "buffer": b"no sound at all"}
        )
        card.get_by_text(re.compile("noise.wav")).wait_for()
