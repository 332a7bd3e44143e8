"""Commands to drive and to move the arm, as fast as they are sent by an operator, under free and forged ids."""

from __future__ import annotations

from ..arena import Arena
from ..attack import Attack, Attacker

RATE = 500


def run(arena: Arena) -> None:
    """By the stranger's own id, with the highest authority; as the operators, and as a component of the robot."""
    for _ in arena.paced(RATE):
        arena.command_robot()
        arena.sent += 1


ATTACK = Attack("commands", Attacker.REMOTE, "commands", run)
