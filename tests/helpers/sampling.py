"""Parametrised sweeps: a sample of the cases runs in `make test`, the others in `make test-slow`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest


def sampled(cases: Sequence[Any], fast: int, *, several: bool = False) -> list[Any]:
    """All cases for `parametrize`; `fast` of them, spread evenly, are fast and the others are marked slow.

    `several` says that a case is a tuple with a value for each of several parameters.
    """
    step = max(1.0, len(cases) / fast)
    chosen = {int(index * step) for index in range(min(fast, len(cases)))}
    return [
        pytest.param(*(case if several else [case]), marks=[] if index in chosen else [pytest.mark.slow])
        for index, case in enumerate(cases)
    ]
