"""A campaign: many cases in one or several processes. The result does not depend on the number of processes."""

from __future__ import annotations

import logging
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import lru_cache, partial
from hashlib import sha256
from importlib import import_module
from multiprocessing import get_context
from pathlib import Path
from random import Random
from typing import Final

from jauspy import __version__
from jauspy.cluster import spread
from jauspy.codec.build import load_schema
from jauspy.codec.registry import MessageEntry, Registry
from jauspy.errors import ConfigError
from jauspy.fuzz.checks import MEMORY_INTERVAL, Checks, CostLimit
from jauspy.fuzz.findings import MAX_TRIES, FuzzFinding, Problem, minimise
from jauspy.fuzz.messages import FuzzTarget, MessageMaker, Style, targets
from jauspy.fuzz.mutation import Seed, from_payloads, from_schemas, mutate, offsets_of
from jauspy.fuzz.progress_file import ProgressFile, SavedProgress
from jauspy.messages import registry
from jauspy.schema import load_builtin
from jauspy.schema.loader import load_own
from jauspy.schema.model import Schema

MAX_SLOW_TRIES: Final = 60
"""Attempts to minimise a finding about time or memory, each of which is slow."""


@dataclass(frozen=True, slots=True)
class Case:
    """Bytes to test; `valid` when they are a message by construction."""

    number: int
    target: FuzzTarget
    data: bytes
    valid: bool


class Fuzzer:
    """The state of a campaign in one process. A case depends on the seeds, `seed` and its number only."""

    def __init__(
        self,
        registry: Registry,
        schema: Schema,
        payloads: Iterable[bytes] = (),
        *,
        seed: int = 0,
        only: Iterable[str] = (),
    ) -> None:
        self.targets = targets(registry, schema, only)
        self.identity: tuple[FuzzFinding, ...] = ()
        """Differences between a generated package and its definitions."""
        made = list(from_schemas(self.targets))
        self._seeds = [*from_payloads(self.targets, payloads), *made]
        self._seed = seed
        self.checks = Checks(CostLimit((self.targets[one.target], one) for one in made))
        self._known: set[str] = set()

    @property
    def seeds(self) -> Sequence[Seed]:
        """All messages to start from."""
        return self._seeds

    def case(self, number: int) -> Case:
        """Return a case: even numbers are valid random messages of all kinds in turn, odd ones are mutated."""
        rng = Random(self._seed << 40 | number)  # noqa: S311 - chance, not secrets
        if number % 2 == 0:
            target = self.targets[number // 2 % len(self.targets)]
            return Case(number, target, MessageMaker(rng, Style.ANY, self.targets).message(target), valid=True)
        seed = self._seed_for(rng, number)
        target, data = self.targets[seed.target], mutate(rng, seed, self._seeds)
        if rng.random() < 0.02:  # the body of another message
            target = rng.choice(self.targets)
            data = target.id + data[2:]
        return Case(number, target, data, valid=False)

    def _seed_for(self, rng: Random, number: int) -> Seed:
        """A seed, or in 30 % of cases a new random message."""
        if rng.random() < 0.7:
            return rng.choice(self._seeds)
        place = number // 2 % len(self.targets)
        data = MessageMaker(rng, Style.ANY, self.targets).message(self.targets[place])
        return Seed(place, data, offsets_of(self.targets[place].layout, data))

    def run(self, numbers: range) -> Iterator[FuzzFinding]:
        """Check these cases; yields the first finding of every cause, minimised."""
        for number in numbers:
            case = self.case(number)
            memory = number % MEMORY_INTERVAL == 0
            problem = self.checks.problem(case.target, case.data, valid=case.valid, memory=memory)
            if problem is None:
                continue
            finding = self._finding(case, problem)
            if finding.cause not in self._known:
                self._known.add(finding.cause)
                yield self._smallest(case.target, finding)

    def replay(self, finding: FuzzFinding) -> FuzzFinding | None:
        """Check the bytes of a finding again; None if there is no problem any more."""
        if finding.check == CHECK:
            return next((case for case in self.identity if case.cause == finding.cause), None)
        wanted = (finding.message, finding.service, finding.version)
        for target in self.targets:
            if wanted == (target.cls.NAME, target.cls.SERVICE, target.cls.VERSION):
                case = Case(finding.case, target, finding.data, valid=finding.check == "valid")
                problem = self.checks.problem(target, case.data, valid=case.valid)
                return self._finding(case, problem) if problem else None
        raise ConfigError(f"there is no {finding.message} of {finding.service} {finding.version}")

    def _finding(self, case: Case, problem: Problem) -> FuzzFinding:
        cls = case.target.cls
        return FuzzFinding(
            problem.check,
            cls.NAME,
            cls.SERVICE,
            cls.VERSION,
            problem.what,
            seen=problem.seen,
            hex=case.data.hex(),
            seed=self._seed,
            case=case.number,
        )

    def _smallest(self, target: FuzzTarget, finding: FuzzFinding) -> FuzzFinding:
        if finding.check == "valid":
            return finding  # a shorter message is no longer valid by construction
        slow = finding.check in ("time", "memory")
        found, accepted = finding, self.checks.accepted

        def shows(data: bytes) -> bool:
            nonlocal found
            problem = self.checks.problem(target, data, memory=slow)
            same = problem is not None and (problem.check, problem.what) == (finding.check, finding.what)
            if same and problem is not None:
                found = finding.smaller(data, problem.seen)
            return same

        minimise(finding.data, shows, target.layout, MAX_SLOW_TRIES if slow else MAX_TRIES)
        self.checks.accepted = accepted
        return found


CASES_PER_CHUNK: Final = 500
"""Cases that a process runs before it reports."""


@dataclass(frozen=True, slots=True)
class CampaignPlan:
    """The settings of a campaign: `cases` from number 0, `payloads` as further seeds, `only` these messages if given.

    `own` are JSIDL files, folders or patterns, whose messages are tested instead of those that are built in; `package`
    is a package that was generated from them, whose classes are tested.
    """

    cases: int
    seed: int = 0
    payloads: Sequence[bytes] = ()
    only: Sequence[str] = ()
    jobs: int = 1
    own: Sequence[str] = ()
    package: str = ""

    @property
    def fingerprint(self) -> str:
        """Equal for plans whose cases are the same, whatever their number, processes and machines."""
        what = (__version__, self.seed, tuple(self.payloads), tuple(self.only), tuple(self.own), self.package)
        return sha256(repr(what).encode()).hexdigest()


@dataclass(slots=True)
class CampaignResult:
    """The result so far: `findings` by cause; `accepted` cases were valid messages."""

    messages: int = 0
    seeds: int = 0
    cases: int = 0
    accepted: int = 0
    findings: dict[str, FuzzFinding] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class _Report:
    cases: int
    accepted: int
    findings: tuple[FuzzFinding, ...]


def fuzzer(plan: CampaignPlan) -> Fuzzer:
    """The fuzzer of a plan. Raises `ConfigError` for an unknown message, `SchemaError` for an invalid definition."""
    if plan.package and not plan.own:
        raise ConfigError(f"name the definitions that {plan.package} was generated from, with --schemas")
    schema = load_own(plan.own) if plan.own else load_builtin()
    known = load_schema(schema) if plan.own else registry
    if not plan.package:
        return Fuzzer(known, schema, plan.payloads, seed=plan.seed, only=plan.only)
    package = load_package(plan.package)
    identity = tuple(identity_findings(package, known))
    try:
        made = Fuzzer(package, schema, plan.payloads, seed=plan.seed, only=plan.only)
    except ConfigError as error:
        if not identity:
            raise
        raise ConfigError(
            f"{plan.package} has none of these messages: {identity[0].cause}: {identity[0].seen}"
        ) from error
    made.identity = identity
    return made


def run(
    plan: CampaignPlan,
    progress: Callable[[CampaignResult], None] = lambda _: None,
    *,
    resume: Path | None = None,
    cluster: str | None = None,
) -> CampaignResult:
    """Run all cases. `progress` is called after each chunk of cases.

    `resume` is a file with the progress, from which a campaign continues. `cluster` is the address of a Dask scheduler,
    or `local`; a chunk whose worker is lost is run by another one.
    """
    file = ProgressFile(resume, plan.fingerprint) if resume else None
    saved = file.load() if file else SavedProgress()
    first = fuzzer(plan)
    outcome = CampaignResult(len(first.targets), len(first.seeds), saved.cases, saved.accepted)
    outcome.findings.update((case.cause, case) for case in (*first.identity, *saved.findings))
    progress(outcome)
    chunks = _chunks(saved.cases, plan.cases)
    if cluster is not None:
        reports = spread(cluster, partial(_work_on_cluster, plan), chunks)
    else:
        reports = _in_this_process(first, chunks) if plan.jobs == 1 else _in_processes(plan, chunks)
    for report in reports:
        outcome.cases += report.cases
        outcome.accepted += report.accepted
        for finding in report.findings:
            outcome.findings.setdefault(finding.cause, finding)
        if file:
            file.save(SavedProgress(outcome.cases, outcome.accepted, tuple(outcome.findings.values())))
        progress(outcome)
    return outcome


def _chunks(first: int, cases: int) -> Iterator[range]:
    return (range(start, min(start + CASES_PER_CHUNK, cases)) for start in range(first, cases, CASES_PER_CHUNK))


def _report(fuzzer: Fuzzer, numbers: range) -> _Report:
    before = fuzzer.checks.accepted
    findings = tuple(fuzzer.run(numbers))
    return _Report(len(numbers), fuzzer.checks.accepted - before, findings)


def _in_this_process(fuzzer: Fuzzer, chunks: Iterable[range]) -> Iterator[_Report]:
    return (_report(fuzzer, numbers) for numbers in chunks)


def _in_processes(plan: CampaignPlan, chunks: Iterable[range]) -> Iterator[_Report]:
    with ProcessPoolExecutor(plan.jobs, get_context("spawn"), _start, (plan,)) as pool:
        yield from pool.map(_work, chunks)


_fuzzers: list[Fuzzer] = []


def _start(plan: CampaignPlan) -> None:
    """Initialise a new process without logging, since the first process has logged all warnings."""
    logging.disable(logging.WARNING)
    _fuzzers.append(fuzzer(plan))


def _work(numbers: range) -> _Report:
    return _report(_fuzzers[0], numbers)


def _work_on_cluster(plan: CampaignPlan, numbers: range) -> _Report:
    return _report(_fuzzer_of_worker(plan), numbers)


@lru_cache(maxsize=1)
def _fuzzer_of_worker(plan: CampaignPlan) -> Fuzzer:
    """The fuzzer of a process of a cluster, which runs many chunks of one plan."""
    logging.disable(logging.WARNING)
    return fuzzer(plan)


CHECK: Final = "identity"
"""The check of findings about ids, names and versions."""


def load_package(name: str) -> Registry:
    """The registry of a package of `jauspy schema generate`, also in this folder; raises `ConfigError`."""
    folder = str(Path.cwd())
    if folder not in sys.path:
        sys.path.insert(0, folder)
    try:
        found = getattr(import_module(name), "registry", None)
    except ImportError as error:
        raise ConfigError(f"the package {name} cannot be imported from here: {error}") from None
    except Exception as error:  # the code is not ours
        raise ConfigError(f"the package {name} cannot be imported: {type(error).__name__}: {error}") from error
    if not isinstance(found, Registry):
        raise ConfigError(
            f"{name} has no `registry` of messages; `jauspy schema generate` writes packages that have one"
        )
    return found


def identity_findings(package: Registry, defined: Registry) -> Iterator[FuzzFinding]:
    """Differences between a package and the definitions: missing or additional messages, ids, versions."""
    right = {_key(entry): entry for entry in defined.own}
    made = {_key(entry): entry for entry in package.own}
    for key, entry in right.items():
        if key not in made:
            yield _finding(entry, "missing", "the package does not have it: generate it again")
    for key, entry in made.items():
        if key not in right:
            yield _finding(
                entry, "undefined", f"the package has it, and the definitions do not{_versions_text(entry, defined)}"
            )
        elif entry.code != right[key].code:
            yield _finding(
                entry, "id", f"the package has the id {entry.code:04X}h, the definition {right[key].code:04X}h"
            )
        elif entry.digest != right[key].digest:
            yield _finding(entry, "fields", "the package was generated from other fields: generate it again")
        yield from _class_findings(entry)


def _key(entry: MessageEntry) -> tuple[str, str, str]:
    return entry.service, entry.version, entry.name


def _versions_text(entry: MessageEntry, defined: Registry) -> str:
    versions = [known.version for known in defined.own if (known.service, known.name) == (entry.service, entry.name)]
    return f", but in version {' and '.join(versions)}" if versions else ""


def _class_findings(entry: MessageEntry) -> Iterator[FuzzFinding]:
    """Differences between the class of an entry and the table of the package."""
    try:
        cls = entry.load()
    except (ImportError, AttributeError, AssertionError) as error:
        yield _finding(entry, "class", f"{entry.module} has no such class: {error}")
        return
    for what, has, should in (
        ("id", f"{cls.CODE:04X}h", f"{entry.code:04X}h"),
        ("name", cls.NAME, entry.name),
        ("service", cls.SERVICE, entry.service),
        ("version", cls.VERSION, entry.version),
    ):
        if has != should:
            yield _finding(entry, f"class {what}", f"its class has the {what} {has}, the package's table {should}")


def _finding(entry: MessageEntry, what: str, seen: str) -> FuzzFinding:
    data = entry.code.to_bytes(2, "little")
    return FuzzFinding(CHECK, entry.name, entry.service, entry.version, what, seen=seen, hex=data.hex(), seed=0, case=0)
