"""All robots that are broken on purpose: each with one small fault, and the steps that must catch it."""

from __future__ import annotations

from typing import Final

from tests.conformance.faults_generated import GENERATED
from tests.conformance.faults_igvc_2011 import IGVC_2011
from tests.conformance.faults_igvc_2015 import IGVC_2015
from tests.conformance.faults_transport import TRANSPORT
from tests.conformance.injectors import Fault

HAND_WRITTEN: Final = {"igvc-2015": IGVC_2015, "igvc-2011": IGVC_2011, "transport": TRANSPORT}
ALL: Final[tuple[Fault, ...]] = (*IGVC_2015, *IGVC_2011, *TRANSPORT, *GENERATED)
