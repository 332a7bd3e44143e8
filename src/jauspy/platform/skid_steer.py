"""How two tracks share the effort of a skid-steered chassis."""

from __future__ import annotations


def clamp(effort: float) -> float:
    """Limit an effort to -1..1; something that is not a number means no effort."""
    if effort != effort:  # noqa: PLR0124 - only NaN differs from itself
        return 0.0
    return min(1.0, max(-1.0, effort))


def mix(linear_x: float, rotational_z: float) -> tuple[float, float]:
    """Efforts of the left and right track, -1..1; when one would exceed 1, both shrink and the curve stays."""
    linear, rotational = clamp(linear_x), clamp(rotational_z)
    left, right = linear - rotational, linear + rotational
    scale = max(1.0, abs(left), abs(right))
    return left / scale, right / scale
