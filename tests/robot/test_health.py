"""The health of a robot: what its CM-MAS finds, hours of operation, and reminders of maintenance."""

from __future__ import annotations

import asyncio
import json
from dataclasses import replace
from datetime import UTC, datetime

import pytest
from tests.robot.workcell import Workcell

from jauspy.errors import ConfigError
from jauspy.messages.exp import (
    QueryHealthDetails,
    QueryHealthSummary,
    QueryHourMeter,
    QueryReminder,
    QueryReminderSummary,
    ReportHealthDetails,
    ResetReminder,
    UpdateHealthReporter,
)
from jauspy.ocu.state import health_of
from jauspy.platform.battery import SimulatedBattery
from jauspy.platform.commands import CHASSIS
from jauspy.platform.contract import PartId
from jauspy.platform.joints import JointGroup
from jauspy.robot.computer import ComputerState, computer_state, problems
from jauspy.robot.hour_meter import SAVE_PERIOD, HourMeterFile
from jauspy.robot.realtime import WHOLE_ROBOT
from jauspy.robot.robot_files import load
from jauspy.services.iop import Code, HealthEntry, HealthReporter, HoursInMemory, Reminder, Severity

TRACKS = Reminder(1, "clean the tracks", 3600.0)


@pytest.fixture
def master(monkeypatch):
    monkeypatch.setattr("jauspy.robot.kinds.health_checks.computer_state", ComputerState)
    made = Workcell("kinematic", "inc1", 110)
    yield made
    made.robot.close()


def details(cell: Workcell) -> dict[tuple[int, str], tuple[int, int, str]]:
    """Severity, code and text by component and the end of the service's URN."""
    report = cell.ask(QueryHealthDetails())
    return {
        (row.component_rec.component_id, entry.service_urn.rpartition(":")[2]): (
            entry.severity,
            entry.code,
            entry.descriptor,
        )
        for row in report.detailed_status_list
        for entry in row.component_status_list
    }


def reporter(cell: Workcell) -> HealthReporter:
    found = cell.host.service(HealthReporter)
    assert found is not None
    return found


def test_all_parts_of_a_robot_that_works_are_well(master):
    master.run(2.0)
    found = details(master)
    assert {where for where, _ in found} == {102, 103, 104, 105, 106, 107, 108, 109, 110}
    assert {severity for severity, _, _ in found.values()} == {Severity.NONE}
    assert "works" in found[110, "HealthReporter"][2]
    summary = {
        row.component_rec.component_id: row.severity_rec.severity
        for row in master.ask(QueryHealthSummary()).summary_status_list
    }
    assert summary == dict.fromkeys(summary, Severity.NONE)
    assert len(summary) == 9


@pytest.mark.slow
def test_a_battery_that_is_low_or_empty_is_told(master):
    battery = next(part for part in master.robot.optional_parts if isinstance(part, SimulatedBattery))
    battery._charge.energy = 0.15 * battery.setup.energy
    master.run(2.0)
    assert details(master)[110, "PowerPlantManager"][:2] == (Severity.WARN, Code.POWER)
    assert details(master)[102, "PrimitiveDriver"][0] == Severity.NONE
    battery._charge.energy = 0.04 * battery.setup.energy
    master.run(2.0)
    found = details(master)
    assert found[110, "PowerPlantManager"][0] == Severity.FAIL
    assert found[102, "PrimitiveDriver"][:2] == (Severity.FAIL, Code.POWER)
    assert found[108, "RangeSensor"][0] == Severity.NONE


@pytest.mark.slow
@pytest.mark.parametrize(
    ("part", "failed"),
    [
        (CHASSIS, {102}),
        (PartId(JointGroup, "arm"), {104}),
        (PartId(JointGroup, "gripper"), {105}),
        (WHOLE_ROBOT, {102, 103, 104, 105, 107}),
    ],
)
def test_faults_of_drives_stand_under_the_component_that_moves_them(master, monkeypatch, part, failed):
    faults = {part: "drive 'arm_2' (node 5) is in Fault"}
    check = reporter(master)._checks[2]
    build = check.args[0]
    monkeypatch.setattr(type(build.shared), "faults", property(lambda _: lambda: faults))
    master.run(1.5)
    report = details(master)
    assert {where for (where, _), (severity, *_) in report.items() if severity} == failed
    assert {code for severity, code, _ in report.values() if severity} == {Code.ACTUATOR}


def test_times_are_those_of_the_change(master):
    master.run(1.0)
    rows = master.ask(QueryHealthDetails()).detailed_status_list
    before = [entry.logtime for row in rows for entry in row.component_status_list]
    master.run(5.0)
    rows = master.ask(QueryHealthDetails()).detailed_status_list
    assert [entry.logtime for row in rows for entry in row.component_status_list] == before


@pytest.mark.slow
def test_hours_and_reminders(master):
    service = reporter(master)
    service._reminders = {1: TRACKS, 2: replace(TRACKS, id=2, interval=7200.0)}
    service._meter.add(3600.0 - 30.0)
    assert master.ask(QueryHourMeter()).elapsed_minutes == 59
    assert [row.reminder_status for row in master.ask(QueryReminderSummary()).reminder_summary_list] == [0, 0]
    master.run(40.0)
    assert master.ask(QueryHourMeter()).elapsed_minutes == 60
    assert [row.reminder_status for row in master.ask(QueryReminderSummary()).reminder_summary_list] == [1, 0]
    report = master.ask(QueryReminder(1))
    assert (report.reminder_status, report.service_interval, report.elapsed_time) == (1, 60, 60)
    assert any(entry.text == "due: clean the tracks" for entry in service.entries)
    master.tell(ResetReminder(1))
    assert master.ask(QueryReminder(1)).reminder_status == 1, "only a client in control resets it"
    master.take_control()
    master.tell(ResetReminder(1), ResetReminder(77))
    master.run(1.5)
    assert master.ask(QueryReminder(1)).reminder_status == 0
    assert master.ask(QueryHourMeter()).elapsed_minutes == 60, "the meter itself is never reset"
    assert master.host.counters["unknown_reminder"] == 1


def test_reminders_that_do_not_exist_and_commanded_tests(master):
    for id in range(256):
        report = master.ask(QueryReminder(id))
        assert report.reminder_id == id
        assert ("there is no reminder" in report.descriptor) is (id not in (1, 2))
    master.tell(UpdateHealthReporter())
    master.take_control()
    before = len(reporter(master).entries)
    master.tell(*[UpdateHealthReporter()] * 50)
    assert len(reporter(master).entries) == before


def test_texts_and_lists_beyond_the_wire_are_cut(master):
    entry = HealthEntry(7, "urn:" + "x" * 400, Severity.ERR, Code.SOFTWARE, "\u6f22" * 10 + "y" * 400)
    service = reporter(master)
    service._checks = [lambda: [replace(entry, component=number % 300 % 256) for number in range(3000)]]
    master.run(1.5)
    report = master.ask(QueryHealthDetails())
    assert len(report.detailed_status_list) == 255
    (first, *_) = report.detailed_status_list[0].component_status_list
    assert len(first.descriptor) == len(first.service_urn) == 255
    assert first.descriptor.startswith("?" * 10)


def test_the_state_of_this_computer_is_read():
    state = computer_state()
    assert state.room is None or 0.0 <= state.room <= 1.0
    assert state.memory is None or 0.0 < state.memory <= 1.0


def test_a_computer_that_is_too_slow_full_or_hot_is_told(tmp_path):
    zone = tmp_path / "sys/class/thermal/thermal_zone0"
    zone.mkdir(parents=True)
    (zone / "temp").write_text("97500\n")
    (tmp_path / "proc").mkdir()
    (tmp_path / "proc/meminfo").write_text("MemTotal:  1000 kB\nMemFree: x\nMemAvailable:   10 kB\n\n")
    state = computer_state(tmp_path)
    assert (state.temperature, state.memory) == (97.5, 0.01)
    found = problems(replace(state, room=0.001, load=0.1))
    assert set(found) == {"processor", "memory", "files"}
    assert "98 degrees" in found["processor"] or "97 degrees" in found["processor"]
    (zone / "temp").write_text("garbage" * 100)
    (tmp_path / "proc/meminfo").write_bytes(b"\xff\xfe:\n" * 500)
    assert computer_state(tmp_path).temperature is None
    assert problems(ComputerState()) == {}
    assert "too slow" in problems(ComputerState(load=3.0))["processor"]


def test_the_hour_meter_goes_on_where_it_was(tmp_path):
    path = tmp_path / "hours.json"
    meter = HourMeterFile(path)
    meter.add(SAVE_PERIOD - 1.0)
    assert not path.exists(), "it is written once a minute"
    meter.add(1.0)
    assert path.exists()
    meter.reset(3)
    meter.add(10.0)
    meter.close()
    again = HourMeterFile(path)
    assert again.total == pytest.approx(SAVE_PERIOD + 10.0)
    assert again.since_reset(3) == pytest.approx(10.0)
    assert again.since_reset(4) == pytest.approx(SAVE_PERIOD + 10.0)
    assert [file.name for file in tmp_path.iterdir()] == ["hours.json"]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "{}",
        "[1, 2]",
        "precious text",
        '{"format": "jauspy hour meter"}',
        '{"format": "jauspy hour meter", "hours": "many", "resets": {}}',
        '{"format": "jauspy hour meter", "hours": -1, "resets": {}}',
        '{"format": "jauspy hour meter", "hours": 1e300, "resets": {}}',
        '{"format": "jauspy hour meter", "hours": NaN, "resets": {}}',
        '{"format": "jauspy hour meter", "hours": 1, "resets": {"1": []}}',
        "[" * 100_000,
    ],
)
def test_files_that_are_no_hour_meters_are_left_alone(tmp_path, text):
    path = tmp_path / "hours.json"
    path.write_text(text)
    with pytest.raises(ConfigError, match=r"health\.hour_meter.*hours\.json|has more than"):
        HourMeterFile(path)
    assert path.read_text() == text


def test_links_are_not_followed(tmp_path, caplog):
    target = tmp_path / "precious"
    path = tmp_path / "hours.json"
    path.symlink_to(target)
    with pytest.raises(ConfigError, match="is a link"):
        HourMeterFile(path)
    path.unlink()
    (tmp_path / "hours.json.partial").symlink_to(target)
    meter = HourMeterFile(path)
    meter.add(100.0)
    meter.add(100.0)
    assert not target.exists()
    assert meter.total == 200.0, "the hours are counted on"


@pytest.mark.parametrize("given", ["../hours.json", "/etc/hours.json", ".bashrc", "deep/../../x.json", r"a\u0000b"])
def test_a_robots_file_names_hours_below_its_folder_only(tmp_path, given):
    file = tmp_path / "robot.toml"
    file.write_text(f'extends = "inc1"\n[health]\nhour_meter = "{given}"\n')
    with pytest.raises(ConfigError, match=r"health\.hour_meter"):
        load(file)


@pytest.mark.parametrize(
    ("reminders", "problem"),
    [
        ('[{ id = 1, text = "a", interval = 0.0 }]', "interval"),
        ('[{ id = 256, text = "a", interval = 1.0 }]', "id"),
        ('[{ id = 1, text = "", interval = 1.0 }]', "text"),
        ('[{ id = 1, text = "a", interval = 1.0 }, { id = 1, text = "b", interval = 1.0 }]', "twice"),
        ("[" + ", ".join(f'{{ id = {id}, text = "a", interval = 1.0 }}' for id in range(17)) + "]", "health.reminders"),
    ],
)
def test_silly_reminders_are_refused(tmp_path, reminders, problem):
    file = tmp_path / "robot.toml"
    file.write_text(f'extends = "inc1"\n[health]\nreminders = {reminders}\n')
    with pytest.raises(ConfigError, match=problem):
        load(file)


@pytest.mark.slow
async def test_an_operator_reads_the_health(virtual_network, tmp_path):
    file = tmp_path / "robot.toml"
    file.write_text('extends = "inc1"\n[health]\nhour_meter = "hours.json"\n')
    async with virtual_network.robot(str(file)), virtual_network.ocu() as ocu:
        robot = await ocu.robot(101)
        await asyncio.sleep(1.5)
        found = await robot.health()
        assert {entry.component for entry in found} >= {102, 104, 107, 110}
        assert all(entry.is_well for entry in found if entry.part not in {"PROCESSOR", "RAM"}), found
        assert all(entry.time is not None for entry in found)
        await asyncio.sleep(61.0)
    assert json.loads((tmp_path / "hours.json").read_text())["hours"] * 3600.0 > 60.0


def test_hours_in_memory_never_go_back():
    meter = HoursInMemory()
    meter.add(-100.0)
    assert meter.total == 0.0


def test_values_that_the_standard_does_not_define_are_shown_as_numbers():
    kind = ReportHealthDetails
    stamp = kind.Logtime(milliseconds=0, seconds=0, minute=0, hour=0, day=0)
    rows = [kind.ComponentStatuRec("urn", severity, 99, stamp, "\x1b[31mred") for severity in (3, 99)]
    report = kind([kind.DetailedStatuSeq(kind.ComponentRec(7), rows)])
    found = health_of(report, datetime.now(UTC))
    assert [(entry.severity, entry.part, entry.is_well) for entry in found] == [
        ("99", "99", False),
        ("ERR", "99", False),
    ]
    assert all("\x1b" not in entry.text for entry in found)
    assert all(entry.time is None for entry in found), "there is no day 0"
