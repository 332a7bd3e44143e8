"""Texts as the messages of the cell carry them."""

from __future__ import annotations

from typing import Final

MAX_LENGTH: Final = 255
"""Characters of a counted string in the messages of the cell."""


def sent_text(text: str) -> str:
    """The text in Latin-1, with question marks for other characters; cut off with an ellipsis where it is too long."""
    sent = text.encode("latin-1", errors="replace").decode("latin-1")
    return sent if len(sent) <= MAX_LENGTH else f"{sent[: MAX_LENGTH - 3]}..."
