"""Docstrings as help texts."""

from __future__ import annotations

import inspect
import re


def help_text(doc: str) -> str:
    """A docstring's paragraphs as one line each, for the help to wrap; indented lines (examples) stay lines."""
    paragraphs = inspect.cleandoc(doc).split("\n\n")
    return "\n\n".join(re.sub(r"\n(?! )", " ", paragraph) for paragraph in paragraphs)
