"""The pages in docs/, and the programs in them."""

from __future__ import annotations

import re
import textwrap
from pathlib import Path

DOCS = Path(__file__).parents[2] / "docs"


def program(name: str, beginning: str) -> str:
    """The indented block of a page that begins so."""
    blocks = (
        textwrap.dedent(each) for each in re.findall(r"(?:^ {4}.*\n|^\n)+", (DOCS / name).read_text(), re.MULTILINE)
    )
    (found,) = [each.strip() for each in blocks if each.strip().startswith(beginning)]
    return found
