"""A person's tour by pointer, keys and gamepad, from a look around to a can that is lifted, in the simulated world."""

from __future__ import annotations

import base64
import json
import math
import re
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, GAMEPAD, HOLD_TO_DRIVE, console_for, page_at
from tests.helpers.command_line import RunningRobot, camera_direction, shared_robot, start
from tests.helpers.recorded_run import write_run
from tests.helpers.robot import described

pytest.importorskip("mujoco", reason="needs the extra 'sim'")
pytest.importorskip("av", reason="the extra 'video' is not installed")
pytest.importorskip("cv2", reason="needs the extra 'demo'")
pytest.importorskip("foxglove", reason="needs the extra 'recording'")

from jauspy.demo.arm import ArmKinematics
from jauspy.demo.grasp import at_height, decode_image, ray, red_region
from jauspy.demo.plan import PLANS
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import Vector

pytestmark = BROWSER_MARKS
PLAN = PLANS["yard"]
ARM_CAMERA = "canvas[data-component='101.1.106']"


class Operator:
    """What a person reads on the page and does there; metres, radians, axes of REP-103."""

    def __init__(self, page: Any) -> None:
        self.page = page
        _, self.model = described("inc1")
        self.kinematics = ArmKinematics(self.model)

    def wait_until(self, is_so: Callable[[], bool]) -> None:
        """Wait for half a minute at most."""
        for _ in range(60):
            if is_so():
                return
            self.page.wait_for_timeout(500)
        pytest.fail("what was to happen has not happened within 30 s")

    # --- driving --------------------------------------------------------------------------------------------------

    def pose(self) -> tuple[float, float, float]:
        """x, y and yaw, as the panel Drive shows them."""
        text = self.page.locator(".facts").inner_text()
        x, y, yaw = (float(re.search(rf"{name} (-?[\d.]+)", text)[1]) for name in ("x", "y", "yaw"))
        return x, y, math.radians(yaw)

    def hold(self, key: str, milliseconds: float) -> None:
        """Hold a key, and wait until everything stands."""
        self.page.keyboard.down(key)
        self.page.wait_for_timeout(milliseconds)
        self.page.keyboard.up(key)
        self.page.wait_for_timeout(700)

    def drive_to(self, x: float) -> None:
        for _ in range(30):
            if abs(off := x - self.pose()[0]) < 0.05:
                return
            self.hold("KeyW" if off > 0.0 else "KeyS", max(150.0, 1500.0 * abs(off)))
        pytest.fail(f"the robot does not come to x = {x} m: {self.pose()}")

    def turn_to(self, yaw: float) -> None:
        shortest = 60.0  # a press of which the motors take no notice is followed by a longer one
        for _ in range(30):
            before = self.pose()[2]
            if abs(off := math.remainder(yaw - before, math.tau)) < math.radians(3.0):
                return
            self.hold("KeyA" if off > 0.0 else "KeyD", max(shortest, 600.0 * abs(off)))
            if abs(math.remainder(self.pose()[2] - before, math.tau)) < math.radians(1.5):
                shortest += 30.0
        pytest.fail(f"the robot does not turn to {yaw} rad: {self.pose()}")

    def push_stick(self, way: float) -> None:
        """Drive that far ahead by the left stick of a gamepad, and let go."""
        began = self.pose()[0]
        self.page.evaluate(f"pad.buttons[{HOLD_TO_DRIVE}].pressed = true; pad.axes[1] = -0.6")
        for _ in range(200):
            self.page.wait_for_timeout(50)
            if self.pose()[0] - began >= way:
                break
        self.page.evaluate(f"pad.buttons[{HOLD_TO_DRIVE}].pressed = false")  # the stick stays where it is
        self.page.wait_for_function("jauspy.moving === false")
        self.page.wait_for_timeout(1000)
        stopped = self.pose()[0]
        assert stopped - began >= way
        self.page.wait_for_timeout(1000)
        assert self.pose()[0] == pytest.approx(stopped, abs=0.02), "without the dead-man's button nothing moves"
        self.page.evaluate("pad.axes[1] = 0")

    # --- the cameras and the views --------------------------------------------------------------------------------

    def look_aside(self, robot: RunningRobot) -> None:
        """Drag the picture of the chassis camera to the left, so that it turns to the right, and have it look ahead."""
        page = self.page
        page.locator("figure[aria-label='camera 101.1.107']").click()
        page.get_by_role("button", name="look").wait_for()
        box = page.locator("figure.large").bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        page.mouse.move(x, y)
        page.mouse.down()
        for step in range(1, 6):
            page.mouse.move(x - 40 * step, y)
            page.wait_for_timeout(120)
        page.mouse.up()
        self.wait_until(lambda: camera_direction(robot)[0] > 0.2)
        page.get_by_role("button", name="look").click()
        page.get_by_text("ahead", exact=True).click()
        self.wait_until(lambda: abs(camera_direction(robot)[0]) < 0.02)

    def arrange(self) -> None:
        """Put the views of driving beside each other, drag the line between them, and show one view again."""
        page = self.page
        page.keyboard.press("Digit2")
        page.locator(".desk.arranged #world-map canvas").wait_for()
        video = page.locator(".pane[data-view='Video']")
        before = video.bounding_box()["width"]
        edge = page.locator(".splitter[data-split='width']").bounding_box()
        page.mouse.move(edge["x"] + 5.0, edge["y"] + edge["height"] / 2)
        page.mouse.down()
        page.mouse.move(edge["x"] - 145.0, edge["y"] + edge["height"] / 2, steps=3)
        page.mouse.up()
        page.wait_for_function(f"document.querySelector('.pane[data-view=Video]').clientWidth < {before - 130}")
        page.keyboard.press("Digit1")
        page.locator(".desk.arranged").wait_for(state="detached")

    def look_into_recording(self, name: str) -> None:
        """Play one of the recorded runs in the list for a second."""
        page = self.page
        page.get_by_role("tab", name="Recordings").click()
        page.get_by_role("button", name=f"play {name}").click()
        page.locator("canvas[data-topic]").wait_for()
        page.get_by_role("button", name="play", exact=True).click()
        page.wait_for_function("+document.querySelector('canvas[data-topic]').dataset.time > 1")
        page.locator(".run-bar").get_by_role("button", name="pause").click()
        page.get_by_role("tab", name="Video").click()

    # --- the arm --------------------------------------------------------------------------------------------------

    def joints(self) -> dict[str, float]:
        """The measured positions that the panel Arm shows."""
        names = self.page.locator(".arm .joint-wanted").evaluate_all(
            "all => all.map((each) => (each.querySelector('[aria-label]') ?? each).getAttribute('aria-label'))"
        )
        values = self.page.locator(".arm .joint-value").all_text_contents()
        return {name: float(value.split()[0]) for name, value in zip(names, values, strict=True)}

    def play(self, *places: tuple[float, float, float, float]) -> None:
        """Load a trajectory of these places of the gripper (turn, distance, height, pitch) from a file, and play it."""
        rows = [{"seconds": 0.0, "positions": [*self.kinematics.joints(*each).values()]} for each in places]
        goal = dict(zip(self.model.groups["arm"].joints, rows[-1]["positions"], strict=True))
        file = json.dumps({"robot": "inc1", "joints": list(goal), "rows": rows})
        self.page.get_by_role("tab", name="Trajectory").click()
        self.page.locator("input[type=file][accept='.json']").set_input_files(
            {"name": "tour.json", "mimeType": "application/json", "buffer": file.encode()}
        )
        last = f"[aria-label='{next(reversed(goal))} of row {len(rows)}']"
        self.page.locator(last).wait_for()
        assert self.page.locator(".line").count() >= len(rows)
        self.page.get_by_role("button", name="play", exact=True).click()
        for _ in range(120):
            self.page.wait_for_timeout(500)
            joints = self.joints()
            if max(abs(joints[name] - value) for name, value in goal.items()) < 0.015:
                break
        else:
            pytest.fail(f"the arm is at {joints}, not {goal}: {self.page.locator('.trajectory .problem').inner_text()}")
        self.page.get_by_role("tab", name="Video").click()

    def tool(self) -> Vector:
        """Where the panel Arm says that the tool is."""
        text = self.page.locator(".jog .pose").inner_text()
        x, y, z = (float(re.search(rf"{axis} (-?[\d.]+)", text)[1]) for axis in "xyz")
        return x, y, z

    def jog(self, key: str, way: float) -> None:
        """Hold a key until the tool has moved that far."""
        began = self.tool()
        self.page.keyboard.down(key)
        for _ in range(400):
            self.page.wait_for_timeout(50)
            if math.dist(self.tool(), began) >= way:
                break
        self.page.keyboard.up(key)
        self.page.wait_for_timeout(1000)
        reached = math.dist(self.tool(), began)  # less by what the arm gives way when it stands
        assert reached >= 0.8 * way, self.page.locator(".jog-answer").inner_text()

    # --- the can --------------------------------------------------------------------------------------------------

    def find(self) -> tuple[float, float, float]:
        """Turn, distance and height of the red can, which the arm's camera shows."""
        before = int(self.page.locator(ARM_CAMERA).get_attribute("data-pictures"))
        self.page.wait_for_function(f'+document.querySelector("{ARM_CAMERA}").dataset.pictures > {before + 2}')
        shown = self.page.evaluate(f"document.querySelector(\"{ARM_CAMERA}\").toDataURL('image/png')")
        region = red_region(decode_image(base64.b64decode(shown.partition(",")[2])))
        assert region is not None, "the can is not in the picture of the arm's camera"
        positions = dict.fromkeys(self.model.description.joints, 0.0) | self.joints()
        frames = FrameTree(self.model.description).frames(Transform(), positions, "robot")
        setup = next(each for each in self.model.cameras if each.name == "arm")
        place = at_height(frames.pose(setup.link, "robot"), ray(region, setup.fov), PLAN.thing.height)
        assert place is not None
        return self.kinematics.around(place)

    def fingers(self) -> float:
        """Metres between them, as the panel Gripper shows them."""
        return float(re.search(r"fingers open (-?[\d.]+)", self.page.locator(".gripper").inner_text())[1]) / 1000.0

    def rest(self) -> float:
        """Wait until the fingers rest; returns where."""
        self.page.wait_for_timeout(1500)
        self.page.wait_for_function(
            "[...document.querySelectorAll('.gripper button')]"
            ".some((each) => each.innerText == 'close' && !each.disabled)"
        )
        shown = [self.fingers()]
        while len(shown) < 4 or max(shown[-4:]) - min(shown[-4:]) > 0.0005:  # the sim may be slower than real time
            assert len(shown) < 60, f"the fingers do not rest: {shown}"
            self.page.wait_for_timeout(500)
            shown.append(self.fingers())
        return shown[-1]


@pytest.fixture
def robot() -> Iterator[RunningRobot]:
    with shared_robot(backend="sim") as running:
        yield running


def weight(robot: RunningRobot) -> float:
    """What the wrist carries, kg, as the robot's sensor measures it."""
    asked = 'query_force_torque_list=[{"sensor_id": 1, "coordinate_system": "VEHICLE", "query_presence_vector": 4}]'
    process = start("query", "101.1.108", "QueryForceTorque", asked, "--connect", robot.local, "--id", "42.9.1")
    output, _ = process.communicate()
    return float(re.search(r"force_z\D*(-?[\d.]+)", output)[1]) / 9.81


def test_a_person_looks_around_and_lifts_the_can_from_its_table(robot: RunningRobot, tmp_path: Path) -> None:
    write_run(tmp_path / "yesterday.mcap")
    with (
        console_for(robot.local, "--recordings", str(tmp_path)) as (url, _),
        page_at(url, GAMEPAD) as page,
    ):
        operator = Operator(page)
        look_around(operator, robot)
        lift_the_can(operator, robot)


def look_around(operator: Operator, robot: RunningRobot) -> None:
    """Take control, see yesterday's run, arrange the views, turn a camera, and drive a little by the gamepad."""
    page = operator.page
    page.get_by_text("101 inc1").first.wait_for()
    page.get_by_role("button", name="take", exact=True).click()
    page.get_by_text("you operate this robot").wait_for()
    page.locator(".facts b").wait_for()
    page.wait_for_function(f'+document.querySelector("{ARM_CAMERA}")?.dataset.pictures > 0')
    operator.look_into_recording("yesterday.mcap")
    operator.arrange()
    operator.look_aside(robot)
    operator.push_stick(0.1)


def lift_the_can(operator: Operator, robot: RunningRobot) -> None:
    """Drive to the table, find the can, reach for it, close the gripper, and lift."""
    page = operator.page
    operator.drive_to(PLAN.goal.x)
    operator.turn_to(PLAN.goal.heading)
    operator.play((0.0, *PLAN.view))
    turn, distance, height = operator.find()

    def beside(offset: Sequence[float]) -> tuple[float, float, float, float]:
        return turn, distance + offset[0], height + offset[1], PLAN.pitch

    page.locator(".gripper").get_by_role("button", name="open", exact=True).click()
    opened = operator.rest()
    assert opened > PLAN.thing.width
    operator.play(*map(beside, (PLAN.high, PLAN.over, *PLAN.approach[:-1])))
    empty = weight(robot)
    page.locator(".arm").get_by_text("tool", exact=True).first.click()
    page.wait_for_function("document.querySelector('.jog .pose').innerText.includes('z ')")
    operator.jog("KeyO", 0.008)
    operator.jog("KeyI", 0.11)
    page.locator(".gripper").get_by_role("button", name="close", exact=True).click()
    held = operator.rest()
    assert held == pytest.approx(PLAN.thing.width, abs=0.008)
    below = operator.tool()[2]
    operator.jog("KeyU", 0.1)
    page.wait_for_timeout(2000)
    assert operator.tool()[2] - below > 0.08
    assert operator.fingers() == pytest.approx(held, abs=0.004), "the can is still between the fingers"
    assert weight(robot) - empty == pytest.approx(PLAN.thing.weight, abs=0.25)
