"""Telling people, once each, that an id is used by two: counters alone do not say by whom."""

from __future__ import annotations

import logging
from collections import OrderedDict
from typing import Final

from jauspy.ids import JausID
from jauspy.protocol.ports import Port

MEMORY: Final = 256
"""Cases to remember as told; an attacker who makes up more of them is told about again."""


class Reports:
    """Warnings about ids, each once per id and place."""

    def __init__(self, logger: logging.Logger) -> None:
        self._logger = logger
        self._told: OrderedDict[tuple[int, Port], None] = OrderedDict()

    def twice(self, id: int, port: Port) -> None:
        """Somebody at `port` uses the id of a component that is registered here."""
        if self._is_news(id, port):
            self._logger.warning(
                "%s is used twice: a component has it here, and %s sends with it too; the latter is not heard",
                JausID.from_int(id),
                place(port),
            )

    def moved(self, id: int, port: Port) -> None:
        """A component has connected whose id was registered elsewhere."""
        if self._is_news(id, port):
            self._logger.info("component %s is now on %s", JausID.from_int(id), place(port))

    def _is_news(self, id: int, port: Port) -> bool:
        key = (id, port)
        if key in self._told:
            return False
        self._told[key] = None
        if len(self._told) > MEMORY:
            self._told.popitem(last=False)
        return True


def place(port: Port) -> str:
    """A port as people read it; the host of an IPv6 address is in brackets."""
    host, *rest = port[:2]
    return ":".join([f"[{host}]" if rest and ":" in host else host, *map(str, rest)])
