"""Emergencies of many forged ids: they do not end that of an honest client, whether it came before or after them."""

from __future__ import annotations

import pytest
from tests.services.conftest import Rig

from jauspy.messages.core import ClearEmergency, ReportStatus, SetEmergency
from jauspy.services.core import AccessControl, Management
from jauspy.services.core.management import MAX_EMERGENCY_CLIENTS

HONEST = "42.1.1"
STOP, CLEAR = SetEmergency(emergency_code=1), ClearEmergency(emergency_code=1)


@pytest.mark.parametrize("forged", ["9.{}.{}", "{1}.{0}.1"])
@pytest.mark.parametrize("number", [64, 2 * MAX_EMERGENCY_CLIENTS])
@pytest.mark.parametrize("is_first", [True, False])
def test_forged_emergencies_do_not_end_an_honest_one(forged, number, is_first) -> None:
    rig = Rig(AccessControl(), Management())
    ids = [forged.format(each // 250 + 1, each % 250 + 1) for each in range(number)]
    ids = [each for each in ids if each != HONEST]
    if is_first:
        rig.tell(HONEST, STOP)
    for each in ids:
        rig.tell(each, STOP)
    if not is_first:
        rig.tell(HONEST, STOP)
    for each in ids:
        rig.tell(each, CLEAR)
    assert rig.host.status is ReportStatus.Status.EMERGENCY
    rig.tell(HONEST, CLEAR)
    if len(ids) < MAX_EMERGENCY_CLIENTS:
        assert rig.host.status is ReportStatus.Status.STANDBY
    else:  # nobody can tell any more whether all have cleared it
        assert rig.host.status is ReportStatus.Status.EMERGENCY
