"""Views beside each other in a real browser: presets by key, sizes and places by the pointer, kept, full window."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, console_for, page_at
from tests.helpers.command_line import shared_robot

pytestmark = BROWSER_MARKS


@pytest.fixture(scope="module")
def url() -> Iterator[str]:
    with shared_robot(few_pictures=True) as running, console_for(running.local) as (address, _):
        yield address


def box(page: Any, view: str) -> dict[str, float]:
    found: dict[str, float] = page.locator(f".pane[data-view='{view}']").bounding_box()
    return found


def shown(page: Any) -> list[str]:
    names: list[str] = page.evaluate(
        "[...document.querySelectorAll('.pane')].filter((pane) => pane.offsetParent).map((pane) => pane.dataset.view)"
    )
    return names


def drag(page: Any, start: tuple[float, float], end: tuple[float, float]) -> None:
    page.mouse.move(*start)
    page.mouse.down()
    page.mouse.move((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    page.mouse.move(*end)
    page.mouse.up()


def press(page: Any, key: str) -> None:
    page.locator(".heading", has_text="Control").click()  # away from fields
    page.keyboard.press(key)


def test_video_and_map_are_beside_each_other_and_stay_as_arranged(url: str) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.locator("figure.large").wait_for()
        press(page, "Digit2")
        page.locator(".desk.arranged #world-map canvas").wait_for()
        assert shown(page) == ["Video", "World"]
        video, world = box(page, "Video"), box(page, "World")
        assert video["x"] + video["width"] < world["x"]
        assert video["width"] > world["width"] > 200
        page.locator("#world-map").click(position={"x": 60, "y": 60})
        page.locator(".waypoint").wait_for()
        page.locator("[aria-label='Drive']").wait_for()
        assert not page.locator(".arm").is_visible()

        edge = page.locator(".splitter[data-split='width']").bounding_box()
        middle = (edge["x"] + 5.0, edge["y"] + edge["height"] / 2)
        drag(page, middle, (middle[0] - 150.0, middle[1]))
        page.wait_for_function(f"document.querySelector('.pane[data-view=Video]').clientWidth < {video['width'] - 130}")
        page.locator(".splitter[data-split='width']").focus()
        narrow = box(page, "Video")["width"]
        page.keyboard.press("ArrowLeft")
        page.wait_for_function(f"document.querySelector('.pane[data-view=Video]').clientWidth < {narrow - 5}")
        title = box(page, "World")
        drag(page, (title["x"] + 40.0, title["y"] + 10.0), (video["x"] + 60.0, video["y"] + 200.0))
        page.wait_for_function("document.querySelector('.pane[data-view=World]').dataset.column === '0'")
        assert box(page, "World")["x"] < box(page, "Video")["x"]

        page.get_by_role("button", name="layout").click()
        page.get_by_text("view Events").click()
        page.wait_for_function("document.querySelector('.pane[data-view=Events]').offsetParent !== null")
        page.keyboard.press("Escape")
        page.locator(".layout-menu").wait_for(state="hidden")
        assert page.locator("#stop-answer").inner_text() == "", "Escape has closed the menu only"
        page.wait_for_timeout(300)
        before = {view: box(page, view) for view in shown(page)}
        page.reload()
        page.locator(".desk.arranged .pane[data-view='Events']").wait_for()
        assert {view: box(page, view) for view in shown(page)} == before


def test_one_view_fills_the_window_and_stop_stays(url: str) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.locator("figure.large").wait_for()
        page.locator(".part-name").get_by_text("flippers").wait_for()
        cut = "each.getBoundingClientRect().right > each.parentElement.getBoundingClientRect().right + 1"
        assert page.evaluate(f"[...document.querySelectorAll('.part-name')].filter((each) => {cut}).length") == 0
        press(page, "Digit2")
        page.locator(".desk.arranged").wait_for()
        before = box(page, "Video")
        page.locator("figure.large").click()
        page.keyboard.press("KeyF")
        page.locator(".side").wait_for(state="hidden")
        assert shown(page) == ["Video"]
        assert box(page, "Video")["width"] > 1400 > before["width"]
        assert page.locator("#stop").is_visible()
        page.keyboard.press("Escape")
        page.locator("#stop-answer").get_by_text("components stopped").wait_for()
        page.get_by_role("button", name="clear emergency").click()
        page.locator("#stop-answer").get_by_text(re.compile("released|no component answered")).wait_for()
        page.keyboard.press("KeyF")
        page.locator(".side").wait_for()
        assert box(page, "Video") == before

        page.keyboard.press("KeyF")
        page.locator(".side").wait_for(state="hidden")
        page.keyboard.press("Digit4")
        page.locator(".side").wait_for()
        page.wait_for_function("document.querySelector('.pane[data-view=Events]').offsetParent !== null")
        page.keyboard.press("KeyF")
        page.locator(".side").wait_for(state="hidden")
        page.get_by_role("button", name="Video: close").click()
        page.locator(".side").wait_for()
        assert shown(page) == ["World", "Events"]


@pytest.mark.parametrize(("width", "height"), [(1280, 800), (1024, 768)])
def test_small_pictures_cover_nothing_and_notes_take_one_line(url: str, width: int, height: int) -> None:
    with page_at(url, viewport={"width": width, "height": height}) as page:
        page.wait_for_function("jauspy.video.views.size === 3")
        page.evaluate(
            "document.getElementById('video-load').textContent = 'this page is slow: '.repeat(20);"
            "document.querySelector('.video-said').textContent = 'recording to a folder with a long name '.repeat(9)"
        )
        bar, notes = (page.locator(f".{name}").bounding_box() for name in ("video-bar", "video-notes"))
        assert bar["height"] < 40.0
        assert notes["height"] < 22.0
        boxes = [each.bounding_box() for each in page.locator("figure").all()]
        for number, one in enumerate(boxes):
            assert one["x"] + one["width"] <= width
            assert one["y"] + one["height"] <= height
            for other in boxes[number + 1 :]:
                apart = (
                    one["x"] + one["width"] <= other["x"] + 0.5
                    or other["x"] + other["width"] <= one["x"] + 0.5
                    or one["y"] + one["height"] <= other["y"] + 0.5
                    or other["y"] + other["height"] <= one["y"] + 0.5
                )
                assert apart, (one, other)


@pytest.mark.parametrize(("width", "height"), [(1440, 900), (1024, 768)])
def test_waypoints_and_their_buttons_have_room(url: str, width: int, height: int) -> None:
    with page_at(url, viewport={"width": width, "height": height}) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.get_by_role("tab", name="World").click()
        page.wait_for_function("jauspy.world.pose && jauspy.map.toScreen(jauspy.world.pose)")
        for number, x in enumerate((60, 90, 120)):
            page.locator("#world-map canvas").click(position={"x": x, "y": 60})
            page.locator(".waypoint").nth(number).wait_for()
        route, held, execution = (page.locator(f".{name}").bounding_box() for name in ("route", "held", "execution"))
        assert held["height"] > 100.0
        assert held["y"] + held["height"] <= execution["y"]
        assert execution["y"] + execution["height"] <= route["y"] + route["height"] + 0.5
        for key, others in (("Digit2", ["Video", "World"]), ("Digit4", ["Video", "World", "Events"])):
            press(page, key)
            page.wait_for_function(
                f"[...document.querySelectorAll('.pane')].filter((pane) => pane.offsetParent).length === {len(others)}"
            )
            assert page.evaluate(COVERED) == [], key


COVERED = """[...document.querySelectorAll(".execution :is(button, .q-field)")].filter((each) => {
    const { left, right, top, bottom } = each.getBoundingClientRect();
    const isSeen = ([x, y]) => each.contains(document.elementFromPoint(x, y));
    return each.offsetParent && ![[left + 6, top + 6], [right - 6, bottom - 6]].every(isSeen);
}).map((each) => each.innerText)"""
"""The buttons and fields below the waypoints that are not in sight as a whole."""
