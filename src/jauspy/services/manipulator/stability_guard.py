"""Keeps joints from tipping the robot over: they move slowly near the limit, and stop before it.

See docs/adr/0186-batteries-health-and-stability.md.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Final

from jauspy.geometry.urdf import Joint
from jauspy.logs import get_logger
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.stability import AS_MEASURED, PREDICTION, StabilityMonitor
from jauspy.services.service import ServiceHost

PERIOD: Final = 0.05
"""Seconds between two checks while the joints move."""
LESS: Final = math.radians(0.2)
"""By how much a motion must lower the margin to count as the cause."""
CHANGE: Final = 0.05
"""Change of the speed, as a fraction, after which joints are commanded anew."""

_LOG: Final = get_logger("jauspy.manipulator")


class ArmStability:
    """The limits of one group of joints."""

    def __init__(self, stability: StabilityMonitor) -> None:
        self._stability = stability
        self._factor = 1.0
        self._commanded: dict[str, float] = {}

    def limited(self, targets: Sequence[Target], joints: Sequence[Joint], positions: Sequence[float]) -> list[Target]:
        """The targets, to be approached at the speed that the margin allows; `positions`: the present ones."""
        stability = self._stability
        rows = list(zip(targets, joints, positions, strict=True))
        self._commanded = {joint.name: _velocity(target, joint, position) for target, joint, position in rows}
        if not stability.limits:
            return list(targets)
        self._factor = stability.factor(stability.limiting(PREDICTION, self._commanded, standing=True))
        return [_slowed(target, joint, self._factor) for target, joint, _ in rows]

    def watch(
        self,
        host: ServiceHost,
        key: str,
        *,
        moves: Callable[[], bool],
        rests: Callable[[], bool],
        slow: Callable[[], None],
        stop: Callable[[], None],
    ) -> None:
        """Check until `moves` is false: command the joints anew (`slow`) when the speed changes, and `stop` them.

        The first check is of the motion that was commanded, before it begins; later ones are left out while all joints
        are at rest (`rests`).
        """
        stability, timer = self._stability, ("stability", key)

        def check(velocities: Mapping[str, float] = AS_MEASURED) -> None:
            if not moves():
                return
            host.set_timer(timer, host.now + PERIOD, check)
            if not stability.limits or (velocities is AS_MEASURED and rests()):
                return
            present = stability.limiting(standing=True)
            predicted = stability.limiting(PREDICTION, velocities, standing=True)
            if predicted.angle < stability.setup.stop and predicted.angle < present.angle - LESS:
                text = f"{stability.text(present)}: the joints stop; move them back, or put the load down"
                host.count("stability", text)
                _LOG.warning("%s: %s", host.id, text)
                stop()
            elif abs(stability.factor(predicted) - self._factor) > CHANGE:
                slow()

        host.set_timer(timer, host.now, lambda: check(self._commanded))


def _velocity(target: Target, joint: Joint, position: float) -> float:
    """The velocity with which a joint is going to move."""
    fastest = joint.velocity if target.speed is None else target.speed
    if target.mode is ControlMode.EFFORT:
        share = target.value / joint.effort if joint.effort else 0.0
        return max(-1.0, min(1.0, share)) * joint.velocity
    wanted = target.value if target.mode is ControlMode.VELOCITY else (target.value - position) / PREDICTION
    return max(-fastest, min(fastest, wanted))


def _slowed(target: Target, joint: Joint, factor: float) -> Target:
    if factor == 1.0:
        return target
    speed = (joint.velocity if target.speed is None else target.speed) * factor
    value = target.value * factor if target.mode is ControlMode.VELOCITY else target.value
    return replace(target, value=value, speed=speed)
