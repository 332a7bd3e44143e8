"""Loggers of this package, and of packages that it runs.

Lines are limited in length, and those of one kind in rate, because peers can cause any number of them.
"""

from __future__ import annotations

import logging
from collections import OrderedDict
from types import TracebackType
from typing import Final, TypeAlias

MAX_LINES_AT_ONCE: Final = 16
"""Lines of one kind; further ones are only counted."""
LINE_INTERVAL: Final = 10.0
"""Seconds until one more line of a kind is written; it contains how many were left out."""
MAX_KINDS: Final = 512
"""Kinds of lines that are distinguished; the kind that was written longest ago is forgotten."""

MAX_LINE: Final = 1000
"""Characters of a message; the rest of a longer one is left out."""
_PACKAGE: Final = __name__.partition(".")[0]

_Kind: TypeAlias = tuple[str, str, str]


class LogRateLimit(logging.Filter):
    """Limits the lines of each kind: those of one logger with one text before formatting, and one place of an error.

    Of other packages, which may format texts themselves, the lines of one place in the code are of one kind.
    `extra={"kind": ...}` replaces the text, for lines that are written once for each of a few kinds.
    """

    def __init__(self) -> None:
        super().__init__()
        self._kinds: OrderedDict[_Kind, tuple[float, float, int]] = OrderedDict()
        """Counts by kind: lines that may be written, the time of that number, and the lines left out since the last
        one."""

    def filter(self, record: logging.LogRecord) -> bool:
        """False for a line too many; else the number of lines that were left out is added to it."""
        if getattr(record, "is_within_limit", False):
            return True  # by the filter of its logger
        is_own = record.name.partition(".")[0] == _PACKAGE
        text = str(getattr(record, "kind", record.msg if is_own else f"{record.pathname}:{record.lineno}"))
        kind = (record.name, text, _place(record.exc_info[2] if record.exc_info else None))
        lines, since, left_out = self._kinds.get(kind, (float(MAX_LINES_AT_ONCE), record.created, 0))
        lines = min(float(MAX_LINES_AT_ONCE), lines + max(0.0, record.created - since) / LINE_INTERVAL)
        granted = lines >= 1.0
        self._kinds[kind] = (lines - granted, record.created, 0 if granted else left_out + 1)
        self._kinds.move_to_end(kind)
        if len(self._kinds) > MAX_KINDS:
            self._kinds.popitem(last=False)
        if granted:
            message = whole = record.getMessage()
            if len(message) > MAX_LINE:
                message = f"{message[:MAX_LINE]} ... ({len(message) - MAX_LINE} more characters)"
            if left_out:
                message = f"{message} ({left_out} such lines were left out)"
            if message is not whole:
                record.msg, record.args = message, ()
        record.is_within_limit = granted
        return granted

    def reset(self) -> None:
        """Forget what was written, as between tests."""
        self._kinds.clear()


LIMIT: Final = LogRateLimit()
"""The limit of all loggers of this package; programs may add it to their own handlers and loggers."""


def get_logger(name: str) -> logging.Logger:
    """The logger of this name, with the limit. All code of this package uses it."""
    logger = logging.getLogger(name)
    logger.addFilter(LIMIT)
    return logger


def adopt(*names: str) -> None:
    """Take the loggers of other packages: with the limit, without handlers of their own, from warnings on."""
    for name in names:
        logger = logging.getLogger(name)
        logger.handlers.clear()
        logger.propagate = True
        logger.setLevel(logging.WARNING)
        logger.addFilter(LIMIT)


def _place(trace: TracebackType | None) -> str:
    """Where an exception was raised."""
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    return "" if trace is None else f"{trace.tb_frame.f_code.co_filename}:{trace.tb_lineno}"
