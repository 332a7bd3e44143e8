"""Counters by reason: every dropped packet is counted."""

from __future__ import annotations

import logging


class Counters(dict[str, int]):
    """Counters by dotted name (`dropped.malformed.size`); what is dropped is logged once per reason at DEBUG.

    A dict, because `collections.Counter` takes twice as long, and every packet is counted twice.
    """

    def __init__(self, logger: logging.Logger) -> None:
        super().__init__()
        self._logger = logger

    def __missing__(self, name: str) -> int:
        return 0

    def drop(self, reason: str, detail: object = "") -> None:
        """Count a dropped packet as `dropped.` and the reason."""
        self.count(f"dropped.{reason}", detail)

    def count(self, name: str, detail: object = "") -> None:
        """Count one more under this name; the first is logged."""
        if not self[name]:
            self._logger.debug("first %s: %s", name, detail, extra={"kind": name})
        self[name] += 1
