"""Valid messages of all services, with random contents, to all components of a robot, of a client without control."""

from __future__ import annotations

from jauspy.fuzz.campaign import Fuzzer
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import RequestControl, SetAuthority
from jauspy.protocol import judp
from jauspy.protocol.header import MAX_PAYLOAD, Packet
from jauspy.schema import load_builtin

from ..arena import STRANGER, Arena
from ..attack import Attack, Attacker, Bounds

RATE = 1000
MODULES = tuple(JausID(101, 1, component) for component in range(102, 109))
_CONTROL = (RequestControl.CODE, SetAuthority.CODE)
"""With control, a stranger may do everything."""
_PREPARED = 4000


def run(arena: Arena) -> None:
    """Half of the messages are damaged; commands need control, which the stranger does not have."""
    fuzzer = Fuzzer(registry, load_builtin(), seed=arena.chance.randrange(1 << 20))
    cases = (fuzzer.case(number).data for number in range(_PREPARED))
    payloads = [
        each for each in cases if len(each) <= MAX_PAYLOAD and int.from_bytes(each[:2], "little") not in _CONTROL
    ]
    sock = arena.open(arena.attacker.udp())
    for number in arena.paced(RATE):
        payload = payloads[number % len(payloads)]
        destination = MODULES[number // 7 % len(MODULES)]
        arena.send(sock, judp.pack(Packet(STRANGER, destination, payload, number & 0xFFFF)))


BOUNDS = Bounds(descriptors=8, tasks=4, lines=1000, driven=0.0, control=0.0, may_be_taken=True)
"""Among the messages is SetEmergency, which anybody may send: the robot stops, and control ends with its
time-out; then anybody may take it.

A camera that somebody asks for video starts a process; each kind of malformed message is logged once a component."""
ATTACK = Attack("services", Attacker.REMOTE, "messages", run, BOUNDS, restarts=True)
