"""Ends the browser of a module."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Iterator

import pytest

BROWSER = "tests.helpers.browser"


def close_chromium() -> None:
    if BROWSER in sys.modules:  # not where playwright or the extra `console` is missing
        sys.modules[BROWSER].close_chromium()


@pytest.fixture(scope="module", autouse=True)
def browser_of_the_module() -> Iterator[None]:
    yield
    close_chromium()


@pytest.fixture(autouse=True)
def no_browser_beside_asyncio(request: pytest.FixtureRequest) -> None:
    """Playwright keeps a loop of its own running, beside which asyncio starts none."""
    if inspect.iscoroutinefunction(request.function):
        close_chromium()
