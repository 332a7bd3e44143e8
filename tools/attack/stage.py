"""What an attack meets: the victims as processes, and honest operators who query and drive the robot all the while."""

from __future__ import annotations

import contextlib
import json
import os
import pty
import socket
import tty
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Final

from jauspy.ids import JausID
from jauspy.node import status
from jauspy.protocol.seal import OperatorKey

from .attack import Layout, NotPossible, Victims
from .hosts import Host, Lan
from .processes import HONEST, PILOT, Honest, Victim
from .truth import Leg, Motion, Sample, judge

PORT: Final = 20794
METRICS: Final = PORT + 1
ROBOT_ID: Final = "101.1.102"
ARM_ID: Final = "101.1.104"
PLANNER_ID: Final = "101.1.130"
OPERATOR_ID: Final = "42.1.1"
"""Who queries the robot."""
PILOT_ID: Final = "42.1.2"
"""Who is in control of it, on the same machine."""
KEY: Final = b"the key of this network"
MULTICAST: Final = "239.255.7.7"
MULTICAST6: Final = "ff15::6a61:7573"
_STATUS_TIMEOUT: Final = 5.0
QUERY_RATE: Final = 50
"""Queries per second of the honest operator."""


class Stage:
    """Starts everything; `with Stage(...)` stops it."""

    def __init__(self, layout: Layout, lan: Lan, folder: Path, mutant: str = "") -> None:
        self.layout = layout
        self._mutant = mutant
        self.lan = lan
        self.folder = folder
        self.victims: list[Victim] = []
        self.line = -1
        """The attacker's end of a serial line."""
        self.pilot: Honest | None = None
        self._operator: Honest | None = None
        self._stack = contextlib.ExitStack()

    def __enter__(self) -> Stage:
        try:
            if self.layout.victims is Victims.ROBOT:
                self._start_robot()
            elif self.layout.victims is Victims.GATEWAYS and not self.lan.why_loopback:
                for name in ("robot", "gateway"):
                    self._start_node_manager(name, self._settings(name) | _gateway(self.lan.hosts[name]))
        except BaseException:
            self._stack.close()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self._stack.close()

    def root(self, host: str) -> Path:
        """The directory of the local sockets of a machine."""
        return self.folder / host

    @property
    def key_file(self) -> Path:
        """The file with the key, on a network that has one."""
        return self.folder / "lan.key"

    @property
    def operator_key(self) -> Path:
        """The key file of the operator, if the robot is sealed."""
        return self.folder / "alice.key"

    def counters(self) -> Counter[str]:
        """The counters of the robot's node manager; empty if they cannot be read."""
        path = str(self.root("robot") / status.SOCKET_NAME)
        try:
            with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as sock:
                sock.settimeout(_STATUS_TIMEOUT)
                sock.connect(path)
                document = b"".join(iter(lambda: sock.recv(1 << 16), b""))
            return Counter(json.loads(document)["counters"])
        except (OSError, ValueError):
            return Counter()

    # --- the operator ---------------------------------------------------------------------------------------------

    def begin(self) -> None:
        """The operator counts from now on, and the robot's motion is judged."""
        for honest in self._honest:
            honest.tell("begin")
        for victim in self.victims:
            victim.truth.begin()

    def end(self, *, may_be_taken: bool) -> tuple[int, int, float, Motion]:
        """Queries since `begin`, those not answered, the longest silence in seconds, and the motion by `judge`."""
        if self._operator is None:
            return 0, 0, 0.0, Motion()
        asked, answered, silence = self._operator.ask("end")
        return asked, asked - answered, silence, judge(self.samples(), self.legs(), PILOT_ID, may_be_taken=may_be_taken)

    def samples(self) -> list[Sample]:
        """Where the robot truly was since `begin`."""
        return next((found for victim in self.victims if (found := victim.truth.samples())), [])

    def legs(self) -> list[Leg]:
        """What the pilot has driven since `begin`."""
        return [] if self.pilot is None else [Leg(*leg) for leg in self.pilot.ask("end")["legs"]]

    @property
    def _honest(self) -> list[Honest]:
        return [each for each in (self._operator, self.pilot) if each is not None]

    # --- processes ------------------------------------------------------------------------------------------------

    @contextlib.contextmanager
    def apart(self) -> Iterator[None]:
        """Within this the attacker has the last processor and the victims have the others, as machines of their own."""
        processors = sorted(os.sched_getaffinity(0))
        victims = [*(each.pid for each in self.victims), *(each.pid for each in self._honest)]
        try:
            if len(processors) > 1:
                os.sched_setaffinity(0, processors[-1:])
                _confine(victims, processors[:-1])
            yield
        finally:
            os.sched_setaffinity(0, processors)
            _confine(victims, processors)

    def _start_robot(self) -> None:
        settings = self._settings("robot")
        if self.layout.keyed:
            self.key_file.write_bytes(KEY)
            self.key_file.chmod(0o600)
        else:
            settings |= self._more_doors()
        self._start_node_manager("robot", {**settings, **self.layout.settings})
        root = str(self.root("robot"))
        options = ("--backend", "kinematic", "--no-node-manager", "--local-root", root, "--verbose")
        self._start("robot", "robot", "stop it", "up", self._robot_file(), *options)
        self._start_operators()
        if self.layout.planner:
            self._start_planner(root)

    def _start_planner(self, root: str) -> None:
        """A planner that no operator controls yet."""
        if missing := [name for name in ("ompl", "coal", "ruckig") if find_spec(name) is None]:
            raise NotPossible(f"{', '.join(missing)} is not installed")
        planner = Victim(
            self.lan.hosts["robot"],
            self.folder,
            "planner",
            ("planner", ARM_ID, "--no-sensors", "--connect", f"local:{root}"),
            self._mutant,
        )
        self._stack.callback(planner.stop)
        self.victims.append(planner)
        planner.wait_until_logged("plans motions of")

    def _robot_file(self) -> str:
        """The robot; with `sealed`, one that takes commands of registered operators only."""
        if not self.layout.sealed:
            return "inc1"
        key = OperatorKey.generate()
        self.operator_key.write_bytes(key.pem())
        self.operator_key.chmod(0o600)
        (self.folder / "operators.toml").write_text(f'[operators.alice]\nrole = "supervisor"\nkey = "{key.public}"\n')
        path = self.folder / "sealed.toml"
        path.write_text('extends = "inc1"\noperators = "operators.toml"\n')
        return str(path)

    def _more_doors(self) -> dict[str, Any]:
        """Settings with TCP, IPv6, a serial line (a pseudo terminal), and metrics on the network."""
        self.line, device = pty.openpty()
        for end in (self.line, device):
            tty.setraw(end)
            self._stack.callback(os.close, end)
        os.set_blocking(self.line, False)
        doors: dict[str, Any] = {
            "tcp": True,
            "serial": [{"device": os.ttyname(device)}],
            "metrics": f"{self.lan.hosts['robot'].address}:{METRICS}",
        }
        if Path("/proc/sys/net/ipv6").exists():
            doors |= {"address6": "::", "multicast_group6": MULTICAST6}
        return doors

    def _start_node_manager(self, host: str, settings: Mapping[str, Any]) -> None:
        path = self.folder / f"{host}.toml"
        path.write_text(_toml({"log_level": "debug", **settings}))
        self._start(host, f"node manager of the {host}", "ready", "node-manager", "--config", str(path))

    def _start(self, host: str, name: str, ready: str, *arguments: str) -> None:
        victim = Victim(self.lan.hosts[host], self.folder, name, arguments, self._mutant)
        self._stack.callback(victim.stop)
        self.victims.append(victim)
        victim.wait_for(ready)

    def _settings(self, host: str) -> dict[str, Any]:
        settings: dict[str, Any] = {
            "address": self.lan.hosts[host].address,
            "port": PORT,
            "local_root": str(self.root(host)),
            "multicast_group": MULTICAST,
        }
        return settings | ({"key_file": str(self.key_file)} if self.layout.keyed else {})

    def _start_operators(self) -> None:
        """One that only queries, with a node manager, and one that is in control, by the same node manager."""
        host = self.lan.hosts["operator"]
        address = f"udp://{self.lan.hosts['robot'].address}:{PORT}"
        settings = self._settings("operator") | {"addresses": {"101.255.255": address}}
        self._operator = Honest(
            host,
            self.folder,
            HONEST,
            {"settings": settings, "id": OPERATOR_ID, "robot": ROBOT_ID, "rate": QUERY_RATE},
        )
        self._stack.callback(self._operator.kill)
        self._operator.wait_for("ready")
        key = str(self.operator_key) if self.layout.sealed else None
        connect = f"local:{self.root('operator')}"
        self.pilot = Honest(
            host,
            self.folder,
            PILOT,
            {"id": PILOT_ID, "connect": connect, "subsystem": JausID.parse(ROBOT_ID).subsystem, "operator": key},
        )
        self._stack.callback(self.pilot.kill)
        self.pilot.wait_for("ready")


def _confine(processes: Iterable[int], processors: Iterable[int]) -> None:
    """Let all threads of these processes run on these processors only."""
    for process in processes:
        for thread in Path(f"/proc/{process}/task").iterdir():
            with contextlib.suppress(ProcessLookupError):
                os.sched_setaffinity(int(thread.name), processors)


def _gateway(host: Host) -> dict[str, Any]:
    vehicle = {"name": "vehicle", "address": host.second, "port": PORT, "multicast_group": MULTICAST}
    return {"networks": [vehicle], "gateway": {"subsystem": 101, "inside": ["vehicle"]}}


def _toml(settings: Mapping[str, Any]) -> str:
    return "".join(f"{name} = {_value(value)}\n" for name, value in settings.items())


def _value(value: Any) -> str:
    """A value as TOML, which is written like JSON but for tables."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{json.dumps(key)} = {_value(each)}" for key, each in value.items()) + "}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_value, value)) + "]"
    return json.dumps(value)
