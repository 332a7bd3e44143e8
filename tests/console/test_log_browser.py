"""The tab Log in a real browser, while messages stream in: no click is lost, and what is paused is what is filtered."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, console_for, page_at
from tests.helpers.command_line import shared_robot

pytestmark = BROWSER_MARKS
CLICKS = 50
NEWEST = "document.querySelector('.traffic tbody tr').innerText"

MIDDLE = """index => {
    const box = document.querySelectorAll('.traffic tbody tr')[index].getBoundingClientRect();
    return [box.x + 40, box.y + box.height / 2];
}"""
"""Where a row of the list is."""


@pytest.fixture(scope="module")
def url() -> Iterator[str]:
    with shared_robot(few_pictures=True) as robot, console_for(robot.local) as (address, _):
        yield address


@pytest.fixture
def page(url: str) -> Iterator[Any]:
    """A page whose tab Log lists the periodic messages, too."""
    with page_at(url) as opened:
        opened.get_by_text("101 inc1").first.wait_for()
        opened.get_by_role("tab", name="Log").click()
        opened.get_by_text("routine", exact=True).click()
        opened.wait_for_function("document.querySelectorAll('.traffic tbody tr').length > 40")
        yield opened


def press_on(page: Any, index: int) -> tuple[str, str]:
    """Press the button on this row of the list; returns the row's time, and the text of the newest row."""
    while True:
        newest = page.evaluate(NEWEST)
        page.mouse.move(*page.evaluate(MIDDLE, index))
        page.mouse.down()
        time = page.evaluate("pressedRow")
        if time is not None:
            return time, newest
        page.mouse.up()


def test_no_click_is_lost_while_messages_stream_in(page: Any) -> None:
    page.evaluate(
        "addEventListener('pointerdown', (event) => window.pressedRow ="
        " event.target.closest('.traffic tbody tr')?.cells[0].innerText ?? null, true)"
    )
    for number in range(CLICKS):
        time, newest = press_on(page, number % 8)
        if number % 5 == 0:  # the list moves under a button that is held
            page.wait_for_function(f"newest => {NEWEST} !== newest", arg=newest)
        page.mouse.up()
        page.locator(".details").get_by_text(time).wait_for(timeout=10_000)


def test_a_pause_right_after_typing_keeps_what_fits_the_filter(page: Any) -> None:
    page.get_by_label("filter").fill("reportstatus 101.1.102")
    page.get_by_role("button", name="pause").click()
    page.get_by_role("button", name="resume").wait_for()
    page.wait_for_function(
        "[...document.querySelectorAll('.traffic tbody tr')].every((row) => row.innerText.includes('ReportStatus'))"
    )
    page.locator(".traffic tbody tr").first.click()
    page.locator(".fields .path").get_by_text("status", exact=True).wait_for()
