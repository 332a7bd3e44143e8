"""Reports as one HTML file that needs nothing else: no script, no font, no network."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from datetime import UTC, datetime
from html import escape
from importlib.resources import files
from typing import Final

from jauspy.conformance.results import Looked, Report, Result, Verdict, transitions_sum
from jauspy.conformance.trace import Direction, Entry

_QUIET: Final = (Verdict.PASS, Verdict.SKIPPED)
"""Steps that nobody needs to open."""


def page(report: Report) -> str:
    """The file."""
    return "\n".join(_lines(report)) + "\n"


def _lines(report: Report) -> Iterator[str]:
    style = files(__package__).joinpath("report.css").read_text()
    yield '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
    yield '<meta name="viewport" content="width=device-width, initial-scale=1">'
    yield f"<title>{escape(report.profile)}: {escape(report.target)}</title>"
    yield f"<style>\n{style}</style></head><body>"
    yield from _head(report)
    yield from _failures(report.failures)
    if report.results:
        yield '<input type="checkbox" id="less"><label for="less">Only what did not pass</label>'
        yield "<main>"
        for result in report.results:
            yield from _step(result)
        yield "</main>"
    yield "</body></html>"


def _head(report: Report) -> Iterator[str]:
    when = datetime.fromtimestamp(report.began, UTC).strftime("%Y-%m-%d %H:%M:%S UTC")
    yield f"<header><h1>{escape(report.title)}</h1>"
    run = f"profile {escape(report.profile)}, {when}, {report.seconds:.1f} s"
    yield f"<p>Target <strong>{escape(report.target)}</strong>, {run}</p>"
    yield f'<p class="sum s{report.status}">{escape(summary(report))}</p>'
    if report.results:
        yield f'<div class="bar" aria-hidden="true">{"".join(_bar(report))}</div>'
    if report.problem:
        yield f'<p class="problem">{escape(report.problem)}</p>'
    yield from (f"<p>{escape(note)}</p>" for note in report.notes)
    yield from _transitions(report)
    yield "</header>"


def _transitions(report: Report) -> Iterator[str]:
    if not (total := transitions_sum(report)):
        return
    left = [each for each in report.transitions if not each.step]
    items = "".join(f"<li>{escape(each.name)}: {escape(each.reason)}</li>" for each in left)
    yield (
        f"<details><summary>{escape(total)}</summary><ul>{items}</ul></details>" if left else f"<p>{escape(total)}</p>"
    )


def _bar(report: Report) -> Iterator[str]:
    for verdict in Verdict:
        if count := report.counts[verdict]:
            yield f'<span class="{verdict}" style="flex-grow:{count}" title="{count} {verdict}"></span>'


def _failures(failures: Iterable[Result]) -> Iterator[str]:
    """Where to look first."""
    items = [
        f'<li><a href="#{escape(each.id)}">{escape(each.id)}</a> {escape(each.title)}: {escape(each.reason)}</li>'
        for each in failures
    ]
    if items:
        yield f"<nav><h2>What did not pass</h2><ul>{''.join(items)}</ul></nav>"


def _step(result: Result) -> Iterator[str]:
    opened = "" if result.verdict in _QUIET else " open"
    points = f"{result.earned:g}/{result.points:g} points, " if result.points else ""
    yield (
        f'<details class="{result.verdict}" id="{escape(result.id)}"{opened}><summary>'
        f'<span class="v">{result.verdict}</span> <span class="id">{escape(result.id)}</span>'
        f' <span class="what">{escape(result.title)}</span>'
        f' <span class="t">{points}{result.elapsed * 1000:.0f} ms</span></summary><div class="in">'
    )
    if result.reason:
        yield f'<p class="reason">{escape(result.reason)}</p>'
    if result.expected:
        yield f"<p>Expected: {escape('; '.join(result.expected))}</p>"
    if result.why:
        yield f'<p class="from">From {escape(result.why)}</p>'
    if result.looked:
        yield f'<ul class="checks">{"".join(map(_check, result.looked))}</ul>'
    if result.entries:
        yield f'<div class="traffic">{"".join(map(_datagram, result.entries))}</div>'
    if result.rest:
        yield f"<p>{result.rest}</p>"
    yield "</div></details>"


def _check(looked: Looked) -> str:
    problem = f": {escape(looked.problem)}" if looked.problem else ""
    return f'<li class="{"no" if looked.problem else "yes"}">{escape(looked.name)}{problem}</li>'


def _datagram(entry: Entry) -> str:
    way = "sent" if entry.direction is Direction.SENT else "received"
    decoded = "<br>".join(map(escape, entry.lines))
    head = f"<time>{entry.at:.4f}</time> <strong>{way}</strong> <span>{decoded}</span>"
    return f'<div class="{way}">{head}<code>{entry.data.hex(" ", -4)}</code></div>\n'


def summary(report: Report) -> str:
    """`79 pass, 1 silent; 79 of 80 points`."""
    counts = ", ".join(f"{report.counts[verdict]} {verdict}" for verdict in Verdict if report.counts[verdict])
    earned, possible = report.points
    return (counts or "nothing was tried") + (f"; {earned:g} of {possible:g} points" if possible else "")
