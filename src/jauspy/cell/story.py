"""A story: tasks one after the other in one cell, each of which begins with what the one before has left."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine, Sequence
from dataclasses import dataclass
from typing import Any, Final, TypeAlias

from jauspy.cell.measurements import Measured
from jauspy.cell.session import Session
from jauspy.errors import JausError

STAGE_TIME: Final = 600.0
"""Seconds in which a stage must end: the longest one takes 200 s, and each of its steps may be repeated."""


@dataclass(frozen=True, slots=True)
class Stage:
    """One task of a story."""

    name: str
    title: str
    """What happens in it, as a sentence without a full stop."""
    run: Callable[[Session, int], Coroutine[Any, Any, Measured]]


Told: TypeAlias = Callable[[Stage, Measured | None], None]
"""Called when a stage begins, with None, and when it has ended, with its measurements."""


def untold(_stage: Stage, _found: Measured | None) -> None:
    """Tell nobody."""


async def tell(
    session: Session, seed: int, stages: Sequence[Stage], told: Told = untold, *, within: float = STAGE_TIME
) -> Measured:
    """Run the stages; succeeds if all do and nothing was put in place by writing positions.

    A stage that ends without its goal, as a throw that misses, does not end the story; one that raises, or has not
    ended `within` seconds of the event loop's time, does, since the next could not take what it left.
    """
    begun = session.cell.now()
    whole = Measured(seed, "demo")
    failures = []
    for stage in stages:
        told(stage, None)
        start = session.cell.now()
        found, ended = None, ""
        limit = asyncio.timeout(within)
        try:
            async with limit:
                found = await stage.run(session, seed)
        except JausError as error:
            ended = str(error)
        except TimeoutError:
            if not limit.expired():
                raise
            ended = f"it has not ended within {within:g} s"
        if found is None:
            found = Measured(seed, stage.name, failure=ended, duration=session.cell.now() - start)
        if session.judge is not None:
            found.written = session.judge.written
        told(stage, found)
        prefix = stage.name.replace(" ", "_")
        whole.values |= {f"{prefix}.{name}": value for name, value in found.values.items()}
        result = "done" if found.success else found.failure
        whole.rows.append({"event": f"{stage.name}: {result}, {found.duration:.1f} s", "stage": stage.name})
        whole.rows[-1] |= {"success": found.success, "failure": found.failure, "duration": found.duration}
        if not found.success:
            failures.append(f"{stage.name}: {found.failure or 'its goal was not reached'}")
        if ended:
            break
    missing = [stage.name for stage in stages[len(whole.rows) :]]
    if missing:
        failures.append(f"not begun: {', '.join(missing)}")
    if session.judge is not None and session.judge.written:
        failures.append(f"put in place by writing positions: {', '.join(session.judge.written)}")
    whole.values["stages"] = float(len(whole.rows))
    whole.duration = session.cell.now() - begun
    whole.success, whole.failure = not failures, "; ".join(failures)
    return whole
