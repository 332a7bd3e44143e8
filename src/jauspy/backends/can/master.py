"""The robot's end of the bus: starts drives, sends their commands and SYNC, supervises them, stops them all.

`cycle` is called at each SYNC: by a thread on a bus, or by the robot's own time with simulated drives in this process.
"""

from __future__ import annotations

import threading
from collections import Counter
from collections.abc import Callable, Mapping
from enum import Enum
from typing import Final

import can
import canopen

from jauspy.backends.can import pdo
from jauspy.backends.can.bus import hint, split
from jauspy.backends.can.cia402 import Controlword, DriveState, towards_operation
from jauspy.backends.can.configuration import Configurator
from jauspy.backends.can.drive import LIMIT_MARGIN, OPERATIONAL, Drive
from jauspy.backends.can.faults import DriveFault
from jauspy.backends.can.inbox import FrameInbox
from jauspy.backends.can.other_senders import OtherMasters
from jauspy.backends.can.readings import DriveReadings
from jauspy.geometry.urdf import JointKind
from jauspy.logs import get_logger
from jauspy.platform.servo_drives import CanSetup

_LOG: Final = get_logger("jauspy.can")

LISTENING_TIME: Final = 0.25
"""Seconds in which another master is listened for before anything is sent."""

START_TIMEOUT: Final = 2.0
"""Seconds in which drives must reach each step of the start."""

STILL_SYNCS: Final = 10
"""SYNCs in which no joint may move before the drives are enabled."""
STILL: Final = 0.005
"""Radians or metres that a joint may move meanwhile."""

EXPLAIN_TIME: Final = 0.02
"""Seconds from a fault to the exception, in which the drive's emergency message with the reason arrives."""

PAUSE: Final = 0.1
"""Seconds between two cycles after which motions must not continue: this process was blocked."""

MAX_SEND_ERRORS: Final = 5
"""Cycles in a row in which nothing could be sent."""

FLOOD: Final = 2000.0
"""Frames a second that are ignored, from which on silence of a drive is explained by them."""


class Phase(Enum):
    """Phases of the cycle, by what it sends to the drives."""

    LISTENING = "nothing at all"
    IDLE = "SYNC, and nothing that moves"
    RESETTING = "fault reset"
    HOMING = "the search of one drive for its home position"
    ENABLING = "steps to Operation Enabled"
    RUNNING = "setpoints"
    STOPPED = "quick stop, after a failure"
    CLOSING = "what takes the power"


class Master:
    """All drives of a robot.

    `wait_cycle` lets one SYNC period pass, with its cycle. `echoes`: whether the bus returns what is sent on it.
    """

    def __init__(
        self,
        setup: CanSetup,
        drives: Mapping[str, Drive],
        network: canopen.Network,
        *,
        clock: Callable[[], float],
        wait_cycle: Callable[[], None],
        echoes: bool,
    ) -> None:
        self.setup = setup
        self.drives = drives
        self.period = 1.0 / setup.sync_rate
        self.lock = threading.RLock()
        """Held during a cycle, and while motions are commanded."""
        self.counters: Counter[str] = Counter(syncs=0, missed=0, unsent=0)
        self._network = network
        self._clock = clock
        self._wait_cycle = wait_cycle
        self._configurator = Configurator(network, setup)
        self._phase = Phase.LISTENING
        self._failure = ""
        self._culprit: Drive | None = None
        self._failed_at = 0.0
        self._next_heartbeat = 0.0
        self._last_cycle: float | None = None
        self._longest_pause = 0.0
        """Seconds between two cycles since the drives were last to be enabled."""
        self._send_errors = 0
        self._reset = False
        self._homing: Drive | None = None
        self._bus_error = ""
        self._others = OtherMasters(setup, echoes=echoes)
        self._second = (0.0, 0)
        """The time of the last full second, and the frames that had been ignored then."""
        self._ignored_rate = 0.0
        self.readings = DriveReadings(drives)
        self.inbox = FrameInbox()
        for drive in drives.values():
            self._expect_frames_of(drive)
        self.inbox.expect(pdo.SYNC, 0, self._others.receive_sync)
        self.inbox.expect(pdo.HEARTBEAT + setup.node, 1, self._others.receive_heartbeat)
        self.inbox.expect(pdo.NMT, 2, self._others.receive_nmt)

    # --- the bus ----------------------------------------------------------------------------------------------------

    def _expect_frames_of(self, drive: Drive) -> None:
        node, clock, expect = drive.setup.node, self._clock, self.inbox.expect
        expect(pdo.STATUS.cob_id + node, pdo.STATUS_LAYOUT.size, lambda data: drive.receive_status(data, clock()))
        expect(pdo.SPEED.cob_id + node, pdo.SPEED_LAYOUT.size, drive.receive_speed)
        expect(pdo.EMCY + node, pdo.EMCY_SIZE, drive.receive_emergency)
        expect(pdo.HEARTBEAT + node, 1, lambda data: drive.receive_heartbeat(data, clock()))
        expect(pdo.SDO_ANSWER + node, pdo.SDO_SIZE, lambda data: self._take_answer(node, data))
        for mode, layout in pdo.COMMAND_LAYOUTS.items():
            expect(pdo.COMMANDS[mode].cob_id + node, layout.size, self._others.receive_command)

    def _take_answer(self, node: int, data: bytes) -> bool:
        return self._configurator.receive_answer(node, data) or self.readings.receive(node, data)

    def bus_failed(self, why: str) -> None:
        """Note that the bus has failed, as by bus-off; any thread may call this."""
        self._bus_error = self._bus_sentence(why)

    def _send(self, cob_id: int, data: bytes) -> None:
        try:
            self._network.send_message(cob_id, data)
        except (can.CanError, OSError) as error:
            self.counters["unsent"] += 1
            self._bus_error = self._bus_error or self._bus_sentence(f"{error}", hint(error))
            raise

    # --- each SYNC --------------------------------------------------------------------------------------------------

    def cycle(self, now: float) -> None:
        """Send commands, SYNC and heartbeat, and check the last answers of the drives."""
        with self.lock:
            if self._phase is Phase.LISTENING:
                return
            self._check_pause(now)
            self._watch_flood(now)
            try:
                if now >= self._next_heartbeat:
                    self._next_heartbeat = now + self.setup.heartbeat
                    self._send(pdo.HEARTBEAT + self.setup.node, bytes((OPERATIONAL,)))
                    self._others.sent_heartbeat()
                for drive in self.drives.values():
                    if drive.configured or self._phase in {Phase.STOPPED, Phase.CLOSING}:
                        self._send(*self._command(drive, now))
                        self._others.sent_command()
                self._send_sync()
                if self._phase is Phase.RUNNING and (question := self.readings.ask(now)) is not None:
                    self._send(*question)
                self.counters["syncs"] += 1
                self._send_errors = 0
            except (can.CanError, OSError):
                self._send_errors += 1
                if self._send_errors >= MAX_SEND_ERRORS:
                    self._fail(None, self._bus_error, now)
            if self._phase in {Phase.RUNNING, Phase.ENABLING, Phase.HOMING}:
                self._supervise(now)

    def _send_sync(self) -> None:
        self._send(pdo.SYNC, b"")
        self._others.sent_sync()
        for drive in self.drives.values():
            drive.unanswered += 1
            drive.answers.add_due()

    def _watch_flood(self, now: float) -> None:
        since, ignored = self._second
        if now - since >= 1.0:
            present = self.inbox.counters["ignored"]
            self._ignored_rate = (present - ignored) / (now - since)
            self._second = now, present
            for drive in self.drives.values():
                drive.answers.forgive()

    def _command(self, drive: Drive, now: float) -> tuple[int, bytes]:
        match self._phase:
            case Phase.RUNNING:
                return drive.run(now, self.period)
            case Phase.ENABLING:
                return drive.idle(towards_operation(drive.state))
            case Phase.RESETTING:
                faulty = drive.state is DriveState.FAULT
                if not faulty:
                    return drive.stop()
                return drive.idle(Controlword.FAULT_RESET if self._reset else Controlword.DISABLE_VOLTAGE)
            case Phase.HOMING if drive is self._homing:
                return drive.home()
            case Phase.CLOSING:
                return drive.idle(Controlword.SHUTDOWN)
            case _:
                return drive.stop()

    def _check_pause(self, now: float) -> None:
        last, self._last_cycle = self._last_cycle, now
        pause = 0.0 if last is None else now - last
        self._longest_pause = max(self._longest_pause, pause)
        if pause > PAUSE and self._phase is Phase.RUNNING:
            self._fail(None, f"the robot's program did not run for {pause:.2f} s, and drives got no commands", now)

    def _supervise(self, now: float) -> None:
        if self._bus_error and self._send_errors == 0:
            self._fail(None, self._bus_error, now)
        if what := self._others.found():
            self._fail(None, f"another master sends {what}: end it; two that command drives are dangerous", now)
        for drive in self.drives.values():
            if why := drive.silence(now, self.setup.heartbeat_timeout) or drive.fault(now) or drive.imitation():
                self._fail(drive, why, now)

    def _bus_sentence(self, error: str, what_to_do: str = "") -> str:
        bus = self.setup.bus
        if error == "bus-off":
            link, channel, _ = split(bus)
            restart = f"restart it (`ip link set {channel} type can restart`), " if link == "socketcan" else ""
            return f"{bus} is bus-off: check bit rate, wiring and termination; {restart}then Reset"
        return f"{bus} takes no more frames ({error}): " + (
            what_to_do
            or "the bus is too full or nobody acknowledges; lower can.sync_rate, or check bit rate, wiring and "
            "termination"
        )

    def _fail(self, drive: Drive | None, why: str, now: float) -> None:
        if self._phase is Phase.STOPPED:
            return
        self._phase = Phase.STOPPED
        self._failure, self._culprit, self._failed_at = why, drive, now
        for stopped in self.drives.values():
            stopped.motion.start(stopped)
            stopped.note_failure()
        try:  # at once, not with the next SYNC only
            for stopped in self.drives.values():
                self._send(*stopped.stop())
                self._others.sent_command()
            self._send_sync()
        except (can.CanError, OSError):
            _LOG.warning("%s: the quick stop could not be sent; the drives stop without heartbeat", self.setup.bus)

    def hold_all(self) -> None:
        """Stop everything, as the robot's thread would; it may command again."""
        with self.lock:
            for drive in self.drives.values():
                drive.motion.hold()

    @property
    def running(self) -> bool:
        """True while drives follow commands."""
        return self._phase is Phase.RUNNING

    def check(self, now: float) -> None:
        """Raise `DriveFault` with the reason if the drives have been stopped."""
        if self._phase is Phase.STOPPED and now - self._failed_at >= EXPLAIN_TIME:
            raise DriveFault(self.reason())

    def reason(self) -> str:
        """Reason why the drives were stopped; empty if they were not."""
        if not self._failure:
            return ""
        drive = self._culprit
        if drive is None:
            return f"{self._failure}; all drives were stopped"
        why = self._failure
        if drive.state in {DriveState.FAULT, DriveState.FAULT_REACTION_ACTIVE} and "is in" in why:
            why = f"is in {drive.state.value}: {drive.error()}"  # the emergency message may have come later
        if contradiction := drive.contradiction():
            why = f"{why}, {contradiction}: another program seems to send as this node on {self.setup.bus}"
        elif drive.unanswered and self._ignored_rate > FLOOD:
            why = f"{why}; {self._ignored_rate:.0f} frames a second of others were received: end their sender"
        return f"{drive.name}, which moves {drive.joint.name!r}, {why}; the other drives were stopped"

    # --- start and recovery -----------------------------------------------------------------------------------------

    def start(self) -> None:
        """Configure the drives, wait until all agree, enable them. Blocks; raises `DriveFault`."""
        self._open()
        self.enable()

    def configure(self) -> None:
        """Configure the drives, and wait until all agree; they get no power. Blocks; raises `DriveFault`."""
        self._open()
        self._make_ready()

    def enable(self) -> None:
        """Reset faults, and enable the configured drives; once more if this program was held up. Blocks.

        Raises `DriveFault` if they cannot be enabled; `held_up` tells whether that may be because of this program.
        `check` raises what stopped them after they were enabled.
        """
        self._longest_pause = 0.0
        try:
            self._bring_up()
        except DriveFault:
            if not self.held_up:
                raise
        else:
            self._settle()
            if self.running or not self.held_up:
                return
        _LOG.warning(
            "%s: the robot's program did not run for %.2f s while the drives were enabled: they are enabled once more",
            *(self.setup.bus, self._longest_pause),
        )
        self._longest_pause = 0.0
        self.recover()
        self._settle()

    def _settle(self) -> None:
        """Let the first cycles pass, and the time in which a failure is explained."""
        for _ in range(STILL_SYNCS + round(EXPLAIN_TIME / self.period)):
            self._wait_cycle()

    @property
    def held_up(self) -> bool:
        """True if this program did not run for a while when the drives were last enabled."""
        return self._longest_pause > PAUSE

    def home(self, tell: Callable[[str], None]) -> None:
        """Home all drives that need it, one after the other; `tell` is called with the text of each motion.

        Blocks; raises `DriveFault`.
        """
        self._open()
        self._prepare()
        for drive in self.drives.values():
            if not drive.homed:
                self._home(drive, tell)
        self._agree()

    def _open(self) -> None:
        load = pdo.bus_load(len(self.drives), self.setup.sync_rate, self.setup.bit_rate)
        if load > MAX_BUS_LOAD:
            raise DriveFault(
                f"{self.setup.bus} would be {100 * load:.0f} % full with {len(self.drives)} drives at "
                f"{self.setup.bit_rate} bit/s: lower can.sync_rate to {self.setup.sync_rate * MAX_BUS_LOAD / load:.0f}"
            )
        self._listen()
        self._set_phase(Phase.IDLE)

    def recover(self) -> None:
        """Try again after a failure: reset faults, configure drives that restarted. Blocks; raises `DriveFault`."""
        self._bus_error, self._send_errors = "", 0
        with self.lock:
            self._others.reset()
            for drive in self.drives.values():
                drive.forget_position()
        for drive in self.drives.values():
            if drive.nmt_state != OPERATIONAL or drive.silence(self._clock(), self.setup.heartbeat_timeout):
                drive.configured = False
        self._set_phase(Phase.IDLE)
        try:
            self._bring_up()
        except DriveFault as error:
            with self.lock:
                self._phase = Phase.STOPPED
                self._failure, self._culprit, self._failed_at = str(error), None, self._clock() - EXPLAIN_TIME
            raise

    def _listen(self) -> None:
        for _ in range(round(LISTENING_TIME / self.period)):
            self._wait_cycle()
        if what := self._others.found(tolerance=0):
            raise DriveFault(f"another master sends {what} already: end it; two that command drives are dangerous")

    def _prepare(self) -> None:
        """Configure drives that are new, and reset faults."""
        new = [drive for drive in self.drives.values() if not drive.configured]
        for drive in new:
            self._configurator.configure(drive)
            drive.begin(self._clock())
        self._wait("enter NMT state Operational", self._operational, START_TIMEOUT)
        self._set_phase(Phase.RESETTING)
        for _ in range(4):
            self._reset = not self._reset
            self._wait_cycle()
            self._wait_cycle()
        self._wait("leave Fault", lambda drive: drive.state is not DriveState.FAULT, START_TIMEOUT)
        self._set_phase(Phase.IDLE)

    def _make_ready(self) -> None:
        self._prepare()
        if lost := [drive.name for drive in self.drives.values() if not drive.homed]:
            raise DriveFault(
                f"{' and '.join(lost)}: position unknown since power-on: `jauspy can home ROBOT --bus "
                f"{self.setup.bus}` moves to the home position"
            )
        self._agree()

    def _bring_up(self) -> None:
        self._make_ready()
        with self.lock:
            for drive in self.drives.values():
                drive.answers.restart()
                drive.start()
        self._others.sends_nmt()
        self._set_phase(Phase.ENABLING)
        self._wait("enable operation", lambda drive: drive.state is DriveState.OPERATION_ENABLED, START_TIMEOUT)
        with self.lock:
            for drive in self.drives.values():
                drive.start()
            self._failure = ""
            self._phase = Phase.RUNNING

    def _home(self, drive: Drive, tell: Callable[[str], None]) -> None:
        homing = drive.setup.homing
        if homing is None:
            return
        tell(f"{drive.name} moves {drive.joint.name!r} by homing method {homing.method}, {homing.timeout:g} s at most")
        self._others.sends_nmt()
        with self.lock:
            self._homing = drive
            drive.start()
            self._phase = Phase.HOMING
        found = None
        for _ in range(round(homing.timeout / self.period)):
            self._wait_cycle()
            if self._phase is Phase.STOPPED:
                raise DriveFault(self.reason())
            if (found := drive.homing()) is not None:
                break
        self._set_phase(Phase.IDLE)  # quick stop
        drive.homed = found is True
        if not drive.homed:
            why = "the drive reports an error" if found is False else f"it took more than {homing.timeout:g} s"
            raise DriveFault(f"{drive.name} did not find its home position: {why}; check switch, method and speed")
        for _ in range(STILL_SYNCS):
            self._wait_cycle()

    def _operational(self, drive: Drive) -> bool:
        if drive.nmt_state == OPERATIONAL and drive.received > 2:
            return True
        try:
            self._send(0, bytes((1, drive.setup.node)))  # NMT: start; a lost one is sent again
        except (can.CanError, OSError) as error:
            raise DriveFault(self._bus_error) from error
        return False

    def _agree(self) -> None:
        """Check that all drives report plausible positions, and that nothing moves."""
        before = {drive: drive.position for drive in self.drives.values()}
        for _ in range(STILL_SYNCS):
            self._wait_cycle()
        for drive, position in before.items():
            joint = drive.joint
            if abs(drive.position - position) > STILL:
                raise DriveFault(f"{drive.name} moves while nothing is enabled: hold {joint.name!r}, check its brake")
            margin = LIMIT_MARGIN * (joint.upper - joint.lower)
            limited = drive.setup.track is None and joint.kind in {JointKind.REVOLUTE, JointKind.PRISMATIC}
            if limited and not joint.lower - margin <= drive.position <= joint.upper + margin:
                raise DriveFault(
                    f"{drive.name} reports {joint.name!r} at {drive.position:.3f}, beyond its limits "
                    f"({drive.limits()}): check zero, sign, gear_ratio and encoder_counts of can.drives."
                    f"{drive.setup.name}, and whether node ids are swapped"
                )

    def _wait(self, what: str, reached: Callable[[Drive], bool], timeout: float) -> None:
        """Wait until all drives have reached something; raises `DriveFault` with the first that has not."""
        for _ in range(round(timeout / self.period)):
            if self._phase is Phase.STOPPED:
                raise DriveFault(self.reason())
            missing = [drive for drive in self.drives.values() if not reached(drive)]
            if not missing:
                return
            self._wait_cycle()
        drive = missing[0]
        raise DriveFault(
            f"{drive.name} does not {what}; it is in {drive.state.value}: {drive.error()}"
            + (f" (and {len(missing) - 1} more)" if len(missing) > 1 else "")
        )

    def _set_phase(self, phase: Phase) -> None:
        with self.lock:
            self._phase = phase

    def close(self) -> None:
        """Stop all drives and take their power. May be called twice."""
        with self.lock:
            if self._phase is Phase.LISTENING:
                return
            self._phase = Phase.STOPPED
        for _ in range(CLOSING_CYCLES):
            self._wait_cycle()
        self._set_phase(Phase.CLOSING)
        self._wait_cycle()
        self._wait_cycle()
        self._set_phase(Phase.LISTENING)


MAX_BUS_LOAD: Final = 0.85
"""The fraction of the bus that cyclic traffic may take; the rest is for SDO, heartbeats and errors."""

CLOSING_CYCLES: Final = 40
"""SYNCs between the quick stop and the loss of power, when brakes engage."""
