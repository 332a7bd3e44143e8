"""Running components as a program: until Ctrl-C, SIGTERM or a closed terminal, and then in order."""

from __future__ import annotations

import asyncio
import signal

from jauspy.arguments import described
from jauspy.component.component import Component
from jauspy.errors import TransportError

_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def run(*components: Component) -> None:
    """Run the components until Ctrl-C or SIGTERM, or until all were closed.

    Raises `TransportError` when one cannot start. In a program with an event loop of its own use `component.run()`.
    """
    for each in components:
        if not isinstance(each, Component):
            raise TypeError(
                f"run() takes components, as in jauspy.Component('101.1.120', [...]), not {described(each)}"
            )
    try:
        asyncio.run(_serve(components))
    except TransportError as error:
        raise error.with_traceback(None) from None  # what to do is in its last line, and its way here is no help


async def _serve(components: tuple[Component, ...]) -> None:
    loop = asyncio.get_running_loop()
    serving = asyncio.gather(*(component.run() for component in components))
    stopped = False

    def stop() -> None:
        nonlocal stopped
        stopped = True
        serving.cancel()

    for number in _SIGNALS:
        loop.add_signal_handler(number, stop)
    try:
        await serving
    except asyncio.CancelledError:
        if not stopped:
            raise
    finally:
        for number in _SIGNALS:
            loop.remove_signal_handler(number)
