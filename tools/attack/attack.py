"""What an attack is: who attacks, how, and the bounds that the victim has to keep."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import TYPE_CHECKING, Any

from .truth import Motion

if TYPE_CHECKING:
    from .arena import Arena


class Attacker(Enum):
    """The attackers of the threat model in docs/security.md."""

    REMOTE = "remote, without the key"
    INSIDER = "remote, with the key"
    LOCAL = "local user"
    AUTHOR = "file author"


class Victims(Enum):
    """What is started for an attack."""

    ROBOT = "a node manager and a robot, and an operator on another host"
    GATEWAYS = "two gateways that join the same two networks, a component at each end"
    COMMANDS = "nothing; the attack runs commands of its own"


@dataclass(frozen=True, slots=True)
class Layout:
    """What is started. Attacks with the same layout follow one another on the same victims."""

    victims: Victims = Victims.ROBOT
    keyed: bool = False
    """The network has a key, and therefore neither TCP nor a serial line."""
    settings: Mapping[str, Any] = field(default_factory=dict)
    """Further settings of the robot's node manager."""
    sealed: bool = False
    """The robot takes commands of registered operators only, and its operator has such a key."""
    planner: bool = False
    """Beside the robot runs a planner of its arm."""


@dataclass(frozen=True, slots=True)
class Bounds:
    """Upper bounds of what an attack may do to its victims."""

    lost: float = 0.0
    """Share of the honest queries that are not answered."""
    silence: float = 1.0
    """Seconds without any answer to the honest operator."""
    memory: float = 24.0
    """MiB by which the resident memory of a victim grows, at its peak."""
    descriptors: int = 0
    """Descriptors that are open after the attack and were not before, in all victims."""
    tasks: int = 0
    """The same for tasks of asyncio."""
    lines: int = 100
    """Lines that the victims log, at the level debug."""
    moved: float = 0.05
    """Metres or radians by which the robot moves without a command of its operator."""
    driven: float = 0.5
    """Share of the operator's drives that the robot carries out at least; 0 for attackers who may stop it."""
    control: float = 0.95
    """Share of the time in which the operator is in control at least."""
    may_be_taken: bool = False
    """The attackers may take control once the operator has lost it, and then move the robot."""


class BoundBroken(Exception):
    """A victim did not keep a bound; the message is one sentence."""


class NotStarted(BoundBroken):
    """A victim did not start, which an attack has not caused."""


class NotPossible(Exception):
    """An attack is not permitted on this machine; the message says why."""


@dataclass(frozen=True, slots=True)
class Attack:
    """One attack. `run` sends until the time of the arena is over; it raises `BoundBroken` for bounds of its own."""

    name: str
    attacker: Attacker
    unit: str
    """What `Arena.sent` counts, as in datagrams."""
    run: Callable[[Arena], None]
    bounds: Bounds = Bounds()
    layout: Layout = field(default_factory=Layout)
    restarts: bool = False
    """The next attack needs new victims, because the effect of this one lasts."""


@dataclass(slots=True)
class Result:
    """What an attack did, as measured."""

    attack: Attack
    sent: int = 0
    asked: int = 0
    lost: int = 0
    silence: float = 0.0
    memory: float = 0.0
    descriptors: int = 0
    tasks: int = 0
    lines: int = 0
    motion: Motion = field(default_factory=Motion)
    skipped: str = ""
    """Why it was not possible."""
    broken: list[str] = field(default_factory=list)
    """One sentence for each bound that was broken."""

    def compare(self) -> None:
        """Add a sentence to `broken` for each bound that the measured values exceed."""
        bounds, name = self.attack.bounds, self.attack.name
        if self.lost > bounds.lost * self.asked:
            self.broken.append(
                f"{name}: {self.lost} of {self.asked} honest queries were lost, {bounds.lost:.0%} may be"
            )
        for what, found, bound, unit in (
            ("the operator heard nothing for", self.silence, bounds.silence, " s"),
            ("the victim's memory grew by", self.memory, bounds.memory, " MiB"),
            ("more descriptors are open, by", self.descriptors, bounds.descriptors, ""),
            ("more tasks run, by", self.tasks, bounds.tasks, ""),
            ("lines were logged:", self.lines, bounds.lines, ""),
            ("without a command of its operator the robot moved by", self.motion.moved, bounds.moved, " m"),
        ):
            if found > bound:
                self.broken.append(f"{name}: {what} {found:.4g}{unit}; the bound is {bound:g}{unit}")
        for what, kept, of, least in (
            ("drives of the operator were carried out", self.motion.driven, self.motion.legs, bounds.driven),
            ("times the operator was in control", self.motion.controlled, self.motion.samples, bounds.control),
        ):
            if kept < least * of:
                self.broken.append(f"{name}: {kept} of {of} {what}; the bound is {least:.0%}")
