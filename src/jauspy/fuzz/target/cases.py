"""The cases of a campaign against a target: which messages it takes in each state, and the datagrams made of them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from random import Random
from typing import Final

from jauspy.conformance.profile import ServiceKey
from jauspy.conformance.state_tests.behaviour import ComponentUnderTest, Situation, component_under_test
from jauspy.conformance.state_tests.plan import Routes
from jauspy.conformance.steering import Path
from jauspy.conformance.tester import CLIENTS, CONTROLLER, OBSERVER, OTHER_CLIENT
from jauspy.errors import ConfigError
from jauspy.fuzz.messages import FuzzTarget, MessageMaker, Style, targets
from jauspy.fuzz.mutation import Seed, from_schemas, mutate, offsets_of
from jauspy.fuzz.target.damage import Packer
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import Shutdown
from jauspy.protocol.header import Ack
from jauspy.schema.loader import load_needed

EPISODE: Final = 20
"""Cases in one state, before the target is brought to the next one."""
ENDING: Final = Shutdown.CODE.to_bytes(2, "little")
"""The id of the message that ends a component by right; no case has it."""
SENDERS: Final = tuple(JausID.parse(CLIENTS[role]) for role in (CONTROLLER, CONTROLLER, OTHER_CLIENT, OBSERVER))
MAX_MESSAGE: Final = 20_000
"""Bytes of a message of a case: several fragments."""


@dataclass(frozen=True, slots=True)
class Stop:
    """A state of the target on the walk, and the inputs that lead there."""

    situation: Situation | None
    path: Path
    legal: tuple[int, ...]
    """Messages, by their place in `Cases.messages`, which this state handles."""


class Cases:
    """The cases against one component. A case depends on `services`, `seed` and its number only."""

    def __init__(
        self, component: JausID, services: frozenset[ServiceKey], seed: int, only: Collection[str] = ()
    ) -> None:
        self.subject: ComponentUnderTest = component_under_test(component, services)
        inputs = {
            (definition.id, definition.version, message.name)
            for definition in self.subject.definitions
            for message in definition.inputs
        }
        found = targets(registry, load_needed(services), only)
        self.messages = tuple(each for each in found if _key(each) in inputs and each.id != ENDING)
        if not self.messages:
            raise ConfigError(f"{component} takes none of these messages")
        self._seed = seed
        self._seeds = [made for made in from_schemas(self.messages) if not made.data.startswith(ENDING)]
        self._seeds_of: dict[int, list[Seed]] = {}
        for made in self._seeds:
            self._seeds_of.setdefault(made.target, []).append(made)
        self.stops = tuple(self._stops())

    def stop(self, number: int) -> Stop:
        """The state in which a case is sent."""
        return self.stops[number // EPISODE % len(self.stops)]

    def datagrams(self, number: int) -> list[bytes]:
        """The datagrams of one case: a legal message, a damaged one, a damaged header, or damaged fragments."""
        rng = Random(self._seed << 40 | number)  # noqa: S311 - chance, not secrets
        packer = Packer(self.subject.component, 0x8000 + 31 * number)
        place, source, kind = self._place(rng, number), rng.choice(SENDERS), rng.random()
        payload = self._payload(rng, place, is_damaged=0.25 < kind < 0.75)
        if payload.startswith(ENDING):
            payload = self.messages[place].id
        if kind < 0.75:
            return packer.whole(payload, source, ack=Ack.REQUIRED if rng.random() < 0.1 else Ack.NONE)
        if kind < 0.9:
            return packer.damaged(rng, payload, source)
        return packer.fragments(rng, payload, source)

    def _place(self, rng: Random, number: int) -> int:
        """A message: in 70 % of cases one that the present state handles."""
        legal = self.stop(number).legal
        return rng.choice(legal) if legal and rng.random() < 0.7 else rng.randrange(len(self.messages))

    def _payload(self, rng: Random, place: int, *, is_damaged: bool) -> bytes:
        target = self.messages[place]
        if not is_damaged:
            return MessageMaker(rng, Style.ANY, self.messages).message(target)[:MAX_MESSAGE]
        if rng.random() < 0.7:
            return mutate(rng, rng.choice(self._seeds_of[place]), self._seeds)[:MAX_MESSAGE]
        data = MessageMaker(rng, Style.ANY, self.messages).message(target)
        return mutate(rng, Seed(place, data, offsets_of(target.layout, data)), self._seeds)[:MAX_MESSAGE]

    def _stops(self) -> Iterator[Stop]:
        """Every state that the merged state machine of the target has a way to and back."""
        machine = self.subject.machine
        routes = Routes(machine)
        for situation, path in routes.paths().items():
            if routes.returns(situation):
                yield Stop(situation, path, self._legal(situation.state))

    def _legal(self, state: Sequence[str]) -> tuple[int, ...]:
        names = {
            rule.trigger
            for rule in self.subject.machine.rules
            if rule.is_input and tuple(state[: len(rule.node.path)]) == rule.node.path
        }
        return tuple(place for place, message in enumerate(self.messages) if message.cls.NAME in names)


def _key(target: FuzzTarget) -> tuple[str, str, str]:
    return target.cls.SERVICE, target.cls.VERSION, target.cls.NAME
