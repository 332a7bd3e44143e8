"""The pytest plugin: fixtures for tests of components and OCUs; see docs/testing.md.

pytest loads this in every project that has jauspy installed, so jauspy itself is imported only when a fixture is used.
"""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable, Iterator
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from jauspy.ocu import OCU
    from jauspy.robot.runner import RobotRunner
    from jauspy.testing import LocalNode, TestEnvironment, VirtualNetwork


def _asynchronous(function: Callable[..., AsyncIterator[Any]]) -> Any:
    """A fixture in the event loop of the test, in every mode of pytest-asyncio."""
    if find_spec("pytest_asyncio") is None:
        return pytest.fixture(name=function.__name__)(_without_asyncio)
    import pytest_asyncio  # noqa: PLC0415 - not needed by tests without these fixtures

    return pytest_asyncio.fixture(function)


def _without_asyncio() -> None:
    pytest.fail("this fixture needs pytest-asyncio: pip install pytest-asyncio", pytrace=False)


@pytest.fixture
def node_manager() -> Iterator[LocalNode]:
    """A node manager on 127.0.0.1 with its sockets in a temporary folder; it runs in its own thread."""
    from jauspy.testing import LocalNode  # noqa: PLC0415

    with LocalNode() as node:
        yield node


@_asynchronous
async def virtual_network() -> AsyncIterator[VirtualNetwork]:
    """A network in memory, on virtual time; a test fails when it leaves tasks or unhandled errors behind.

    It also fails when a service of a component raised an exception, unless `virtual_network.allow_errors` is true.
    """
    from jauspy.testing import VirtualNetwork  # noqa: PLC0415
    from jauspy.testing.assertions import no_leftovers  # noqa: PLC0415

    async with no_leftovers(), VirtualNetwork() as network:
        yield network
        network.check_services()


@pytest.fixture
def environment(request: pytest.FixtureRequest) -> TestEnvironment:
    """`node_manager` when the test uses it, else `virtual_network`; `ocu` and `robot` are in it."""
    names = {"node_manager", "virtual_network"} & set(request.fixturenames)
    if len(names) == 2:
        pytest.fail(
            "a test uses either node_manager, on real time, or virtual_network, on virtual time; not both",
            pytrace=False,
        )
    found: TestEnvironment = request.getfixturevalue(names.pop() if names else "virtual_network")
    return found


@_asynchronous
async def ocu(environment: TestEnvironment) -> AsyncIterator[OCU]:
    """An open OCU, 42.1.1, in `environment`."""
    async with environment.ocu() as opened:
        yield opened


@_asynchronous
async def robot(environment: TestEnvironment) -> AsyncIterator[RobotRunner]:
    """The robot `inc1`, subsystem 101, on the kinematic backend, in `environment`."""
    async with environment.robot() as running:
        yield running
