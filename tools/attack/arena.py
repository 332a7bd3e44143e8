"""What an attack works with: the machines, the victims, time, chance, and counters."""

from __future__ import annotations

import contextlib
import random
import socket
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

from jauspy.ids import JausID

from .attack import Attack, BoundBroken, Victims
from .commander import INTERVAL, Commander
from .hosts import Host
from .processes import Outcome, Usage, run_command
from .stage import OPERATOR_ID, PILOT_ID, PORT, ROBOT_ID, Stage
from .truth import Motion

ROBOT, OPERATOR, PILOT, STRANGER = (JausID.parse(text) for text in (ROBOT_ID, OPERATOR_ID, PILOT_ID, "43.1.1"))
SIBLING = JausID.parse("101.1.103")
"""Another component of the robot."""
_SETTLE_TIME: Final = 6.0
"""Seconds after an attack in which victims close what it has opened."""
_OVERTAKEN: Final = 0.5
"""Seconds by which a slow attacker may be behind its rate before it gives up to catch up."""


class Arena:
    """Used by one attack: made, then `attack.run(arena)`, then `measure`; `close` may be called at any time."""

    def __init__(self, attack: Attack, stage: Stage, seconds: float, seed: int) -> None:
        self.attack = attack
        self.stage = stage
        self.chance = random.Random(f"{seed} {attack.name}")  # noqa: S311 - the same attack for the same seed
        self.hosts = stage.lan.hosts
        self.folder = stage.folder
        self.sent = 0
        self.memory = 0.0
        """MiB at the peak of a command that the attack has run."""
        self.asked = self.lost = 0
        """Of an honest party other than the operator."""
        self._counters = stage.counters()
        self._opened = contextlib.ExitStack()
        self._before = [victim.usage() for victim in stage.victims]
        self._seconds = seconds
        self._end: float | None = None
        self.motion = Motion()
        """What the robot did meanwhile; known after `measure`."""
        self._commander: Commander | None = None
        if attack.layout.victims is Victims.ROBOT:
            self._commander = Commander(self.chance, (STRANGER, OPERATOR, PILOT, SIBLING))
            self._commanding = self.open(self.attacker.udp())
        stage.begin()

    @property
    def has_namespaces(self) -> bool:
        """True when each machine has a network of its own."""
        return not self.stage.lan.why_loopback

    @property
    def attacker(self) -> Host:
        """The attacker's machine."""
        return self.hosts["attacker"]

    @property
    def where(self) -> tuple[str, int]:
        """The address of the victim's node manager."""
        return self.hosts["robot"].address, PORT

    @property
    def root(self) -> Path:
        """The directory of the local sockets of the victim."""
        return self.stage.root("robot")

    @property
    def left(self) -> float:
        """Seconds of the attack that are left; its time begins with the first use of this, or of `paced`."""
        if self._end is None:
            self._end = time.monotonic() + self._seconds
        return max(0.0, self._end - time.monotonic())

    def paced(self, rate: float) -> Iterator[int]:
        """Numbers from 0 until the time is over, at most `rate` a second; meanwhile commands are sent, too."""
        begin, number = time.monotonic(), 0
        due = begin
        while self.left:
            yield number
            if time.monotonic() >= due:
                due = time.monotonic() + INTERVAL
                self.command_robot()
            number += 1
            ahead = begin + number / rate - time.monotonic()
            if ahead > 0.002:
                time.sleep(ahead)
            elif ahead < -_OVERTAKEN:
                begin -= ahead

    def command_robot(self) -> None:
        """Send one of the commands that nobody but the operator is entitled to."""
        if self._commander is not None:
            with contextlib.suppress(OSError):
                self._commanding.sendto(self._commander.next(), self.where)

    def send(self, sock: socket.socket, data: bytes, where: tuple[Any, ...] | str | None = None) -> None:
        """Send a datagram to the victim's node manager, or elsewhere; what has no room is lost."""
        self.sent += 1
        with contextlib.suppress(OSError):
            sock.sendto(data, self.where if where is None else where)

    def open(self, sock: Any) -> Any:
        """Close something when the time of the attack is over."""
        return self._opened.enter_context(contextlib.closing(sock))

    def command(self, *arguments: str, timeout: float = 30.0) -> Outcome:
        """Run `python ARGUMENTS` to its end."""
        return run_command(arguments, self.folder, timeout=timeout)

    def require(self, condition: bool, sentence: str) -> None:
        """Raise `BoundBroken` unless the condition holds."""
        if not condition:
            raise BoundBroken(f"{self.attack.name}: {sentence}")

    def drops(self) -> str:
        """What the robot's node manager has dropped since the start of the attack, by reason."""
        found = self.stage.counters() - self._counters
        drops = ((name.removeprefix("dropped."), n) for name, n in found.most_common() if name.startswith("dropped."))
        return ", ".join(f"{count} {name}" for name, count in drops)

    def close(self) -> None:
        """Close what the attacker has opened."""
        self._opened.close()

    def measure(self) -> tuple[int, int, float, list[Usage]]:
        """Honest queries, those lost, the longest silence, and what each victim uses more than before."""
        self.close()
        time.sleep(0.3)
        asked, lost, silence, self.motion = self.stage.end(may_be_taken=self.attack.bounds.may_be_taken)
        return asked + self.asked, lost + self.lost, silence, self._growth()

    def _growth(self) -> list[Usage]:
        """The peak of the memory, and what is still open when nothing more of it closes."""
        deadline, bounds = time.monotonic() + _SETTLE_TIME, self.attack.bounds
        peaks = [0.0] * len(self.stage.victims)
        while True:
            after = [victim.usage() for victim in self.stage.victims]
            peaks = [max(peak, each.memory) for peak, each in zip(peaks, after, strict=True)]
            grown = [
                Usage(
                    peak - old.memory, new.descriptors - old.descriptors, new.tasks - old.tasks, new.lines - old.lines
                )
                for peak, old, new in zip(peaks, self._before, after, strict=True)
            ]
            settled = all(each.descriptors <= bounds.descriptors and each.tasks <= bounds.tasks for each in grown)
            if settled or time.monotonic() > deadline:
                return grown
            time.sleep(0.25)
