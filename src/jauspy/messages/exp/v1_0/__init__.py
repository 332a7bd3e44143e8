"""Messages of exp, v1_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.exp.v1_0.types import (
        AttachmentFrameRecord as AttachmentFrameRecord, EncodingQuality as EncodingQuality,
        EndpointRecord as EndpointRecord, Formats as Formats, SampleWidths as SampleWidths,
        SeverityRec as SeverityRec, UGVSeverityRec as UGVSeverityRec,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.exp.v1_0.types": "AttachmentFrameRecord EncodingQuality EndpointRecord Formats SampleWidths SeverityRec UGVSeverityRec",
})
