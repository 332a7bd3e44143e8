"""The robot's side of one drive: reported state, next command, and faults."""

from __future__ import annotations

from typing import Final, Protocol

from jauspy.backends.can import pdo
from jauspy.backends.can.cia402 import (
    CHANGE_IMMEDIATELY,
    HOMING_ATTAINED,
    HOMING_ERROR,
    LIMIT_ACTIVE,
    NEW_SETPOINT,
    TARGET_REACHED,
    Controlword,
    DriveState,
    Mode,
    error_text,
    register_text,
    state_of,
    towards_operation,
)
from jauspy.backends.can.other_senders import Balance
from jauspy.backends.can.units import DriveUnits, unwrapped
from jauspy.geometry.urdf import Joint, JointKind
from jauspy.platform.servo_drives import DriveSetup

TRANSITION_TIME: Final = 0.1
"""Seconds that a drive may take to enter Operation Enabled again after a quick stop."""

OPERATIONAL: Final = 5
"""The NMT state in which a drive sends and takes PDOs."""
NMT_STATES: Final = {0: "has restarted", 4: "is stopped (NMT)", 127: "is in NMT state Pre-operational"}

FAULTY: Final = frozenset({DriveState.FAULT, DriveState.FAULT_REACTION_ACTIVE})

MAX_EXCESS: Final = 2
"""Answers beyond SYNCs that a drive may send."""

LIMIT_MARGIN: Final = 0.02
"""Fraction of a joint's range by which it may be beyond its limits."""


class DriveMotion(Protocol):
    """Computes the command of a drive at each SYNC."""

    def advance(self, drive: Drive, dt: float) -> tuple[Mode, float] | None:
        """Mode and value in SI units for the next `dt` seconds; None is a quick stop, after which the drive holds."""
        ...

    def start(self, drive: Drive) -> None:
        """Begin at the drive's present position, before it is enabled."""
        ...

    def hold(self) -> None:
        """Quick stop."""
        ...


SATURATED: Final = 0.98
"""Share of the greatest effort above which a motor counts as saturated."""
CARRIES: Final = 0.9
"""Share of the greatest effort below which the motor carries its load again."""
STANDING: Final = 0.02
"""Share of the speed limit below which a joint counts as standing."""
MOVING: Final = 0.1
"""Share of the speed limit above which a joint with an overload counts as moving."""
OVERLOAD_TIME: Final = 0.2
"""Seconds of overload after which it is reported; shorter ones are shocks."""


class Drive:
    """One drive. `receive_*` may be called by another thread than the other methods."""

    def __init__(self, setup: DriveSetup, joint: Joint, motion: DriveMotion, max_unanswered: int) -> None:
        self.setup = setup
        self.joint = joint
        self.units = DriveUnits(setup, joint)
        self.motion = motion
        self._max_unanswered = max_unanswered
        self.configured = False
        """True when it was configured since it last started."""
        self.homed = True
        """False if it has a homing and did not find its home position since it got power."""
        self.by_profile = False
        """True if it lacks cyclic synchronous modes: it gets positions in the mode `PROFILE_POSITION`."""
        self.ready = False
        """True while it moves on command: in Operation Enabled, with its brake released."""
        self.statusword = 0
        self.state = DriveState.NOT_READY
        self.counts: int | None = None
        """The encoder, beyond 32 bits; None before the first PDO."""
        self.position = self.velocity = self.effort = 0.0
        """State of the joint: radians or metres, rad/s or m/s, newton metres or newtons."""
        self.mode_display = 0
        self.error_code = 0
        self.error_register = 0
        self.nmt_state: int | None = None
        self.last_status = self.last_heartbeat = 0.0
        """Times at which it was heard."""
        self.unanswered = 0
        """SYNCs since its last answer. SYNCs that this process did not send because it was blocked do not count."""
        self.received = 0
        """PDOs with its status."""
        self.answers = Balance(max_unanswered)
        """PDOs with its status, compared with SYNCs."""
        self._failed_in = DriveState.NOT_READY
        self._received_before = 0
        """State of the drive, and the number of PDOs with its status, when the drives were stopped."""
        self._restarted = False
        self._enabled_at: float | None = None
        self._powered_at: float | None = None
        self._new_setpoint = False
        self._target: tuple[Mode, float] | None = None
        self._following_since: float | None = None
        self._idle_value = 0.0
        self._saturated_since: float | None = None

    @property
    def overload(self) -> float | None:
        """The load that the motor cannot carry, N m or N: it stands still with all of its torque; None otherwise."""
        since = self._saturated_since
        if since is None or self.last_status - since < OVERLOAD_TIME:
            return None
        return abs(self.effort)

    @property
    def name(self) -> str:
        """Name in error texts, as in `drive 'arm_2' (node 4)`."""
        return f"drive {self.setup.name!r} (node {self.setup.node})"

    # --- received ---------------------------------------------------------------------------------------------------

    def receive_status(self, data: bytes, now: float) -> bool:
        """Take a PDO with status, position and torque."""
        self.statusword, counts, torque = pdo.STATUS_LAYOUT.unpack(data)
        self.state = state_of(self.statusword)
        self.counts = counts if self.counts is None else unwrapped(counts, self.counts)
        self.position = self.units.position(self.counts)
        self.effort = self.units.effort(torque)
        self.last_status = now
        self.unanswered = 0
        self.received += 1
        begun = self._saturated_since is not None  # an overload ends later than it begins: it does not flicker
        speed, effort = abs(self.velocity) / self.joint.velocity, abs(self.effort) / self.joint.effort
        if speed > (MOVING if begun else STANDING) or effort < (CARRIES if begun else SATURATED):
            self._saturated_since = None
        elif not begun:
            self._saturated_since = now
        self.answers.received += 1
        return True

    def receive_speed(self, data: bytes) -> bool:
        """Take a PDO with velocity, mode and error code."""
        velocity, self.mode_display, code = pdo.SPEED_LAYOUT.unpack(data)
        self.velocity = self.units.velocity(velocity)
        if code or self.state is not DriveState.FAULT:
            self.error_code = code
        return True

    def receive_emergency(self, data: bytes) -> bool:
        """Take an emergency message. It explains a fault, and is none: the statusword says whether the drive works."""
        self.error_code, self.error_register = int.from_bytes(data[:2], "little"), data[2]
        return True

    def receive_heartbeat(self, data: bytes, now: float) -> bool:
        """Take a heartbeat; the state 0 means that the drive has started. Returns False for an unknown state."""
        state = data[0] & 0x7F
        if state != OPERATIONAL and state not in NMT_STATES:
            return False
        self.nmt_state = state
        self.last_heartbeat = now
        if not state:
            self._restarted = True
            self.configured = False
        return True

    # --- commanded --------------------------------------------------------------------------------------------------

    def begin(self, now: float) -> None:
        """Start supervision after the configuration, with cleared state."""
        self.counts = None
        self.received = 0
        self.error_code = self.error_register = 0
        self._restarted = False
        self._enabled_at = self._following_since = self._target = None
        self.last_status = self.last_heartbeat = now
        self.unanswered = 0
        self.configured = True

    def forget_position(self) -> None:
        """Read the encoder anew, beyond whose 32 bits forged positions may have led."""
        self.counts = None
        self.answers.reset()

    def start(self) -> None:
        """Hold the present position when it is enabled."""
        self.motion.start(self)
        self._enabled_at = self._following_since = self._target = None

    def run(self, now: float, dt: float) -> tuple[int, bytes]:
        """COB-ID and bytes of the next command while the robot works."""
        self._watch_brake(now)
        wanted = self.motion.advance(self, dt)
        self._target = wanted
        if wanted is None:
            self._enabled_at = None
            return self.stop()
        if self._enabled_at is None:
            self._enabled_at = now
        control = int(towards_operation(self.state))
        if wanted[0] is Mode.PROFILE_POSITION and self.state is DriveState.OPERATION_ENABLED:
            self._new_setpoint = not self._new_setpoint
            control |= CHANGE_IMMEDIATELY | (NEW_SETPOINT if self._new_setpoint else 0)
        return self.command(control, *wanted)

    def _watch_brake(self, now: float) -> None:
        powered = self.state in {DriveState.OPERATION_ENABLED, DriveState.QUICK_STOP_ACTIVE}
        if not powered:
            self._powered_at = None
        elif self._powered_at is None:
            self._powered_at = now
        self.ready = (
            self.state is DriveState.OPERATION_ENABLED
            and self._powered_at is not None
            and now - self._powered_at >= self.setup.brake_release
        )

    def home(self) -> tuple[int, bytes]:
        """COB-ID and bytes of the next command while it searches its home position."""
        is_ready = self.state is DriveState.OPERATION_ENABLED and self.mode_display == Mode.HOMING
        return self.command(Controlword.START_HOMING if is_ready else towards_operation(self.state), Mode.HOMING, 0.0)

    def homing(self) -> bool | None:
        """True when it has found its home position, False if it failed, None before."""
        if self.mode_display != Mode.HOMING or self.state is not DriveState.OPERATION_ENABLED:
            return None
        if self.statusword & HOMING_ERROR:
            return False
        return True if self.statusword & HOMING_ATTAINED and self.statusword & TARGET_REACHED else None

    def stop(self) -> tuple[int, bytes]:
        """COB-ID and bytes of a quick stop; a drive without power stays without.

        It does not depend on the reported state: a forged one must not take the power of a drive that holds a load.
        """
        return self.idle(Controlword.QUICK_STOP)

    def idle(self, control: int) -> tuple[int, bytes]:
        """COB-ID and bytes of a controlword, with the present position as target."""
        if self.setup.track is not None:
            return self.command(control, Mode.CYCLIC_VELOCITY, 0.0)
        return self.command(control, Mode.CYCLIC_POSITION, self.position)

    def command(self, control: int, mode: Mode, value: float) -> tuple[int, bytes]:
        """COB-ID and bytes of a controlword with a target."""
        units = self.units
        match mode:
            case Mode.CYCLIC_VELOCITY:
                raw = units.velocity_counts(value)
            case Mode.CYCLIC_TORQUE:
                raw = units.torque(value)
            case _:
                raw = units.counts(value)
        carrier = mode if mode in pdo.COMMANDS else Mode.CYCLIC_POSITION
        return pdo.COMMANDS[carrier].cob_id + self.setup.node, pdo.COMMAND_LAYOUTS[carrier].pack(control, mode, raw)

    # --- supervised -------------------------------------------------------------------------------------------------

    def silence(self, now: float, heartbeat_timeout: float) -> str:
        """Reason why it cannot be reached; empty if it can."""
        if self._restarted:
            return "has restarted: it lost its settings; check its supply"
        if self.nmt_state in NMT_STATES:
            return f"{NMT_STATES[self.nmt_state]}; another master or its own fault has put it there"
        quiet, beating = now - self.last_status, now - self.last_heartbeat
        is_silent = self.unanswered > self._max_unanswered
        if is_silent and self.last_heartbeat > self.last_status:
            return f"sends heartbeats, but has not answered SYNC for {1e3 * quiet:.0f} ms: SYNC or its PDOs are lost"
        if is_silent or beating > heartbeat_timeout:
            return f"fell silent for {1e3 * max(quiet, beating):.0f} ms: check its supply, the wiring and termination"
        return ""

    def fault(self, now: float) -> str:
        """Reason why it does not work although it can be reached; empty if it works. Call it after `run`."""
        if self.state in FAULTY:
            return f"is in {self.state.value}: {self.error()}"
        if self._enabled_at is None:
            return ""
        if self.state is not DriveState.OPERATION_ENABLED and now - self._enabled_at > TRANSITION_TIME:
            return f"has left {DriveState.OPERATION_ENABLED.value} and is in {self.state.value}: {self.error()}"
        return self._deviation(now)

    def imitation(self) -> str:
        """Reason why its frames cannot all be its own; empty if they can."""
        return "is not the only one that sends with its node id" if self.answers.excess() > self._max_unanswered else ""

    def note_failure(self) -> None:
        """Remember what it has reported when the drives are stopped."""
        self._failed_in, self._received_before = self.state, self.received

    def contradiction(self) -> str:
        """Contradiction of its frames since a failure, as `but it answers SYNC`; empty if they agree."""
        if (self._restarted or self.nmt_state in NMT_STATES) and self.received > self._received_before:
            return "but it answers SYNC"
        if self._failed_in in FAULTY and self.state not in FAULTY:
            return "and then that it is not, without a reset"
        excess = self.answers.excess()
        return f"and {excess} frames more than SYNCs were received from it" if excess > MAX_EXCESS else ""

    def error(self) -> str:
        """The text of its last error."""
        return f"{error_text(self.error_code)}, error register: {register_text(self.error_register)}"

    def _deviation(self, now: float) -> str:
        if self._target is None or self.setup.track is not None:
            return ""
        mode, value = self._target
        if self.joint.kind in {JointKind.REVOLUTE, JointKind.PRISMATIC}:
            margin = LIMIT_MARGIN * (self.joint.upper - self.joint.lower)
            if not self.joint.lower - margin <= self.position <= self.joint.upper + margin:
                return f"has moved {self.joint.name!r} to {self.position:.3f}, beyond its limits ({self.limits()})"
        error = abs(value - self.position) if mode in {Mode.CYCLIC_POSITION, Mode.PROFILE_POSITION} else 0.0
        if error <= self.setup.following_error:
            self._following_since = None
        elif self._following_since is None:
            self._following_since = now
        elif now - self._following_since > self.setup.following_time:
            limited = " (it says that an internal limit is active)" if self.statusword & LIMIT_ACTIVE else ""
            return (
                f"does not follow: {self.joint.name!r} is {error:.3f} from its command{limited}; it is blocked or too "
                "weak, or node ids, sign or gear_ratio are wrong"
            )
        return ""

    def limits(self) -> str:
        """The limits of the joint, as in `-2.9..2.9`."""
        return f"{self.joint.lower:g}..{self.joint.upper:g}"
