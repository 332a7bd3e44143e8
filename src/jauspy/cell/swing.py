"""The swing after a release: the modular arm swings, lets go of its box on the way, and comes to rest.

In the published system the arm swung on for long. The IMU of the last module shows how long, by its reports over JAUS.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np

from jauspy.cell.frames import Array
from jauspy.cell.measurements import Measured
from jauspy.cell.session import UNDISTURBED, Session, simulated
from jauspy.cell.timed_connector import begin_motion
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import rotation_about
from jauspy.platform.modular.arm import ArmController
from jauspy.plots import figure

ARM: Final = ("servo_1", "bracket_1", "servo_2", "tube_1", "servo_3", "tube_2", "servo_4", "servo_5")
"""The parts of the arm, from its base up: with an X5-4 as its fourth joint, as its published figures have it."""
BASE: Final = "platform_1/top"
TIP: Final = "servo_5/output"
BOX: Final = "box_1"
LAST_MODULE: Final = "servo_5"

START: Final = (-0.8, 0.7, 0.9, 0.6, 0.0)
END: Final = (0.6, 0.3, 0.6, 0.5, 0.0)
"""Joint positions (rad): from low in front, up and to the left."""
DURATION: Final = 1.4
"""Seconds of the swing."""
RELEASE: Final = 0.8 * DURATION
"""Seconds from its start until the box is let go."""

AT_REST: Final = 0.02
"""rad/s: the last module is at rest when its angular velocity stays below."""
OBSERVED: Final = 6.0
"""Seconds that are observed after the release."""
PERIOD: Final = 0.01
"""Seconds from one report to the next."""
SETTLE_TIME: Final = 4.0
"""Seconds at rest before the swing."""
JOIN_SHIFT: Final = 0.0006
JOIN_TILT: Final = 0.002
"""Metres and radians by which each part is off its connector at most: what the assembly leaves."""


@dataclass(frozen=True, slots=True)
class Swing:
    """Measurements of the IMU of the last module; times in seconds from the release."""

    controller: ArmController
    times: Array
    """Shape (n,)."""
    rates: Array
    """Shape (n, 3): angular velocity about x, y, z of the last module's housing at each time, rad/s."""
    end: float
    """End of the commanded motion."""
    payload: float
    """Mass of the box as the arm estimated it before the swing, in kilograms."""

    @property
    def speeds(self) -> Array:
        """Shape (n,): magnitude of the angular velocity at each time, rad/s."""
        found: Array = np.linalg.norm(self.rates, axis=1)
        return found

    @property
    def settled(self) -> float:
        """Seconds from the release until the last module is at rest for good."""
        moving = np.flatnonzero(self.speeds >= AT_REST)
        return float(self.times[min(int(moving[-1]) + 1, len(self.times) - 1)]) if len(moving) else 0.0

    @property
    def came_to_rest(self) -> bool:
        """True if the last module came to rest within the observed time."""
        return bool(self.speeds[-1] < AT_REST)

    @property
    def settled_after_end(self) -> float:
        """Seconds from the end of the commanded motion until the last module is at rest for good."""
        return max(0.0, self.settled - self.end)

    @property
    def overshoot(self) -> float:
        """The largest angular velocity after the commanded motion has ended, rad/s."""
        return float(np.max(self.speeds[self.times >= self.end], initial=0.0))


@dataclass(frozen=True, slots=True)
class SwingComparison:
    """The same swing by both controllers."""

    pid: Swing
    model: Swing

    @property
    def sooner(self) -> float:
        """The factor by which the arm is sooner at rest after the release with the model-based controller."""
        return self.pid.settled / max(self.model.settled, PERIOD)

    @property
    def overshoot(self) -> float:
        """The overshoot with the model-based controller over that with independent PID controllers.

        Infinite when only the former has one, 1 when none has.
        """
        if not self.pid.overshoot:
            return math.inf if self.model.overshoot else 1.0
        return self.model.overshoot / self.pid.overshoot

    def measured(self, seed: int) -> Measured:
        """The figures, for tables and files."""
        values = {
            "settled_pid": self.pid.settled,
            "settled_model": self.model.settled,
            "settled_sooner": self.sooner,
            "settled_after_end_pid": self.pid.settled_after_end,
            "settled_after_end_model": self.model.settled_after_end,
            "overshoot_pid": self.pid.overshoot,
            "overshoot_model": self.model.overshoot,
            "overshoot_ratio": self.overshoot,
            "payload": self.model.payload,
        }
        found = Measured(seed, "swing", values=values, duration=2.0 * OBSERVED)
        found.success = self.sooner >= 5.0 and self.overshoot <= 1.0 / 3.0 and self.model.came_to_rest
        if not found.success:
            found.failure = f"at rest {self.sooner:.1f} times sooner, overshoot {self.overshoot:.2f} of that of PID"
        return found


async def swing(session: Session, controller: ArmController) -> Swing:
    """Swing the arm with a box, and release it on the way. The arm must be there, with the box at its tip."""
    cell = session.cell
    await cell.move_arm(START, 3.0)
    await cell.choose_controller(controller)
    await cell.enable(TIP, True)  # it is enabled already; this takes control of it
    await cell.servo(LAST_MODULE)
    await cell.sleep(SETTLE_TIME)
    state = await cell.arm()
    if len(state.joints) != len(START):
        raise ConfigError(f"the swing needs an arm with {len(START)} joints; there are {len(state.joints)}")
    began = cell.now()
    await begin_motion(cell, END, DURATION, TIP, RELEASE, enabled=False)
    await cell.sleep(0.1)
    if error := (await cell.arm()).error:
        raise ConfigError(f"the arm does not swing: {error}")
    await cell.sleep(began + RELEASE - cell.now())
    released = cell.now()
    times: list[float] = []
    rates: list[tuple[float, float, float]] = []
    for count in range(round(OBSERVED / PERIOD)):
        await cell.sleep(max(0.0, released + count * PERIOD - cell.now()))
        report = await cell.servo(LAST_MODULE)
        found = report.angular_velocity_x, report.angular_velocity_y, report.angular_velocity_z
        times.append(cell.now() - released)
        rates.append((found[0] or 0.0, found[1] or 0.0, found[2] or 0.0))
    end = began + DURATION - released
    return Swing(controller, np.array(times), np.array(rates), end, state.payload)


def joint_errors(seed: int) -> dict[str, Transform]:
    """The poses of the arm's parts on their connectors, drawn with a seed."""
    random = np.random.default_rng(seed)
    found = {}
    for part in ARM:
        x, y = random.uniform(-JOIN_SHIFT, JOIN_SHIFT, 2).tolist()
        tilt, direction = random.uniform(0.0, JOIN_TILT), random.uniform(0.0, math.tau)
        rotation = rotation_about((math.cos(direction), math.sin(direction), 0.0), tilt)
        found[part] = Transform(rotation, (x, y, 0.0))
    return found


async def compare(seed: int, report: Callable[[str], None] = lambda _: None) -> SwingComparison:
    """The swing with both controllers, each in a separate simulated cell with the arm prepared.

    The seed is that of the joints' errors and of the sensors' noise.
    """
    found = {}
    for controller in ArmController:
        report(f"swing with the controller {controller.value}")
        async with simulated(seed, UNDISTURBED) as session:
            session.true.prepare(BASE, ARM, joint_errors(seed))
            session.true.prepare(TIP, (BOX,))
            found[controller] = await swing(session, controller)
    return SwingComparison(found[ArmController.PID], found[ArmController.MODEL])


def plot_swing(comparison: SwingComparison, path: Path) -> None:
    """Angular velocity of the last module after the release, both controllers in one picture."""
    names = ("x", "y", "z", "magnitude")
    colours = {ArmController.PID: "#b3423a", ArmController.MODEL: "#3b6ea5"}
    labels = {ArmController.PID: "PID for each joint", ArmController.MODEL: "model of the arm"}
    both = comparison.pid, comparison.model
    longest = min(OBSERVED, 1.3 * max(swing.settled for swing in both))
    with figure(path, columns=4, size=(13.0, 4.0)) as axes:
        for column, (axis, name) in enumerate(zip(axes, names, strict=True)):
            for swing in both:
                rows = swing.speeds if column == 3 else swing.rates[:, column]
                axis.plot(swing.times, rows, color=colours[swing.controller], label=labels[swing.controller], lw=1.6)
            axis.axvline(both[1].end, color="0.5", lw=1.0, ls="--")
            axis.set_xlim(0.0, longest)
            axis.set_xlabel("seconds after the release")
            axis.set_title(f"angular velocity, {name}" if column == 3 else f"angular velocity about {name}")
        axes[0].set_ylabel("rad/s, by the IMU of the last module")
        axes[3].set_yscale("log")
        axes[3].set_ylim(1e-3, None)
        axes[3].axhline(AT_REST, color="#2f7d4f", lw=1.2)
        axes[3].annotate(f"at rest: {AT_REST:g} rad/s", (longest, 1.2e-3), ha="right", va="bottom", color="#2f7d4f")
        for swing in both:
            axes[3].axvline(swing.settled, color=colours[swing.controller], lw=1.0, ls=":")
        axes[1].annotate("end of the commanded motion", (1.3 * both[1].end, -1.0), fontsize=9)
        axes[0].legend(loc="best")
