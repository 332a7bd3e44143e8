"""Axes and units, the help about keys, names for screen readers, and sliders that follow fast presses, in a browser."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, console_for, page_at
from tests.helpers.command_line import shared_robot

pytestmark = BROWSER_MARKS
FIELDS = ("checkbox", "combobox", "listbox", "radio", "searchbox", "slider", "spinbutton", "switch", "textbox")
NAMED = (*FIELDS, "button", "Canvas", "dialog", "image", "link", "menu", "progressbar", "region", "tab")
"""Roles that WAI-ARIA requires a name of."""


@pytest.fixture(scope="module")
def url() -> Iterator[str]:
    with shared_robot(few_pictures=True) as robot, console_for(robot.local) as (address, _):
        yield address


def unnamed(page: Any) -> tuple[int, list[str]]:
    """How many elements need a name in chromium's accessibility tree, and those that have none."""
    session = page.context.new_cdp_session(page)
    count, found = 0, []
    for node in session.send("Accessibility.getFullAXTree")["nodes"]:
        role = node.get("role", {}).get("value", "")
        if node.get("ignored") or role not in NAMED:
            continue
        count += 1
        if not node.get("name", {}).get("value", "").strip() and "backendDOMNodeId" in node:
            described = session.send("DOM.describeNode", {"backendNodeId": node["backendDOMNodeId"]})["node"]
            found.append(f"{role} <{described['localName']} {' '.join(described.get('attributes', []))[:200]}>")
    session.detach()
    return count, found


def test_every_input_has_a_name_for_screen_readers(url: str) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        counts = {}
        for tab in ("Video", "World", "Trajectory", "Tasks", "Plots", "Log", "Recordings"):
            page.get_by_role("tab", name=tab).click()
            page.wait_for_timeout(1500)
            counts[tab], without = unnamed(page)
            assert without == [], tab
            if tab == "World":
                page.get_by_role("button", name="mission …").click()
                page.get_by_role("button", name="draw an area").wait_for()
                page.wait_for_timeout(500)
                assert unnamed(page)[1] == []
                page.keyboard.press("Escape")
        for mode in ("tool", "poses"):
            page.locator(".arm").get_by_text(mode, exact=True).first.click()
            page.wait_for_timeout(1000)
            assert unnamed(page)[1] == [], mode
        assert min(counts.values()) > 30, counts


def test_axes_and_units_are_chosen_and_kept(url: str) -> None:
    with page_at(url) as page:
        page.get_by_text("yaw 0°").wait_for()
        page.get_by_role("button", name="axes and units").click()
        page.get_by_role("button", name="JAUS", exact=True).click()
        page.get_by_role("button", name="feet").click()
        page.get_by_role("dialog", name="axes and units").get_by_role("button", name="close").click()
        page.get_by_text("heading 0°").wait_for()
        page.locator(".facts b").get_by_text("ft").wait_for()
        page.locator("figure.large .numbers").get_by_text("0.0 ft/s").wait_for()
        page.reload()
        page.get_by_text("heading 0°").wait_for()
        page.get_by_text("limit 1.6 ft/s").wait_for()
        page.get_by_role("tab", name="World").click()
        page.wait_for_function("jauspy.world.pose && jauspy.map.toScreen(jauspy.world.pose)")
        page.get_by_text("click on the map to set a waypoint").wait_for()
        page.locator("#world-map canvas").click(position={"x": 60, "y": 60})
        page.locator(".waypoint").get_by_text(re.compile(r"^-?\d+\.\d\d, -?\d+\.\d\d ft$")).wait_for()
        page.get_by_label("ft/s", exact=True).wait_for()
        assert page.evaluate("jauspy.settings.scaleBar(0.5)") == {"metres": 2 * 0.3048, "text": "2 ft"}


def test_the_help_opens_by_a_key_and_escape_closes_it_without_a_stop(url: str) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.keyboard.press("?")
        page.get_by_role("dialog", name="keyboard help").get_by_text("stop all robots, always").wait_for()
        keys = page.locator("#key-help kbd").all_inner_texts()
        assert {"1 2 3 4", "F", "Q", "Shift", "arrows"} <= set(keys)
        page.keyboard.press("Escape")
        page.get_by_role("dialog", name="keyboard help").wait_for(state="hidden")
        page.wait_for_timeout(500)
        assert page.locator("#stop-answer").inner_text() == ""


def test_a_slider_follows_fast_presses_and_the_events_follow_again(url: str) -> None:
    with page_at(url) as page:
        slider = page.get_by_role("slider", name="limit of the speed in m/s")
        slider.focus()
        for _ in range(8):
            page.keyboard.press("ArrowRight")
        page.get_by_text("limit 1.3 m/s").wait_for()
        page.wait_for_timeout(1000)
        assert slider.get_attribute("aria-valuenow") == "1.3"

        lines = page.locator(".lines .q-scrollarea__container")
        lines.evaluate("list => { list.firstElementChild.style.paddingTop = '500px'; }")
        page.wait_for_function(  # a line that comes scrolls down again; 0 to 0 is no scrolling
            "(() => { const list = document.querySelector('.lines [data-follows]');"
            " list.firstElementChild.style.paddingTop = '500px'; list.scrollTop = list.scrollTop === 0 ? 1 : 0;"
            " return list.dataset.follows === 'no'; })()"
        )
        before = lines.inner_text()
        page.get_by_role("button", name="take", exact=True).click()
        page.wait_for_function("(before) => document.querySelector('.lines').innerText !== before", arg=before)
        assert lines.evaluate("list => list.scrollTop") < 50, "who reads an old line is left alone"
        lines.evaluate("list => { list.scrollTop = list.scrollHeight - list.clientHeight - 3; }")
        page.get_by_role("button", name="release", exact=True).click()
        page.wait_for_timeout(2000)
        assert lines.evaluate("list => list.scrollHeight - list.scrollTop - list.clientHeight") < 2
