"""The pytest plugin: fixtures for tests of components and OCUs; see docs/testing.md.

pytest loads this in every project that has jauspy installed, so jauspy itself is imported only when a fixture is used.
"""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable, Iterator
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from jauspy.modules.robot import RobotRunner
    from jauspy.ocu import OCU
    from jauspy.testing import LocalNode, Place, VirtualNetwork


def _asynchronous(function: Callable[..., AsyncIterator[Any]]) -> Any:
    """A fixture that runs in the test's event loop, whatever mode pytest-asyncio is in."""
    if find_spec("pytest_asyncio") is None:
        return pytest.fixture(name=function.__name__)(_without_asyncio)
    import pytest_asyncio  # noqa: PLC0415 - not needed by tests without these fixtures

    return pytest_asyncio.fixture(function)


def _without_asyncio() -> None:
    pytest.fail("this fixture needs pytest-asyncio: pip install pytest-asyncio", pytrace=False)


@pytest.fixture
def node_manager() -> Iterator[LocalNode]:
    """A node manager on 127.0.0.1 and in a folder of its own, in a thread of its own."""
    from jauspy.testing import LocalNode  # noqa: PLC0415

    with LocalNode() as node:
        yield node


@_asynchronous
async def virtual_network() -> AsyncIterator[VirtualNetwork]:
    """A network in memory, on virtual time; fails a test that leaves tasks or unseen errors behind."""
    from jauspy.testing import VirtualNetwork  # noqa: PLC0415
    from jauspy.testing.strict import no_leftovers  # noqa: PLC0415

    async with no_leftovers(), VirtualNetwork() as network:
        yield network


@pytest.fixture
def place(request: pytest.FixtureRequest) -> Place:
    """`node_manager` when the test uses it, else `virtual_network`; `ocu` is there."""
    names = {"node_manager", "virtual_network"} & set(request.fixturenames)
    if len(names) == 2:
        pytest.fail(
            "a test uses either node_manager, on real time, or virtual_network, on virtual time; not both",
            pytrace=False,
        )
    found: Place = request.getfixturevalue(names.pop() if names else "virtual_network")
    return found


@_asynchronous
async def ocu(place: Place) -> AsyncIterator[OCU]:
    """An OCU, 42.1.1, on the node manager that the test uses, else on the virtual network."""
    async with place.ocu() as opened:
        yield opened


@_asynchronous
async def robot(place: Place) -> AsyncIterator[RobotRunner]:
    """The robot `inc1`, subsystem 101, on the kinematic backend, where `ocu` is."""
    async with place.robot() as running:
        yield running
