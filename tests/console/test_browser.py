"""A person's tour of the console in a real browser: take control, drive by keys, stop, close the page."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from tests.helpers.browser import BROWSER_MARKS, console_for, new_page, page_at
from tests.helpers.command_line import RunningRobot, shared_robot, start

pytestmark = BROWSER_MARKS


@pytest.fixture(scope="module")
def robot() -> Iterator[RunningRobot]:
    with shared_robot(few_pictures=True) as running:
        yield running


@pytest.fixture(scope="module")
def url(robot: RunningRobot) -> Iterator[str]:
    with console_for(robot.local) as (address, _):
        yield address


def status(robot: RunningRobot) -> str:
    output, _ = start("query", "101.1.102", "QueryStatus", "--connect", robot.local, "--id", "42.9.1").communicate()
    return output


def x_of(page) -> float:
    text = page.locator(".facts b").inner_text()
    return float(text.split()[1])


def test_a_persons_tour(url: str, robot: RunningRobot) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.get_by_text("standby").first.wait_for()
        page.get_by_role("button", name="take", exact=True).click()
        page.get_by_text("you operate this robot").wait_for()
        page.locator(".facts b").wait_for()
        before = x_of(page)

        page.keyboard.down("KeyW")
        page.wait_for_function(
            f"parseFloat(document.querySelector('.facts b').innerText.split(' ')[1]) > {before + 0.3}"
        )
        page.keyboard.up("KeyW")
        page.wait_for_timeout(1500)
        stopped = x_of(page)
        page.wait_for_timeout(1500)
        assert x_of(page) == stopped, "the robot stands when the key is up"

        page.keyboard.down("KeyW")
        page.wait_for_timeout(500)
        page.evaluate("window.dispatchEvent(new Event('blur'))")
        page.wait_for_timeout(1500)
        stopped = x_of(page)
        page.wait_for_timeout(1000)
        assert x_of(page) == stopped, "the robot stands when the window has lost the focus"
        page.keyboard.up("KeyW")

        page.keyboard.press("Escape")
        page.get_by_text("components stopped").first.wait_for()
        assert "EMERGENCY" in status(robot)
        page.get_by_role("button", name="clear emergency").click()
        page.get_by_text("released from the emergency").first.wait_for()
        assert "EMERGENCY" not in status(robot)
    for _ in range(100):  # the page is closed: control is released, the robot is in Standby
        if "STANDBY" in status(robot):
            return
    pytest.fail("the robot is still controlled after its operator's page was closed")


def test_two_browsers_one_operates_and_hands_over(url: str) -> None:
    with page_at(url) as first:
        first.get_by_role("button", name="take", exact=True).click()
        first.get_by_text("you operate this robot").wait_for()
        second = new_page(first.context.browser)
        second.goto(url)
        second.get_by_text("another browser operates it").wait_for()
        second.get_by_role("button", name="ask", exact=True).click()
        first.get_by_text("another browser asks for control, with authority 127").wait_for()
        first.get_by_role("button", name="refuse").click()
        second.get_by_role("button", name="ask", exact=True).click()
        first.get_by_role("button", name="hand over").click()
        second.get_by_text("you operate this robot").wait_for()
        first.get_by_role("button", name="take over").click()
        first.get_by_text("you operate this robot").wait_for()
        second.get_by_text("another browser operates it").wait_for()


def test_a_component_shows_its_services_and_what_it_refused(url: str, robot: RunningRobot) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        holder = start("send", "101.1.102", "SetEmergency", "--connect", robot.local, "--id", "42.9.1")
        holder.communicate()
        page.get_by_role("button", name="take", exact=True).click()
        page.get_by_role("button", name=re.compile("1.102 CM-MOB")).click()
        page.locator(".service").get_by_text("PrimitiveDriver").wait_for()
        page.get_by_text(re.compile("last sign of life . s ago")).wait_for()
        page.get_by_role("button", name="clear emergency").click()
        page.get_by_text("released from the emergency").first.wait_for()


def test_pictures_of_the_cameras_arrive(url: str) -> None:
    pytest.importorskip("av", reason="the extra 'video' is not installed")
    with page_at(url) as page:
        canvas = page.locator("canvas[data-component='101.1.106']")
        canvas.wait_for()
        page.wait_for_function("+document.querySelector('canvas[data-component]').dataset.pictures > 10")


def test_a_field_is_plotted_and_saved(url: str) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.get_by_role("tab", name="Plots").click()
        page.get_by_label("message").click()
        page.get_by_role("option", name="LocalPose", exact=True).click()
        page.get_by_label("fields").click()
        page.locator(".q-item").filter(has_text=re.compile("^yaw ")).click()
        page.keyboard.press("Tab")  # Escape would stop all robots
        page.get_by_role("button", name="add").click()
        page.locator(".trace").get_by_text("101.1.102 LocalPose.yaw").wait_for()
        page.wait_for_function("[...jauspy.charts.values()][0]?.get(0)?.length > 20")
        page.get_by_role("button", name="pause").click()
        with page.expect_download() as download:
            page.get_by_role("button", name="CSV").click()
        lines = download.value.path().read_text().splitlines()
        assert lines[0] == "time,101.1.102 LocalPose.yaw [rad]"
        assert len(lines) > 20


def test_a_message_is_found_and_opened(url: str) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.get_by_role("tab", name="Log").click()
        page.get_by_text("routine", exact=True).click()
        page.get_by_label("filter").fill("reportstatus 101.1.102")
        row = page.locator(".traffic tbody tr").filter(has_text="ReportStatus").first
        row.wait_for()
        page.get_by_role("button", name="pause").click()
        row.click()
        page.locator(".fields .path").filter(has_text=re.compile("^status$")).wait_for()


def test_costs_of_a_navigator_are_a_layer_of_the_map_that_is_switched(url: str, robot: RunningRobot) -> None:
    costs = "{rows: 1, columns: 1, width: 6, height: 6, x: 0, y: 0, yaw: 0, cells: btoa('\\u00fe')}"
    pixel = "[...jauspy.map.canvas.getContext('2d').getImageData(...jauspy.map.toScreen([0.8, -1.1]), 1, 1).data]"
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.get_by_role("tab", name="World").click()
        page.wait_for_function("jauspy.world.pose && jauspy.world.model.shapes.length > 80")
        page.evaluate(f"jauspy.way.take({{path: [[0, 0], [1, 1]], costs: {costs}}})")
        page.evaluate("jauspy.map.draw()")
        before = page.evaluate(pixel)
        page.get_by_text("costs", exact=True).click()
        page.wait_for_function("jauspy.world.show.costs")
        page.evaluate("jauspy.map.draw()")
        after = page.evaluate(pixel)
        assert after[0] - after[1] > before[0] - before[1] + 30, "red, as the robot cannot stand there"


def test_waypoints_are_set_by_clicks_and_driven(url: str, robot: RunningRobot) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.get_by_role("tab", name="World").click()
        page.wait_for_function("jauspy.world.pose && jauspy.world.model.shapes.length > 80")
        x, y = page.evaluate("jauspy.world.pose.slice(0, 2)")

        def click(ahead: float, left: float) -> None:
            page.evaluate("jauspy.map.draw()")
            right, down = page.evaluate(f"jauspy.map.toScreen([{x + ahead}, {y + left}])")
            box = page.locator("#world-map").bounding_box()
            assert box is not None
            page.mouse.click(box["x"] + 1 + right, box["y"] + 1 + down)

        click(0.8, 0.4)
        page.locator(".waypoint").nth(0).wait_for()
        click(1.6, 0.0)
        page.locator(".waypoint").nth(1).wait_for()
        assert page.locator(".waypoint").all_inner_texts()[1].split("\n")[:1] == ["2"]
        start_button = page.get_by_role("button", name="start", exact=True)
        assert start_button.is_disabled(), "an observer plans, and does not drive"
        page.get_by_role("button", name="take", exact=True).click()
        page.get_by_text("you operate this robot").wait_for()
        speed = page.locator(".execution").get_by_label("m/s", exact=True)
        speed.fill("0.1")  # it is still under way when a slow page has sent the pause
        page.keyboard.press("Tab")
        start_button.click()
        page.locator(".execution .progress").get_by_text("drives to waypoint").wait_for()
        page.get_by_role("button", name="pause", exact=True).click()
        page.locator(".execution .progress").get_by_text("waits on the way").wait_for()
        speed.fill("0.5")
        page.keyboard.press("Tab")
        page.get_by_role("button", name="resume", exact=True).click()
        page.locator(".execution .progress").get_by_text("ended at waypoint 2 of 2").wait_for()
        there = page.evaluate("jauspy.world.pose.slice(0, 2)")
        assert abs(there[0] - x - 1.6) < 0.3
        assert abs(there[1] - y) < 0.3
        output, _ = start(
            "query", "101.1.102", "QueryElementList", "--connect", robot.local, "--id", "42.9.1"
        ).communicate()
        assert output.count("element_uid") == 2
        page.get_by_role("button", name="clear", exact=True).click()
        page.get_by_text("click on the map to set a waypoint").wait_for()
