"""The node manager as an asyncio service: moves datagrams between sockets and the router."""

from __future__ import annotations

import asyncio
import math
import resource
import socket
import struct
from collections.abc import Callable, Mapping
from contextlib import AsyncExitStack
from functools import partial
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Final, Self, TypeAlias

from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.node import liveness
from jauspy.node.back_pressure import BackPressure
from jauspy.node.component_senders import ComponentSenders
from jauspy.node.config import NodeConfig, load_key, make_gateway, parse_pattern, source_limits
from jauspy.node.ingress import Ingress
from jauspy.node.link_shaper import LinkShaper
from jauspy.node.links import Links
from jauspy.node.liveness import ComponentSockets, LivenessCheck
from jauspy.node.local_users import LocalUsers, users_of
from jauspy.node.mirror_server import MirrorServer
from jauspy.node.mirrored_packets import MirroredPackets
from jauspy.node.network import Network
from jauspy.node.status import NodeState, StatusServer
from jauspy.protocol import addressing, header, junior
from jauspy.protocol.address_book import MAX_COMPONENTS, ComponentPort
from jauspy.protocol.addressing import GroupPort, LocalPort, NetworkPort, Port, SerialPort, TcpPort, UdpPort
from jauspy.protocol.egress import ROUTED_COUNTERS
from jauspy.protocol.link_limits import LinkLimits
from jauspy.protocol.routing import RECEIVED_COUNTERS, BroadcastRoute, Router
from jauspy.protocol.sources import SourceChecks
from jauspy.transport import base, local, multicast, node_status
from jauspy.transport.age import DatagramReader
from jauspy.transport.send_queue import QueueMemory

if TYPE_CHECKING:
    from jauspy.node.mirror import Mirror


_LOG = get_logger(__name__)

MAX_SENDERS: Final = 4096
"""Names of local sockets that are cached."""
RELOADABLE: Final = ("gateway", "source_check", "rate_limit", "rate_burst", "limit", "addresses", "address_books")
"""Settings that `NodeManager.reload` applies, with `limit` of further networks and serial lines."""
CACHE_LIFETIME: Final = 0.5
"""Seconds after which routes from and to networks expire, so that the router learns from packets at most this late.
Those between components of this machine hold until the directory of components changes."""
MAX_ROUTES: Final = 1024

_BROADCAST: Final = 0x0C
"""The bits of the control byte with the broadcast field."""
_GLOBAL: Final = header.Broadcast.GLOBAL << 2
_IDS: Final = 0xFFFFFFFF
_unpack_plain: Final = struct.Struct("<IBQxx").unpack_from
"""Version, flags and data size as one number, the control byte, and destination and source as one number."""

Send: TypeAlias = Callable[[bytes], object]
_Route: TypeAlias = tuple[Send, str, str, int]
"""The sender, the counters of received and of sent datagrams, and how many are sent for one."""


class NodeManager:
    """Owns UDP 3794 and the multicast group on each network, and the local socket `<local_root>/JuniorRTE`.

    Use it as an async context manager, or call `open` and `close`. Raises `TransportError` when another one is running.
    """

    _loop: asyncio.AbstractEventLoop

    def __init__(self, config: NodeConfig | None = None) -> None:
        self.config = config or NodeConfig()
        self._known = self.config.known_addresses()
        self._max_age = self.config.max_message_age or math.inf
        self._component_sockets = ComponentSockets(self.config.local_root)
        self._local_users: LocalUsers | None = None
        self._max_sockets = max_component_sockets()
        self._router = Router(
            str(self.config.local_root),
            addresses=self._known,
            address_lifetime=self.config.address_lifetime,
            bounds=self.config.id_bounds,
            local_udp=self.config.local_udp,
            may_connect=lambda port: self._local_users is not None and self._local_users.may_connect(port),
            is_abandoned=lambda port: self._local_users is not None and self._local_users.is_abandoned(port),
            own_ids=[parse_pattern(text) for text in self.config.own_ids],
            limits=LinkLimits(self.config.link_limits),
            compression=self.config.header_compression,
            max_message_age=self._max_age,
            is_dead=self._component_sockets.is_dead,
            max_sockets=self._max_sockets,
            networks=[network.name for network in self.config.all_networks],
            gateway=make_gateway(self.config),
            sources=SourceChecks(
                source_limits(self.config),
                authenticated=[setup.name for setup in self.config.all_networks if setup.key_file],
                bounds=self.config.id_bounds,
            ),
            changed=self._invalidate,
        )
        self._cache = RoutingCache(self._router, self._sender_for, self._broadcast_sender)
        self._networks: dict[str, Network] = {}
        self._local: socket.socket | None = None
        self._ingress: Ingress | None = None
        memory = QueueMemory(self.config.queue_memory, self._router.counters)
        self._component_senders = ComponentSenders(self._component_sockets, self._router, self._max_age, memory)
        self._local_ports: dict[str | bytes | None, LocalPort] = {}
        self._mirrors: tuple[Mirror | MirrorServer, ...] = ()
        self._file_mirror: Mirror | None = None
        self._mirror_server: MirrorServer | None = None
        self._mirrored = MirroredPackets(self._group_address)
        self._mirror_source: Port = LocalPort("")
        self._links = Links(
            self._router.counters,
            self.config.name,
            self._receive,
            self._router.disconnected,
            limits=self._router.limits,
            max_age=self._max_age,
            memory=memory,
        )
        self._memory = memory
        self._shapers: dict[str, LinkShaper] = {}
        """Of the networks with a limit of all their traffic."""
        self._timer: asyncio.TimerHandle | None = None
        self._membership_timer: asyncio.TimerHandle | None = None
        self._liveness = LivenessCheck(self._router.components, self._is_dead, self._component_senders.remove_dead)
        self._liveness_timer: asyncio.TimerHandle | None = None
        self._services = AsyncExitStack()
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
        """The UDP port in use on the first network, also when the configuration says 0."""
        return self.port_of(self.config.name)

    def port_of(self, network: str) -> int:
        """The UDP port in use on a network."""
        if network in self._networks:
            return self._networks[network].port
        return next(setup.port for setup in self.config.all_networks if setup.name == network)

    @property
    def tcp_port(self) -> int | None:
        """The TCP port in use, if any."""
        return self._links.tcp_port

    @property
    def components(self) -> tuple[JausID, ...]:
        """The ids of the components that are registered here."""
        return tuple(sorted(JausID.from_int(id) for id, _ in self._router.components))

    @property
    def counters(self) -> Mapping[str, int]:
        """Counters of received, routed and dropped packets, by reason."""
        return self._router.counters

    @property
    def state(self) -> NodeState:
        """The current state, for the status and the metrics."""
        ingress = len(self._ingress or ())
        return NodeState(
            config=self.config,
            router=self._router,
            networks=self._networks,
            queued=self._component_senders.queued,
            queued_bytes=self._component_senders.queued_bytes,
            ingress=ingress,
            shapers=self._shapers,
            now=self._loop.time(),
        )

    async def open(self) -> None:
        """Open all sockets; raises `TransportError` or `ConfigError`, and then none stays open."""
        self._loop = asyncio.get_running_loop()
        config = self.config
        local.check_directory(config.local_root)
        self._local = local.bind(self.path, owner="a node manager", mode=config.local_mode)
        try:
            self._component_sockets.open()
            local.give_to_group(self.path, config.local_group)
            may_use = users_of(self.path)
            self._local_users = LocalUsers(may_use)
            for setup in config.all_networks:
                authenticator = load_key(setup.key_file)
                self._networks[setup.name] = Network(
                    setup, self._router.counters, config.receive_buffer, authenticator, self._router.remove_dead
                )
            self._set_rates()
            await self._links.open(config, self.port, (port for ports in self._known.values() for port in ports))
            await self._open_services()
            self._take_up_components(may_use)
        except BaseException:
            await self.close()
            raise
        self._closed.clear()
        counters = self._router.counters
        reader = DatagramReader(self._local, counters, self._max_age)
        resume = base.start_reading(self._loop, reader, self._from_component, self._socket_error, take_is_fast=True)
        pause = partial(self._loop.remove_reader, self._local)
        self._component_senders.back_pressure = BackPressure(pause, resume, counters)
        authenticated = any(network.authenticator for network in self._networks.values())
        receive = self._from_network if authenticated else self._receive
        self._ingress = Ingress(receive, counters, self._max_age, sources=self._router.sources)
        for name, network in self._networks.items():
            for sock in network.sockets:
                self._ingress.attach(sock, name, self._udp_error, skip=network.skip)
        self._membership_timer = self._loop.call_later(multicast.WATCH_INTERVAL, self._refresh_memberships)
        self._liveness_timer = self._loop.call_later(liveness.CHECK_INTERVAL, self._check_liveness)
        self._check_limit()

    def _take_up_components(self, may_use: Callable[[int], bool]) -> None:
        """Register the components of an earlier node manager: some send only when queried."""
        ids = []
        for id, path in self._component_sockets.find_live(may_use):
            if not self._router.components.register(id, LocalPort(path)):
                break
            ids.append(JausID.from_int(id))
        if ids:
            _LOG.info("found %d components that run: %s", len(ids), ", ".join(map(str, sorted(ids))))

    async def _open_services(self) -> None:
        """Open status, metrics and mirrors as configured; modules that are not needed are not imported."""
        config, counters = self.config, self._router.counters
        if config.status:
            path = config.local_root / node_status.SOCKET_NAME
            server = StatusServer(path, config.local_mode, config.local_group, lambda: self.state)
            await self._services.enter_async_context(server)
        if config.metrics is not None:
            from jauspy.node.metrics import MetricsServer  # noqa: PLC0415 - prometheus_client is slow to import

            host, _, port = config.metrics.rpartition(":")
            await self._services.enter_async_context(MetricsServer(host, int(port), lambda: self.state))
        if config.mirror is not None:
            from jauspy.node.mirror import Mirror  # noqa: PLC0415 - needed only here

            self._file_mirror = self._services.enter_context(Mirror(config.mirror, config.mirror_limit, counters))
        if config.mirror_socket:
            path = config.local_root / node_status.MIRROR_NAME
            mirror = MirrorServer(path, config.local_mode, config.local_group, counters, self._update_mirrors)
            await self._services.enter_async_context(mirror)
            self._mirror_server = mirror
        self._update_mirrors()

    def _update_mirrors(self) -> None:
        """Pass on packets to the mirrors that somebody reads; only without any, known routes bypass the router."""
        server = self._mirror_server
        mirrors = self._file_mirror, server if server is not None and server.has_readers else None
        self._mirrors = tuple(mirror for mirror in mirrors if mirror is not None)
        self._cache.clear()

    def _group_address(self, name: str) -> tuple[str, int]:
        network = self._networks[name]
        return network.config.multicast_group, network.port

    async def close(self) -> None:
        """Close everything; a second call does nothing."""
        local_socket, self._local = self._local, None
        if local_socket is None:
            return
        for timer in (self._timer, self._membership_timer, self._liveness_timer):
            if timer is not None:
                timer.cancel()
        self._timer = self._membership_timer = self._liveness_timer = None
        if self._component_senders.back_pressure is not None:
            self._component_senders.back_pressure.close()
        base.stop_reading(self._loop, local_socket)
        if self._ingress is not None:
            self._ingress.close()
        for shaper in self._shapers.values():
            shaper.close()
        self._shapers.clear()
        await self._links.close()
        self._component_senders.close()
        self._component_sockets.close()
        self._cache.clear()
        for network in self._networks.values():
            network.close()
        self._networks.clear()
        self._mirrors = ()
        self._file_mirror = self._mirror_server = None
        await self._services.aclose()
        local.clean_up(self.path)
        self._closed.set()

    def reload(self, config: NodeConfig) -> list[str]:
        """Apply rules, limits and addresses; returns the changed settings that need a restart.

        Raises `ConfigError`, and then nothing is changed. New TCP peers are connected to after a restart.
        """
        gateway, known = make_gateway(config), config.known_addresses()
        self._router.gateway = gateway
        self._router.address_book.set_static({int(id): ports for id, ports in known.items()})
        self._router.sources.set_limits(source_limits(config))
        self._cache.clear()
        names = type(config).model_fields
        applied = {name: getattr(config, name) for name in names if name in RELOADABLE}
        networks = {network.name: network.limit for network in config.networks}
        lines = {line.device: line.limit for line in config.serial}
        applied["networks"] = tuple(
            network.model_copy(update={"limit": networks.get(network.name, network.limit)})
            for network in self.config.networks
        )
        applied["serial"] = tuple(
            line.model_copy(update={"limit": lines.get(line.device, line.limit)}) for line in self.config.serial
        )
        before, self.config = self.config.link_limits, self.config.model_copy(update=applied)
        if self.config.link_limits != before:
            self._router.limits.set_limits(self.config.link_limits)
            self._links.set_rates(self.config.link_limits)
            self._set_rates()
        return [name for name in names if getattr(config, name) != getattr(self.config, name)]

    def _set_rates(self) -> None:
        """Send no more to the networks than they carry; what waits for other limits is dropped."""
        for shaper in self._shapers.values():
            shaper.close()
        self._shapers = {
            name: LinkShaper(
                name,
                limit.total,
                self._transmit,
                counters=self._router.counters,
                left_out=self._router.limits.left_out,
                max_age=self._max_age,
                memory=self._memory,
            )
            for name, limit in self.config.link_limits.items()
            if name in self._networks and limit.total is not None
        }

    async def run(self) -> None:
        """Wait until `close` is called."""
        await self._closed.wait()

    # --- receiving ------------------------------------------------------------------------------------------------

    def _from_component(self, datagram: bytes, sender: str | bytes | None) -> None:
        port = self._local_ports.get(sender)
        if port is None:
            path = _path(sender)
            if path.endswith(f"/{junior.SOCKET_NAME}"):
                self._router.counters.drop("node_manager", f"{path} is not the socket of a component")
                return
            if len(self._local_ports) > MAX_SENDERS:
                self._local_ports.clear()
            port = self._local_ports[sender] = LocalPort(path)
        if not self._cache.forward(datagram, port):
            self._route(datagram, port)

    def _from_network(self, data: bytes, port: UdpPort) -> None:
        network = self._networks.get(port.network)
        datagram = None if network is None else network.authenticate(data, port)
        if datagram is not None:
            self._receive(datagram, port)

    def _receive(self, datagram: bytes, port: Port) -> None:
        if not self._cache.forward(datagram, port):
            self._route(datagram, port)

    def _route(self, datagram: bytes, port: Port) -> None:
        self._router.receive(datagram, port, self._loop.time())
        self._mirror_source = port
        self._flush()

    def _invalidate(self, id: int | None) -> None:
        self._cache.invalidate(id)

    def _socket_error(self, error: OSError) -> None:
        self._router.counters.drop("socket_error", error)

    def _udp_error(self, error: OSError) -> None:
        """Handle a socket error; a wake-up without a datagram also signals that ports are unreachable."""
        if not isinstance(error, BlockingIOError):
            self._router.counters.drop("udp_unreachable", error)
        for network in self._networks.values():
            network.report_unreachable()

    # --- sending -------------------------------------------------------------------------------------------------

    def _flush(self) -> None:
        for port, datagram in self._router.poll_output():
            if isinstance(port, LocalPort):
                self._component_senders.send(port.path, datagram)
            elif self._shapers and (shaper := self._shaper_of(port)) is not None:
                shaper.send(port, datagram)
            else:
                self._transmit(port, datagram)
            if self._mirrors:
                block = self._mirrored.block(self._mirror_source, port, datagram)
                for mirror in self._mirrors:
                    mirror.add(block)
        self._arm()

    def _transmit(self, port: Port, datagram: bytes) -> None:
        """Send to a network, a connection or a line now."""
        network = None if isinstance(port, LocalPort) else self._networks.get(port.network)
        if network is None:
            self._router.counters.drop("closed")
        elif isinstance(port, GroupPort):
            network.multicast(datagram)
            if port.network == self.config.name:
                self._links.broadcast(datagram)
        elif isinstance(port, TcpPort | SerialPort):
            self._links.send(port, datagram)
        elif isinstance(port, UdpPort):
            network.send(datagram, port.host, port.port)

    def _shaper_of(self, port: NetworkPort | GroupPort) -> LinkShaper | None:
        """The shaper for what is sent to this port; None for a serial line, and for a component of this machine."""
        if isinstance(port, SerialPort) or (isinstance(port, UdpPort) and self._router.components.has_port(port)):
            return None
        return self._shapers.get(port.network)

    def _sender_for(self, port: LocalPort | UdpPort) -> Send | None:
        """The sender of a cached route; None with a mirror, which must record each datagram."""
        if self._mirrors:
            return None
        if isinstance(port, LocalPort):
            return self._component_senders.sender_for(port.path).send
        network = self._networks.get(port.network)
        if network is None:
            return None
        if (shaper := self._shapers.get(port.network)) is not None:
            return partial(shaper.send, port)
        return network.sender_for(port.host, port.port)

    def _broadcast_sender(self, route: BroadcastRoute) -> Send | None:
        """The sender of a cached broadcast; None with a mirror."""
        networks = [self._networks[name] for name in route.networks if name in self._networks]
        if self._mirrors or len(networks) < len(route.networks) or (self._shapers and networks):
            return None
        deliver = self._component_senders.group(port.path for port in route.components)
        if not networks:
            return deliver

        def send(datagram: bytes) -> None:
            deliver(datagram)
            now = self._loop.time()
            for network in networks:
                self._router.note_multicast(datagram, network.config.name, now)
                network.multicast(datagram)
                if network.config.name == self.config.name:
                    self._links.broadcast(datagram)

        return send

    def _refresh_memberships(self) -> None:
        self._membership_timer = self._loop.call_later(multicast.WATCH_INTERVAL, self._refresh_memberships)
        for network in self._networks.values():
            try:
                network.refresh_memberships()
            except OSError as error:  # no descriptor to read the addresses with
                self._router.counters.count("multicast.not_refreshed", error)

    def _check_limit(self) -> None:
        """Accept as many components as there are descriptors for, also after somebody has changed the limit."""
        number = max_component_sockets()
        if number != self._max_sockets:
            self._max_sockets = number
            self._router.components.set_max_sockets(number)
            self._router.counters["open_files.limit_changed"] += 1
            limit, _ = resource.getrlimit(resource.RLIMIT_NOFILE)
            _LOG.warning(
                "the limit of open files is now %d: up to %d components are accepted; `prlimit --nofile` sets it",
                limit,
                number,
            )

    def _is_dead(self, port: ComponentPort) -> bool:
        if isinstance(port, LocalPort):
            return self._component_sockets.is_dead(port.path)
        return self._local_users is not None and self._local_users.has_left(port)

    def _check_liveness(self) -> None:
        self._liveness_timer = self._loop.call_later(liveness.CHECK_INTERVAL, self._check_liveness)
        self._check_limit()
        self._liveness.check_next()

    # --- time ----------------------------------------------------------------------------------------------------

    def _arm(self) -> None:
        if self._timer is None and self._local is not None and (when := self._router.next_timeout()) is not None:
            self._timer = self._loop.call_at(when, self._timeout)

    def _timeout(self) -> None:
        self._timer = None
        self._router.handle_timeout(self._loop.time())
        self._flush()


def _path(sender: str | bytes | None) -> str:
    """The path of a component's socket; empty when it has no name in the file system."""
    return sender if isinstance(sender, str) and sender.startswith("/") else ""


class RoutingCache:
    """Sends packets whose route is known, and counts them like the router.

    `sender_for(port)` returns a function that sends to the port, or None if its datagrams must pass the router;
    `broadcast_sender(route)` one that sends a broadcast, and counts its multicasts.
    """

    def __init__(
        self,
        router: Router,
        sender_for: Callable[[LocalPort | UdpPort], Send | None],
        broadcast_sender: Callable[[BroadcastRoute], Send | None],
    ) -> None:
        self._router = router
        self._counters = router.counters
        self._sender_for = sender_for
        self._broadcast_sender = broadcast_sender
        self._routes: dict[tuple[Port, int, int], _Route] = {}
        """Routes by the port of the sender, both ids, and the broadcast field of the header."""
        self._expiring: list[tuple[Port, int, int]] = []
        """The keys of routes from or to a network."""
        self._ids: set[int] = set()
        self._has_broadcasts = False
        self._timer: asyncio.TimerHandle | None = None

    def __len__(self) -> int:
        return len(self._routes)

    def forward(self, datagram: bytes, port: Port) -> bool:
        """Send a datagram from `port` by its cached route; false if the router must process it."""
        try:
            start, control, ids = _unpack_plain(datagram)
        except struct.error:
            return False
        if start != (len(datagram) - 1) << 16 | header.VERSION:
            return False
        broadcast = control & _BROADCAST
        route = self._routes.get((port, ids, broadcast)) or self._find(port, ids, broadcast)
        if route is None:
            return False
        send, received, routed, number = route
        counters = self._counters
        counters[received] += 1
        counters[routed] += number
        send(datagram)
        return True

    def invalidate(self, id: int | None) -> None:
        """Clear the cache if it has routes of this id, or broadcasts; None stands for any id."""
        if id is None or self._has_broadcasts or id in self._ids:
            self.clear()

    def clear(self) -> None:
        """Remove all routes."""
        self._routes.clear()
        self._expiring.clear()
        self._ids.clear()
        self._has_broadcasts = False
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _expire(self) -> None:
        self._timer = None
        for key in self._expiring:
            del self._routes[key]
        self._expiring.clear()
        self._ids = {id for _, ids, _ in self._routes for id in (ids >> 32, ids & _IDS)}

    def _find(self, port: Port, ids: int, broadcast: int) -> _Route | None:
        source, destination = ids >> 32, ids & _IDS
        is_broadcast = addressing.is_wildcard(destination)
        if is_broadcast and type(port) is not LocalPort:
            return None
        loop = asyncio.get_running_loop()
        if is_broadcast:
            route, is_local = self._find_broadcast(source, destination, port, broadcast >> 2), True
        elif broadcast == _GLOBAL:
            return None
        else:
            cached = self._router.cacheable_route(source, destination, port, loop.time())
            send = None if cached is None else self._sender_for(cached)
            if cached is None or send is None:
                return None
            route = send, RECEIVED_COUNTERS[type(port)], ROUTED_COUNTERS[type(cached)], 1
            is_local = type(port) is LocalPort and type(cached) is LocalPort
        if route is None:
            return None
        if len(self._routes) >= MAX_ROUTES:
            self.clear()
        self._routes[port, ids, broadcast] = route
        self._ids.update((source, destination))
        self._has_broadcasts |= is_broadcast
        if not is_local:
            self._expiring.append((port, ids, broadcast))
            if self._timer is None:
                self._timer = loop.call_later(CACHE_LIFETIME, self._expire)
        return route

    def _find_broadcast(self, source: int, destination: int, port: Port, broadcast: int) -> _Route | None:
        found = self._router.cacheable_broadcast(source, destination, broadcast, port)
        send = None if found is None else self._broadcast_sender(found)
        if found is None or send is None:
            return None
        return send, RECEIVED_COUNTERS[LocalPort], ROUTED_COUNTERS[LocalPort], len(found.components)


MAX_OPEN_FILES: Final = 4096
"""Limit of open files: a socket for each of up to 1024 components, TCP connections, logs and captures."""
RESERVED_FILES: Final = 192
"""Descriptors for networks, probes, connections, readers of status and metrics, serial lines and logs."""


def raise_open_files_limit() -> None:
    """Raise the soft limit of open files, which is 1024 on many systems."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    enough = MAX_OPEN_FILES if hard == resource.RLIM_INFINITY else min(MAX_OPEN_FILES, hard)
    if soft != resource.RLIM_INFINITY and soft < enough:
        resource.setrlimit(resource.RLIMIT_NOFILE, (enough, hard))


def max_component_sockets() -> int:
    """The number of components on local sockets: each needs one descriptor. The reserve is at most half of all."""
    limit, _ = resource.getrlimit(resource.RLIMIT_NOFILE)
    if limit == resource.RLIM_INFINITY:
        return MAX_COMPONENTS
    return min(MAX_COMPONENTS, max(limit - RESERVED_FILES, limit // 2))
