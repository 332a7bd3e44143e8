"""A tablet of 1024x768: every control can be reached by touch, and the stick drives."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from tests.console.test_browser import x_of
from tests.helpers.browser import BROWSER_MARKS, console_for, page_at
from tests.helpers.command_line import shared_robot

pytestmark = BROWSER_MARKS
HIDDEN = """() => {
    const middle = (box) => [box.x + box.width / 2, box.y + box.height / 2];
    const found = [];
    for (const each of document.querySelectorAll('button, [role=slider], #stick, .q-field, .q-checkbox')) {
        if (!each.checkVisibility() || each.closest('[aria-hidden=true], .disabled')) continue;
        each.scrollIntoView({ block: 'nearest', inline: 'nearest' });
        const top = document.elementFromPoint(...middle(each.getBoundingClientRect()));
        if (!top || !(each.contains(top) || top.contains(each))) found.push(each.outerHTML.slice(0, 200));
    }
    return found;
}"""
"""Controls that something else covers, or that no scrolling brings into view."""
SMALL = """() => [...document.querySelectorAll('.bar button, .tabs button, .panel .q-btn, .video-bar button')]
    .filter((each) => each.checkVisibility() && each.getBoundingClientRect().height < 40)
    .map((each) => each.outerHTML.slice(0, 200))"""


@pytest.fixture(scope="module")
def url(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    poses = tmp_path_factory.mktemp("poses") / "poses.toml"
    poses.write_text("[inc1.ahead]\nbase_link_to_arm_link_1 = 0.2\n[inc1.other]\nno_such_joint = 1.0\n")
    with shared_robot(few_pictures=True) as robot, console_for(robot.local, "--poses", str(poses)) as (address, _):
        yield address


@pytest.fixture
def page(url: str) -> Iterator[Any]:
    with page_at(url, viewport={"width": 1024, "height": 768}, has_touch=True) as opened:
        opened.get_by_text("101 inc1").first.wait_for()
        opened.get_by_role("button", name="take", exact=True).tap()
        opened.get_by_text("you operate this robot").wait_for()
        yield opened


def test_every_control_is_in_reach_and_large_enough(page: Any) -> None:
    for tab in ("Video", "World", "Trajectory", "Plots", "Log"):
        page.get_by_role("tab", name=tab).tap()
        page.locator(f".tabs .chosen >> text={tab}").wait_for()
        for view in ("joints", "tool", "poses"):
            page.locator("section.arm").get_by_text(view, exact=True).first.tap()
            assert page.evaluate(HIDDEN) == [], (tab, view)
            assert page.evaluate(SMALL) == [], (tab, view)


def test_a_finger_on_the_stick_drives_until_it_is_lifted(page: Any) -> None:
    page.locator(".facts b").wait_for()
    before = x_of(page)
    box = page.locator("#stick").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    finger = page.context.new_cdp_session(page)

    def touch(kind: str, *points: tuple[float, float]) -> None:
        at = [{"x": each[0], "y": each[1]} for each in points]
        finger.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": at})

    touch("touchStart", (x, y))
    for step in range(1, 6):
        touch("touchMove", (x, y - step * box["height"] / 10))
    page.wait_for_function(f"parseFloat(document.querySelector('.facts b').innerText.split(' ')[1]) > {before + 0.3}")
    assert page.evaluate("jauspy.moving")
    touch("touchEnd")
    page.wait_for_function("!jauspy.moving && jauspy.stick.forward === 0")


def test_a_pose_of_the_file_is_reached(page: Any) -> None:
    page.locator("section.arm").get_by_text("poses", exact=True).first.tap()
    page.get_by_text("poses of the file for other joints: 1").wait_for()
    page.get_by_role("button", name="go to ahead").tap()
    page.locator("section.arm").get_by_text("joints", exact=True).first.tap()
    page.locator(".joint-value").first.get_by_text("0.200 rad").wait_for()


def test_long_words_on_a_small_picture_stay_inside(page: Any) -> None:
    page.get_by_role("tab", name="Video").tap()
    note = page.locator("figure:not(.large) .video-note").first
    note.wait_for(state="attached")
    outside = note.evaluate("""(each) => {
        each.textContent = 'no picture: ' + 'the robot has not agreed to send to rtp://127.0.0.1:60728; '.repeat(9);
        const [inner, outer] = [each, each.closest('figure')].map((box) => box.getBoundingClientRect());
        return inner.bottom > outer.bottom || inner.right > outer.right;
    }""")
    assert not outside
