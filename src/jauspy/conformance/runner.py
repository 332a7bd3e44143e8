"""Runs the steps of a profile, checks that the target still answers, and leaves it in Standby without a controller."""

from __future__ import annotations

import traceback
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Final

from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.conformance.link import TesterLink
from jauspy.conformance.profile import DISCOVERY_CLIENT, Offers, Profile, Step, discover
from jauspy.conformance.results import Report, Result, StepOutcome, Verdict
from jauspy.conformance.tester import HARMLESS_QUERIES, TIMEOUT, Tester
from jauspy.errors import ConfigError, RequestError, TransportError
from jauspy.ids import JausID
from jauspy.messages import registry as known_messages
from jauspy.messages.core import (
    ClearEmergency,
    QueryIdentification,
    ReleaseControl,
    ReportIdentification,
    RequestControl,
    SetEmergency,
    Standby,
)

MAX_SILENT_STEPS: Final = 3
"""Steps in a row without an answer after which the others are skipped."""
COUNT_TIME: Final = 0.5
"""Timeouts in which all components of a wildcard answer."""
LATE_TIME: Final = 1.5
"""Timeouts for which a first answer is waited for after that."""
MAX_PROBE_CLIENTS: Final = 64
"""Clients that probe in turn, so that a late answer to an earlier probe does not count."""


class LivenessMonitor:
    """Detects during a run that the target does not answer any more."""

    def __init__(self, tester: Tester) -> None:
        self._tester = tester
        self._asked = 0
        self._silent = 0

    @property
    def stopped(self) -> bool:
        """True once the remaining steps are to be skipped."""
        return self._silent >= MAX_SILENT_STEPS

    @property
    def reason(self) -> str:
        """The reason for which the remaining steps are skipped."""
        return silent_since(self._tester.silent_since)

    def judged(self, result: Result) -> Result:
        """The result. A step that passed because nothing came is silent if the target does not answer at all."""
        if self._is_responsive(result):
            self._silent, self._tester.silent_since = 0, ""
            return result
        self._silent += 1
        self._tester.silent_since = self._tester.silent_since or result.id
        if result.verdict is Verdict.PASS or (self.stopped and result.verdict is Verdict.SKIPPED):
            return replace(result, verdict=Verdict.SILENT, reason=self.reason)
        return result

    def _is_responsive(self, result: Result) -> bool:
        """True if nothing was sent to the target, it sent something or had no reason to, or it answers now.

        Once the target was silent, only the answer to a new query counts, because other messages may be late answers.
        """
        content = result.verdict is Verdict.PASS or self._tester.received_in_step
        return not self._tester.sent_in_step or (content and not self._tester.silent_since) or self._answers()

    def _answers(self) -> bool:
        tester = self._tester
        self._asked = self._asked % MAX_PROBE_CLIENTS + 1
        asking = tester.client(f"42.9.{self._asked}")
        asking.pending.clear()
        for destination in {tester.target, tester.memory.get("component", tester.target)}:
            for ping in HARMLESS_QUERIES:
                asking.send(ping, to=destination)
        return tester.pump(
            tester.now + tester.timeout,
            lambda: any(tester.target.matches(heard.source) for heard in asking.pending),
        )


def silent_since(step: str) -> str:
    """The sentence for a target that stopped answering."""
    return f"the target is silent since step {step}"


STOP: Final = SetEmergency.EmergencyCode.STOP
UNDO: Final[tuple[tuple[type[Message], tuple[Message, ...]], ...]] = (
    (SetEmergency, (ClearEmergency(STOP),)),
    (RequestControl, (Standby(), ReleaseControl())),
)
"""Messages and the messages that undo them, in order: control cannot be released during an emergency."""
SETTLE_TIME: Final = 0.1
"""Timeouts to wait after that."""


def restore_target(tester: Tester) -> str:
    """Clear emergencies, return to Standby and release control. Returns what prevented it, or an empty string."""
    undone = [
        (client, message)
        for kind, undoing in UNDO
        for client in tester.clients
        if kind.CODE in client.sent
        for message in undoing
    ]
    try:
        for client, message in undone:
            client.send(message)
    except TransportError as error:
        return f"the target could not be left in order: {error}"
    with suppress(TransportError):  # messages that arrive now are ignored
        tester.wait(SETTLE_TIME * tester.timeout if undone else 0.0)
    return ""


OnResult = Callable[[Result], None]
"""Called with the result of each step as it ends."""

NO_ANSWER: Final = (
    "{target} answers nothing; check that it runs, that its id is right, that it takes messages for a wildcard id "
    "if that is one, and that both are on one network (`jauspy ls` shows who answers)"
)


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a run; raised after `restore_target`."""

    def __init__(self, report: Report) -> None:
        super().__init__(report.problem)
        self.report = report


@dataclass(frozen=True, slots=True)
class Settings:
    """Settings of a run. `timeout` is in seconds; without `motion`, steps that make the robot drive are left out.

    `only` are beginnings of step ids; by default all steps run. Later steps may need earlier ones.
    """

    timeout: float = TIMEOUT
    motion: bool = True
    only: tuple[str, ...] = ()


def run(
    profile: Profile,
    link: TesterLink,
    target: JausID,
    *,
    began: float,
    offers: Offers | None = None,
    settings: Settings | None = None,
    registry: Registry = known_messages,
    watch: OnResult = lambda _: None,
) -> Report:
    """Run a profile and return the report. `began`: wall clock, seconds since 1970. A missing answer never raises.

    `offers` are the services of a target without Discovery; by default the target is queried for them.
    Ctrl-C raises `Interrupted`, which has the report of what was done so far.
    """
    settings = settings or Settings()
    tester = Tester(link, target, registry=registry, timeout=settings.timeout)
    results: list[Result] = []
    problem, interrupted = "", False
    try:
        for result in _results(profile, tester, offers, settings):
            results.append(result)
            watch(result)
        problem = "" if tester.has_received or not tester.has_sent else NO_ANSWER.format(target=target)
    except (ConfigError, TransportError) as error:
        problem = str(error)
    except RequestError as error:
        problem = _unanswered(tester, error)
    except KeyboardInterrupt:
        problem, interrupted = f"interrupted after {len(results)} steps", True
    except BaseException:
        restore_target(tester)
        raise
    problem = restore_target(tester) or problem
    report = Report(
        profile=profile.name,
        title=profile.title,
        target=str(target),
        began=began,
        seconds=tester.now,
        results=tuple(results),
        entries=tuple(tester.record.entries),
        problem=problem,
        notes=(*profile.notes, *_notes(tester)),
    )
    if interrupted:
        raise Interrupted(report)
    return report


def planned_steps(
    profile: Profile,
    link: TesterLink,
    target: JausID,
    *,
    offers: Offers | None = None,
    timeout: float = TIMEOUT,
    registry: Registry = known_messages,
) -> tuple[Step, ...]:
    """The steps that a run would have. Raises `ConfigError` if the target does not answer or offers nothing to test."""
    tester = Tester(link, target, registry=registry, timeout=timeout)
    try:
        return profile.plan(_offers(profile, tester, offers))
    except RequestError as error:
        raise ConfigError(_unanswered(tester, error)) from error


def _unanswered(tester: Tester, error: RequestError) -> str:
    return str(error) if tester.has_received else NO_ANSWER.format(target=tester.target)


def _notes(tester: Tester) -> tuple[str, ...]:
    """Notes for the report: that the target stopped answering, and what the report omits."""
    omitted, dropped = tester.record.omitted, tester.dropped
    notes = (
        silent_since(tester.silent_since) if tester.silent_since else "",
        f"{omitted} datagrams were too many to keep for the report; no verdict depends on that" if omitted else "",
        f"{dropped} messages were dropped before a step read them: more arrived than a client holds" if dropped else "",
    )
    return (*tester.notes, *filter(None, notes))


def _results(profile: Profile, tester: Tester, offers: Offers | None, settings: Settings) -> Iterator[Result]:
    """Run step by step, and stop if the target has never answered."""
    if profile.one_component and tester.target.is_wildcard:
        _check_one_component(tester)
    offered = _offers(profile, tester, offers)
    steps = _chosen(profile.plan(offered), settings.only)
    if profile.check is not None:
        profile.check(tester, offered)
    for result in results(steps, tester, settings):
        yield result
        if result.verdict is Verdict.SILENT and tester.has_sent and not tester.has_received:
            return


def _check_one_component(tester: Tester) -> None:
    """Raise `ConfigError` if several components answer, each of which would get a part of the steps."""
    client = tester.client(DISCOVERY_CLIENT)
    query = QueryIdentification(QueryIdentification.QueryType.COMPONENT)
    found = {source for source, _ in client.answers(query, ReportIdentification, COUNT_TIME * tester.timeout)}
    if not found:  # a late answer must not pass for one to the first step
        deadline = tester.now + LATE_TIME * tester.timeout
        tester.pump(deadline, lambda: any(packet.code == ReportIdentification.CODE for packet in client.pending))
    if len(found) > 1:
        ids = ", ".join(map(str, sorted(found)))
        raise ConfigError(
            f"{len(found)} components answer; name one: {ids} (as in --target {min(found)}), since this test needs one "
            "component with all services"
        )


def results(steps: Iterable[Step], tester: Tester, settings: Settings) -> Iterator[Result]:
    """Run each step when it is requested; skip the others once the target stopped answering."""
    pulse = LivenessMonitor(tester)
    for step in steps:
        if pulse.stopped:
            now = tester.now
            yield Result(
                id=step.id,
                title=step.title,
                verdict=Verdict.SKIPPED,
                reason=pulse.reason,
                began=now,
                ended=now,
                points=step.points,
                transitions=step.transitions,
            )
        else:
            yield pulse.judged(run_step(step, tester, settings))


def _offers(profile: Profile, tester: Tester, named: Offers | None) -> Offers:
    if not profile.asks_for_services:
        return Offers({})
    return discover(tester) if named is None else named


def _chosen(steps: tuple[Step, ...], only: Iterable[str]) -> tuple[Step, ...]:
    chosen = tuple(step for step in steps if not only or any(step.id.startswith(prefix) for prefix in only))
    if not chosen:
        beginnings = list(dict.fromkeys(step.id.partition("/")[0] for step in steps))
        there_are = ", ".join([*beginnings[:12], *(["..."] if len(beginnings) > 12 else [])])
        raise ConfigError(f"no step begins with {' or '.join(only)}; they begin with {there_are}")
    return chosen


def run_step(step: Step, tester: Tester, settings: Settings) -> Result:
    """Run one step."""
    tester.begin()
    began = tester.now
    verdict, reason = Verdict.PASS, _obstacle(step, tester, settings)
    if reason:
        verdict = Verdict.SKIPPED
    else:
        try:
            step.run(tester)
        except StepOutcome as outcome:
            verdict, reason = outcome.verdict, str(outcome)
        except (ConfigError, TransportError):
            raise
        except Exception as error:  # noqa: BLE001 - somebody's profile has a bug; the other steps are worth reporting
            verdict, reason = Verdict.FAIL, f"the step itself has a bug: {_where(error)}"
    return Result(
        id=step.id,
        title=step.title,
        verdict=verdict,
        reason=reason,
        why="; ".join(dict.fromkeys(reason for reason in (*tester.why, step.why) if reason)),
        expected=tuple(dict.fromkeys(tester.expected)),
        checks=tuple(tester.checks),
        entries=tester.record.of_step,
        omitted=tester.record.omitted_in_step,
        began=began,
        ended=tester.now,
        points=step.points,
        transitions=step.transitions,
        taken=tuple(tester.taken),
    )


def _where(error: Exception) -> str:
    """The text of the error and the line that raised it."""
    *_, last = traceback.extract_tb(error.__traceback__)
    return f"{type(error).__name__}: {error} ({last.filename}:{last.lineno})"


def _obstacle(step: Step, tester: Tester, settings: Settings) -> str:
    """The reason for which a step is skipped; empty if it is run."""
    missing = step.wants.difference(tester.link.features)
    if missing:
        return f"this way of connecting cannot do it ({', '.join(sorted(missing))}); use udp://HOST, or multicast"
    return "it moves the robot, and --no-motion was given" if step.moves and not settings.motion else ""
