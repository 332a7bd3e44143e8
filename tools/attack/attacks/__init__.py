"""All attacks, in the order of the table."""

from __future__ import annotations

from typing import Final

from ..attack import Attack
from . import (
    captures,
    compression,
    configurations,
    definitions,
    events,
    floods,
    forged_ids,
    fragments,
    gateways,
    insider,
    ipv6,
    legacy,
    local_components,
    local_udp,
    made_up_ids,
    malformed,
    other_user,
    replay,
    robot_files,
    serial,
    services,
    status_readers,
    tcp,
    vague_sources,
)

ALL: Final[tuple[Attack, ...]] = (
    malformed.ATTACK,
    made_up_ids.ATTACK,
    forged_ids.ATTACK,
    vague_sources.ATTACK,
    fragments.ATTACK,
    ipv6.ATTACK,
    compression.ATTACK,
    legacy.ATTACK,
    floods.STANDARD,
    floods.URGENT,
    floods.LIMITED,
    services.ATTACK,
    events.ATTACK,
    tcp.ATTACK,
    serial.ATTACK,
    gateways.ATTACK,
    replay.ATTACK,
    insider.ATTACK,
    local_components.ATTACK,
    local_udp.ATTACK,
    other_user.ATTACK,
    status_readers.ATTACK,
    definitions.ATTACK,
    captures.ATTACK,
    robot_files.ATTACK,
    configurations.ATTACK,
)
