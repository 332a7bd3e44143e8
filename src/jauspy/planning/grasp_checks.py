"""What fingers and wrist tell of a grasp, in words."""

from __future__ import annotations

from typing import Final

from jauspy.errors import RequestError

EMPTY_WIDTH: Final = 0.004
"""Metres between fingers that hold nothing, at most."""
WIDTH_TOLERANCE: Final = (0.035, 0.012)
"""Metres by which a thing may be thinner and thicker between the fingers than it looked."""
LEAST_WEIGHT: Final = 0.05
"""Kilograms that the wrist must feel: its noise is less than 0.01 kg."""
SLIP: Final = 0.005
"""Metres by which the fingers may close while the thing is held."""


class GraspFailed(RequestError):
    """A thing was not found, not grasped, or lost; the message says why."""


def grip_problem(width: float, seen: float, opened: float) -> str:
    """What is wrong after the fingers have closed, widths in metres; empty if they seem to hold the thing."""
    if opened - width < 0.003:
        return f"the gripper did not close: its fingers are still {100.0 * width:.1f} cm apart"
    if width <= EMPTY_WIDTH:
        return "the fingers closed on nothing"
    thinner, thicker = WIDTH_TOLERANCE
    if not seen - thinner <= width <= seen + thicker:
        return (
            f"the fingers stopped {100.0 * width:.1f} cm apart, and the thing looked {100.0 * seen:.1f} cm wide: it is "
            "not between them as planned"
        )
    return ""


def hold_problem(gripped: float, lifted: float, kept: float, weight: float | None) -> str:
    """What is wrong after the lift; empty if the thing is held.

    Widths in metres: when the fingers had closed, after the lift, and after it was held; `weight` in kilograms, None
    without a sensor. A thing may turn between the fingers as it is lifted, if it is felt.
    """
    turned = SLIP if weight is None else WIDTH_TOLERANCE[0]
    if kept <= EMPTY_WIDTH or gripped - lifted > turned or lifted - kept > SLIP:
        return (
            "the thing slipped out of the gripper: "
            f"its fingers went from {100.0 * gripped:.1f} to {100.0 * kept:.1f} cm"
        )
    if weight is not None and weight < LEAST_WEIGHT:
        return f"the wrist feels no weight ({weight:.2f} kg): the thing was not lifted"
    return ""
