"""Runs the steps of a profile as pytest tests."""

from __future__ import annotations

import atexit
from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from typing import TYPE_CHECKING

from jauspy.conformance.link import TesterLink
from jauspy.conformance.profile import Offers, Profile, Step, find
from jauspy.conformance.results import Result, Verdict
from jauspy.conformance.runner import Settings, restore_target, results
from jauspy.conformance.tester import Tester
from jauspy.conformance.virtual_target import VirtualTarget
from jauspy.errors import ConfigError, JausError
from jauspy.ids import JausID
from jauspy.messages import registry

if TYPE_CHECKING:
    import pytest


def offers_of(virtual_target: VirtualTarget) -> Offers:
    """The services of the components of a virtual target, read without messages."""
    return Offers(
        {
            id: frozenset(definition.key for definition in component.host.definitions.values())
            for id, component in virtual_target.components.items()
        }
    )


def pytest_steps(
    profile: str | Profile,
    link: Callable[[], TesterLink],
    target: str,
    *,
    offers: Offers | None = None,
    settings: Settings | None = None,
) -> pytest.MarkDecorator:
    """Parametrise a test with `step`, once for each step of a profile; `step()` passes, fails or skips the test.

    `link` returns the `TesterLink` to the target; it is called once, before the first step, and all steps run on it, in
    order.
    Profiles whose steps depend on the target need `offers`: its services, by component.
    Raises `ConfigError` for an unknown profile, or if `offers` has no service that it tests.
    """
    import pytest  # noqa: PLC0415 - jauspy does not need it otherwise

    chosen = find(profile) if isinstance(profile, str) else profile
    if chosen.asks_for_services and offers is None:
        raise ConfigError(f"the steps of {chosen.name} depend on the services of the target; pass them as offers=")
    session = _Session(link, JausID.parse(target), settings or Settings(), chosen.plan(offers or Offers({})))
    tests = [pytest.param(session.test_of(number), id=step.id) for number, step in enumerate(session.steps)]
    return pytest.mark.parametrize("step", tests)


class _Session:
    """One target for all steps. The steps before a requested one are run first, in any order of pytest's calls.

    After the last one, or when the process ends, the target is left in Standby without a controller.
    """

    def __init__(
        self, link: Callable[[], TesterLink], target: JausID, settings: Settings, steps: Sequence[Step]
    ) -> None:
        self.steps = steps
        self._link = link
        self._target = target
        self._settings = settings
        self._tester: Tester | None = None
        self._running: Iterator[Result] = iter(())
        self._results: list[Result] = []
        self._problem: JausError | None = None
        """Reason why the steps that follow cannot be run."""
        self._closed = False

    def test_of(self, number: int) -> Callable[[], None]:
        """Return the function that the test calls."""

        def test() -> None:
            import pytest  # noqa: PLC0415 - jauspy does not need it otherwise

            result = self._result(number)
            if result.verdict is Verdict.SKIPPED:
                pytest.skip(result.reason)
            if result.verdict is not Verdict.PASS:
                pytest.fail(f"{result.verdict}: {result.reason}\nfrom {result.why}", pytrace=False)

        return test

    def _result(self, number: int) -> Result:
        if self._tester is None:
            self._tester = Tester(self._link(), self._target, registry=registry, timeout=self._settings.timeout)
            self._running = results(self.steps, self._tester, self._settings)
            atexit.register(self._close)
        try:
            self._results += islice(self._running, max(0, number + 1 - len(self._results)))
        except JausError as error:
            self._problem = error
        if len(self._results) == len(self.steps):
            self._close()
        if self._problem is not None and number >= len(self._results):
            raise self._problem
        return self._results[number]

    def _close(self) -> None:
        atexit.unregister(self._close)
        if self._tester is not None and not self._closed:
            self._closed = True
            restore_target(self._tester)
            self._tester.link.close()
