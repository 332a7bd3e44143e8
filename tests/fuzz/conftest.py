"""Campaigns against one message, in which bugs can be planted."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from jauspy.fuzz.campaign import CampaignPlan, run
from jauspy.fuzz.findings import FuzzFinding
from jauspy.messages.core import RegisterServices

Decode = Callable[[bytes, int], Any]


@pytest.fixture
def plant(monkeypatch: pytest.MonkeyPatch) -> Callable[[Callable[[Decode, bytes], Any]], None]:
    """Puts a function around the straight-line decoder of RegisterServices; it gets that decoder and the bytes."""

    def put(bug: Callable[[Decode, bytes], Any]) -> None:
        RegisterServices.decode(RegisterServices([]).encode())  # the decoder is made when it is first called
        right = RegisterServices._unpack
        monkeypatch.setattr(RegisterServices, "_unpack", lambda data, nesting: bug(right, data))

    return put


@pytest.fixture
def hunt() -> Callable[..., list[FuzzFinding]]:
    """The findings of a campaign against RegisterServices."""

    def find(cases: int = 400, seed: int = 1) -> list[FuzzFinding]:
        return list(run(CampaignPlan(cases, seed, only=("RegisterServices",))).findings.values())

    return find
