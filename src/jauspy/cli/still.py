"""`jauspy still`: a picture by a camera of a robot."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from jauspy.cli.options import Connect, OwnId, Timeout


def still(
    *,
    camera: Annotated[str, typer.Argument(metavar="ID", help="The vision module, as in 101.1.106.")],
    save: Annotated[Path, typer.Option("--save", metavar="FILE", help="Where to save it: .jpg, .jpeg or .png.")],
    size: Annotated[
        str | None,
        typer.Option("--size", metavar="WxH", help="Size of this picture, as in 1280x720.  [default: as it is set]"),
    ] = None,
    sensor: Annotated[int, typer.Option("--sensor", min=1, max=65535, help="Which of its cameras.")] = 1,
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Timeout = 20.0,
) -> None:
    """Have a camera take a picture, and save it.

    The ending of the file's name says whether it is JPEG or PNG. For a picture that is unlike what the camera is set
    to, control is taken for a moment, and then the camera is set back.

    Examples:
      jauspy still 101.1.106 --save arm.jpg
      jauspy still 101.1.107 --save front.png --size 1280x720
    """
    from jauspy.cli import addresses
    from jauspy.cli.run import run
    from jauspy.cli.still_shot import format_of, shoot, size_of
    from jauspy.errors import ConfigError
    from jauspy.ocu import OCU
    from jauspy.ocu.stills import LARGE_IMAGE_DELIVERY

    component = addresses.destination(camera)
    if component.is_wildcard:
        raise ConfigError(f"{component} may be several; name one")
    wanted = size_of(size), format_of(save)
    ocu = OCU(addresses.own_id(own_id, connect), connect, delivery=LARGE_IMAGE_DELIVERY)
    run(shoot(ocu, component, sensor, *wanted, file=save, patience=timeout))
