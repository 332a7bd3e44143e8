"""Elements of service definitions, and how they are written: lines of at most 120 characters."""

from __future__ import annotations

from dataclasses import dataclass, field
from textwrap import wrap
from xml.sax.saxutils import escape, quoteattr

WIDTH = 120


@dataclass
class Xml:
    """An element; attributes keep their order."""

    tag: str
    attributes: dict[str, str] = field(default_factory=dict)
    children: list[Xml] = field(default_factory=list)
    text: str = ""

    def lines(self, depth: int = 0) -> list[str]:
        """The element as lines of at most 120 characters."""
        indent = "  " * depth
        pairs = [f"{name}={quoteattr(value)}" for name, value in self.attributes.items()]
        end = ">" if self.children or self.text else "/>"
        rows, row = [], f"{indent}<{self.tag}"
        for number, pair in enumerate(pairs):
            last = len(end) if number == len(pairs) - 1 else 0
            if len(row) + 1 + len(pair) + last > WIDTH and row.strip():
                rows.append(row)
                row = f"{indent}    {pair}"
            else:
                row += f" {pair}"
        rows.append(row + end)
        rows = [part for row in rows for part in _wrapped_row(row, f"{indent}        ")]
        if self.text:
            text = escape(self.text)
            if len(rows[-1]) + len(text) + len(self.tag) + 3 <= WIDTH:
                rows[-1] += f"{text}</{self.tag}>"
            else:
                rows += [f"{indent}  {part}" for part in wrap(text, WIDTH - 2 * depth - 2)] + [f"{indent}</{self.tag}>"]
        elif self.children:
            rows += [line for child in self.children for line in child.lines(depth + 1)] + [f"{indent}</{self.tag}>"]
        return rows

    def content(self) -> str:
        """Everything that matters on the wire: no descriptions, and of itself not whether it is optional."""
        attributes = {
            name: value for name, value in self.attributes.items() if name not in ("interpretation", "optional")
        }
        return _content(self, attributes)

    def unnamed(self) -> str:
        """The same without its own name."""
        return Xml(self.tag, {**self.attributes, "name": ""}, self.children).content()


def _content(xml: Xml, attributes: dict[str, str]) -> str:
    inner = "".join(
        _content(child, {name: value for name, value in child.attributes.items() if name != "interpretation"})
        for child in xml.children
    )
    return f"<{xml.tag} {sorted((name, _number(value)) for name, value in attributes.items())}>{inner}</>"


def _wrapped_row(row: str, indent: str) -> list[str]:
    """A line of attributes; a long value goes on in the next line, which readers take for a blank."""
    if len(row) <= WIDTH:
        return [row]
    return wrap(row, WIDTH, initial_indent="", subsequent_indent=indent, drop_whitespace=True, break_long_words=False)


def _number(text: str) -> str:
    try:
        return repr(float(text))
    except ValueError:
        return text
