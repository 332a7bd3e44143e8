"""The pages that are open in browsers: a token and a user for each, and shares for each session."""

from __future__ import annotations

import secrets
from collections import Counter
from collections.abc import Callable, Hashable
from dataclasses import dataclass
from typing import Final

from jauspy.console.languages import ENGLISH
from jauspy.console.users import User

MAX_PAGES: Final = 64
MAX_PAGES_OF_SESSION: Final = 16


@dataclass(eq=False, slots=True)
class _Page:
    user: User
    session: Hashable
    remove: Callable[[], object]
    language: str
    is_connected: bool = False


class OpenPages:
    """Pages by their tokens. One that was requested and has not connected yet keeps no further one out."""

    def __init__(self) -> None:
        self._pages: dict[str, _Page] = {}

    def __len__(self) -> int:
        return len(self._pages)

    def add(self, user: User, session: Hashable, remove: Callable[[], object], language: str = ENGLISH) -> str | None:
        """A token for one more page; None when too many are connected.

        `remove` is called when the page is given up because it has not connected and others need its place.
        """
        own_pages = {token: page for token, page in self._pages.items() if page.session == session}
        if len(own_pages) >= MAX_PAGES_OF_SESSION and not self._give_up_oldest(own_pages):
            return None
        if len(self._pages) >= MAX_PAGES and not self._give_up_oldest(self._of_largest_session()):
            return None
        token = secrets.token_urlsafe(16)
        self._pages[token] = _Page(user, session, remove, language)
        return token

    def connected(self, token: str) -> None:
        """Handle the first connection of a page."""
        if token in self._pages:
            self._pages[token].is_connected = True

    def user(self, token: str) -> User | None:
        """The user of a page that is open."""
        page = self._pages.get(token)
        return None if page is None else page.user

    def language(self, token: str) -> str:
        """The code of the language of a page; English for one that is not open."""
        page = self._pages.get(token)
        return ENGLISH if page is None else page.language

    def forget(self, token: str) -> None:
        """Handle the end of a page."""
        self._pages.pop(token, None)

    def _of_largest_session(self) -> dict[str, _Page]:
        """The pages of the session with most that have not connected."""
        waiting = Counter(page.session for page in self._pages.values() if not page.is_connected)
        largest = max(waiting, key=lambda session: waiting[session], default=None)
        return {token: page for token, page in self._pages.items() if page.session == largest}

    def _give_up_oldest(self, pages: dict[str, _Page]) -> bool:
        """Give up the oldest of these pages that has not connected; false if all have."""
        token = next((token for token, page in pages.items() if not page.is_connected), None)
        if token is None:
            return False
        self._pages.pop(token).remove()
        return True
