"""What README.md shows is what happens."""

import asyncio
import doctest
import re
import signal
import subprocess
import sys
import textwrap
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import jauspy
from jauspy.cli.main import app
from jauspy.node import NodeConfig, NodeManager
from jauspy.robot.runner import RobotRunner
from jauspy.testing import VirtualNetwork

README = Path(__file__).parents[1] / "README.md"


def blocks() -> list[str]:
    """The indented blocks of the README."""
    return [textwrap.dedent(block) for block in re.findall(r"(?:^ {4}.*\n|^\n)+", README.read_text(), re.MULTILINE)]


def test_message_examples_are_right() -> None:
    results = doctest.testfile(str(README), module_relative=False, optionflags=doctest.NORMALIZE_WHITESPACE)
    assert results.attempted >= 2
    assert results.failed == 0


@pytest.mark.slow
async def test_ocu_example_drives_the_robot(virtual_network: VirtualNetwork, robot: RobotRunner) -> None:
    (program,) = [block for block in blocks() if "jauspy.OCU(" in block]
    program = program.replace('jauspy.OCU("42.1.1")', 'network.ocu("42.1.1")').replace("asyncio.run(main())", "")
    names: dict[str, Any] = {"network": virtual_network}
    exec(compile(program, str(README), "exec"), names)
    await asyncio.wait_for(names["main"](), 20)
    assert robot.snapshot is not None
    assert robot.snapshot.pose.x == pytest.approx(2.0, abs=0.3)
    mobility = robot.components[0]
    assert mobility.host.state.endswith("NotControlled.Available.Standby")


@pytest.mark.slow
async def test_component_example_is_queried_and_subscribed(
    root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (program,) = [block for block in blocks() if "jauspy.Component(" in block]
    assert len(program.strip().splitlines()) < 40
    (command,) = re.findall(r"`(jauspy new definition [^`]*)`", README.read_text())
    monkeypatch.chdir(tmp_path)
    result = CliRunner().invoke(app, command.split()[1:])
    assert result.output == "battery.xml\n"
    place = f'name="battery", connect="local:{root}")'
    (tmp_path / "battery.py").write_text(program.replace('name="battery")', place))
    registry = jauspy.load("battery.xml")
    query = registry.by_name("QueryBattery")
    node = NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root))
    async with node, jauspy.OCU("42.1.1", connect=f"local:{root}", registry=registry) as ocu:
        child = await asyncio.create_subprocess_exec(
            sys.executable, "-W", "error", "battery.py", stderr=subprocess.PIPE
        )
        try:
            async with asyncio.timeout(30):
                robot = await ocu.discover(101, timeout=20.0)
                service = robot.component(120).service("Battery")
                report = await service.query(query(0xFF))
                assert report.charge <= 100.0
                assert report.current == -2.5
                assert (await service.query(query(1))).current is None
                async for each in service.subscribe(query(1), rate=20.0):
                    if each.charge < report.charge:
                        break
        finally:
            child.send_signal(signal.SIGINT)
            async with asyncio.timeout(20):
                _, problems = await child.communicate()
    assert (child.returncode, problems) == (0, b"")
