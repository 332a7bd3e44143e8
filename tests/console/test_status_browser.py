"""The line below the bar in a real browser: mode, link, age of the video, an alarm with sound until acknowledged."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress

import pytest
from tests.helpers.browser import BROWSER_MARKS, console_for, page_at, sync_api
from tests.helpers.command_line import shared_robot

pytest.importorskip("av", reason="the extra 'video' is not installed")

pytestmark = BROWSER_MARKS


@pytest.fixture(scope="module")
def url() -> Iterator[str]:
    with shared_robot(few_pictures=True) as running, console_for(running.local) as (address, _):
        yield address


def test_an_emergency_is_an_alarm_that_is_acknowledged(url: str) -> None:
    with page_at(url, viewport={"width": 1024, "height": 768}) as page:
        page.locator(".status .mode").get_by_text("standby, observing").wait_for()
        page.locator(".status .battery").get_by_text(re.compile(r"battery  \d+ %")).wait_for()
        page.locator(".status-link").get_by_text(re.compile(r"link \d+ ms, \d+ % lost")).wait_for()
        page.locator("#video-age").get_by_text(re.compile(r"video \d+ ms")).wait_for()
        page.get_by_role("button", name="take", exact=True).click()
        page.locator(".status .mode").get_by_text("ready, you operate, velocity").wait_for()
        page.locator(".heading", has_text="Control").click()
        page.keyboard.press("F8")
        page.locator(".alarms .alarm-text").get_by_text("the robot is in emergency").wait_for()
        assert page.evaluate("document.body.dataset.beeps > 0")
        page.wait_for_function(
            "[...document.querySelectorAll('#time-line [data-kind=stop]')]"
            ".some((mark) => mark.title.includes('emergency stop of all'))"
        )
        bar = page.locator(".status").bounding_box()
        assert bar["height"] < 34.0
        for part in page.locator(".status > *:visible").all():
            box = part.bounding_box()
            assert box["x"] + box["width"] <= 1024.0
            assert box["y"] + box["height"] <= bar["y"] + bar["height"] + 1.0
        assert page.locator("#alarm-sound").is_visible()
        page.locator(".alarms .alarm-text").hover()
        page.locator(".alarm-list").get_by_text("the robot is in emergency").wait_for()
        page.keyboard.press("KeyQ")
        page.wait_for_function(
            "document.querySelector('.lines').innerText.match(/acknowledged: .*the robot is in emergency/)"
        )
        mode = page.locator(".status .mode")
        for _ in range(6):  # a robot that has just started releases some of its components too late, as the log tells
            page.get_by_role("button", name="clear emergency").click()
            with suppress(sync_api.TimeoutError):
                mode.get_by_text(re.compile("standby|ready")).wait_for(timeout=15_000)
                break
        page.wait_for_function(  # one that came again, as while packets are late, stays until it is acknowledged
            "!/in emergency(?! \\(is over)/.test(document.querySelector('.alarm-text').innerText)"
        )


def test_old_video_is_an_alarm_and_the_sound_is_switched(url: str) -> None:
    with page_at(url) as page:
        page.locator("#video-age").get_by_text(re.compile(r"video \d+ ms")).wait_for()
        page.locator("#alarm-sound").click()
        page.locator("#alarm-sound").get_by_text("sound off").wait_for()
        page.evaluate("jauspy.video.views.forEach((view) => { view.decode = () => {}; })")  # no picture comes any more
        page.locator(".alarm-text").get_by_text("the large picture is old").wait_for()
        page.locator("#video-age[data-old]").wait_for()
        assert page.evaluate("document.body.dataset.beeps") is None
