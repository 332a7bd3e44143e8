"""`replay`: a regression test from a recording."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Awaitable, Callable, Iterable
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import pytest

from jauspy.capture.filters import Filter
from jauspy.codec.registry import Registry
from jauspy.ids import JausID
from jauspy.messages import registry as public
from jauspy.replay.comparison import Comparison
from jauspy.replay.player import DEFAULT_CLIENT, Playback, replay as play
from jauspy.replay.recorded import PATIENCE, load
from jauspy.transport import Transport

if TYPE_CHECKING:
    from jauspy.virtual.environment import Environment

MAX_SHOWN: Final = 20


def replay(
    recording: str | Path,
    *,
    clients: Iterable[str | JausID] = (),
    target: int | None = None,
    now: int | None = None,
    filter: str | None = None,
    speed: float | None = 1.0,
    timeout: float = PATIENCE,
    strict: bool = False,
    tolerance: float = 0.0,
    ignore: Iterable[str] = (),
    registry: Registry = public,
) -> Callable[[Callable[..., Any]], Callable[..., Awaitable[None]]]:
    """Decorator of a test: first replay a recording to the components that its fixtures run.

    The test fails if answers differ from the recorded ones; otherwise its own body runs afterwards. The path is
    relative to the file of the test. The network is that of the fixture `environment`; on virtual time, waiting takes
    no time. `target` is the recorded subsystem, `now` its number in the test; `speed=None` is as fast as answers come;
    the others are the options of `jauspy replay`.

        @jauspy.testing.replay("run.pcap")
        def test_field_run(robot): ...
    """

    def decorate(test: Callable[..., Any]) -> Callable[..., Awaitable[None]]:
        path = Path(inspect.getfile(test)).parent / recording
        signature = inspect.signature(test)
        parameters = list(signature.parameters.values())
        has_environment = "environment" in signature.parameters
        if not has_environment:
            parameters.append(inspect.Parameter("environment", inspect.Parameter.KEYWORD_ONLY))

        @functools.wraps(test)
        async def replayed(environment: Environment, **fixtures: Any) -> None:
            async def transport(id: JausID) -> Transport:
                return environment.transport(id)

            found = load(
                path,
                registry,
                clients=[JausID.of(id) for id in clients],
                subsystem=target,
                fits=None if filter is None else Filter(filter, registry),
            )
            playback = Playback(
                speed=speed,
                timeout=timeout,
                client=DEFAULT_CLIENT,
                subsystem=now,
                comparison=Comparison(strict, tolerance, tuple(ignore)),
            )
            result = await play(found, registry, transport, playback, utc_now=environment.utc_now)
            if result.differences:
                shown = [*map(str, result.differences[:MAX_SHOWN])]
                more = len(result.differences) + result.more - len(shown)
                shown += [f"and {more} more"] if more else []
                pytest.fail("\n".join([f"answers differ from those in {path.name}:", *shown]), pytrace=False)
            ended = test(**fixtures, **({"environment": environment} if has_environment else {}))
            if inspect.isawaitable(ended):
                await ended

        del replayed.__wrapped__  # pytest would take the fixtures of the test alone
        replayed.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
        if find_spec("pytest_asyncio") is not None:
            marked: Callable[..., Awaitable[None]] = pytest.mark.asyncio(replayed)
            return marked
        return replayed

    return decorate
