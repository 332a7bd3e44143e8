"""Reports as one HTML file that needs nothing else: no script, no font, no network."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import UTC, datetime
from html import escape
from typing import Final

from jauspy.conformance.results import Report, Result, Verdict

_STYLE: Final = """
:root { color-scheme: light dark; font: 15px/1.5 system-ui, sans-serif; }
body { max-width: 72rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.4rem; } .sum { font-size: 1.1rem; }
details { border-bottom: 1px solid #8884; } summary { padding: .25rem 0; cursor: pointer; }
.v { display: inline-block; width: 5.5rem; font-weight: 600; } .t { color: #888; float: right; }
.pass { color: #1a8f3c; } .skipped { color: #888; } .fail, .silent, .late, .malformed { color: #d0342c; }
.id { display: inline-block; min-width: 3rem; color: #888; } .in { margin: .25rem 0 1rem 3rem; }
pre { font: 12px/1.45 ui-monospace, monospace; overflow-x: auto; margin: .5rem 0; } .h { color: #888; }
li.no { color: #d0342c; }
"""


def page(report: Report) -> str:
    """The file."""
    return "\n".join(_lines(report)) + "\n"


def _lines(report: Report) -> Iterator[str]:
    title = escape(f"{report.profile}: {report.target}")
    yield f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
    yield f"<style>{_STYLE}</style></head><body>"
    yield f"<h1>{escape(report.title)}</h1>"
    when = datetime.fromtimestamp(report.began, UTC).strftime("%Y-%m-%d %H:%M:%S UTC")
    yield f"<p>Target {escape(report.target)}, {when}, {report.seconds:.1f} s.</p>"
    yield f'<p class="sum">{escape(summary(report))}</p>'
    if report.problem:
        yield f'<p class="fail">{escape(report.problem)}</p>'
    yield from (f"<p>{escape(note)}.</p>" for note in report.notes)
    for result in report.results:
        yield from _step(result)
    yield "</body></html>"


def _step(result: Result) -> Iterator[str]:
    opened = "" if result.verdict in (Verdict.PASS, Verdict.SKIPPED) else " open"
    points = f"{result.earned:g}/{result.points:g} points, " if result.points else ""
    yield (
        f'<details{opened}><summary><span class="v {result.verdict}">{result.verdict}</span>'
        f'<span class="id">{escape(result.id)}</span> {escape(result.title)}'
        f'<span class="t">{points}{result.elapsed * 1000:.0f} ms</span></summary><div class="in">'
    )
    if result.reason:
        yield f'<p class="{result.verdict}">{escape(result.reason)}</p>'
    if result.why:
        yield f"<p>From {escape(result.why)}.</p>"
    if result.looked:
        yield "<ul>"
        for each in result.looked:
            yield f'<li class="{"no" if each.problem else "yes"}">{escape(each.name)}</li>'
        yield "</ul>"
    if result.entries:
        yield f"<pre>{''.join(_traffic(result))}</pre>"
    yield "</div></details>"


def _traffic(result: Result) -> Iterator[str]:
    for entry in result.entries:
        arrow = escape(str(entry.direction))
        yield f'<span class="h">{entry.at:9.4f} {arrow} {entry.data.hex()}</span>\n'
        for line in entry.lines:
            yield f"          {arrow} {escape(line)}\n"


def summary(report: Report) -> str:
    """`79 pass, 1 silent; 79 of 80 points`."""
    counts = ", ".join(f"{report.counts[verdict]} {verdict}" for verdict in Verdict if report.counts[verdict])
    earned, possible = report.points
    return (counts or "nothing was tried") + (f"; {earned:g} of {possible:g} points" if possible else "")
