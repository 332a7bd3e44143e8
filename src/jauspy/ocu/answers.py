"""Which message answers a query."""

from __future__ import annotations

from typing import Final

from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.ocu.arguments import check_class, check_message

REPORT_OFFSET: Final = 0x2000
"""From the code of a query (2000h to 3FFFh) to that of its report (AS5710)."""
REPORTS: Final = range(0x4000, 0x6000)


def answer_to(
    registry: Registry, message: Message, expects: type[Message] | None, use: str = "query()"
) -> type[Message]:
    """What answers this message: `expects`, else the report of the query that it is; `use` is what it was given to."""
    check_message(message, use)
    check_class(expects, "expects")
    return expects or report_of(registry, message)


def report_of(registry: Registry, query: Message) -> type[Message]:
    """The class of the report that answers a query, of the same service and version."""
    if not query.IS_QUERY:
        raise ConfigError(f"{query.NAME} is no query; say with `expects` which message answers it, or send it")
    if (report := getattr(query, "REPORT", None)) is not None:
        return report  # type: ignore[no-any-return]  # queries whose report is of the same service have it
    code = query.CODE + REPORT_OFFSET
    found = registry.by_code(code) if code in REPORTS else _named_report(registry, query)
    for each in found:
        if (each.SERVICE, each.VERSION) == (query.SERVICE, query.VERSION):
            return each
    if not found:
        what = f"with id {code:04X}" if code in REPORTS else f"called {report_name(query)} of {query.SERVICE}"
        raise ConfigError(f"no message {what} is known to answer {query.NAME}; say with `expects` which one does")
    return found[0]


def _named_report(registry: Registry, query: Message) -> tuple[type[Message], ...]:
    """What answers a query whose id says nothing, as those of users do."""
    try:
        return (registry.by_name(report_name(query), service=query.SERVICE, version=query.VERSION),)
    except ConfigError:
        return ()


def report_name(query: Message) -> str:
    """`ReportLamp` of `QueryLamp`."""
    return f"Report{query.NAME.removeprefix('Query')}"
