"""Coverage-guided fuzzing of Python code in this process: inputs that reach new lines become seeds of further ones."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from importlib import import_module
from pathlib import Path
from random import Random
from types import CodeType, FrameType, TracebackType
from typing import Any, Final

from jauspy.errors import ConfigError, JausError
from jauspy.fuzz.findings import minimise
from jauspy.fuzz.messages import FuzzTarget, targets
from jauspy.fuzz.mutation import Seed, from_payloads, from_schemas, mutate, offsets_of
from jauspy.messages import registry
from jauspy.schema import load_builtin

Function = Callable[[bytes], object]
MAX_CORPUS: Final = 5000
"""Inputs that have reached new lines, at most; then further ones are run, but not kept."""
RECENT: Final = 0.5
"""Part of the cases that start from the newest inputs, which are the deepest."""
NEWEST: Final = 8
CASES_PER_REPORT: Final = 500


@dataclass(frozen=True, slots=True)
class PythonFinding:
    """An exception other than those that a decoder may raise, and the bytes that cause it."""

    exception: str
    place: str
    """File and line that raised it."""
    seen: str
    data: bytes
    case: int

    @property
    def cause(self) -> str:
        """The name of the finding."""
        return f"{self.exception} {self.place}"


@dataclass(slots=True)
class PythonResult:
    """The result of a campaign so far."""

    cases: int = 0
    lines: int = 0
    """Lines that were reached."""
    corpus: int = 0
    """Inputs that reached new lines."""
    findings: dict[str, PythonFinding] = field(default_factory=dict)


class LineCoverage:
    """The lines of some files that were executed; a case that adds none is not interesting.

    `sys.monitoring` (Python 3.12) reports each line once and costs nothing then; before, `sys.settrace` slows down.
    """

    def __init__(self, roots: Sequence[str]) -> None:
        self.lines: set[tuple[CodeType, int]] = set()
        self._roots = tuple(roots)

    @contextmanager
    def measured(self) -> Iterator[None]:
        """Measure in this block. Raises `ConfigError` if another tool, such as a profiler, measures already."""
        if not hasattr(sys, "monitoring"):
            before = sys.gettrace()
            sys.settrace(self._on_call)
            try:
                yield
            finally:
                sys.settrace(before)
            return
        monitoring: Any = sys.monitoring
        tool = next((number for number in range(6) if monitoring.get_tool(number) is None), None)
        if tool is None:
            raise ConfigError("coverage cannot be measured: other tools use all of sys.monitoring")
        monitoring.use_tool_id(tool, "jauspy fuzz")
        try:
            monitoring.register_callback(tool, monitoring.events.LINE, self._on_line)
            monitoring.set_events(tool, monitoring.events.LINE)
            monitoring.restart_events()  # lines that an earlier campaign has disabled
            yield
        finally:
            monitoring.set_events(tool, 0)
            monitoring.register_callback(tool, monitoring.events.LINE, None)
            monitoring.free_tool_id(tool)

    def _on_line(self, code: CodeType, line: int) -> Any:
        if code.co_filename.startswith(self._roots):
            self.lines.add((code, line))
        return sys.monitoring.DISABLE  # type: ignore[attr-defined,unused-ignore]  # Python 3.12

    def _on_call(self, frame: FrameType, event: str, argument: Any) -> Any:  # noqa: ARG002 - of settrace
        return self._on_event if frame.f_code.co_filename.startswith(self._roots) else None

    def _on_event(self, frame: FrameType, event: str, argument: Any) -> Any:  # noqa: ARG002 - of settrace
        if event == "line":
            self.lines.add((frame.f_code, frame.f_lineno))
        return self._on_event


@dataclass(frozen=True, slots=True)
class PythonPlan:
    """The settings of a campaign: `function` as MODULE:FUNCTION takes the bytes of one message, with its id.

    Without `guided` no input becomes a seed, which shows what coverage is good for. `include` are further folders or
    files whose lines count; the folder of the module always does.
    """

    function: str
    cases: int
    seed: int = 0
    payloads: tuple[bytes, ...] = ()
    only: tuple[str, ...] = ()
    include: tuple[str, ...] = ()
    guided: bool = True


def run(plan: PythonPlan, progress: Callable[[PythonResult], None] = lambda _: None) -> PythonResult:
    """Run the given payloads, then all cases. Raises `ConfigError` if the function cannot be imported."""
    function, root = load_function(plan.function)
    return _GuidedFuzzer(plan, function, LineCoverage([root, *plan.include])).run(progress)


def load_function(name: str) -> tuple[Function, str]:
    """The function of MODULE:FUNCTION, also in this folder, and the folder of its package or its file."""
    module_name, _, function_name = name.partition(":")
    folder = str(Path.cwd())
    if folder not in sys.path:
        sys.path.insert(0, folder)
    try:
        module = import_module(module_name)
    except Exception as error:  # the code is not ours
        raise ConfigError(f"{module_name} cannot be imported: {type(error).__name__}: {error}") from error
    function = getattr(module, function_name, None)
    file = getattr(module, "__file__", None)
    if not callable(function) or file is None:
        raise ConfigError(f"{name} is not a function of Python code; name it as MODULE:FUNCTION")
    return function, str(Path(file).parent) if "." in module_name or file.endswith("__init__.py") else file


class _GuidedFuzzer:
    """The loop: choose an input, mutate it, run it, and keep it if it reached a new line."""

    def __init__(self, plan: PythonPlan, function: Function, coverage: LineCoverage) -> None:
        self._plan = plan
        self._function = function
        self._coverage = coverage
        self._targets: tuple[FuzzTarget, ...] = targets(registry, load_builtin(), plan.only)
        self._layouts = {each.id: (place, each) for place, each in enumerate(self._targets)}
        self._seeds: list[Seed] = [*from_payloads(self._targets, plan.payloads), *from_schemas(self._targets)]
        self._corpus: list[Seed] = []
        self._result = PythonResult()

    def run(self, progress: Callable[[PythonResult], None]) -> PythonResult:
        """Run all cases of the plan."""
        rng = Random(self._plan.seed)  # noqa: S311 - chance, not secrets
        with self._coverage.measured():
            for data in self._inputs(rng):
                self._run(data)
                self._result.cases += 1
                if self._result.cases % CASES_PER_REPORT == 0:
                    progress(self._result)
        progress(self._result)
        return self._result

    def _inputs(self, rng: Random) -> Iterable[bytes]:
        yield from self._plan.payloads
        for _ in range(self._plan.cases):
            yield mutate(rng, self._chosen(rng), self._seeds)

    def _chosen(self, rng: Random) -> Seed:
        if self._corpus and rng.random() < RECENT:
            return rng.choice(self._corpus[-NEWEST:])
        if self._corpus and rng.random() < RECENT:
            return rng.choice(self._corpus)
        return rng.choice(self._seeds)

    def _run(self, data: bytes) -> None:
        known = len(self._coverage.lines)
        problem = self._problem(data)
        self._result.lines = len(self._coverage.lines)
        if problem is not None and problem[:2] not in {(f.exception, f.place) for f in self._result.findings.values()}:
            self._keep_finding(data, problem)
        if self._plan.guided and self._result.lines > known and len(self._corpus) < MAX_CORPUS:
            self._corpus.append(self._seed(data))
            self._result.corpus = len(self._corpus)

    def _problem(self, data: bytes) -> tuple[str, str, str] | None:
        """Type, place and text of an exception that no decoder may raise; None if there is none."""
        try:
            self._function(data)
        except JausError:
            return None
        except RecursionError as error:
            return "RecursionError", self._place(error.__traceback__, outermost=True), str(error)
        except Exception as error:  # noqa: BLE001 - what the campaign looks for
            return type(error).__name__, self._place(error.__traceback__), str(error)
        return None

    def _place(self, traceback: TracebackType | None, *, outermost: bool = False) -> str:
        """The line of the function's code that raised, or called what raised; the first one if `outermost`."""
        lines = []
        while traceback is not None:
            code = traceback.tb_frame.f_code
            if code is not _GuidedFuzzer._problem.__code__:
                lines.append(f"{Path(code.co_filename).name}:{traceback.tb_lineno}")
            traceback = traceback.tb_next
        return (lines[0] if outermost else lines[-1]) if lines else "?"

    def _keep_finding(self, data: bytes, problem: tuple[str, str, str]) -> None:
        def shows(candidate: bytes) -> bool:
            found = self._problem(candidate)
            return found is not None and found[:2] == problem[:2]

        smallest = minimise(data, shows)
        exception, place, seen = problem
        finding = PythonFinding(exception, place, seen, smallest, self._result.cases)
        self._result.findings[finding.cause] = finding

    def _seed(self, data: bytes) -> Seed:
        place, target = self._layouts.get(data[:2], (0, None))
        return Seed(place, data, offsets_of(target.layout, data) if target else ())
