"""Counting by reason: nothing is dropped in silence."""

from __future__ import annotations

import logging
from collections import Counter


class Counters(Counter[str]):
    """Counters by dotted name (`dropped.malformed.size`); a drop is logged once per reason at DEBUG."""

    def __init__(self, logger: logging.Logger) -> None:
        super().__init__()
        self._logger = logger

    def drop(self, reason: str, detail: object = "") -> None:
        """Count a dropped packet; the first of each reason is logged."""
        name = f"dropped.{reason}"
        if not self[name]:
            self._logger.debug("first %s: %s", name, detail)
        self[name] += 1
