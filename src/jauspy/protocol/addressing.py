"""Wildcards and unassigned parts of destination ids, on 32-bit numbers as they stand in headers."""

from __future__ import annotations

ALL_SUBSYSTEMS = 0xFFFF0000
ALL_NODES = 0xFF00
ALL_COMPONENTS = 0xFF


def is_wildcard(id: int) -> bool:
    """True when the id addresses all of some level."""
    return id & ALL_COMPONENTS == ALL_COMPONENTS or id & ALL_NODES == ALL_NODES or id >= ALL_SUBSYSTEMS


def is_unassigned(id: int) -> bool:
    """True when some part is zero: a component that waits to be given its id."""
    return not (id >> 16 and id & ALL_NODES and id & ALL_COMPONENTS)


def is_vague(id: int) -> bool:
    """True when the id does not name one component: nobody's address can be told from it."""
    return is_wildcard(id) or is_unassigned(id)


def reaches(destination: int, id: int) -> bool:
    """True when `destination` addresses the component `id`, field by field.

    A part of `id` that is zero or a wildcard is not assigned yet, so any broadcast may be meant for it; 100.1.2
    and 356.1.2 are different subsystems.
    """
    return (
        _part(destination >> 16, id >> 16, 0xFFFF)
        and _part(destination >> 8 & 0xFF, id >> 8 & 0xFF, 0xFF)
        and _part(destination & 0xFF, id & 0xFF, 0xFF)
    )


def _part(wanted: int, own: int, any_value: int) -> bool:
    return wanted in (own, any_value) or own in (0, any_value)
