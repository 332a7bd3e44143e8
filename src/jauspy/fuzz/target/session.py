"""A session with one target: finds its component and services, walks its states, and watches whether it lives."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise
from typing import Final

from jauspy.codec.message import Message
from jauspy.conformance.profile import ServiceKey, discover
from jauspy.conformance.results import StepOutcome
from jauspy.conformance.state_tests.explorer import Explorer
from jauspy.conformance.tester import CLIENTS, HARMLESS_QUERIES, OBSERVER, Client, Tester
from jauspy.errors import ConfigError, RequestError
from jauspy.fuzz.target.address import Address
from jauspy.fuzz.target.cases import Cases, Stop
from jauspy.fuzz.target.link import RecordingLink
from jauspy.fuzz.target.process import TargetProcess
from jauspy.ids import EVERYONE, JausID
from jauspy.messages import registry

START_TIME: Final = 20.0
"""Seconds until a target that was started has to answer."""
QUERIES: Final = 3
"""Queries without an answer after which a target counts as dead, or as hanging while its process runs."""
PATIENCE: Final = 3.0
"""Limits of an answer that the last of these queries is waited for."""
CHECK_EVERY: Final = 20
"""Datagrams between two queries of liveness, so that none is lost in a full receive buffer."""
MAX_UNCHECKED: Final = 60_000
"""Bytes between two queries of liveness, for the same reason."""
WALK_TIMEOUT: Final = 0.5
"""Seconds to wait for an answer, and for a state, on the way to that state."""
PROCESS_CHECK: Final = 0.05
"""Seconds between two looks at the process while an answer is waited for."""
SAMPLES: Final = 12
"""Samples of memory that a leak must have grown over."""
MAX_SAMPLES: Final = 256
"""Samples that are kept; then every second one is."""
FLAT: Final = 0.1
"""Part of the growth that the last quarter of the samples must have; a cache that is full has less."""
MEBIBYTE: Final = 1 << 20


class Failure(StrEnum):
    """What happened to a target."""

    DIED = "died"
    HANGS = "hangs"
    LEAKS = "leaks"


@dataclass(frozen=True, slots=True)
class Symptom:
    """A failure as it was observed."""

    failure: Failure
    seen: str


@dataclass(frozen=True, slots=True)
class Limits:
    """What a correct target keeps: seconds to answer a query, and bytes that its memory may grow by."""

    answer: float = 2.0
    memory: int = 64 * MEBIBYTE


class TargetSession:
    """A target that answers, until `symptom` returns what is wrong with it.

    `wanted` is the component to test; by default it is the one with the most services.
    """

    def __init__(
        self, address: Address, process: TargetProcess, limits: Limits, seed: int = 0, wanted: JausID | None = None
    ) -> None:
        self.address = address
        self.process = process
        self.limits = limits
        self.component = wanted or EVERYONE
        self._wanted = wanted
        self._seed = seed
        self._query: Message = HARMLESS_QUERIES[0]
        self._explorer: Explorer | None = None
        self._connect()

    def open(self) -> frozenset[ServiceKey]:
        """Start the target if there is a command, and return the services of its component.

        Raises `ConfigError` if nothing answers.
        """
        if self.process.can_restart:
            self.process.restart()
        self._await_answer(START_TIME if self.process.can_restart else PATIENCE * self.limits.answer)
        services = self._discover()
        self._reconnect()
        self._await_answer(PATIENCE * self.limits.answer)
        return services

    def restart(self) -> bool:
        """Start the target again, with an empty history; false if it does not answer then."""
        self.process.restart()
        self._reconnect()
        try:
            self._await_answer(START_TIME)
        except ConfigError:
            return False
        return True

    def close(self) -> None:
        """Close the socket, and end the process that was started."""
        self.link.close()
        self.process.close()

    def walk(self, stop: Stop, cases: Cases) -> bool:
        """Bring the target to a state; false if it cannot be brought there."""
        if stop.situation is None:
            return True
        if self._explorer is None:
            self._explorer = Explorer(self._client.tester, cases.subject)
        try:
            self._explorer.where = None
            self._explorer.reach(stop.situation, stop.path)
        except StepOutcome:
            return False
        return True

    def send(self, datagram: bytes) -> None:
        """Send one datagram of a case."""
        self.link.send(datagram, self._client.id)

    def play(self, datagrams: Sequence[bytes]) -> Symptom | None:
        """Send datagrams with queries of liveness between them; returns what goes wrong."""
        unchecked = 0
        for number, datagram in enumerate(datagrams, 1):
            self.send(datagram)
            unchecked += len(datagram)
            if number % CHECK_EVERY == 0 or unchecked > MAX_UNCHECKED:
                unchecked = 0
                if (found := self.symptom()) is not None:
                    return found
        return self.symptom()

    def symptom(self) -> Symptom | None:
        """Query the target, and return what is wrong with it, if anything."""
        tester, start = self._client.tester, self._client.tester.now
        self._client.tester.begin()
        for number in range(QUERIES):
            if self.process.is_known and not self.process.is_running:
                return Symptom(Failure.DIED, self.process.ending)
            wait = self.limits.answer * (PATIENCE if number == QUERIES - 1 else 1.0)
            if self._is_answered(wait):
                taken = tester.now - start
                if taken > self.limits.answer:
                    return Symptom(
                        Failure.HANGS, f"it answered after {taken:.1f} s; the limit is {self.limits.answer:g} s"
                    )
                return self._leak()
        silence = f"no answer to {QUERIES} queries in {tester.now - start:.1f} s"
        if self.process.is_known and self.process.is_running:
            return Symptom(Failure.HANGS, f"{silence}, though its process runs")
        if self.process.is_known:
            return Symptom(Failure.DIED, self.process.ending)
        return Symptom(Failure.DIED, silence + (", and its port is closed" if self.link.is_refused else ""))

    def _leak(self) -> Symptom | None:
        memory = self.process.memory
        if memory is None:
            return None
        self._memory.append(memory)
        if len(self._memory) > MAX_SAMPLES:
            del self._memory[1::2]
        growth = steady_growth(self._memory)
        if growth <= self.limits.memory:
            return None
        limit = self.limits.memory // MEBIBYTE
        return Symptom(
            Failure.LEAKS, f"its memory grew steadily by {growth / MEBIBYTE:.0f} MiB; the limit is {limit} MiB"
        )

    def _reconnect(self) -> None:
        """Begin with a new socket, so that nothing of an earlier target arrives."""
        self.link.close()
        self._connect()

    def _connect(self) -> None:
        self.link = RecordingLink(self.address, self._seed)
        tester = Tester(self.link, self.component, registry=registry, timeout=min(WALK_TIMEOUT, self.limits.answer))
        self._client: Client = tester.client(CLIENTS[OBSERVER])
        self._explorer = None
        self._memory: list[int] = []

    def _await_answer(self, seconds: float) -> None:
        """Wait until the target answers one of the usual queries, which is the one of liveness from then on."""
        tester = self._client.tester
        end = tester.now + seconds
        while tester.now < end:
            for query in HARMLESS_QUERIES:
                self._query = query
                if self._is_answered(0.05):
                    self.link.history.clear()
                    return
            if self.process.is_known and not self.process.is_running:
                raise ConfigError(f"the target does not start: {self.process.ending}")
        host, port = self.address
        raise ConfigError(
            f"nothing at UDP {host}:{port} answers JAUS queries within {seconds:g} s; does the target run?"
        )

    def _is_answered(self, seconds: float) -> bool:
        """Send the query of liveness without a trace in the history; true if the target answers in time."""
        client, tester = self._client, self._client.tester
        client.pending.clear()
        self.link.is_recording = False
        client.send(self._query)
        self.link.is_recording = True
        code = self._query.CODE + 0x2000  # AS5710: the report of a query
        end = tester.now + seconds
        while not tester.pump(
            min(end, tester.now + PROCESS_CHECK), lambda: any(each.code == code for each in client.pending)
        ):
            if tester.now >= end or (self.process.is_known and not self.process.is_running):
                return False
        return True

    def _discover(self) -> frozenset[ServiceKey]:
        """The services of the wanted component, or of the one that has the most."""
        try:
            components = discover(self._client.tester).components
        except RequestError as error:
            raise ConfigError(
                f"the target does not report its services, so its messages are not known: {error}"
            ) from error
        if self._wanted is not None and self._wanted in components:
            self.component = self._wanted
        else:
            self.component = max(sorted(components), key=lambda each: len(components[each]))
        return components[self.component]


def steady_growth(samples: Sequence[int]) -> int:
    """Bytes by which memory grew in every quarter of the samples; 0 if it did not, or if there are too few."""
    if len(samples) < SAMPLES:
        return 0
    size = len(samples) // 4
    quarters = [min(samples[at * size : (at + 1) * size]) for at in range(4)]
    growth = quarters[-1] - quarters[0]
    steps = [after - before for before, after in pairwise(quarters)]
    return growth if all(step > FLAT * growth for step in steps) and growth > 0 else 0
