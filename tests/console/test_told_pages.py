"""What each page is told about control of a robot: why it was lost, and why it was not granted."""

from __future__ import annotations

from typing import Any

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

from jauspy.console.operation import Operation
from jauspy.console.panels.status import lost_control
from jauspy.console.users import User
from jauspy.errors import ConfigError

ANNA, CARA = User("anna", "operator", 127), User("cara", "supervisor", 255)


class FakeControl:
    """Control of a robot, which a test takes away by `lost`."""

    ids = ()

    def __init__(self, refused: str) -> None:
        self.refused, self.lost, self.held = refused, "", False

    async def __aenter__(self) -> None:
        if self.refused:
            raise ConfigError(self.refused)
        self.held = True

    async def __aexit__(self, *_: object) -> None:
        self.held = False


class FakeRobot:
    id, name, components = 101, "inc1", ()
    refused = ""

    def control(self, *_: Any, **__: Any) -> FakeControl:
        self.granted = FakeControl(self.refused)
        return self.granted

    async def stop(self) -> None:
        pass


@pytest.fixture
def robot() -> FakeRobot:
    return FakeRobot()


@pytest.fixture
def operation(robot: FakeRobot) -> Operation:
    return Operation(robot, lambda _: None)  # type: ignore[arg-type]


async def test_each_page_is_told_who_has_stopped_the_robot(operation: Operation, robot: FakeRobot) -> None:
    await operation.take("a", 127)
    operation.stopped("b", "STOP ALL")
    robot.granted.lost, robot.granted.held = "in emergency", False
    told = {page: operation.problem_for(page).partition(" has ended it")[0] for page in "abc"}
    assert told == {
        "a": "STOP ALL by another page of this console",
        "b": "STOP ALL by this page",
        "c": "STOP ALL by another page of this console",
    }
    assert operation.drive("a", 1.0, 0.0) == operation.problem_for("a")
    assert "another page" in lost_control(operation, "a")
    await operation.take("a", 127)
    assert operation.problem_for("a") == ""


async def test_a_refused_take_is_told_to_the_page_that_asked(operation: Operation, robot: FakeRobot) -> None:
    robot.refused = "held by 42.1.9"
    assert await operation.take("a", 127) == "held by 42.1.9"
    assert (operation.problem_for("a"), operation.problem_for("b")) == ("held by 42.1.9", "")
    robot.refused = ""
    await operation.take("b", 127)
    assert operation.problem_for("a") == "", "it is over"


async def test_who_loses_control_to_another_page_is_alarmed(operation: Operation, robot: FakeRobot) -> None:
    await operation.take("a", 127, ANNA)
    await operation.take("c", 200, CARA)
    assert lost_control(operation, "a") == "control was lost: cara has taken it over"
    robot.refused = "no answer"
    await operation.take("s", 255, User("sam", "supervisor", 255))
    assert lost_control(operation, "c") == "control was lost: control of robot 101 was not granted to sam: no answer"


async def test_who_releases_or_hands_over_is_not_alarmed(operation: Operation) -> None:
    await operation.take("a", 127, ANNA)
    operation.ask("c", 127, CARA)
    await operation.answer("a", grant=True)
    assert operation.operator == "c"
    assert lost_control(operation, "a") == ""
    operation.problem = "a command was refused"
    await operation.release("c")
    assert lost_control(operation, "c") == ""


async def test_a_mode_that_was_refused_is_told_to_one_page(operation: Operation) -> None:
    await operation.take("a", 127)
    operation.tell("b", operation.set_mode("b", "effort"))
    assert (operation.problem_for("a"), operation.problem_for("b")) == ("", "take control first")
