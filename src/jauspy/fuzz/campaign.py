"""A campaign: many cases in one or several processes, with the same result whatever their number."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from multiprocessing import get_context
from typing import Final

from jauspy.codec.dynamic import load_schema
from jauspy.fuzz.cases import Fuzzer
from jauspy.fuzz.findings import Finding
from jauspy.messages import registry
from jauspy.schema import load_builtin
from jauspy.schema.own import load_own

CHUNK: Final = 500
"""Cases that a process does before it reports."""


@dataclass(frozen=True, slots=True)
class Plan:
    """What to do: `cases` from number 0, with `payloads` as further seeds; `only` these messages when given.

    `own` are JSIDL files, folders or patterns, whose messages are tested instead of those that are built in.
    """

    cases: int
    seed: int = 0
    payloads: Sequence[bytes] = ()
    only: Sequence[str] = ()
    jobs: int = 1
    own: Sequence[str] = ()


@dataclass(slots=True)
class Outcome:
    """What came of it so far: `findings` by cause, `accepted` cases were valid messages."""

    messages: int = 0
    seeds: int = 0
    cases: int = 0
    accepted: int = 0
    findings: dict[str, Finding] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class _Report:
    cases: int
    accepted: int
    findings: tuple[Finding, ...]


def fuzzer(plan: Plan) -> Fuzzer:
    """The fuzzer of a plan; raises `ConfigError` and `SchemaError` for what it names and is not there, or wrong."""
    schema = load_own(plan.own) if plan.own else load_builtin()
    known = load_schema(schema) if plan.own else registry
    return Fuzzer(known, schema, plan.payloads, seed=plan.seed, only=plan.only)


def run(plan: Plan, progress: Callable[[Outcome], None] = lambda _: None) -> Outcome:
    """Run all cases; `progress` is called now and then, and for every new cause."""
    first = fuzzer(plan)
    outcome = Outcome(messages=len(first.targets), seeds=len(first.seeds))
    progress(outcome)
    for report in _here(first, plan) if plan.jobs == 1 else _elsewhere(plan):
        outcome.cases += report.cases
        outcome.accepted += report.accepted
        for finding in report.findings:
            outcome.findings.setdefault(finding.cause, finding)
        progress(outcome)
    return outcome


def _chunks(cases: int) -> Iterator[range]:
    return (range(start, min(start + CHUNK, cases)) for start in range(0, cases, CHUNK))


def _report(fuzzer: Fuzzer, numbers: range) -> _Report:
    before = fuzzer.checks.accepted
    findings = tuple(fuzzer.run(numbers))
    return _Report(len(numbers), fuzzer.checks.accepted - before, findings)


def _here(fuzzer: Fuzzer, plan: Plan) -> Iterator[_Report]:
    return (_report(fuzzer, numbers) for numbers in _chunks(plan.cases))


def _elsewhere(plan: Plan) -> Iterator[_Report]:
    with ProcessPoolExecutor(plan.jobs, get_context("spawn"), _start, (plan,)) as pool:
        yield from pool.map(_work, _chunks(plan.cases))


_fuzzers: list[Fuzzer] = []


def _start(plan: Plan) -> None:
    """In a new process; the first one has said what there is to warn of."""
    logging.disable(logging.WARNING)
    _fuzzers.append(fuzzer(plan))


def _work(numbers: range) -> _Report:
    return _report(_fuzzers[0], numbers)
