"""Video over a link that delays and loses packets: age of the picture, freezes and bit rate, by what protects it.

python tools/bench/bad_link.py [--delay 0.3] [--loss 0.05] [--bursts 4 8] [--seconds 40] [--seed 2] [--rows as-is ...]

Real encoder, sender and receiver; virtual time, so that the load of the machine changes nothing. Requests of the
receiver take the same delay back, and are lost as often. The picture is one that an operator sees: none that is damaged
or follows a damaged one, but in the row `gradual`, which shows damaged ones until they have been refreshed. The first 5
seconds are not counted. All rows have the same bit rate to share, parity included.

    as-is       key pictures every 2 s and on demand
    short       a key picture every 5 pictures
    gradual     columns of macroblocks are refreshed in turn (x264's intra-refresh), and damage is shown
    slow        a quarter of the bit rate
    parity      parity packets, as many as the receiver asks for (ADR 199)

Sending lost packets again is no row: it takes a way back and one forth, so that a picture stands for twice the delay at
least.
"""

from __future__ import annotations

import argparse
import resource
from dataclasses import replace
from itertools import chain

import cv2
import numpy as np

from jauspy.platform.video_settings import H264Settings, VideoSettings, with_parity
from jauspy.video.h264 import H264Encoder
from jauspy.virtual.bad_link import Direction, Losses, burst_losses, random_losses, watch

BEGIN = 5.0
"""Seconds that are not counted."""
SETTINGS = VideoSettings()
ROWS = {
    "as-is": (SETTINGS, False, False),
    "short": (replace(SETTINGS, gop=5), False, False),
    "gradual": (replace(SETTINGS, coding=H264Settings(gradual=True)), False, True),
    "slow": (replace(SETTINGS, bit_rate=SETTINGS.bit_rate // 4), False, False),
    "parity": (SETTINGS, True, False),
}
"""Settings, whether parity is asked for, and whether damage is shown."""


def measure(name: str, losses: Losses, options: argparse.Namespace) -> str:
    """The row of a protection."""
    settings, parity, show_damaged = ROWS[name]
    encoder = H264Encoder(settings)
    noise = np.random.default_rng(7).integers(0, 255, (60, 80, 3), dtype=np.uint8)
    scene = cv2.resize(noise, (settings.width, settings.height), interpolation=cv2.INTER_CUBIC)

    def encode(number: int, idr: bool, share: float) -> list[bytes]:
        encoder.settings = with_parity(settings, share)
        return encoder.encode(np.ascontiguousarray(np.roll(scene, 4 * number, axis=1)), idr=idr)

    before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
    seen = watch(
        encode,
        Direction(losses, options.delay),
        Direction(random_losses(options.loss, options.seed + 97), options.delay),
        rate=settings.rate,
        seconds=options.seconds,
        parity=parity,
        show_damaged=show_damaged,
    )
    used = resource.getrusage(resource.RUSAGE_SELF).ru_utime - before
    ages = seen.ages(BEGIN, options.seconds)
    figures = [1e3 * ages[int(part * (len(ages) - 1))] for part in (0.5, 0.95, 1.0)] if ages else [float("nan")] * 3
    figures.append(1e3 * seen.longest_freeze(BEGIN, options.seconds))
    cells = "".join(f"{figure:9.0f}" for figure in figures)
    return f"{name:10}{cells}{seen.bit_rate / 1e6:9.2f}{len(seen.shown):9}{seen.damaged:9}{used:8.1f}"


def main() -> None:
    """Print a table for each kind of losses."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--delay", type=float, default=0.3, help="seconds, each way")
    parser.add_argument("--loss", type=float, default=0.05)
    parser.add_argument("--bursts", type=float, nargs="*", default=[4.0, 8.0], help="mean lengths, in packets")
    parser.add_argument("--seconds", type=float, default=40.0)
    parser.add_argument("--seed", type=int, default=2)
    parser.add_argument("--rows", nargs="+", choices=list(ROWS), default=list(ROWS))
    options = parser.parse_args()
    kinds = chain([("random", None)], ((f"bursts of {length:g}", length) for length in options.bursts))
    for kind, length in kinds:
        heads = ("age p50", "p95", "most", "freeze", "Mbit/s", "shown", "damaged")
        print(f"\n{kind}, ms\n{'':10}" + "".join(f"{head:>9}" for head in heads) + f"{'CPU s':>8}")
        for name in options.rows:
            losses = (
                random_losses(options.loss, options.seed)
                if length is None
                else burst_losses(options.loss, length, options.seed)
            )
            print(measure(name, losses, options), flush=True)


if __name__ == "__main__":
    main()
