"""Runs a profile against a target, step by step."""

from __future__ import annotations

import traceback
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Final

from jauspy.codec.registry import Registry
from jauspy.conformance.offers import Offers, discover
from jauspy.conformance.parting import part
from jauspy.conformance.profile import Profile, Step
from jauspy.conformance.pulse import Pulse, silent_since
from jauspy.conformance.results import Outcome, Report, Result, Verdict
from jauspy.conformance.tester import TIMEOUT, Tester
from jauspy.conformance.wire import Wire
from jauspy.errors import ConfigError, RequestError, TransportError
from jauspy.ids import JausID
from jauspy.messages import registry as known_messages

Watch = Callable[[Result], None]
"""Hears of each step as it ends."""

DEAF: Final = (
    "{target} answers nothing; check that it runs, that its id is right, that it takes messages for a wildcard id "
    "if that is one, and that both are on one network (`jauspy ls` shows who answers)"
)


class Interrupted(KeyboardInterrupt):
    """Ctrl-C in the midst of a run, after the target was left in order."""

    def __init__(self, report: Report) -> None:
        super().__init__(report.problem)
        self.report = report


@dataclass(frozen=True, slots=True)
class Settings:
    """How to run. `timeout` is in seconds; without `motion`, steps that make the robot drive are left out.

    `only` are beginnings of step ids; all steps when there is none. Later steps may need earlier ones.
    """

    timeout: float = TIMEOUT
    motion: bool = True
    only: tuple[str, ...] = ()


def run(
    profile: Profile,
    wire: Wire,
    target: JausID,
    *,
    began: float,
    settings: Settings | None = None,
    registry: Registry = known_messages,
    watch: Watch = lambda _: None,
) -> Report:
    """The report of a whole run. `began`: the wall clock, seconds since 1970. Never raises for what the target does.

    Ctrl-C raises `Interrupted`, which has the report of what was done so far.
    """
    settings = settings or Settings()
    tester = Tester(wire, target, registry=registry, timeout=settings.timeout)
    results: list[Result] = []
    problem, interrupted = "", False
    try:
        for result in _results(profile, tester, settings):
            results.append(result)
            watch(result)
        problem = "" if tester.answered or not tester.asked else DEAF.format(target=target)
    except (ConfigError, TransportError) as error:
        problem = str(error)
    except RequestError as error:
        problem = _unanswered(tester, error)
    except KeyboardInterrupt:
        problem, interrupted = f"interrupted after {len(results)} steps", True
    except BaseException:
        part(tester)
        raise
    problem = part(tester) or problem
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


def planned(
    profile: Profile, wire: Wire, target: JausID, *, timeout: float = TIMEOUT, registry: Registry = known_messages
) -> tuple[Step, ...]:
    """The steps that a run would have; raises `ConfigError` when there is nobody to ask, or nothing to test."""
    tester = Tester(wire, target, registry=registry, timeout=timeout)
    try:
        return profile.plan(_offers(profile, tester))
    except RequestError as error:
        raise ConfigError(_unanswered(tester, error)) from error


def _unanswered(tester: Tester, error: RequestError) -> str:
    return str(error) if tester.answered else DEAF.format(target=tester.target)


def _notes(tester: Tester) -> tuple[str, ...]:
    """What became of the target, and what came and cannot be found in the report."""
    left_out, unread = tester.record.left_out, tester.unread
    notes = (
        silent_since(tester.lost) if tester.lost else "",
        f"{left_out} datagrams were too many to keep for the report; no verdict depends on that" if left_out else "",
        f"{unread} messages were dropped before a step looked at them: more came than a client holds" if unread else "",
    )
    return tuple(filter(None, notes))


def _results(profile: Profile, tester: Tester, settings: Settings) -> Iterator[Result]:
    """Step by step; a target that has never answered is not tried any further."""
    for result in results(_chosen(profile.plan(_offers(profile, tester)), settings.only), tester, settings):
        yield result
        if result.verdict is Verdict.SILENT and tester.asked and not tester.answered:
            return


def results(steps: Iterable[Step], tester: Tester, settings: Settings) -> Iterator[Result]:
    """Each step as it is asked for; a target that has died is not tried any further."""
    pulse = Pulse(tester)
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


def _offers(profile: Profile, tester: Tester) -> Offers:
    return discover(tester) if profile.asks_for_services else Offers({})


def _chosen(steps: tuple[Step, ...], only: Iterable[str]) -> tuple[Step, ...]:
    chosen = tuple(step for step in steps if not only or any(step.id.startswith(each) for each in only))
    if not chosen:
        beginnings = list(dict.fromkeys(step.id.partition("/")[0] for step in steps))
        there_are = ", ".join([*beginnings[:12], *(["..."] if len(beginnings) > 12 else [])])
        raise ConfigError(f"no step begins with {' or '.join(only)}; they begin with {there_are}")
    return chosen


def run_step(step: Step, tester: Tester, settings: Settings) -> Result:
    """One step and how it ended."""
    tester.begin()
    began = tester.now
    verdict, reason = Verdict.PASS, _obstacle(step, tester, settings)
    if reason:
        verdict = Verdict.SKIPPED
    else:
        try:
            step.run(tester)
        except Outcome as outcome:
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
        why="; ".join(dict.fromkeys(each for each in (*tester.why, step.why) if each)),
        expected=tuple(dict.fromkeys(tester.expected)),
        looked=tuple(tester.looked),
        entries=tester.record.of_step,
        left_out=tester.record.left_out_of_step,
        began=began,
        ended=tester.now,
        points=step.points,
        transitions=step.transitions,
        taken=tuple(tester.taken),
    )


def _where(error: Exception) -> str:
    """The error, and the line that raised it."""
    *_, last = traceback.extract_tb(error.__traceback__)
    return f"{type(error).__name__}: {error} ({last.filename}:{last.lineno})"


def _obstacle(step: Step, tester: Tester, settings: Settings) -> str:
    """Why a step is not tried; empty when it is."""
    missing = step.wants.difference(tester.wire.features)
    if missing:
        return f"this way of connecting cannot do it ({', '.join(sorted(missing))}); use udp://HOST, or multicast"
    return "it moves the robot, and --no-motion was given" if step.moves and not settings.motion else ""
