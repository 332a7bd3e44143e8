"""Values that a definition does not name or allow reach every service: each is counted, and tolerated or refused.

No action fails, and whoever is answered for a valid message is answered for this one.
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Iterable, Iterator
from random import Random
from typing import Any, Final

import pytest
from tests.helpers.memory_cell import MemoryBackend

from jauspy.codec.items import Bits, Choice, Formatted, Item, Number, Values
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Message
from jauspy.codec.scalars import FLOATS, limits
from jauspy.fuzz.messages import MessageMaker, Style, targets
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import RejectEventRequest, RequestControl, Resume
from jauspy.robot.kinds import KINDS
from jauspy.robot.robot_files import load
from jauspy.robot.runner import RobotRunner
from jauspy.schema import load_builtin
from jauspy.services.core import AccessControl, Discovery, Events, Liveness, Management, Time
from jauspy.services.host import Host
from jauspy.testing import VirtualNetwork
from jauspy.virtual.environment import VirtualTime

CLIENT: Final = JausID(42, 1, 1)
TARGETS: Final = {each.cls: each for each in targets(registry, load_builtin())}
MAX_SEEDS: Final = 40
NUMBERS: Final = {"sensor_id": 1, "element_uid": 1, "previous_uid": 0, "next_uid": 0}
"""Fields that are to have a value with which a service does something."""

UNANSWERED: Final = {"SetPlatformState.platform_state"}
"""Fields whose value selects the transition, so that the definition answers only those that it names."""

Put = Callable[[Any], None]


def undefined(values: Values, low: int, high: int) -> list[int]:
    """The highest value that is not allowed, and the lowest two."""
    if values.anything:
        return []
    lowest = [value for value in range(max(0, low), min(high, 300) + 1) if not values.allows(value)]
    return [*([high] if not values.allows(high) else []), *lowest[:2]]


def variants(item: Item, value: Any, put: Put, path: str) -> Iterator[str]:
    """Give each field with a value set each undefined value in turn; what was put last, and where, is the path."""
    match item:
        case Composite():
            for slot in item.slots:
                part = getattr(value, slot.name)
                if part is not None:
                    yield from variants(slot.item, part, setter(value, slot.name), f"{path}.{slot.name}")
        case Number() if item.code not in FLOATS:
            yield from replaced(undefined(item.values, *limits(item.code)), value, put, path)
        case Bits():
            for bit in item.bits:
                values = undefined(bit.values, 0, bit.mask)
                yield from replaced(values, getattr(value, bit.name), setter(value, bit.name), f"{path}.{bit.name}")
        case Union():
            for name, arm in item.arms.items():
                if type(value) is arm.cls:
                    yield from variants(arm, value, put, f"{path}.{name}")
        case Repeat() if value:
            yield from variants(item.item, value[0], lambda new: value.__setitem__(0, new), f"{path}[]")
        case Choice():
            yield from variants(item.items[value.choice], value.value, setter(value, "value"), path)
        case Formatted():
            value.data = value.data.encode() if isinstance(value.data, Message) else value.data
            yield from replaced(undefined(item.formats, 0, 255), value.format, setter(value, "format"), path)


def replaced(values: Iterable[int], usual: Any, put: Put, path: str) -> Iterator[str]:
    for value in values:
        put(value)
        yield path
    put(usual)


def setter(owner: Any, name: str) -> Put:
    return lambda value: setattr(owner, name, value)


def places(item: Item, path: str) -> Iterator[str]:
    """The fields of a layout that have undefined values."""
    match item:
        case Composite():
            for slot in item.slots:
                yield from places(slot.item, f"{path}.{slot.name}")
        case Number() if item.code not in FLOATS and undefined(item.values, *limits(item.code)):
            yield path
        case Bits():
            yield from (f"{path}.{bit.name}" for bit in item.bits if undefined(bit.values, 0, bit.mask))
        case Union():
            for name, arm in item.arms.items():
                yield from places(arm, f"{path}.{name}")
        case Repeat() | Grid():
            yield from places(item.item, f"{path}[]")
        case Formatted() if undefined(item.formats, 0, 255):
            yield path


def tame(item: Item, value: Any) -> None:
    """Let the numbers of sensors and elements be those of some that are there."""
    match item:
        case Composite():
            for slot in item.slots:
                part = getattr(value, slot.name)
                if slot.name in NUMBERS and isinstance(part, int):
                    setattr(value, slot.name, NUMBERS[slot.name])
                elif part is not None:
                    tame(slot.item, part)
        case Union():
            for arm in item.arms.values():
                if type(value) is arm.cls:
                    tame(arm, value)
        case Repeat():
            del value[1:]
            for part in value:
                tame(item.item, part)


class Sender:
    """A client in control that sends everything to one component."""

    def __init__(self, host: Host, now: Callable[[], float]) -> None:
        self.host = host
        self.now = now
        self.tried: set[str] = set()

    def send(self, data: bytes) -> list[int]:
        """The ids of the answers."""
        self.host.receive(data, CLIENT, self.now())
        found = self.host.poll_output(self.now())
        return [int.from_bytes(each.payload[:2], "little") for each in found if each.destination == CLIENT]

    def try_all(self) -> None:
        """Every input of the component, with every undefined value, in control and Ready."""
        inputs = [kind for kind in self.host._bound.inputs.values() if kind in TARGETS]
        queries = [TARGETS[kind] for kind in inputs if kind.IS_QUERY][:8]
        for kind in inputs:
            wanted = set(places(kind.layout(), kind.NAME))
            for seed in range(MAX_SEEDS):
                if not wanted - self.tried and (seed > 2 or not wanted):
                    break
                self._try(kind, MessageMaker(Random(seed), [Style.FULL, Style.ANY][seed % 2], queries))
            assert not wanted - self.tried, "each field was tried"

    def _try(self, kind: type[Message], maker: MessageMaker) -> None:
        message = registry.decode_as(kind, maker.message(TARGETS[kind]))
        tame(kind.layout(), message)
        self._take_control()
        usual = self.send(message.encode(strict=False))
        for path in variants(kind.layout(), message, setter(None, ""), kind.NAME):
            self.tried.add(path)
            self._take_control()
            before = self.host.counters[f"deviating_{kind.NAME}"]
            answers = self.send(message.encode(strict=False))
            assert self.host.counters[f"deviating_{kind.NAME}"] == before + 1, path
            assert answers or not usual or path in UNANSWERED, f"{path} is answered: {message}"
            if path == "CreateEvent.event_type":
                assert RejectEventRequest.CODE in answers
            assert self.host.counters["action_failed"] == 0, f"{path}: {message}"

    def _take_control(self) -> None:
        for message in (RequestControl(255), Resume()):
            self.send(message.encode())


@pytest.fixture(autouse=True)
def _quiet() -> None:
    logging.getLogger("jauspy.services").setLevel(logging.ERROR)


@pytest.mark.slow
async def test_every_service_of_a_robot() -> None:
    running: set[str] = set()
    backend = MemoryBackend()
    async with VirtualNetwork() as network, network.robot("inc1") as inc1:
        cell = RobotRunner(load("cell"), network.transport, backend=backend, realtime=VirtualTime)
        async with cell:
            backend.robot.assemble("servo_1")
            async with asyncio.timeout(5.0):
                while not any(module.part == "servo_1" for _, module in cell.running):
                    await asyncio.sleep(0.05)
            kinds_of_modules = {module.type: component for component, module in cell.running}
            for component in (*inc1.components, *kinds_of_modules.values()):
                Sender(component.host, network.now).try_all()
                assert component.host.counters["unencodable"] == 0
                running |= {each.name for each in component.host.definitions.values()}
    elsewhere = {
        "DataLogging",
        "SubsystemIDAllocator",
    }  # need a folder or are to be listed; they have tests of their own
    others = {name for kind in KINDS.values() for name in kind.services} - running - elsewhere
    inputs = {(each.name, *own.key) for own in load_builtin().services if own.name in others for each in own.inputs}
    kinds = [kind for kind in registry if (kind.NAME, kind.SERVICE, kind.VERSION) in inputs]
    assert kinds, "services that this robot does not have"
    assert [place for kind in kinds for place in places(kind.layout(), kind.NAME)] == [], "have nothing to try"


def test_core_services_of_version_1_0(make: Any) -> None:
    rig = make(Discovery(), Liveness(), Time(), Management(), AccessControl(), Events())
    Sender(rig.host, lambda: rig.now).try_all()
