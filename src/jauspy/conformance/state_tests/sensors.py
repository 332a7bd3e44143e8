"""Settings of sensors and still images: confirmed settings must be in use, refused or ignored ones must not."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, Final

from jauspy.codec.message import Message
from jauspy.conformance.checks import Check, has, that
from jauspy.conformance.results import Skipped
from jauspy.conformance.state_tests.events import CREATE
from jauspy.conformance.state_tests.explorer import Explorer, Stimulus, StimulusResult
from jauspy.conformance.tester import OBSERVER
from jauspy.messages.environment_sensing.v1_0.types import SensorIdRec
from jauspy.messages.environment_sensing.v2_0.digital_video import (
    QueryDigitalVideoSensorConfiguration as QueryVideo,
    ReportDigitalVideoSensorConfiguration as ReportVideo,
    SetDigitalVideoSensorConfiguration as SetVideo,
)
from jauspy.messages.environment_sensing.v2_0.h264_video_encoding import (
    QueryH264VideoEncodingConfiguration as QueryEncoding,
    ReportH264VideoEncodingConfiguration as ReportEncoding,
    SetH264VideoEncodingConfiguration as SetEncoding,
)
from jauspy.messages.environment_sensing.v2_0.range_sensor import (
    ConfirmSensorConfiguration,
    QueryRangeSensorConfiguration as QueryRange,
    ReportRangeSensorConfiguration as ReportRange,
    SetRangeSensorConfiguration as SetRange,
)
from jauspy.messages.environment_sensing.v2_0.still_image import (
    QueryStillImageDataExt,
    QueryStillImageSensorConfiguration as QueryStill,
    ReportStillImageDataExt,
    ReportStillImageSensorConfiguration as ReportStill,
    SetStillImageSensorConfiguration as SetStill,
)
from jauspy.messages.environment_sensing.v2_0.visual_sensor import (
    QueryVisualSensorConfiguration as QueryVisual,
    ReportVisualSensorConfiguration as ReportVisual,
    SetVisualSensorConfiguration as SetVisual,
)

ENVIRONMENT_SENSING: Final = "urn:jaus:jss:environmentSensing:"
"""Beginning of the ids of its services: IOP has messages of the same names with other fields."""
CURRENT_SETTING: Final = "setting of a sensor"
PRECISION: Final = 0.01
"""Allowed relative error of a value by its resolution on the wire and in the sensor."""


@dataclass(frozen=True, slots=True)
class SensorSetting:
    """One field of the configuration of sensors."""

    field: str
    command: Callable[[int, Any], Message]
    """Makes the command from the id of a sensor and the value."""
    query: Message
    report: type[Message]
    records: Callable[[Any], Iterable[Any]]
    """The records of a report, one for each sensor."""
    other: Callable[[Any], Any]
    """Another value, set during the step; the sensor may refuse it."""

    def stimulus(self) -> Stimulus:
        """The command that sets it."""
        return Stimulus(
            self.command(1, None).NAME,
            lambda explorer: self.command(_sensor(explorer), self.other(_value(explorer))),
            before=self._read,
            after=self._set_back,
            checks={"ConfirmSensorConfiguration": has(request_id_rec__request_id=CREATE)},
            verify=self._check_setting,
            of=ENVIRONMENT_SENSING,
        )

    def _values(self, report: Message) -> dict[int, Any]:
        return {record.sensor_id: getattr(record, self.field) for record in self.records(report)}

    def _read(self, explorer: Explorer, role: str) -> None:  # noqa: ARG002 - a Prepare
        explorer.tester.memory.pop(CURRENT_SETTING, None)
        report = explorer.client(OBSERVER).ask(self.query, self.report, to=explorer.component)
        known = next((item for item in self._values(report).items() if item[1] is not None), None)
        if known is None:
            raise Skipped(f"{self.report.NAME} contains no {self.field}, so the setting cannot be verified")
        explorer.tester.memory[CURRENT_SETTING] = known

    def _set_back(self, explorer: Explorer, role: str) -> None:
        if CURRENT_SETTING in explorer.tester.memory:
            explorer.client(role).send(self.command(_sensor(explorer), _value(explorer)), to=explorer.component)
            explorer.observe()

    def _check_setting(self, then: StimulusResult) -> None:
        explorer = then.explorer
        taken = then.outcome.acts and _is_confirmed(then)
        wanted = self.other(_value(explorer)) if taken else _value(explorer)

        def problem(report: Message) -> str:
            value = self._values(report).get(_sensor(explorer))
            same = value is not None and abs(value - wanted) <= PRECISION * abs(wanted)
            return "" if same else f"{self.field} of sensor {_sensor(explorer)} is {value}, not {wanted}"

        right = Check("shows what was confirmed, and nothing else", problem)
        explorer.client(OBSERVER).ask(self.query, self.report, right, to=explorer.component)


def _sensor(explorer: Explorer) -> int:
    found: int = explorer.tester.memory[CURRENT_SETTING][0]
    return found


def _value(explorer: Explorer) -> Any:
    return explorer.tester.memory[CURRENT_SETTING][1]


def _is_confirmed(then: StimulusResult) -> bool:
    """True if the sensor confirms the setting. Checks that the answer is about that sensor alone."""
    explorer = then.explorer
    answer = ConfirmSensorConfiguration.decode(explorer.client(then.role).confirmed[-1].payload)
    about = [getattr(confirm_sensor, "sensor_id", None) for confirm_sensor in answer.confirm_sensor_list]
    wrong = "" if about == [_sensor(explorer)] else f"it is about {about}, and sensor {_sensor(explorer)} was to be set"
    explorer.tester.check("the answer is about the sensor that was to be set", wrong)
    return isinstance(answer.confirm_sensor_list[0], SensorIdRec)


ALL: Final = 0
"""The sensor id that means every sensor."""
JPEG, PNG = SetStill.StillImageFormat.JPEG, SetStill.StillImageFormat.PNG

SETTINGS: Final = (
    SensorSetting(
        "update_rate",
        lambda sensor, rate: SetRange(
            SetRange.RequestIdRec(CREATE), [SetRange.RangeSensorConfigurationRec(sensor, update_rate=rate)]
        ),
        QueryRange([QueryRange.QueryRangeSensorConfigurationRec(ALL, 0xFFFF)]),
        ReportRange,
        lambda report: report.range_sensor_configuration_list,
        other=lambda rate: rate / 2,
    ),
    SensorSetting(
        "horizontal_field_of_view",
        lambda sensor, angle: SetVisual(
            SetVisual.RequestIdRec(CREATE),
            [SetVisual.VisualSensorConfigurationRec(sensor, horizontal_field_of_view=angle)],
        ),
        QueryVisual([QueryVisual.QueryVisualSensorConfigurationRec(ALL, 0xFFFF)]),
        ReportVisual,
        lambda report: report.visual_sensor_configuration_list,
        other=lambda angle: angle / 2,
    ),
    SensorSetting(
        "frame_rate",
        lambda sensor, rate: SetVideo(
            SetVideo.RequestIdRec(CREATE), [SetVideo.DigitalVideoSensorConfigurationRec(sensor, frame_rate=rate)]
        ),
        QueryVideo([QueryVideo.QueryDigitalVideoConfigurationRec(ALL, 0xFF)]),
        ReportVideo,
        lambda report: report.digital_video_sensor_configuration_list,
        other=lambda rate: max(1, rate // 2) if rate != 1 else 2,
    ),
    SensorSetting(
        "still_image_format",
        lambda sensor, coding: SetStill(
            SetStill.RequestIdRec(CREATE),
            [SetStill.StillImageSensorConfigurationRec(sensor, still_image_format=coding)],
        ),
        QueryStill([QueryStill.QueryStillImageSensorConfigurationRec(ALL, 0xFF)]),
        ReportStill,
        lambda report: report.still_image_sensor_configuration_list,
        other=lambda coding: PNG if coding == JPEG else JPEG,
    ),
    SensorSetting(
        "group_of_pictures",
        lambda sensor, pictures: SetEncoding(
            SetEncoding.RequestIdRec(CREATE),
            [
                SetEncoding.H264ConfigurationSequence(
                    SetEncoding.H264ConfigurationRec(sensor, group_of_pictures=pictures)
                )
            ],
        ),
        QueryEncoding([QueryEncoding.QueryH264VideoEncodingRec(ALL)]),
        ReportEncoding,
        lambda report: [
            h264_configuration.h264_configuration_rec for h264_configuration in report.h264_configuration_list
        ],
        other=lambda pictures: max(1, pictures // 2) if pictures != 1 else 2,
    ),
)
SENSORS: Final = tuple(setting.stimulus() for setting in SETTINGS)


IMAGE_TIMEOUT: Final = 10.0
"""Seconds until the first image of a camera that has to be started."""

_ANY: Final = {"isCoordinateTransformSupported": False}
"""Predicates whose values make no difference to the outputs."""

_ALL: Final = QueryStillImageDataExt.QueryStillImageDataRec(
    QueryStillImageDataExt.SensorID.ALL_SENSORS, QueryStillImageDataExt.ReportCoordinateSystem.NATIVE, 0xFF
)


def _has_pictures(report: ReportStillImageDataExt) -> bool:
    pictures = report.still_image_data_list
    return bool(pictures) and all(picture.image_frame is not None or picture.still_image_uri for picture in pictures)


STILL_IMAGES: Final = (
    Stimulus("QueryStillImageDataExt", lambda _: QueryStillImageDataExt([]), "no camera", _ANY),
    Stimulus(
        "QueryStillImageDataExt",
        lambda _: QueryStillImageDataExt([_ALL]),
        "all cameras",
        _ANY,
        checks={
            "ReportStillImageDataExt": (that("has a picture of each camera, or where to fetch it", _has_pictures),)
        },
        seconds=lambda _: IMAGE_TIMEOUT,
        once=True,  # control would time out in the meantime
    ),
)
