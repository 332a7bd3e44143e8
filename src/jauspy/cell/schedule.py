"""A schedule of actions with prerequisites and exclusive resources; actions that may run in parallel do."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Iterable
from dataclasses import dataclass, field

from jauspy.errors import ConfigError, JausError


class TaskFailed(JausError):
    """A task cannot be carried out; the message contains the reason and the attempts."""


@dataclass(frozen=True, slots=True)
class Action:
    """One step of a task."""

    name: str
    run: Callable[[], Awaitable[None]]
    after: tuple[str, ...] = ()
    """Actions that must be done before."""
    uses: frozenset[str] = frozenset()
    """Resources that no other action may use meanwhile: an arm, a conveyor."""


@dataclass(frozen=True, slots=True)
class Entry:
    """When an action ran, in seconds from the start of the schedule."""

    action: str
    start: float
    end: float
    uses: frozenset[str] = frozenset()


@dataclass(slots=True)
class Timeline:
    """The actions that ran, with their times."""

    entries: list[Entry] = field(default_factory=list)

    @property
    def total(self) -> float:
        """Seconds until the last action ended."""
        return max((entry.end for entry in self.entries), default=0.0)

    @property
    def saved(self) -> float:
        """Seconds by which it was shorter than all actions one after the other."""
        return sum(entry.end - entry.start for entry in self.entries) - self.total


class Schedule:
    """Runs actions, those that were added first before others; `clock` gives seconds."""

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self._actions: dict[str, Action] = {}
        self.timeline = Timeline()

    def add(
        self, name: str, run: Callable[[], Awaitable[None]], *, after: Iterable[str] = (), uses: Iterable[str] = ()
    ) -> str:
        """Add an action; returns its name. Raises `ConfigError` if the name is taken, or one of `after` is unknown."""
        if name in self._actions:
            raise ConfigError(f"the schedule has an action {name!r} already")
        for other in after:
            if other not in self._actions:
                raise ConfigError(f"{name!r} is to run after {other!r}, which was not added before")
        self._actions[name] = Action(name, run, tuple(after), frozenset(uses))
        return name

    async def run(self) -> Timeline:
        """Run all actions. The first that fails ends the others, and its error is raised."""
        start = self._clock()
        waiting, done = dict(self._actions), set[str]()
        running: dict[asyncio.Task[None], tuple[Action, float]] = {}
        busy: set[str] = set()
        try:
            while waiting or running:
                for action in list(waiting.values()):
                    if done.issuperset(action.after) and not busy & action.uses:
                        del waiting[action.name]
                        busy |= action.uses
                        task = asyncio.create_task(_run(action), name=action.name)
                        running[task] = action, self._clock() - start
                ended, _ = await asyncio.wait(running, return_when=asyncio.FIRST_COMPLETED)
                for task in sorted(ended, key=lambda ended_task: ended_task.get_name()):
                    action, begun = running.pop(task)
                    self.timeline.entries.append(Entry(action.name, begun, self._clock() - start, action.uses))
                    busy -= action.uses
                    done.add(action.name)
                    task.result()
        finally:
            for task in running:
                task.cancel()
            if running:
                await asyncio.gather(*running, return_exceptions=True)
        return self.timeline


async def _run(action: Action) -> None:
    await action.run()
