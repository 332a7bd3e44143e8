"""DataLogging: its answers, the files that the logger writes, and a robot whose log a client switches."""

from __future__ import annotations

import asyncio
import errno
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path

import pytest

from jauspy.capture.reader import Datagram
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.inspection.traffic import seen_messages
from jauspy.messages import registry
from jauspy.messages.core import QueryStatus, RequestControl, Resume, SetEmergency, Standby
from jauspy.messages.iop import (
    QueryLoggerCapability,
    QueryLoggerConfiguration,
    QueryLoggerStatus,
    SetLoggerConfiguration,
    SetLoggerConfigurationResponse,
    SetLoggerState,
)
from jauspy.ocu import OCU
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.recording.mcap_capture import open_capture_file
from jauspy.robot import robot_files, traffic_log
from jauspy.robot.runner import RobotRunner
from jauspy.robot.traffic_log import LogPlace, LogWriter, TrafficLog, own_files
from jauspy.services.host import Host
from jauspy.services.iop import DataLogging, LogLevel, LogSettings, LogState, LogStatus
from jauspy.testing import LocalNode

CLIENT, ME = JausID(42, 1, 1), JausID(101, 1, 110)
Level = SetLoggerConfiguration.LoggingLevel
Policy = SetLoggerConfiguration.OverflowPolicyRec
Error = SetLoggerConfigurationResponse.ErrorField


BEGUN = LogStatus(LogState.OFF, 1_500_000, datetime(2026, 3, 14, 15, 9, 26, 535_000, UTC))


@dataclass
class Logger:
    """A logger without files."""

    max_size: int = 1_000_000_000
    settings: LogSettings = field(default_factory=LogSettings)
    status: LogStatus = BEGUN

    def configure(self, settings: LogSettings) -> None:
        self.settings = settings

    def switch(self, state: LogState) -> None:
        self.status = LogStatus(state)


class Logging:
    """A component with DataLogging that a client controls."""

    def __init__(self) -> None:
        self.logger = Logger()
        self.host = Host(ME, [DataLogging(self.logger)], utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC), now=0.0)
        self.tell(RequestControl(200), Resume())

    def tell(self, *messages, source: JausID = CLIENT) -> list:
        for message in messages:
            self.host.receive(message.encode(), source, 0.0)
        return [registry.decode(output.payload) for output in self.host.poll_output(0.0)]


def ids(query, *numbers: int):
    return query([query.LoggerIDRec(number) for number in numbers])


def states(*entries: tuple[int, int]) -> SetLoggerState:
    return SetLoggerState([SetLoggerState.LoggerStateRec(*entry) for entry in entries])


def settings(levels: Level, policy: int = 0, number: int = 1, **thresholds) -> SetLoggerConfiguration:
    entry = SetLoggerConfiguration.LoggerConfigurationSeq(
        SetLoggerConfiguration.LoggerConfigurationRec(number, levels), Policy(policy, **thresholds)
    )
    return SetLoggerConfiguration([entry])


def levels(**bits: int) -> Level:
    names = ("verbose", "unknown", "critical", "error", "warning", "information", "debug")
    return Level(**{f"log_{name}": bits.get(name, 0) for name in names})


def test_status_capability_and_configuration_of_the_one_logger():
    tested = Logging()
    (status,) = tested.tell(ids(QueryLoggerStatus, 0))
    (entry,) = status.logger_status_list
    assert (entry.logger_id, entry.logger_state, entry.fill_size) == (1, 1, 2)
    time = entry.beginning_timestamp
    assert (time.day, time.hour, time.minutes, time.seconds, time.milliseconds) == (14, 15, 9, 26, 535)
    assert entry.ending_timestamp is None
    (capability,) = tested.tell(ids(QueryLoggerCapability, 1, 1, 0))
    (entry,) = capability.logger_capability_list
    assert entry.overflow_size_threshold == 1000
    assert (entry.logging_level.log_critical, entry.logging_level.log_debug) == (1, 0)
    (configuration,) = tested.tell(ids(QueryLoggerConfiguration, 1))
    (entry,) = configuration.logger_configuration_list
    assert entry.overflow_policy_rec.overflow_size_threshold == 1000
    assert tested.tell(ids(QueryLoggerStatus, 7))[0].logger_status_list == []


def test_only_the_client_in_control_switches():
    tested = Logging()
    tested.tell(states((1, 0)), source=JausID(43, 1, 1))
    assert tested.logger.status.state is LogState.OFF
    tested.tell(states((9, 0)))
    assert tested.logger.status.state is LogState.OFF
    tested.tell(states((0, 0)))
    assert tested.logger.status.state is LogState.ON
    tested.tell(states((1, 2)))
    assert tested.logger.status.state is LogState.PAUSE
    tested.tell(states((1, 0), (1, 1)))
    assert tested.logger.status.state is LogState.OFF


@pytest.mark.parametrize(
    ("wanted", "error"),
    [
        (settings(levels(critical=1), overflow_size_threshold=5), Error.NONE),
        (settings(levels(verbose=1), overflow_size_threshold=100, overflow_percentage_threshold=50.0), Error.NONE),
        (settings(levels(debug=1)), Error.LOGGING_LEVEL_UNSUPPORTED),
        (settings(levels(verbose=1), policy=5), Error.OVERFLOW_POLICY_UNSUPPORTED),
        (settings(levels(verbose=1), overflow_size_threshold=0), Error.OVERFLOW_POLICY_UNSUPPORTED),
        (settings(levels(verbose=1), overflow_size_threshold=2**64 - 1), Error.OVERFLOW_POLICY_UNSUPPORTED),
        (settings(levels(verbose=1), overflow_percentage_threshold=0.0), Error.OVERFLOW_POLICY_UNSUPPORTED),
    ],
)
def test_settings_are_taken_or_refused_with_the_reason(wanted, error):
    tested = Logging()
    before = tested.logger.settings
    (answer,) = tested.tell(wanted)
    (response,) = answer.logger_configuration_response_list
    assert response.error_field == error
    assert (tested.logger.settings != before) == (error == Error.NONE)


def test_settings_are_in_bytes_and_levels():
    tested = Logging()
    tested.tell(settings(levels(critical=1, information=1), number=0, overflow_size_threshold=200))
    assert tested.logger.settings == LogSettings(LogLevel.CRITICAL | LogLevel.INFORMATION, 200_000_000)


def test_undefined_states_and_unknown_loggers_change_nothing():
    tested = Logging()
    for payload in (states((1, 0)).encode()[:-1] + b"\x07", states((1, 0)).encode()[:-1]):
        tested.host.receive(payload, CLIENT, 0.0)
    (answer,) = tested.tell(settings(levels(verbose=1), number=-3))
    assert answer.logger_configuration_response_list == []
    assert tested.logger.status.state is LogState.OFF
    assert "host.action_failed" not in tested.host.counters


# --- files ----------------------------------------------------------------------------------------------------------


def datagram(message, number: int, source: JausID = CLIENT, destination: JausID = ME) -> Datagram:
    packet = Packet(source=source, destination=destination, payload=message.encode(), sequence=number & 0xFFFF)
    return Datagram(number, 1000.0 + number, ("10.0.0.1", 3794), ("10.0.0.2", 3794), judp.pack(packet))


def order(state: LogState, **changes) -> traffic_log._Order:
    return traffic_log._Order(state, LogSettings(**changes))


def names(path: Path) -> list[str]:
    with path.open("rb") as file:
        return [seen.name for seen in seen_messages(open_capture_file(file, name=path.name), registry)]


@pytest.fixture
def place(tmp_path: Path) -> LogPlace:
    return LogPlace(101, tmp_path, tmp_path / "logs")


def test_a_log_has_what_its_levels_name_while_it_is_on(place):
    writer = LogWriter(place)
    writer.add(datagram(Resume(), 0))
    writer.obey(order(LogState.ON, levels=LogLevel.CRITICAL | LogLevel.INFORMATION))
    other = JausID(102, 1, 1)
    for number, message in enumerate((Resume(), QueryStatus(), SetEmergency(1), RequestControl(1)), 1):
        writer.add(datagram(message, number))
        writer.add(datagram(message, number, destination=other))
    writer.obey(order(LogState.PAUSE))
    writer.add(datagram(Standby(), 8))
    writer.obey(order(LogState.ON))
    writer.add(datagram(QueryStatus(), 9))
    writer.obey(order(LogState.OFF))
    writer.add(datagram(Resume(), 10))
    (path,) = own_files(place)
    assert names(path) == ["Resume", "SetEmergency", "RequestControl", "QueryStatus"]
    assert writer.progress == traffic_log._Progress(path.stat().st_size, 1001.0, 1009.0, "")
    assert path.parent == place.folder


def test_the_oldest_files_give_way_and_others_are_left_alone(place, monkeypatch):
    monkeypatch.setattr(traffic_log, "find_spec", lambda name: None)  # pcapng: sizes are those of the datagrams
    place.folder.mkdir()
    (place.folder / "mine.pcapng").write_bytes(b"x" * 50_000)
    (place.folder / "101-log-20200101-000000.pcapng").symlink_to(place.folder / "mine.pcapng")
    writer = LogWriter(place)
    writer.obey(order(LogState.ON, size=16_000))
    for number in range(1000):
        writer.add(datagram(Resume(), number))
        total = sum(path.stat().st_size for path in own_files(place))
        assert total <= 16_000 + 2_000
    writer.close()
    assert writer.counters["deleted"] > 3
    assert writer.counters["datagrams"] == 1000
    assert (place.folder / "mine.pcapng").stat().st_size == 50_000
    assert (place.folder / "101-log-20200101-000000.pcapng").is_symlink()


def test_a_full_disk_ends_the_log_with_the_reason(place, monkeypatch):
    writer = LogWriter(place)
    writer.obey(order(LogState.ON))

    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    assert writer._file is not None
    monkeypatch.setattr(writer._file, "add", full)
    writer.add(datagram(Resume(), 1))
    assert "No space left" in writer.progress.problem
    writer.add(datagram(Resume(), 2))
    assert writer.counters["datagrams"] == 0


def test_a_folder_that_is_a_file_is_one_sentence(tmp_path):
    (tmp_path / "logs").write_text("")
    with pytest.raises(ConfigError, match=r"logs is no folder, and recordings need one; choose another"):
        asyncio.run(TrafficLog(LogPlace(101, tmp_path, tmp_path / "logs")).open())


@pytest.mark.parametrize("given", ["../elsewhere", "/tmp", ".", ".hidden", "link", "link/logs"])
def test_a_robots_file_records_below_its_own_folder(tmp_path, given):
    (tmp_path / "link").symlink_to("..")
    (tmp_path / "it.toml").write_text(f'extends = "inc1"\nrecord_to = "{given}"\n')
    with pytest.raises(
        ConfigError,
        match=r"record_to = .*(leads out of|is not visible below|is or goes through a link).*--record-to DIR",
    ):
        robot_files.load(tmp_path / "it.toml")


@pytest.mark.slow
async def test_a_client_switches_the_log_of_a_robot(tmp_path):
    with LocalNode() as node:
        log = TrafficLog(LogPlace(101, node.root, tmp_path / "logs"))
        config = robot_files.load("inc1")
        async with (
            RobotRunner(config, node.transport, backend="kinematic", traffic_log=log),
            OCU(connect=node.local) as ocu,
        ):
            robot = await ocu.discover(101)
            logging = robot.service("DataLogging")
            async with logging.control():
                await logging.send(states((1, 0)), ack=True)
                async with asyncio.timeout(60):
                    while (await status(logging)).ending_timestamp is None:
                        await logging.query(QueryStatus())
                        await asyncio.sleep(0.05)  # the worker has a lower priority
                await logging.send(states((1, 1)), ack=True)
                after = await status(logging)
                assert (after.logger_state, after.fill_size) == (1, 1)
        (path,) = (tmp_path / "logs").iterdir()
        assert {"QueryStatus", "ReportStatus", "ReportLoggerStatus"} & set(names(path))
        assert path.name.startswith("101-log-")


async def status(logging):
    return (await logging.query(ids(QueryLoggerStatus, 1))).logger_status_list[0]
