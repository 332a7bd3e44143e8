"""Size and rates of a camera's stream, as `jauspy video` and the demo set them."""

from __future__ import annotations

from dataclasses import dataclass

from jauspy.errors import ConfigError, RequestError
from jauspy.messages.environment_sensing.v2_0.digital_video import SetDigitalVideoSensorConfiguration
from jauspy.messages.environment_sensing.v2_0.visual_sensor import ConfirmSensorConfiguration
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.robot import ComponentClient
from jauspy.platform.video_settings import SUPPORTED_FRAME_SIZES, FrameSize, frame_size


@dataclass(frozen=True, slots=True)
class StreamSettings:
    """What is to be changed; None keeps what the camera has."""

    size: FrameSize | None = None
    rate: int | None = None
    """Pictures per second."""
    bit_rate: int | None = None
    """Kilobits per second."""

    @property
    def is_empty(self) -> bool:
        """True if nothing is to be changed."""
        return self == StreamSettings()


def known_size(pixels: tuple[int, int] | None) -> FrameSize | None:
    """JAUS's number of a size; raises `ConfigError` with the sizes that there are."""
    if pixels is None:
        return None
    found = frame_size(*pixels)
    if found not in SUPPORTED_FRAME_SIZES:
        sizes = sorted(set(SUPPORTED_FRAME_SIZES.values()))
        known = ", ".join(f"{width}x{height}" for width, height in sizes)
        raise ConfigError(f"--size {pixels[0]}x{pixels[1]}: JAUS has no such size for video; it has: {known}")
    return found


async def change_stream(
    camera: ComponentClient, sensor: int, settings: StreamSettings, *, authority: int = DEFAULT_AUTHORITY
) -> None:
    """Set them for all who watch, which needs control for a moment; raises `RequestError` with what was refused."""
    service = camera.service("DigitalVideo")
    order = SetDigitalVideoSensorConfiguration
    wanted = order.DigitalVideoSensorConfigurationRec(
        sensor, frame_size=settings.size, frame_rate=settings.rate, maximum_bit_rate=settings.bit_rate
    )
    async with service.control(authority):
        await service.resume()
        answer = await service.query(order(order.RequestIdRec(1), [wanted]), expects=ConfirmSensorConfiguration)
    for each in answer.confirm_sensor_list:
        if text := getattr(each, "error_message", ""):
            raise RequestError(f"{camera.id} refused the settings of its video: {text}")
