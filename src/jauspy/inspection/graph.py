"""Who talks to whom: the components that were seen, and the messages between them; as text, DOT or SVG."""

from __future__ import annotations

import math
from collections import Counter
from html import escape
from typing import Final

from jauspy.inspection.rates import Rates
from jauspy.printable import printable

MAX_NAMES: Final = 4
"""Names of messages at an arrow; the most frequent ones."""
NODE_WIDTH, NODE_HEIGHT = 110, 34


class Graph:
    """Arrows between components, with the messages of each."""

    def __init__(self, rates: Rates) -> None:
        self._seconds = max(rates.seconds, 1e-3)
        self.arrows: dict[tuple[str, str], Counter[str]] = {}
        """Numbers of messages by name, by sender and receiver."""
        for route, rate in sorted(rates.routes.items()):
            self.arrows.setdefault((route.source, route.destination), Counter())[route.message] += rate.count

    @property
    def components(self) -> list[str]:
        """The components and patterns of components, in the order of their ids."""
        names = {name for arrow in self.arrows for name in arrow}
        return sorted(names, key=lambda name: [int(part) if part.isdigit() else -1 for part in name.split(".")])

    def lines(self) -> list[str]:
        """A line for each arrow, the busiest first."""
        arrows = sorted(self.arrows.items(), key=lambda item: -item[1].total())
        width = max((len(f"{source} → {destination}") for (source, destination), _ in arrows), default=0)
        return [
            f"{f'{source} → {destination}':<{width}}  {counts.total() / self._seconds:8.1f}/s  {self._label(counts)}"
            for (source, destination), counts in arrows
        ]

    def dot(self) -> str:
        """The graph in Graphviz's language."""
        rows = [f'  "{name}" [shape=box];' for name in self.components]
        for (source, destination), counts in self.arrows.items():
            label = self._label(counts).replace("\\", "\\\\").replace('"', '\\"')
            rows.append(f'  "{source}" -> "{destination}" [label="{label}"];')
        return "\n".join(["digraph jaus {", "  rankdir=LR;", *rows, "}"])

    def svg(self) -> str:
        """A drawing: components in a circle, arrows as wide as their rates, names of messages as tool tips."""
        names = self.components
        radius = max(150.0, 60.0 * len(names) / math.pi)
        size = 2.0 * radius + 2.0 * NODE_WIDTH
        center = size / 2.0
        places = {}
        for number, name in enumerate(names):
            angle = 2.0 * math.pi * number / max(1, len(names)) + math.pi
            places[name] = center + radius * math.cos(angle), center + radius * math.sin(angle)
        body = [self._arrow(places[s], places[d], counts) for (s, d), counts in self.arrows.items()]
        body += [_node(name, *places[name]) for name in names]
        style = (
            "svg{background:#fff}.n{fill:#eef3fa;stroke:#3c5a80}"
            ".t{font:13px sans-serif;fill:#16202c;text-anchor:middle}.a{fill:none;stroke:#5b7ba5;opacity:.8}"
            ".r{font:11px sans-serif;fill:#43536a;text-anchor:middle;paint-order:stroke;stroke:#fff;stroke-width:5px}"
            "@media(prefers-color-scheme:dark){svg{background:#14181d}.n{fill:#22303f;stroke:#7fa3d1}"
            ".t{fill:#e8eef5}.r{fill:#b4c2d3;stroke:#14181d}}"
        )
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size:.0f} {size:.0f}" width="{size:.0f}">'
            f'<style>{style}</style><defs><marker id="h" viewBox="0 0 8 8" refX="7" refY="4" '
            'markerWidth="9" markerHeight="9" markerUnits="userSpaceOnUse" orient="auto">'
            f'<path d="M0 0L8 4L0 8z" fill="#5b7ba5"/></marker></defs>{"".join(body)}</svg>'
        )

    def _label(self, counts: Counter[str]) -> str:
        names = [f"{printable(name)} {count / self._seconds:.3g}/s" for name, count in counts.most_common(MAX_NAMES)]
        return ", ".join(names) + (f", {len(counts) - MAX_NAMES} more" if len(counts) > MAX_NAMES else "")

    def _shortest_label(self, counts: Counter[str]) -> str:
        (name, _), *others = counts.most_common()
        return printable(name) + (f" and {len(others)} more" if others else "")

    def _arrow(self, start: tuple[float, float], end: tuple[float, float], counts: Counter[str]) -> str:
        rate = counts.total() / self._seconds
        width = min(6.0, 1.0 + math.log10(1.0 + rate))
        middle = ((start[0] + end[0]) / 2.0, (start[1] + end[1]) / 2.0)
        dx, dy = end[0] - start[0], end[1] - start[1]
        length = math.hypot(dx, dy) or 1.0
        bend = 0.12 * length  # both directions of a pair bend to different sides
        if start == end:  # a component that sends to itself, or a pattern of ids
            start, end, bend = (start[0] - 30.0, start[1]), (end[0] + 30.0, end[1]), -80.0
            dx, dy, length = 60.0, 0.0, 60.0
        control = middle[0] - dy / length * bend, middle[1] + dx / length * bend
        first, last = _edge(start, control), _edge(end, control)
        x, y = (0.25 * (a + b) + 0.5 * c for a, b, c in zip(start, end, control, strict=True))
        path = "M{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}".format(*first, *control, *last)
        return (
            f"<g><title>{escape(self._label(counts))}</title>"
            f'<path class="a" stroke-width="{width:.1f}" marker-end="url(#h)" d="{path}"/>'
            f'<text class="r" x="{x:.1f}" y="{y:.1f}">{rate:.3g}/s</text>'
            f'<text class="r" x="{x:.1f}" y="{y + 14:.1f}">{escape(self._shortest_label(counts))}</text></g>'
        )


def _edge(node: tuple[float, float], toward: tuple[float, float]) -> tuple[float, float]:
    """Where a line from the middle of a node leaves its box."""
    dx, dy = toward[0] - node[0], toward[1] - node[1]
    scale = min(
        NODE_WIDTH / 2.0 / abs(dx) if dx else math.inf,
        NODE_HEIGHT / 2.0 / abs(dy) if dy else math.inf,
    )
    return node[0] + min(1.0, scale) * dx, node[1] + min(1.0, scale) * dy


def _node(name: str, x: float, y: float) -> str:
    left, top = x - NODE_WIDTH / 2.0, y - NODE_HEIGHT / 2.0
    return (
        f'<rect class="n" x="{left:.1f}" y="{top:.1f}" width="{NODE_WIDTH}" height="{NODE_HEIGHT}" rx="5"/>'
        f'<text class="t" x="{x:.1f}" y="{y + 4:.1f}">{escape(name)}</text>'
    )
