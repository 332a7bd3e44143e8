"""Profiles: named steps, each a function of a tester."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from importlib.metadata import EntryPoint, entry_points
from typing import Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.conformance.checks import Check
from jauspy.conformance.offers import Offers
from jauspy.conformance.tester import Tester
from jauspy.errors import ConfigError
from jauspy.ids import JausID

GROUP: Final = "jauspy.conformance"
"""Group of entry points: a name and the location of a `Profile`."""

BUILT_IN: Final = {
    "core-1.1": "jauspy.conformance.state_tests.plan:CORE",
    "cell-1.0": "jauspy.conformance.state_tests.plan:CELL",
    "mobility-1.1": "jauspy.conformance.state_tests.plan:MOBILITY",
    "manipulator-2.0": "jauspy.conformance.state_tests.plan:MANIPULATOR",
    "sensing-2.0": "jauspy.conformance.state_tests.plan:SENSING",
    "ugv-1.0": "jauspy.conformance.state_tests.plan:UGV",
    "transport": "jauspy.conformance.profiles.transport:PROFILE",
    "igvc-2011": "jauspy.conformance.profiles.igvc_2011:PROFILE",
    "igvc-2015": "jauspy.conformance.profiles.igvc_2015:PROFILE",
}
"""Locations of the included profiles, which are imported when they are used."""

Action: TypeAlias = Callable[[Tester], object]
"""The function of a step; raises a `StepOutcome` unless the step passes."""


@dataclass(frozen=True, slots=True)
class Step:
    """One step. `id` is unique in its profile."""

    id: str
    title: str
    run: Action
    points: float = 0.0
    why: str = ""
    """Source of the expectation, such as a state or a rule, if the messages do not show it."""
    moves: bool = False
    """True if the robot drives in this step; `--no-motion` omits it."""
    wants: frozenset[str] = field(default=frozenset())
    """Required features of the wire."""
    transitions: tuple[str, ...] = ()
    """Transitions of the target's state machines that the step may take."""


Plan: TypeAlias = Callable[[Offers], Sequence[Step]]
"""Makes the steps for the services of a target."""


@dataclass(frozen=True, slots=True)
class Profile:
    """A test of one standard or competition.

    `steps` are the same for every target, or made by a function from what the target offers (`Offers`). Such a
    function may raise `ConfigError` when there is nothing to test.
    """

    name: str
    title: str
    steps: tuple[Step, ...] | Plan
    notes: tuple[str, ...] = ()
    """Notes for the readers of its reports."""
    one_component: bool = False
    """True if all steps need one component; then several that answer to a wildcard are an error before the first."""

    @property
    def asks_for_services(self) -> bool:
        """True if the steps depend on the services of the target."""
        return callable(self.steps)

    def plan(self, offers: Offers) -> tuple[Step, ...]:
        """The steps for a target; raises `ConfigError` when two have the same id."""
        steps = tuple(self.steps(offers)) if callable(self.steps) else self.steps
        twice = sorted(id for id, count in Counter(step.id for step in steps).items() if count > 1)
        if twice:
            raise ConfigError(f"conformance profile {self.name!r} has two steps {twice[0]!r}; ids must be unique")
        return steps


def ask(
    client: str,
    message: Message | bytes,
    answer: type[Message],
    *checks: Check | Iterable[Check],
    to: JausID | None = None,
) -> Action:
    """A step in which a client sends a message and receives the right answer."""
    return lambda tester: tester.client(client).ask(message, answer, *checks, to=to)


def tell(client: str, message: Message | bytes) -> Action:
    """A step in which a client sends a message that has no answer."""

    def action(tester: Tester) -> None:
        tester.client(client).send(message)
        tester.client(client).silence()

    return action


def known() -> list[str]:
    """The names of the included profiles and of those that installed packages register."""
    return sorted({*BUILT_IN, *(entry.name for entry in entry_points(group=GROUP))})


def find(name: str) -> Profile:
    """The profile with a name or location, as in `acme.brakes:PROFILE`.

    Raises `ConfigError` that lists the profiles, or says why one cannot be loaded.
    """
    if re.fullmatch(r"[\w.]+:\w+", name):
        return _loaded(EntryPoint(name, name, GROUP))
    if name in BUILT_IN:
        return _loaded(EntryPoint(name, BUILT_IN[name], GROUP))
    for entry in entry_points(group=GROUP, name=name):
        return _loaded(entry)
    raise ConfigError(f"no conformance profile {name!r}; there are: {', '.join(known())}; MODULE:NAME is one of yours")


def _loaded(entry: EntryPoint) -> Profile:
    which = entry.name if entry.name == entry.value else f"{entry.name!r} ({entry.value})"
    try:
        profile = entry.load()
    except Exception as error:
        what = f"{type(error).__name__}: {error}"
        raise ConfigError(f"conformance profile {which} cannot be loaded: {what}") from error
    if not isinstance(profile, Profile):
        raise ConfigError(f"conformance profile {which} is no Profile")
    return profile
