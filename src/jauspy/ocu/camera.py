"""A camera: its video as frames for NumPy and OpenCV, and still images."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says what may be wrong

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import AsyncGenerator, Mapping
from contextlib import aclosing, asynccontextmanager, suppress
from datetime import UTC, datetime
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Final, Protocol, TypeVar

from jauspy.arguments import check_number
from jauspy.errors import ConfigError, RequestError, ResponseTimeout, TransportError
from jauspy.messages.environment_sensing import (
    ConfirmDigitalResourceEndpoint as Confirm,
    QueryVisualSensorCapabilities,
    RegisterDigitalResourceEndpoint as Register,
    RemoveDigitalResourceEndpoint as Remove,
    ReportVisualSensorCapabilities,
)
from jauspy.messages.environment_sensing.v2_0.digital_video import SetDigitalVideoSensorConfiguration
from jauspy.ocu.connection import Connection
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.stills import Photo
from jauspy.ocu.subsystems import ComponentInfo, choose_sensor
from jauspy.platform.video_settings import RTP_SERVER_TYPE, SUPPORTED_FRAME_SIZES, FrameSize, frame_size
from jauspy.video import need_video
from jauspy.video.h264_payload import Picture
from jauspy.video.receiver import RtpReceiver

if TYPE_CHECKING:
    from jauspy.video.frames import Frame

VIDEO: Final = "DigitalVideo"
ENDPOINTS: Final = "DigitalResourceDiscovery"
NAMES_OF: Final = "VisualSensor"
RENEWAL_INTERVAL: Final = 60.0
"""Seconds between two registrations; a robot removes an endpoint after five minutes."""
SILENCE: Final = 5.0
"""Seconds without a frame after which `frames` raises by default, once the video runs."""
MAX_WAITING: Final = 64
"""Encoded pictures that wait to be read; the oldest go first."""


P_co = TypeVar("P_co", covariant=True)


class Reader(Protocol[P_co]):
    """Reads the video that one camera sends."""

    @property
    def receiver(self) -> RtpReceiver:
        """The receiver of the packets."""
        ...

    def fileno(self) -> int:
        """File descriptor for an event loop: readable when packets have arrived."""
        ...

    def take(self) -> P_co | None:
        """The next picture; None until more packets arrive."""
        ...

    def close(self) -> None:
        """Stop receiving."""
        ...


R = TypeVar("R", bound=Reader[Any])


class PictureReader:
    """Encoded pictures in order; after a loss, none until the next IDR picture."""

    def __init__(self, host: str) -> None:
        self.receiver = RtpReceiver(host)
        self._waiting: deque[Picture] = deque(maxlen=MAX_WAITING)
        self._broken = True

    def fileno(self) -> int:
        """File descriptor for an event loop: readable when packets have arrived."""
        return self.receiver.fileno()

    def take(self) -> Picture | None:
        """The next picture; None until more packets arrive."""
        for picture in self.receiver.take():
            self._broken = not picture.whole or (self._broken and not picture.is_idr)
            if not self._broken:
                self._waiting.append(picture)
        return self._waiting.popleft() if self._waiting else None

    def close(self) -> None:
        """Stop receiving."""
        self.receiver.close()


class Camera:
    """One camera of a robot; `name` is that of the sensor, None for the only one."""

    def __init__(self, connection: Connection, components: tuple[ComponentInfo, ...], name: str | None) -> None:
        self.name: str | None = name
        """The name that was given to `Robot.camera`."""
        self._connection = connection
        self._components = components
        self._found: tuple[ComponentInfo, int] | None = None
        self._url = ""
        self._receiver: RtpReceiver | None = None
        self._counters: Mapping[str, int] = MappingProxyType({})

    def __repr__(self) -> str:
        return f"<camera {self.name or ''}>"

    @property
    def waiting(self) -> str:
        """A text for users: what `frames` or `encoded` wait for until a picture arrives, as in "a first packet"."""
        if self._receiver is None:
            return "the robot has not yet agreed to send video"
        if note := self.note:
            return f"the camera says: {note}"
        counters = {name: count for name, count in self._receiver.counters.items() if count}
        if not counters:
            return f"the robot agreed to send to {self._url}, and no packet has arrived"
        counted = ", ".join(f"{count} {name}" for name, count in counters.items())
        if counters.get("pictures"):
            return f"no further picture has arrived ({counted})"
        return f"packets arrive, and no whole picture yet ({counted})"

    @property
    def counters(self) -> Mapping[str, int]:
        """Counters of the last `frames` or `encoded`: `pictures`, packets `lost`, pictures `damaged`, ..."""
        return self._counters if self._receiver is None else self._receiver.counters

    @property
    def note(self) -> str:
        """Note of the camera about its stream while it is received; empty without one.

        A text for users: the camera is still starting, or its machine is too slow for what is set. It is not checked.
        """
        return "" if self._receiver is None else self._receiver.note

    def taken(self, picture: Picture) -> datetime | None:
        """When a picture of `encoded` was taken, by the robot's clock; None before its first report of the time."""
        seconds = None if self._receiver is None else self._receiver.taken(picture)
        return None if seconds is None else datetime.fromtimestamp(seconds, UTC)

    def refresh(self) -> None:
        """Request a picture that can be decoded without others (IDR); without effect when nothing is received."""
        if self._receiver is not None:
            self._receiver.ask_for_idr()

    async def set_video(
        self,
        *,
        size: tuple[int, int] | None = None,
        rate: int | None = None,
        bit_rate: int | None = None,
        authority: int = DEFAULT_AUTHORITY,
    ) -> None:
        """Set the video's size (width, height in pixels), pictures a second and kbit/s, for all who watch.

        None leaves a setting as it is. Takes control for a moment; raises `RequestError` with what was refused.
        """
        component, sensor = await self._find()
        info, number = component.find(VIDEO), frame_size(*size) if size else None
        assert info is not None
        if size and number not in SUPPORTED_FRAME_SIZES:
            known = ", ".join(f"{width}x{height}" for width, height in sorted(set(SUPPORTED_FRAME_SIZES.values())))
            raise ConfigError(f"JAUS has no video of {size[0]}x{size[1]}; the sizes are {known}")
        service = ServiceClient(self._connection, component.id, info)
        await set_stream(service, sensor, number, rate, bit_rate, authority=authority)

    async def frames(
        self, *, address: str | None = None, timeout: float = 20.0, silence: float = SILENCE
    ) -> AsyncGenerator[Frame, None]:
        """Frames as they arrive: NumPy arrays of uint8, (height, width, 3), in BGR, with `.time`; extra `video`.

        A slow reader gets the newest one. `address` is the IP address of this machine to which the robot sends; by
        default the one from which the robot is reached. Raises `RequestError` when no first frame arrives within
        `timeout` seconds, or none for `silence` seconds later. The camera stops sending when the loop is left.
        """
        check_number(timeout, "timeout")
        check_number(silence, "silence")
        need_video()
        from jauspy.video.frames import FrameReader  # noqa: PLC0415 - of the extra `video`

        component, sensor = await self._find()
        host = address or await self._own_address(component)
        async with (
            self._registered(component, sensor, FrameReader(host), host) as (reader, url),
            aclosing(self._received(reader, url, component, (timeout, silence))) as frames,
        ):
            async for frame in frames:
                yield frame

    async def encoded(
        self, *, address: str | None = None, timeout: float = 20.0, silence: float = SILENCE
    ) -> AsyncGenerator[Picture, None]:
        """Pictures as the camera encodes them (H.264), beginning with an IDR picture; otherwise as `frames`.

        After a lost packet, pictures are dropped until the next IDR picture.
        """
        check_number(timeout, "timeout")
        check_number(silence, "silence")
        component, sensor = await self._find()
        host = address or await self._own_address(component)
        async with (
            self._registered(component, sensor, PictureReader(host), host) as (reader, url),
            aclosing(self._received(reader, url, component, (timeout, silence))) as pictures,
        ):
            async for picture in pictures:
                yield picture

    async def still(
        self, *, size: tuple[int, int] | None = None, format: str | None = None, timeout: float = 10.0
    ) -> Photo:
        """Take a still image, returned as the content of a file; see `ServiceClient.still`.

        Raises `ResponseTimeout` when none arrives within `timeout` seconds.
        """
        check_number(timeout, "timeout")
        client, sensor = await self._still_image()
        return await client.still(size=size, format=format, sensor=sensor, timeout=timeout)

    async def check_still(self) -> None:
        """Raise `ConfigError` unless there is such a camera, and it takes still images."""
        await self._still_image()

    # --- inside ---------------------------------------------------------------------------------------------------

    async def _still_image(self) -> tuple[ServiceClient, int]:
        """The service that takes still images, and the number of the sensor."""
        component, sensor = await self._find()
        info = component.find("StillImage")
        if info is None:
            raise ConfigError(f"{component.id} takes no pictures: it does not offer StillImage")
        return ServiceClient(self._connection, component.id, info), sensor

    async def _find(self) -> tuple[ComponentInfo, int]:
        """The component and the number of the sensor."""
        if self._found is None:
            self._found = await self._search()
        return self._found

    async def _search(self) -> tuple[ComponentInfo, int]:
        if not self._components:
            raise ConfigError(f"this robot has no camera: it does not offer {VIDEO}")
        sensors = [
            (component, sensor, name) for component in self._components for sensor, name in await self._names(component)
        ]
        return choose_sensor(sensors, self.name, "camera")

    async def _names(self, component: ComponentInfo) -> list[tuple[int, str]]:
        """Number and name of each sensor; sensor 1 of a component that does not name its sensors."""
        if component.find(NAMES_OF) is None:
            return [(1, component.name)]
        kind = QueryVisualSensorCapabilities
        query = kind([kind.QueryVisualSensorCapabilitiesRec(kind.SensorID.ALL_SENSORS, 0)])
        report = await self._connection.query(component.id, query, expects=ReportVisualSensorCapabilities)
        assert isinstance(report, ReportVisualSensorCapabilities)
        rows = report.visual_sensor_capabilities_list
        return [(int(row.sensor_id), str(getattr(row, "sensor_name", ""))) for row in rows]

    async def _own_address(self, component: ComponentInfo) -> str:
        found = await self._connection.address_towards(component.id)
        if found is not None:
            return found
        raise ConfigError(
            f"it is unknown on which machine {component.id} is; name the address of this machine to which it is to "
            "send: frames(address=...)"
        )

    async def _register(self, component: ComponentInfo, sensor: int, url: str) -> int:
        if component.find(ENDPOINTS) is None:
            raise ConfigError(f"{component.id} sends no video: it does not offer {ENDPOINTS}")
        record = Register.DigitalResourceEndpointRec(RTP_SERVER_TYPE, url, None, sensor)
        answer = await self._connection.query(component.id, Register(Register.RequestIDRec(1), record), expects=Confirm)
        assert isinstance(answer, Confirm)
        if not answer.id:
            raise RequestError(
                f"{component.id} does not send to {url}: is this an address from which the robot hears this machine, "
                "is there a free place among the receivers, and the extra 'video' on the robot?"
            )
        return answer.id

    @asynccontextmanager
    async def _registered(
        self, component: ComponentInfo, sensor: int, reader: R, host: str
    ) -> AsyncGenerator[tuple[R, str], None]:
        """The camera sends to the reader; with the URL that it was given.

        This ends when the OCU is closed, too: Python ends a loop that was left by `break` some time later.
        """
        try:
            url = f"rtp://{f'[{host}]' if ':' in host else host}:{reader.receiver.port}"
            endpoint = await self._register(component, sensor, url)
            renewal = asyncio.create_task(self._renew(component, sensor, url), name=f"video of {component.id}")

            async def end() -> None:
                if not renewal.cancelling():
                    renewal.cancel()
                    with suppress(RequestError, TransportError):  # a camera that is gone sends no video
                        await self._connection.query(component.id, Remove(endpoint, 2), expects=Confirm)

            with self._connection.on_close(end):
                self._receiver, self._url = reader.receiver, url
                try:
                    yield reader, url
                finally:
                    await end()
        finally:
            self._counters, self._receiver = reader.receiver.counters, None
            reader.close()

    async def _renew(self, component: ComponentInfo, sensor: int, url: str) -> None:
        while True:
            await asyncio.sleep(RENEWAL_INTERVAL)
            with suppress(RequestError):  # repeated in a minute; the endpoint lasts for five
                await self._register(component, sensor, url)

    async def _received(
        self, reader: Reader[P_co], url: str, component: ComponentInfo, patience: tuple[float, float]
    ) -> AsyncGenerator[P_co, None]:
        """Pictures of the reader; `patience` is the time for the first and for each further one, s."""
        loop, arrived, descriptor = asyncio.get_running_loop(), asyncio.Event(), reader.fileno()
        loop.add_reader(descriptor, arrived.set)
        try:
            end = loop.time() + patience[0]
            while True:
                frame = reader.take()
                if frame is not None:
                    yield frame
                    end = loop.time() + patience[1]
                    continue
                arrived.clear()
                try:
                    async with asyncio.timeout_at(end):
                        await arrived.wait()
                except TimeoutError:
                    raise ResponseTimeout(_nothing(component, url, reader)) from None
        finally:
            loop.remove_reader(descriptor)


async def set_stream(
    service: ServiceClient,
    sensor: int,
    size: FrameSize | None,
    rate: int | None,
    bit_rate: int | None,
    *,
    authority: int = DEFAULT_AUTHORITY,
) -> None:
    """Set size, pictures a second and kbit/s of the video of a sensor, as `Camera.set_video`."""
    order = SetDigitalVideoSensorConfiguration
    wanted = order.DigitalVideoSensorConfigurationRec(
        sensor, frame_size=size, frame_rate=rate, maximum_bit_rate=bit_rate
    )
    async with service.control(authority):
        await service.resume()
        await service.configure(order(order.RequestIdRec(1), [wanted]), "the settings of its video")


def _nothing(component: ComponentInfo, url: str, reader: Reader[P_co]) -> str:
    counters = dict(reader.receiver.counters)
    if note := reader.receiver.note:
        return f"{component.id} sends no picture to {url}: the camera says: {note}"
    what = f"what arrived could not be used ({counters})" if counters else "no packet arrived"
    return (
        f"{component.id} sends no picture to {url}: {what}; its camera may still be starting, or a firewall or another "
        "network be in between (`address` says where it is to send)"
    )
