"""Messages of iop, v1_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.iop.v1_0.types import (
        CostAndConfidenceDataRec as CostAndConfidenceDataRec, CostDataRec as CostDataRec,
        CostMap2DGlobalPoseRec as CostMap2DGlobalPoseRec, CostMap2DLocalPoseRec as CostMap2DLocalPoseRec,
        CostMap2DRec as CostMap2DRec, DeviceRec as DeviceRec,
        DigitalResourceEndpointRec as DigitalResourceEndpointRec, GlobalPoseRec as GlobalPoseRec,
        GlobalVertexRec as GlobalVertexRec, LocalVertexRec as LocalVertexRec,
        PathReporterCapabilitiesRec as PathReporterCapabilitiesRec, QueryCostMap2DRec as QueryCostMap2DRec,
        ReadingRec as ReadingRec, ReleaseControlRec as ReleaseControlRec,
        RunLengthEncodedDataRec as RunLengthEncodedDataRec, TimestampRec as TimestampRec, ValueRec as ValueRec,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.iop.v1_0.types": "CostAndConfidenceDataRec CostDataRec CostMap2DGlobalPoseRec CostMap2DLocalPoseRec CostMap2DRec DeviceRec DigitalResourceEndpointRec GlobalPoseRec GlobalVertexRec LocalVertexRec PathReporterCapabilitiesRec QueryCostMap2DRec ReadingRec ReleaseControlRec RunLengthEncodedDataRec TimestampRec ValueRec",
})
