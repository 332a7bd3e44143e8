"""`jauspy can` beside simulated drives on a bus of python-can in this process."""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest
from tests.helpers.command_line import jauspy

pytest.importorskip("can", reason="python-can is not installed")
pytest.importorskip("canopen", reason="canopen is not installed")

import can

from jauspy.backends.can import bus as buses
from jauspy.backends.can.simulated.fleet import MOTORS, RealTimeFleet, plant_of
from jauspy.cli import can as verbs
from jauspy.robot.robot_files import load, robot_model

BUS = ("--bus", "socketcan:can0")
DRIVES = robot_model(load("inc1")).can.drives


def opened() -> can.BusABC:
    return can.Bus("drives", interface="virtual")


@pytest.fixture
def fleet(monkeypatch: pytest.MonkeyPatch) -> Iterator[RealTimeFleet]:
    """All drives of inc1, of which each opening of a bus sees the frames."""
    monkeypatch.setattr(buses, "open_bus", lambda bus, bit_rate: opened())
    model = robot_model(load("inc1"))
    bus = opened()
    running = RealTimeFleet(model, model.can, bus, plant_of(MOTORS, model, model.can, "empty"))
    running.open()
    yield running
    running.close()
    running.fleet.close()
    bus.shutdown()


def listed(*, status: int = 0) -> dict[str, dict[str, object]]:
    rows = map(json.loads, jauspy("can", "drives", "inc1", *BUS, "--json", status=status).stdout.splitlines())
    return {str(row["drive"]): row for row in rows}


def test_drives_are_listed_and_a_fault_is_seen(fleet: RealTimeFleet, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(verbs, "SCAN_TIME", 0.2)
    before = listed()
    assert before.keys() == DRIVES.keys()
    assert {row["state"] for row in before.values()} == {"Switch On Disabled"}
    assert {row["node"] for row in before.values()} == {drive.node for drive in DRIVES.values()}
    assert all(row["voltage"] > 20.0 for row in before.values())

    name, other = sorted(DRIVES)[:2]
    assert jauspy("can", "fault", name, "overcurrent", *BUS).stderr == f"node {DRIVES[name].node}: overcurrent\n"
    assert jauspy("can", "fault", str(DRIVES[other].node), "silent", *BUS).stderr.endswith("silent\n")
    assert fleet.fleet.drives[other].silent
    after = listed(status=1)
    assert (after[name]["state"], after[other]["state"]) == ("Fault", "Switch On Disabled")
    assert "current" in str(after[name]["error"])
    table = jauspy("can", "drives", "inc1", *BUS, status=1).stdout
    assert table.split()[:4] == ["node", "drive", "state", "volt"]
    assert len(table.splitlines()) == 1 + len(DRIVES)


def test_a_silent_bus_has_no_drives(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(verbs, "SCAN_TIME", 0.0)
    monkeypatch.setattr(buses, "open_bus", lambda bus, bit_rate: opened())
    assert {row["state"] for row in listed(status=1).values()} == {"no answer"}


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("drives", "rover"), "rover has no drives on CAN: its file has no table [can]"),
        (("drives", "inc1", "--bus", "virtual:motors"), "virtual:motors is inside the robot's process; give a bus"),
        (("simulate", "inc1", "--bus", "virtual:motors"), "which simulates its drives itself; give a bus"),
        (("fault", "arm_9", "encoder", *BUS), "no drive 'arm_9'; inc1 has: "),
        (("fault", "127", "encoder", *BUS), "or give a node id, 1..126"),
        (("fault", "1", "tired", *BUS), "no fault 'tired'; there are: overcurrent"),
        (("drives", "inc1", "--bus", "can0"), "write INTERFACE:CHANNEL, as in socketcan:can0"),
    ],
)
def test_wrong_usage_is_one_sentence(arguments: tuple[str, ...], said: str) -> None:
    assert said in " ".join(jauspy("can", *arguments, status=1).stderr.split())


def test_missing_packages_name_the_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(verbs, "find_spec", lambda name: None)
    assert "pip install 'jauspy[can]'" in jauspy("can", "drives", "inc1", status=1).stderr


def test_absolute_encoders_need_no_homing() -> None:
    assert "no drive of inc1 needs homing" in jauspy("can", "home", "inc1", *BUS).stderr
