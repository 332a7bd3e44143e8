"""Tests of the programs in docs/, and of the index of decision records."""

from __future__ import annotations

import math
import re
import tomllib
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from tests.helpers.documentation import DOCS, program
from tools.draw_architecture import LAYERS, SIMULATOR_LAYERS, TARGET, contracts, draw, layers

from jauspy.backends import check_robot
from jauspy.messages.core import Standby
from jauspy.robot import robot_files
from jauspy.testing import LocalNode, VirtualNetwork

GATE = Path(__file__).parent / "vendor" / "Gate.xml"


@pytest.mark.slow
def test_documented_synchronous_ocu_runs(node_manager: LocalNode, robot) -> None:
    source = program("ocu.md", "from jauspy.sync import OCU")
    start = "import math, time\nfrom jauspy.messages.mobility import QueryLocalPose, SetWrenchEffort\n"
    exec(start + source.replace('OCU("42.1.1")', f'OCU("42.1.1", "{node_manager.local}")'), {})
    assert robot.snapshot.pose.x > 1.99
    assert robot.components[0].host.state.endswith("NotControlled.Available.Standby")


async def test_documented_gate_runs(virtual_network: VirtualNetwork) -> None:
    states = program("components.md", '<state name="Ready" initial_state="Closed">')
    assert " ".join(states.split()) in " ".join(GATE.read_text().split())
    names: dict[str, Any] = {}
    exec(program("components.md", "import jauspy\n\ngate").replace("Gate.xml", str(GATE)), names)
    registry, wanted = names["gate"], names["SetGate"].Wanted
    async with (
        virtual_network.component("101.1.120", [names["Gate"]()]) as component,
        virtual_network.ocu("42.1.1", registry=registry) as ocu,
    ):
        gate = (await ocu.discover(101)).service("Gate")
        async with gate.subscribe(registry.by_name("QueryGate")()) as changes, gate.control():
            await gate.resume()
            for left_by in (None, wanted.CLOSED, Standby()):
                assert (await changes.get()).opening == 0
                began = virtual_network.now()
                await gate.send(names["SetGate"](wanted=wanted.OPEN))
                assert (await changes.get()).opening == 100
                assert component.state.endswith("Ready.Open")
                if left_by is not None:
                    await gate.send(left_by if isinstance(left_by, Standby) else names["SetGate"](wanted=left_by))
            assert (await changes.get()).opening == 0
            assert virtual_network.now() - began < 1.0
    assert "host.action_failed" not in component.counters


@pytest.mark.slow
@pytest.mark.parametrize(("page", "goal"), [("index.md", (2.0, 0.0)), ("tutorial.md", (1.9, 0.5))])
async def test_program_for_newcomers_runs(
    page: str, goal: tuple[float, float], virtual_network: VirtualNetwork, robot
) -> None:
    source = (
        program(page, "import asyncio, jauspy")
        .replace("jauspy.OCU(", "network.ocu(")
        .replace("asyncio.run(main())", "")
    )
    names: dict[str, Any] = {"network": virtual_network}
    exec(source, names)
    await names["main"]()
    pose = robot.snapshot.pose
    assert math.dist((pose.x, pose.y), goal) < 0.2
    assert robot.components[0].host.state.endswith("NotControlled.Available.Standby")


def test_drawing_of_the_architecture_is_that_of_the_contracts() -> None:
    assert draw() == TARGET.read_text(), "run tools/draw_architecture.py"
    known = contracts()
    for contract in (LAYERS, SIMULATOR_LAYERS):
        for names in layers(known[contract]):
            for name in names:
                assert f">{name}</text>" in draw()


@pytest.mark.slow
async def test_compared_program_runs_and_lines_are_counted_right(virtual_network: VirtualNetwork, robot) -> None:
    page = (DOCS / "side-by-side.md").read_text()
    parts = [re.findall(r"^ {4}.*\S", part, re.MULTILINE) for part in page.split("\n## ")[1:4]]
    assert f"| lines of code | {' | '.join(str(len(part)) for part in parts)} |" in page
    source = program("side-by-side.md", "import asyncio\nimport jauspy")
    source = source.replace("jauspy.OCU(", "network.ocu(").replace("asyncio.run(main())", "")
    names: dict[str, Any] = {"network": virtual_network}
    exec(source, names)
    await names["main"]()
    assert robot.snapshot.pose.x > 1.85
    assert robot.components[0].host.state.endswith("NotControlled.Available.Standby")


def test_index_of_decisions_is_complete() -> None:
    listed = [line for line in (DOCS / "adr" / "README.md").read_text().splitlines() if line.startswith("| [")]
    records = []
    for path in sorted((DOCS / "adr").glob("[0-9]*.md")):
        found = re.match(r"# (\d+)\. (.+)\n\n- Status: (.+)\n- Date: (\d{4}-\d\d-\d\d)\n", path.read_text())
        assert found, f"{path.name} must begin with title, status and date"
        number, title, status, date = found.groups()
        assert number == str(int(path.name[:4]))
        records.append(f"| [{number}]({path.name}) | {title} | {status} | {date} |")
    assert listed == records


def test_documented_entry_point_is_a_backend_that_is_as_the_contract_says(monkeypatch: pytest.MonkeyPatch) -> None:
    (table,) = re.findall(r"```toml\n(.*?)```", (DOCS / "own-backend.md").read_text(), re.DOTALL)
    ((name, value),) = tomllib.loads(table)["project"]["entry-points"]["jauspy.backends"].items()
    monkeypatch.syspath_prepend(str(DOCS.parent / "examples"))
    module, _, factory = value.partition(":")
    backend = getattr(import_module(module), factory)()
    config = robot_files.load(DOCS.parent / "examples" / "tracked.toml")
    assert config.backend == backend.name == name
    robot = backend.open(robot_files.robot_model(config), config.world)
    check_robot(robot)
    robot.close()
