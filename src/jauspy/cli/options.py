"""Options that several verbs share, so that they read and behave the same everywhere."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

DEFAULT_PORT = 3794
DEFAULT_ROOT = Path("/tmp")  # noqa: S108  # where the Junior protocol of the JAUS Toolset has its sockets

Port = Annotated[int, typer.Option("--port", min=1, max=65535, help="UDP port; 3794 is registered for JAUS.")]
LocalRoot = Annotated[
    Path, typer.Option("--local-root", metavar="DIR", help="Directory of the local sockets (JuniorRTE).")
]
Connect = Annotated[
    str | None,
    typer.Option(
        "--connect",
        metavar="WHERE",
        help="How to reach the node manager: udp://HOST:PORT, tcp://HOST:PORT or local:DIR. "
        "Default: the one in /tmp, else multicast.",
    ),
]
OwnId = Annotated[
    str | None,
    typer.Option("--id", metavar="ID", help="The JAUS id to speak as. Default: 42.1.2, or the next that is free."),
]
Timeout = Annotated[float, typer.Option("--timeout", min=0.01, metavar="SECONDS", help="How long to wait for answers.")]
Json = Annotated[bool, typer.Option("--json", help="One JSON object per line.")]
WithParent = Annotated[
    bool, typer.Option("--with-parent", hidden=True, help="End when standard input closes, as it does with the parent.")
]
