"""The node manager as an asyncio service: it only moves bytes between sockets and the core."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Mapping
from contextlib import AsyncExitStack
from functools import partial
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Final, Self

from jauspy.ids import JausID
from jauspy.node import keys, operations, policy, sweep
from jauspy.node.config import NodeConfig
from jauspy.node.ingress import Ingress
from jauspy.node.links import Links
from jauspy.node.mailboxes import Mailboxes, is_dead
from jauspy.node.network import Network
from jauspy.node.shortcuts import Send, Shortcuts
from jauspy.node.state import NodeState
from jauspy.node.sweep import Sweep
from jauspy.protocol import junior
from jauspy.protocol.addressing import GroupPort, LocalPort, Port, SerialPort, TcpPort, UdpPort
from jauspy.protocol.routing import Router
from jauspy.protocol.sources import SourceChecks
from jauspy.transport import draining, local_socket, memberships

if TYPE_CHECKING:
    from jauspy.node.mirror import Mirror

MAX_SENDERS: Final = 4096
"""Names of local sockets that are remembered."""
RELOADABLE: Final = ("gateway", "source_check", "rate_limit", "rate_burst", "addresses", "address_books")
"""Settings that `NodeManager.reload` takes over."""


class NodeManager:
    """Owns UDP 3794 and the multicast group on each network, and the local socket `<local_root>/JuniorRTE`.

    Use it as a context manager, or `open` and `close` it. `TransportError` when another one is running.
    """

    _loop: asyncio.AbstractEventLoop

    def __init__(self, config: NodeConfig | None = None) -> None:
        self.config = config or NodeConfig()
        self._known = self.config.known_addresses()
        dead = partial(is_dead, self.config.local_root)
        self._core = Router(
            str(self.config.local_root),
            addresses=self._known,
            address_lifetime=self.config.address_lifetime,
            local_udp=self.config.local_udp,
            compression=self.config.header_compression,
            is_dead=dead,
            networks=[network.name for network in self.config.all_networks],
            gateway=policy.gateway(self.config),
            sources=SourceChecks(policy.limits(self.config)),
            changed=self._changed,
        )
        self._shortcuts = Shortcuts(self._core, self._way_to)
        self._networks: dict[str, Network] = {}
        self._local: socket.socket | None = None
        self._ingress: Ingress | None = None
        self._mailboxes = Mailboxes(self.config.local_root, self._core)
        self._senders: dict[str | bytes | None, LocalPort] = {}
        self._mirror: Mirror | None = None
        self._mirrored: Port = LocalPort("")
        self._links = Links(self._core.counters, self.config.name, self._take, self._core.disconnected)
        self._timer: asyncio.TimerHandle | None = None
        self._watch: asyncio.TimerHandle | None = None
        self._sweep = Sweep(self._core.components, dead, self._mailboxes.buried)
        self._sweeping: asyncio.TimerHandle | None = None
        self._extras = AsyncExitStack()
        self._closed = asyncio.Event()

    async def __aenter__(self) -> Self:
        await self.open()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    @property
    def path(self) -> Path:
        """The socket that components send to."""
        return self.config.local_root / junior.SOCKET_NAME

    @property
    def port(self) -> int:
        """The UDP port in use on the first network; also when the configuration said 0."""
        return self.port_of(self.config.name)

    def port_of(self, network: str) -> int:
        """The UDP port in use on a network."""
        if network in self._networks:
            return self._networks[network].port
        return next(each.port for each in self.config.all_networks if each.name == network)

    @property
    def tcp_port(self) -> int | None:
        """The TCP port in use, if any."""
        return self._links.tcp_port

    @property
    def components(self) -> tuple[JausID, ...]:
        """The ids of the components that are registered here."""
        return tuple(sorted(JausID.from_int(id) for id, _ in self._core.components))

    @property
    def counters(self) -> Mapping[str, int]:
        """What was received, routed and dropped, by reason."""
        return self._core.counters

    @property
    def state(self) -> NodeState:
        """What the status and the metrics are made from."""
        ingress = len(self._ingress or ())
        return NodeState(self.config, self._core, self._networks, self._mailboxes.waiting, ingress, self._loop.time())

    async def open(self) -> None:
        """Bind everything, or nothing."""
        self._loop = asyncio.get_running_loop()
        config = self.config
        self._local = local_socket.bind(self.path, owner="a node manager", mode=config.local_mode)
        try:
            local_socket.give_to_group(self.path, config.local_group)
            for each in config.all_networks:
                seal = keys.load(each.key_file)
                self._networks[each.name] = Network(
                    each, self._core.counters, config.receive_buffer, seal, self._core.remove_dead
                )
            await self._links.open(config, self.port, (port for ports in self._known.values() for port in ports))
            self._mirror = await operations.open_all(self._extras, config, lambda: self.state)
        except BaseException:
            await self.close()
            raise
        self._closed.clear()
        draining.attach(self._loop, self._local, self._from_component, self._socket_error)
        sealed = any(network.seal for network in self._networks.values())
        self._ingress = Ingress(self._from_network if sealed else self._take, self._core.counters)
        for name, network in self._networks.items():
            for sock in network.sockets:
                self._ingress.attach(sock, name, self._udp_error, skip=network.skip)
        self._watch = self._loop.call_later(memberships.WATCH_INTERVAL, self._watch_interfaces)
        self._sweeping = self._loop.call_later(sweep.INTERVAL, self._sweep_components)

    async def close(self) -> None:
        """Give everything back; a second call does nothing."""
        local, self._local = self._local, None
        if local is None:
            return
        for timer in (self._timer, self._watch, self._sweeping):
            if timer is not None:
                timer.cancel()
        self._timer = self._watch = self._sweeping = None
        draining.detach(self._loop, local)
        if self._ingress is not None:
            self._ingress.close()
        await self._links.close()
        self._mailboxes.close()
        self._shortcuts.clear()
        for network in self._networks.values():
            network.close()
        self._networks.clear()
        self._mirror = None
        await self._extras.aclose()
        local_socket.clean_up(self.path)
        self._closed.set()

    def reload(self, config: NodeConfig) -> list[str]:
        """Take over rules, limits and addresses; returns the settings that differ and need a restart.

        Raises `ConfigError`, and then nothing has changed. New TCP peers are connected to after a restart.
        """
        gateway, known = policy.gateway(config), config.known_addresses()
        self._core.gateway = gateway
        self._core.address_book.set_static({int(id): ports for id, ports in known.items()})
        self._core.sources.set_limits(policy.limits(config))
        self._shortcuts.clear()
        names = type(config).model_fields
        changed = [name for name in names if getattr(config, name) != getattr(self.config, name)]
        taken = {name: getattr(config, name) for name in changed if name in RELOADABLE}
        self.config = self.config.model_copy(update=taken)
        return [name for name in changed if name not in RELOADABLE]

    async def run(self) -> None:
        """Wait until somebody closes it."""
        await self._closed.wait()

    # --- in ------------------------------------------------------------------------------------------------------

    def _from_component(self, datagram: bytes, sender: str | bytes | None) -> None:
        port = self._senders.get(sender)
        if port is None:
            if len(self._senders) > MAX_SENDERS:
                self._senders.clear()
            port = self._senders[sender] = LocalPort(_path(sender))
        self._take(datagram, port)

    def _from_network(self, data: bytes, port: UdpPort) -> None:
        network = self._networks.get(port.network)
        datagram = None if network is None else network.open_seal(data)
        if datagram is not None:
            self._take(datagram, port)

    def _take(self, datagram: bytes, port: Port) -> None:
        if not self._shortcuts.take(datagram, port):
            self._core.receive(datagram, port, self._loop.time())
            self._mirrored = port
            self._flush()

    def _changed(self, id: int | None) -> None:
        self._shortcuts.forget(id)

    def _socket_error(self, error: OSError) -> None:
        self._core.counters.drop("socket_error", error)

    def _udp_error(self, error: OSError) -> None:
        """A wake-up without a datagram, too, is for datagrams that have come back."""
        if not isinstance(error, BlockingIOError):
            self._core.counters.drop("udp_unreachable", error)
        for network in self._networks.values():
            network.take_back()

    # --- out -----------------------------------------------------------------------------------------------------

    def _flush(self) -> None:
        for port, datagram in self._core.poll_output():
            if isinstance(port, LocalPort):
                self._mailboxes.send(port.path, datagram)
            elif (network := self._networks.get(port.network)) is None:
                self._core.counters.drop("closed")
            elif isinstance(port, GroupPort):
                network.multicast(datagram)
                if port.network == self.config.name:
                    self._links.broadcast(datagram)
            elif isinstance(port, TcpPort | SerialPort):
                self._links.send(port, datagram)
            else:
                network.send(datagram, port.host, port.port)
            if self._mirror is not None:
                self._mirror.add(self._mirrored, port, datagram)
        self._arm()

    def _way_to(self, port: LocalPort | UdpPort) -> Send | None:
        """For the shortcuts; a mirror wants to see each datagram."""
        if self._mirror is not None:
            return None
        if isinstance(port, LocalPort):
            return self._mailboxes.of(port.path).send
        network = self._networks.get(port.network)
        return None if network is None else network.way_to(port.host, port.port)

    def _watch_interfaces(self) -> None:
        self._watch = self._loop.call_later(memberships.WATCH_INTERVAL, self._watch_interfaces)
        for network in self._networks.values():
            network.watch_interfaces()

    def _sweep_components(self) -> None:
        self._sweeping = self._loop.call_later(sweep.INTERVAL, self._sweep_components)
        self._sweep.turn()

    # --- time ----------------------------------------------------------------------------------------------------

    def _arm(self) -> None:
        if self._timer is None and self._local is not None and (when := self._core.next_timeout()) is not None:
            self._timer = self._loop.call_at(when, self._timeout)

    def _timeout(self) -> None:
        self._timer = None
        self._core.handle_timeout(self._loop.time())
        self._flush()


def _path(sender: str | bytes | None) -> str:
    """A component's socket as the kernel names it; empty when it has no name in the file system to answer to."""
    return sender if isinstance(sender, str) and sender.startswith("/") else ""
