"""Findings about a target: the datagrams that show a failure, minimised, as pcapng and JSON."""

from __future__ import annotations

import json
import re
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from jauspy.capture import writer
from jauspy.fuzz.target.address import Address
from jauspy.fuzz.target.session import Failure, Symptom, TargetSession
from jauspy.ids import message_id
from jauspy.messages import registry
from jauspy.protocol import header, judp

INTERVAL: Final = 10_000_000
"""Nanoseconds between the datagrams of a finding's capture."""
LEAK_SENDS: Final = 2000
"""Datagrams, at least, that are sent to see a leak: a candidate again and again, with new sequence numbers."""
LEAK_ROUNDS: Final = 3
"""Times, at least, that all datagrams of a candidate are sent to see a leak."""


@dataclass(frozen=True, slots=True)
class TargetFinding:
    """A failure of a target, and the datagrams that make it fail after it has started."""

    failure: Failure
    seen: str
    component: str
    datagrams: tuple[bytes, ...]
    is_minimised: bool
    """False if the target could not be started again, or if the failure did not appear again."""
    source: Address
    destination: Address
    seed: int
    case: int

    @property
    def cause(self) -> str:
        """The failure, and the last message before it if that is known."""
        last = message_of(self.datagrams[-1]) if self.is_minimised else "not minimised"
        return f"{self.failure} {last}"

    def to_dict(self) -> dict[str, Any]:
        """The finding for JSON."""
        return {
            "cause": self.cause,
            "failure": str(self.failure),
            "seen": self.seen,
            "component": self.component,
            "minimised": self.is_minimised,
            "seed": self.seed,
            "case": self.case,
            "datagrams": [datagram.hex() for datagram in self.datagrams],
        }

    def save(self, folder: Path) -> Path:
        """Write `<cause>.pcapng` and `<cause>.json` into a folder, which is created if necessary; the former's path."""
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / (re.sub(r"[^\w.]+", "-", self.cause).strip("-.") + ".pcapng")
        start = time.time_ns()
        blocks = [
            writer.packet(self.source, self.destination, datagram, start + number * INTERVAL)
            for number, datagram in enumerate(self.datagrams)
        ]
        path.write_bytes(writer.preamble() + b"".join(blocks))
        path.with_suffix(".json").write_text(json.dumps(self.to_dict(), indent=2) + "\n", encoding="utf-8")
        return path


def code_of(datagram: bytes) -> int | None:
    """The id of the message in a datagram; None for a damaged header, and for fragments after the first."""
    packets, errors = judp.unpack_all(datagram)
    if errors or len(packets) != 1 or len(packets[0].payload) < 2:
        return None
    flag = packets[0].data_flag
    return message_id(packets[0].payload) if flag in (header.DataFlag.SINGLE, header.DataFlag.FIRST) else None


def message_of(datagram: bytes) -> str:
    """The name of the message in a datagram, or what it is instead of one."""
    code = code_of(datagram)
    if code is None:
        return "fragment" if not judp.unpack_all(datagram)[1] else "damaged header"
    kinds = registry.by_code(code)
    return kinds[0].NAME if kinds else f"{code:04X}h"


def minimised(
    session: TargetSession, history: Sequence[bytes], symptom: Symptom, tries: int
) -> tuple[tuple[bytes, ...], Symptom] | None:
    """The fewest datagrams found, in `tries` starts of the target, that show the failure; None if it does not return.

    First the shortest end of the history is searched by doubling, then datagrams are left out by delta debugging.
    """
    attempts = _Attempts(session, symptom, tries)
    found = _shortest_end(history, attempts.shows)
    if found is None:
        return None
    return tuple(delta_debugged(found, attempts.shows)), attempts.last


class _Attempts:
    """Starts of the target; each plays some datagrams. After the last one nothing shows the failure any more."""

    def __init__(self, session: TargetSession, symptom: Symptom, tries: int) -> None:
        self._session = session
        self._wanted = symptom.failure
        self._left = tries
        self.last = symptom

    def shows(self, datagrams: Sequence[bytes]) -> bool:
        """True if these datagrams make a target that has just started fail in the same way."""
        if self._left <= 0 or not datagrams or not self._session.restart():
            return False
        self._left -= 1
        is_leak = self._wanted is Failure.LEAKS
        total = max(LEAK_SENDS, LEAK_ROUNDS * len(datagrams))
        found = self._session.play(repeated(datagrams, total) if is_leak else datagrams)
        if found is None or found.failure is not self._wanted:
            return False
        self.last = found
        return True


def _shortest_end(history: Sequence[bytes], shows: Callable[[Sequence[bytes]], bool]) -> Sequence[bytes] | None:
    size = 1
    while size < len(history):
        if shows(history[-size:]):
            return history[-size:]
        size *= 2
    return history if shows(history) else None


def delta_debugged(datagrams: Sequence[bytes], shows: Callable[[Sequence[bytes]], bool]) -> Sequence[bytes]:
    """A subsequence that still shows the failure, of which no part can be left out (ddmin: A. Zeller, 2002)."""
    parts = 2
    while len(datagrams) >= 2:
        size = -(-len(datagrams) // parts)
        rests = ([*datagrams[:start], *datagrams[start + size :]] for start in reversed(range(0, len(datagrams), size)))
        smaller = next((rest for rest in rests if shows(rest)), None)
        if smaller is not None:
            datagrams, parts = smaller, max(parts - 1, 2)
        elif size == 1:
            break
        else:
            parts = min(2 * parts, len(datagrams))
    return datagrams


def repeated(datagrams: Sequence[bytes], total: int) -> list[bytes]:
    """The datagrams again and again, up to a total, with new sequence numbers, since equal ones are duplicates."""
    return [renumbered(datagrams[number % len(datagrams)], number) for number in range(total)]


def renumbered(datagram: bytes, number: int) -> bytes:
    """A datagram with another sequence number; one with a damaged header as it is."""
    packets, errors = judp.unpack_all(datagram)
    if errors or len(packets) != 1:
        return datagram
    return datagram[:-2] + (number & 0xFFFF).to_bytes(2, "little")
