"""Parametrised sweeps: a sample of the cases runs in `make test`, the others in `make test-slow`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest


def sampled(cases: Sequence[Any], fast: int) -> list[Any]:
    """All cases for `parametrize`; `fast` of them, spread evenly, are fast and the others are marked slow."""
    step = max(1.0, len(cases) / fast)
    chosen = {int(index * step) for index in range(min(fast, len(cases)))}
    return [case if index in chosen else pytest.param(case, marks=pytest.mark.slow) for index, case in enumerate(cases)]
