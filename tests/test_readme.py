"""What README.md shows is what happens."""

import asyncio
import doctest
import re
import textwrap
from pathlib import Path

import pytest

from jauspy.modules import robots
from jauspy.modules.robot import RobotRunner
from jauspy.node import NodeConfig, NodeManager
from jauspy.transport import LocalTransport

README = Path(__file__).parents[1] / "README.md"


def blocks() -> list[str]:
    """The indented blocks of the README."""
    return [textwrap.dedent(block) for block in re.findall(r"(?:^ {4}.*\n|^\n)+", README.read_text(), re.MULTILINE)]


def test_the_examples_of_messages() -> None:
    results = doctest.testfile(str(README), module_relative=False, optionflags=doctest.NORMALIZE_WHITESPACE)
    assert results.attempted >= 2
    assert results.failed == 0


async def test_the_ocu_drives_the_robot(root: Path) -> None:
    (program,) = [block for block in blocks() if "jauspy.OCU(" in block]
    program = program.replace('OCU("42.1.1")', f'OCU("42.1.1", connect="local:{root}")').replace(
        "asyncio.run(main())", ""
    )
    names: dict[str, object] = {}
    exec(compile(program, str(README), "exec"), names)
    async with (
        NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)),
        RobotRunner(robots.load("inc1"), lambda own: LocalTransport(own, root), backend="kinematic") as robot,
    ):
        await asyncio.wait_for(names["main"](), 20)  # type: ignore[operator]
        assert robot.snapshot is not None
        assert robot.snapshot.pose.x == pytest.approx(2.0, abs=0.3)
        (mobility,) = robot.components
        assert mobility.host.state.endswith("NotControlled.Available.Standby")
