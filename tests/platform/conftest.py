"""Every backend that the platform's contract tests run over."""

from collections.abc import Callable, Iterator
from importlib.util import find_spec

import pytest

from jauspy.backends import find
from jauspy.platform.contract import Robot
from jauspy.robot.robot_files import load, robot_model

OpenRobot = Callable[[], Robot]
MODELS = {name: robot_model(load(name)) for name in ("inc1", "rover")}


@pytest.fixture(
    params=[
        "kinematic",
        pytest.param(
            "can",
            marks=[
                pytest.mark.slow,
                pytest.mark.skipif(find_spec("canopen") is None, reason="canopen is not installed"),
            ],
        ),
        pytest.param("sim", marks=pytest.mark.skipif(find_spec("mujoco") is None, reason="MuJoCo is not installed")),
    ]
)
def backend_name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def robot_name() -> str:
    """The robot that is opened; tests of what all have override it."""
    return "inc1"


@pytest.fixture
def open_robot(backend_name: str, robot_name: str) -> Iterator[OpenRobot]:
    if robot_name == "rover" and backend_name == "can":
        pytest.skip("the backend can has no wheels")
    opened: list[Robot] = []

    def open_one() -> Robot:
        opened.append(find(backend_name).open(MODELS[robot_name], "empty"))
        return opened[-1]

    yield open_one
    for robot in opened:
        robot.close()


@pytest.fixture
def robot(open_robot: OpenRobot) -> Robot:
    return open_robot()
