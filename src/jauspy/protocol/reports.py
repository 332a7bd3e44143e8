"""Telling people that an id is used by two, once each and not too often: counters alone do not say by whom."""

from __future__ import annotations

import logging
from collections import OrderedDict
from typing import Final

from jauspy.ids import JausID
from jauspy.protocol.addressing import LocalPort, Port
from jauspy.protocol.sources import TokenBuckets

MAX_LOGGED_CASES: Final = 256
"""Cases to remember as told; an attacker who makes up more of them is told about again."""
LOG_RATE: Final = 0.1
LOG_BURST: Final = 16.0
"""Lines per second, and at once: what more is made up is only counted."""


class DuplicateIdLog:
    """Warnings about ids, each once per id and host, or local socket."""

    def __init__(self, logger: logging.Logger) -> None:
        self._logger = logger
        self._told: OrderedDict[tuple[int, str], None] = OrderedDict()
        self._lines = TokenBuckets(LOG_RATE, LOG_BURST)

    def twice(self, id: int, port: Port, now: float) -> None:
        """Somebody at `port` uses the id of a component that is registered here."""
        if self._is_news(id, port, now):
            self._logger.warning(
                "%s is used twice: a component has it here, and %s sends with it too; the latter is not heard",
                JausID.from_int(id),
                format_port(port),
            )

    def moved(self, id: int, port: Port, now: float) -> None:
        """A component has connected whose id was registered elsewhere."""
        if self._is_news(id, port, now):
            self._logger.info("component %s is now on %s", JausID.from_int(id), format_port(port))

    def _is_news(self, id: int, port: Port, now: float) -> bool:
        key = (id, port.path if isinstance(port, LocalPort) else port[0])
        if key in self._told or not self._lines.take(None, now):
            return False
        self._told[key] = None
        if len(self._told) > MAX_LOGGED_CASES:
            self._told.popitem(last=False)
        return True


def format_port(port: Port) -> str:
    """A port as people read it; the host of an IPv6 address is in brackets."""
    host, *rest = port[:2]
    return ":".join([f"[{host}]" if rest and ":" in host else host, *map(str, rest)])
