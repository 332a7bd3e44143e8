"""Queries for still images: of no camera, and of all there are."""

from __future__ import annotations

from typing import Final

from jauspy.conformance.checks import that
from jauspy.conformance.walk.explorer import Stimulus
from jauspy.messages.environment_sensing.v2_0.still_image import QueryStillImageDataExt, ReportStillImageDataExt

PATIENCE: Final = 10.0
"""Seconds that a picture may take, from a camera that has to be switched on."""

_ANY: Final = {"isCoordinateTransformSupported": False}
"""Whether it is makes no difference to what is sent."""

_ALL: Final = QueryStillImageDataExt.QueryStillImageDataRec(
    QueryStillImageDataExt.SensorID.ALL_SENSORS, QueryStillImageDataExt.ReportCoordinateSystem.NATIVE, 0xFF
)


def _has_pictures(report: ReportStillImageDataExt) -> bool:
    pictures = report.still_image_data_list
    return bool(pictures) and all(each.image_frame is not None or each.still_image_uri for each in pictures)


PICTURES: Final = (
    Stimulus("QueryStillImageDataExt", lambda _: QueryStillImageDataExt([]), "no camera", _ANY),
    Stimulus(
        "QueryStillImageDataExt",
        lambda _: QueryStillImageDataExt([_ALL]),
        "all cameras",
        _ANY,
        checks={
            "ReportStillImageDataExt": (that("has a picture of each camera, or where to fetch it", _has_pictures),)
        },
        seconds=lambda _: PATIENCE,
        once=True,  # control would time out meanwhile
    ),
)
