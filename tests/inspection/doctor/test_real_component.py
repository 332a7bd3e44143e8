"""A component of jauspy behind its node manager: nothing is wrong with it, and it judges the seals of operators."""

from __future__ import annotations

import asyncio
from pathlib import Path

from jauspy.component import Component
from jauspy.ids import JausID
from jauspy.inspection.doctor.examination import Examination
from jauspy.inspection.doctor.findings import Finding, Severity
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol.seal import Operator, OperatorKey
from jauspy.services.core import AccessControl, Discovery, Events, Liveness, Management, Time
from jauspy.services.core.command_seal import CommandSeal
from jauspy.transport import LocalTransport

PEER, GROUP = JausID(101, 1, 1), "239.255.77.1"


async def test_seals_and_everything_else(free_port: int, root: Path) -> None:
    alice, mallory, oscar = OperatorKey.generate(), OperatorKey.generate(), OperatorKey.generate()
    operators = [Operator("alice", "operator", 127, alice.public), Operator("oscar", "observer", 0, oscar.public)]
    services = [AccessControl(), Events(), Discovery(), Liveness(), Management(), Time()]
    services.append(CommandSeal(operators, secret=bytes(32)))
    config = NodeConfig.make(
        local_root=root, port=free_port, multicast_group=GROUP, multicast_interfaces=("127.0.0.1",)
    )

    async def examined(key: OperatorKey | None) -> list[Finding]:
        examination = Examination(
            ids=(JausID(42, 1, 2),),
            used_interfaces=("127.0.0.1",),
            root=root,
            chosen=("127.0.0.1",),
            port=free_port,
            group=GROUP,
            peer=PEER,
            key=key,
        )
        return await asyncio.to_thread(lambda: list(examination.findings()))

    async with NodeManager(config), Component(PEER, services, transport=LocalTransport(PEER, root)):
        found = {finding.check: finding for finding in await examined(alice)}
        assert [finding for finding in found.values() if finding.severity is not Severity.OK] == []
        assert found["seal"].what == "101.1.1 takes what is sealed with this key"
        for key, reason in ((mallory, "its key is not in the operators file"), (None, "")):
            (seal,) = [finding for finding in await examined(key) if finding.check == "seal"]
            assert seal.severity is (Severity.FAIL if reason else Severity.WARN)
            assert reason in seal.what
