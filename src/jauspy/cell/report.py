"""The report of results: plots as SVG files, and HTML pages with tables, plots and films inside.

Plots need matplotlib, of the extra `plot`; pages open without a network and run no scripts. Results and names of files
are text on them, never markup.
"""

from __future__ import annotations

import base64
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from html import escape
from pathlib import Path
from typing import Final

from jauspy.cell.measurements import Measured
from jauspy.cell.trials import Summary
from jauspy.plots import ACCENT, BAD, GOOD, figure


def plot_trials(results: Sequence[Measured], summary: Summary, path: Path) -> None:
    """The time of each run, with failures marked, and the distribution of the placement errors."""
    good = [run for run in results if run.success]
    bad = [run for run in results if not run.success]
    with figure(path, columns=2) as (times, errors):
        times.bar([run.seed for run in good], [run.duration for run in good], color=GOOD, label="success")
        times.bar([run.seed for run in bad], [run.duration for run in bad], color=BAD, label="failure")
        times.set_xlabel("seed")
        times.set_ylabel("time of the cell, s")
        times.set_title(f"{summary.task}: {summary.successes} of {summary.runs} succeeded")
        times.legend(loc="lower right")
        rows = [row for run in results for row in run.rows]
        found = [1000.0 * row["error"] for row in rows if "error" in row]
        if found:
            errors.hist(found, bins=30, color=ACCENT)
            errors.set_xlabel("placement error of a part, mm")
            errors.set_ylabel("parts")
        else:
            errors.hist([run.duration for run in good], bins=20, color=ACCENT)
            errors.set_xlabel("time of the cell, s")
            errors.set_ylabel("runs")


MAX_FILM: Final = 40_000_000
"""Bytes of a film that is put into the page; a larger one is only named."""
CONTENT_SECURITY_POLICY: Final = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; media-src data:"
"""The page loads nothing, and runs nothing."""

STYLE: Final = """
:root { color-scheme: light dark; --text: #1c2733; --soft: #52606d; --line: #d5dce3; --ground: #ffffff;
  --panel: #f4f6f8; --good: #1f7a45; --bad: #b3322a; --link: #245a94; }
@media (prefers-color-scheme: dark) { :root { --text: #e3e8ed; --soft: #a6b1bc; --line: #38434e; --ground: #14191e;
  --panel: #1d242b; --good: #63c58d; --bad: #f28b82; --link: #8ab8e8; }
  img.plot { filter: invert(0.92) hue-rotate(180deg); } }
body { font: 16px/1.5 system-ui, sans-serif; margin: 0 auto; max-width: 66rem; padding: 2rem 1.25rem;
  color: var(--text); background: var(--ground); }
h1 { font-size: 1.9rem; line-height: 1.2; margin-bottom: 0; } p.lead { color: var(--soft); margin-top: 0.3rem; }
h2 { font-size: 1.35rem; line-height: 1.3; margin-top: 3rem; padding-bottom: 0.3rem;
  border-bottom: 1px solid var(--line); }
a { color: var(--link); } nav ol { columns: 2 20rem; padding-left: 1.4rem; margin: 1rem 0 0; }
.wide { overflow-x: auto; margin: 1.2rem 0; } .wide:focus-visible, a:focus-visible { outline: 3px solid var(--link); }
table { border-collapse: collapse; width: 100%; font-size: 0.9rem; }
caption { text-align: left; font-weight: 600; padding: 0.3rem 0; } p.note { color: var(--soft); font-size: 0.9rem; }
th, td { text-align: left; padding: 0.3rem 0.7rem; border-bottom: 1px solid var(--line); vertical-align: top; }
thead th { background: var(--panel); } tbody th { font-weight: 400; min-width: 9rem; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.yes { color: var(--good); font-weight: 600; white-space: nowrap; }
.no { color: var(--bad); font-weight: 600; white-space: nowrap; }
figure { margin: 1.2rem 0; } figcaption { color: var(--soft); font-size: 0.9rem; }
video, img { display: block; width: 100%; height: auto; border-radius: 6px; background: #ffffff; }
summary { cursor: pointer; margin: 1.2rem 0; color: var(--link); }
@media print { details > * { display: block; } video { display: none; } }
"""


@dataclass(frozen=True, slots=True)
class Promise:
    """Something that is promised, what was measured of it, and whether that is enough."""

    what: str
    wanted: str
    measured: str
    kept: bool


@dataclass(frozen=True, slots=True)
class Table:
    """A table with a caption. The first of `rows` is the heading, the first cell of a row names it."""

    caption: str
    rows: Sequence[Sequence[str]]
    note: str = ""
    """A sentence below it."""
    folded: bool = False
    """True for a long one, which readers unfold."""


@dataclass(frozen=True, slots=True)
class Plot:
    """A picture in a file, SVG or PNG, with a sentence that says what it shows."""

    path: Path
    caption: str


@dataclass(slots=True)
class Section:
    """One part of the page."""

    title: str
    text: str = ""
    tables: list[Table] = field(default_factory=list)
    plots: list[Plot] = field(default_factory=list)
    film: Path | None = None


def page(title: str, lead: str, promises: Sequence[Promise], sections: Sequence[Section]) -> str:
    """The HTML of the whole page."""
    body = [f'<h1>{escape(title)}</h1><p class="lead">{_prose(lead)}</p>']
    if promises:
        body.append(_promises(promises))
    body.append(
        '<nav aria-label="Contents"><ol>'
        + "".join(
            f'<li><a href="#s{number}">{escape(section.title)}</a></li>' for number, section in enumerate(sections, 1)
        )
        + "</ol></nav>"
    )
    for number, section in enumerate(sections, 1):
        body.append(f'<section aria-labelledby="s{number}"><h2 id="s{number}">{escape(section.title)}</h2>')
        if section.text:
            body.append(f"<p>{_prose(section.text)}</p>")
        if section.film is not None and section.film.exists():
            body.append(_film(section.film, section.title))
        body += [_plot(plot) for plot in section.plots if plot.path.exists()]
        body += [_table(table) for table in section.tables]
        body.append("</section>")
    return (
        f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{escape(title)}</title>'
        f'<meta http-equiv="Content-Security-Policy" content="{escape(CONTENT_SECURITY_POLICY)}">'
        f'<meta name="viewport" content="width=device-width, initial-scale=1"><style>{STYLE}</style></head>'
        f"<body><main>{''.join(body)}</main></body></html>\n"
    )


def _prose(text: str) -> str:
    """A text as HTML; what stands between backquotes is code."""
    return _CODE.sub(r"<code>\1</code>", escape(text))


_CODE: Final = re.compile(r"`([^`<>]{1,80})`")


def _promises(promises: Sequence[Promise]) -> str:
    marks = {True: '<td class="yes">kept</td>', False: '<td class="no">not kept</td>'}
    lines = [
        f'<tr><th scope="row">{escape(promise.what)}</th><td>{escape(promise.wanted)}</td>'
        f"<td>{escape(promise.measured)}</td>{marks[promise.kept]}</tr>"
        for promise in promises
    ]
    head = "".join(f'<th scope="col">{name}</th>' for name in ("what", "promised", "measured", "result"))
    return _wide("What is promised, and what was measured", f"<thead><tr>{head}</tr></thead>", lines)


def _table(table: Table) -> str:
    head, *rest = table.rows
    numbers = [all(map(_is_number, column)) for column in zip(*rest, strict=True)] or [False] * len(head)
    marks = ["", *(' class="number"' if numeric else "" for numeric in numbers[1:])]
    names = "".join(f'<th scope="col"{mark}>{escape(cell)}</th>' for mark, cell in zip(marks, head, strict=True))
    lines = []
    for first, *others in rest:
        cells = "".join(f"<td{mark}>{escape(cell)}</td>" for mark, cell in zip(marks[1:], others, strict=True))
        lines.append(f'<tr><th scope="row">{escape(first)}</th>{cells}</tr>')
    whole = _wide(table.caption, f"<thead><tr>{names}</tr></thead>", lines)
    if table.note:
        whole += f'<p class="note">{_prose(table.note)}</p>'
    return f"<details><summary>{escape(table.caption)}</summary>{whole}</details>" if table.folded else whole


def _wide(caption: str, head: str, lines: Sequence[str]) -> str:
    """A table that scrolls sideways on a narrow screen, by keys too."""
    return (
        f'<div class="wide" role="region" tabindex="0" aria-label="{escape(caption)}"><table>'
        f"<caption>{escape(caption)}</caption>{head}<tbody>{''.join(lines)}</tbody></table></div>"
    )


def _is_number(cell: str) -> bool:
    """True for a number with or without a unit, and for an empty cell."""
    first = cell.partition(" ")[0]
    try:
        float(first.removesuffix("%") or "0")
    except ValueError:
        return cell in ("-", "")
    return True


def _film(path: Path, title: str) -> str:
    if path.stat().st_size > MAX_FILM:
        return f"<p>Film: {escape(path.name)}</p>"
    data = base64.b64encode(path.read_bytes()).decode()
    label = escape(f"Film: {title}")
    return f'<video controls preload="metadata" aria-label="{label}" src="data:video/mp4;base64,{data}"></video>'


def _plot(plot: Plot) -> str:
    kind = "image/svg+xml" if plot.path.suffix == ".svg" else "image/png"
    data = base64.b64encode(plot.path.read_bytes()).decode()
    image = f'<img class="plot" alt="{escape(plot.caption)}" src="data:{kind};base64,{data}">'
    return f"<figure>{image}<figcaption>{escape(plot.caption)}</figcaption></figure>"
