"""A service of your own: a winch, its JSIDL definition, a component and a client.

winch.xml was written by `jauspy new definition urn:example:Winch length:meter`. `python own_service.py` runs the
component, `python own_service.py client` the client; a node manager (`jauspy node-manager`) connects them.
"""

import asyncio
import sys
from pathlib import Path

import jauspy

WINCH = jauspy.load(Path(__file__).with_name("winch.xml"))
QueryWinch, ReportWinch = WINCH.by_name("QueryWinch"), WINCH.by_name("ReportWinch")


class Winch(jauspy.Service, urn="urn:example:Winch", definitions=WINCH):
    """Pays out rope at 5 cm/s."""

    length = 0.0  # metres

    def attached(self) -> None:
        self.every(0.1, self.pay_out)

    def pay_out(self) -> None:
        self.length = min(20.0, self.length + 0.005)

    def report_winch(self) -> jauspy.Message:
        """Called to answer QueryWinch, and for each event on it."""
        return ReportWinch(length=self.length)


async def client(connect: str | None) -> None:
    async with jauspy.OCU("42.1.1", connect, registry=WINCH) as ocu:
        robot = await ocu.discover(subsystem=101)
        async for report in robot.service("urn:example:Winch").subscribe(QueryWinch(presence_vector=1), rate=5.0):
            print(f"{report.length:.2f} m of rope")
            if report.length > 0.1:
                break


if __name__ == "__main__":
    if sys.argv[1:2] == ["client"]:
        asyncio.run(client(sys.argv[2] if len(sys.argv) > 2 else None))
    else:
        connect = sys.argv[1] if len(sys.argv) > 1 else None
        jauspy.run(jauspy.Component("101.1.120", [Winch()], name="winch", connect=connect))
