"""How many pages may be open: only those that connect keep others out."""

from __future__ import annotations

import pytest

pytest.importorskip("cryptography", reason="needs the extra 'console'")

from jauspy.console.open_pages import MAX_PAGES, MAX_PAGES_OF_SESSION, OpenPages
from jauspy.console.users import LOCAL


def connected(pages: OpenPages, session: str) -> str | None:
    token = pages.add(LOCAL, session, lambda: None)
    if token is not None:
        pages.connected(token)
    return token


def test_pages_that_never_connect_are_given_up_for_others() -> None:
    pages, removed = OpenPages(), list[int]()
    for number in range(10 * MAX_PAGES):
        assert pages.add(LOCAL, "one", lambda number=number: removed.append(number)) is not None  # type: ignore[misc]
    assert len(pages) == MAX_PAGES_OF_SESSION
    assert removed == list(range(10 * MAX_PAGES - MAX_PAGES_OF_SESSION)), "the oldest first"


def test_a_session_has_a_share_of_the_pages() -> None:
    pages = OpenPages()
    own = [connected(pages, "one") for _ in range(MAX_PAGES_OF_SESSION + 1)]
    assert own[-1] is None
    assert connected(pages, "other") is not None
    assert own[0] is not None
    pages.forget(own[0])
    assert connected(pages, "one") is not None


def test_all_places_are_for_pages_that_connect() -> None:
    pages = OpenPages()
    for number in range(MAX_PAGES):
        pages.add(LOCAL, number % 4, lambda: None)
    tokens = [connected(pages, f"user {number % 8}") for number in range(MAX_PAGES)]
    assert None not in tokens
    assert len(pages) == MAX_PAGES
    assert connected(pages, "one more") is None
    assert pages.add(LOCAL, "one more", lambda: None) is None
