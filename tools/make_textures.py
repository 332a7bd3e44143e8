"""Make the textures of the worlds: grounds, walls, things, signs and the sky.

    python tools/make_textures.py [-o FOLDER] [NAME ...]

writes PNG files to `src/jauspy_sim/worlds/assets`, or to FOLDER; with names, only these. All are computed: noise with a
spectrum (FFT), cells around random points, lines and letters. Textures of surfaces repeat without a seam. `look.xml`
beside them says how many metres each covers.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont
from scipy.spatial import cKDTree

Array: TypeAlias = NDArray[np.float64]
Colour: TypeAlias = tuple[float, float, float]

TARGET: Final = Path(__file__).parents[1] / "src" / "jauspy_sim" / "worlds" / "assets"
SIZE: Final = 512
"""Pixels of a side of most textures."""
FONT: Final = "DejaVuSans-Bold.ttf"


def noise(
    slope: float, seed: int, *, size: int = SIZE, stretch: tuple[float, float] = (1.0, 1.0), low: float = 1.0
) -> Array:
    """Periodic noise, mean 0, deviation 1: the amplitude falls with frequency ** slope; `low`: the lowest frequency.

    `stretch` (down, across) makes its grains longer in one direction.
    """
    random = np.random.default_rng(seed)
    fy, fx = (
        np.fft.fftfreq(size, 1.0 / size)[:, None] * stretch[0],
        np.fft.fftfreq(size, 1.0 / size)[None, :] * stretch[1],
    )
    frequency = np.hypot(fx, fy)
    amplitude = np.where(frequency >= low, np.maximum(frequency, 1.0) ** -slope, 0.0)
    made = np.real(np.fft.ifft2(np.fft.fft2(random.normal(size=(size, size))) * amplitude))
    scaled: Array = (made - made.mean()) / made.std()
    return scaled


def cells(count: int, seed: int, *, size: int = SIZE) -> tuple[Array, Array, NDArray[np.int64]]:
    """Of each pixel the distances to the nearest and second nearest of random points (pixels), and which is nearest."""
    points = np.random.default_rng(seed).uniform(0.0, size, (count, 2))
    tree = cKDTree(points, boxsize=size)
    y, x = np.mgrid[0:size, 0:size]
    distances, nearest = tree.query(np.stack([y.ravel(), x.ravel()], axis=1) % size, k=2)
    first, second = distances[:, 0].reshape(size, size), distances[:, 1].reshape(size, size)
    return first, second, nearest[:, 0].reshape(size, size)


def tinted(value: Array, colour: Colour) -> Array:
    """A colour (0..1) with brightness factors of shape (rows, columns)."""
    shaded: Array = np.asarray(value)[..., None] * np.array(colour)
    return shaded


def mixed(a: Array, b: Array | Colour, weight: Array) -> Array:
    """`a` where the weight is 0, `b` where it is 1."""
    w = np.clip(weight, 0.0, 1.0)[..., None]
    blended: Array = a * (1.0 - w) + np.asarray(b) * w
    return blended


def edge(value: Array, at: float | Array, width: float) -> Array:
    """0 below `at`, 1 above `at + width`, smooth between."""
    t = np.clip((value - at) / width, 0.0, 1.0)
    smooth: Array = t * t * (3.0 - 2.0 * t)
    return smooth


def relief(height: Array, strength: float) -> Array:
    """Brightness of a surface of that height (pixels) with light from the upper left."""
    dy, dx = height - np.roll(height, 1, 0), height - np.roll(height, 1, 1)
    lit: Array = 1.0 + strength * np.clip(dx + dy, -1.5, 1.5)
    return lit


# --- grounds ---------------------------------------------------------------------------------------------------------


def asphalt() -> Array:
    """Stones in bitumen, worn and patched."""
    count = 30000  # of about a centimetre
    first, second, which = cells(count, 1)
    random = np.random.default_rng(2)
    stones = random.normal(0.0, 1.0, count)[which]
    bitumen = edge(second - first, 0.0, 1.3)
    worn = noise(1.6, 3, low=5.0)  # what is larger would show that it repeats
    value = 0.315 + 0.035 * worn * 0.5 + bitumen * (0.05 * stones + 0.035) - 0.05 * (1.0 - bitumen)
    bright = edge(random.uniform(size=count)[which], 0.975, 0.01) * bitumen
    value = value + 0.20 * bright
    return np.clip(tinted(value, (1.0, 0.995, 0.98)), 0.05, 0.9)


def concrete() -> Array:
    """Cast concrete with small pores; what is larger than a hand is even, so that it does not show that it repeats."""
    return _concrete(SIZE, 11)


def _concrete(size: int, seed: int) -> Array:
    value = 0.62 + 0.020 * noise(1.3, seed, size=size, low=0.012 * size) + 0.020 * noise(0.4, seed + 1, size=size)
    count = size * size // 290
    first, _, which = cells(count, seed + 2, size=size)
    radius = np.minimum(np.random.default_rng(seed + 3).exponential(0.55, count), 1.5)[which]
    return tinted(value * (1.0 - 0.22 * (1.0 - edge(first, radius, 1.0))), (1.0, 0.985, 0.95))


def apron() -> Array:
    """A slab of an apron of concrete, 4 m: brushed across, with joints around it."""
    size = 1024
    y, x = np.mgrid[0:size, 0:size] + 0.5
    made = _concrete(size, 15) * (1.0 + 0.018 * noise(0.5, 18, size=size, stretch=(0.3, 12.0)))[..., None]
    wobble = 0.8 * noise(1.2, 19, size=size, low=8.0)
    inside = np.minimum.reduce([x, size - x, y, size - y]) + wobble
    made = made * (1.0 - 0.05 * (1.0 - edge(inside, 4.0, 60.0)))[..., None]
    return mixed(tinted(0.30 + 0.02 * noise(0.5, 20, size=size), (1.0, 0.97, 0.92)), made, edge(inside, 1.4, 1.6))


def grass() -> Array:
    """A lawn from above: blades of many greens, a little soil."""
    random = np.random.default_rng(21)
    big = SIZE
    picture = Image.new("RGB", (big, big), (58, 66, 34))
    draw = ImageDraw.Draw(picture)
    patches = noise(1.8, 22, low=7.0)  # what is larger would show that it repeats
    for _ in range(22000):
        x, y = random.uniform(0, big, 2)
        angle, length = random.uniform(0, 2 * np.pi), random.uniform(5, 16)
        dx, dy = length * np.cos(angle), length * np.sin(angle)
        shade = 0.62 + 0.16 * random.normal() + 0.10 * patches[int(y), int(x)]
        dry = random.uniform() < 0.10 + 0.05 * patches[int(y), int(x)]
        colour = (0.62, 0.56, 0.33) if dry else (0.36 + 0.06 * random.normal(), 0.53, 0.19)
        rgb = tuple(int(max(0.0, min(255.0, 255.0 * shade * c))) for c in colour)
        for ox in (-big, 0, big):
            for oy in (-big, 0, big):
                if -20 < x + ox < big + 20 and -20 < y + oy < big + 20:
                    draw.line((x + ox, y + oy, x + dx + ox, y + dy + oy), rgb, 1 if length < 12 else 2)
    return np.asarray(picture, np.float64) / 255.0


def soil() -> Array:
    """Earth with gravel, for rubble and verges."""
    base = tinted(0.44 + 0.05 * noise(1.3, 31) + 0.03 * noise(0.3, 32), (1.0, 0.86, 0.68))
    for count, seed, reach in ((1600, 33, 4.5), (260, 36, 11.0)):
        first, second, which = cells(count, seed)
        random = np.random.default_rng(seed + 1)
        radius = random.uniform(0.2, 1.0, count)[which] * reach
        stone = (1.0 - edge(first, radius, 1.2)) * edge(second - first, 0.5, 1.0)
        grey = 0.52 + 0.11 * random.normal(size=count)[which]
        lit = relief(np.sqrt(np.maximum(radius**2 - first**2, 0.0)), 0.22)
        base = mixed(
            base * (1.0 - 0.25 * edge(-np.abs(first - radius - 1.5), -1.5, 1.5))[..., None],
            tinted(grey * lit, (1.0, 0.96, 0.9)),
            stone,
        )
    return base


def paving() -> Array:
    """Slabs of a pavement, four by four, with joints; worn unevenly."""
    count, joint = 4, 5.0
    pitch = SIZE / count
    y, x = np.mgrid[0:SIZE, 0:SIZE] + 0.5
    row, column = (y // pitch).astype(int), (x // pitch).astype(int)
    to_edge = np.minimum.reduce([x % pitch, pitch - x % pitch, y % pitch, pitch - y % pitch])
    shade = np.random.default_rng(41).normal(0.0, 0.022, (count, count))[row, column]
    value = 0.56 + shade + 0.022 * noise(1.4, 42) + 0.018 * noise(0.2, 43)
    bevel = relief(np.minimum(to_edge, joint + 2.0), 0.16)
    slab = tinted(value * bevel, (1.0, 0.975, 0.93))
    sand = tinted(0.30 + 0.05 * noise(0.3, 44), (1.0, 0.92, 0.78))
    return mixed(sand, slab, edge(to_edge, joint * 0.4, 1.6))


def tiles() -> Array:
    """Floor tiles in a house, four by four."""
    count = 4
    pitch = SIZE / count
    y, x = np.mgrid[0:SIZE, 0:SIZE] + 0.5
    row, column = (y // pitch).astype(int), (x // pitch).astype(int)
    to_edge = np.minimum.reduce([x % pitch, pitch - x % pitch, y % pitch, pitch - y % pitch])
    shade = np.random.default_rng(51).normal(0.0, 0.014, (count, count))[row, column]
    vein = edge(-np.abs(noise(1.8, 52)), -0.10, 0.10)
    value = (0.76 + shade + 0.018 * noise(1.6, 53) - 0.05 * vein) * relief(np.minimum(to_edge, 4.0), 0.06)
    return mixed(
        tinted(0.42 + 0.02 * noise(0.2, 54), (1.0, 0.97, 0.92)),
        tinted(value, (1.0, 0.965, 0.90)),
        edge(to_edge, 1.0, 1.2),
    )


# --- walls and things ------------------------------------------------------------------------------------------------


def brick() -> Array:
    """Stretcher bond, eight courses of four bricks: a metre across is 4 x 0.25 m."""
    courses, across = 12, 4
    high, wide = SIZE / courses, SIZE / across
    y, x = np.mgrid[0:SIZE, 0:SIZE] + 0.5
    wobble = 0.8 * noise(1.6, 60)
    row = (y // high).astype(int)
    shifted = (x + wobble + (row % 2) * wide / 2.0) % SIZE
    column = (shifted // wide).astype(int) % across
    to_edge = np.minimum.reduce(
        [shifted % wide, wide - shifted % wide, (y + wobble) % high, high - (y + wobble) % high]
    )
    random = np.random.default_rng(61)
    shade, red = (
        random.normal(0.0, 0.085, (courses, across))[row, column],
        random.normal(0.0, 0.035, (courses, across))[row, column],
    )
    grain = 0.06 * noise(0.5, 62) + 0.05 * noise(1.5, 63)
    value = (1.0 + shade + grain) * relief(np.minimum(to_edge, 6.0), 0.10)
    clay = np.stack([value * (0.53 + red), value * (0.315 - 0.3 * red), value * (0.245 - 0.4 * red)], axis=-1)
    mortar = tinted(0.60 + 0.05 * noise(0.5, 64), (1.0, 0.96, 0.89))
    return mixed(mortar, clay, edge(to_edge, 2.2, 1.8))


def plaster() -> Array:
    """A painted wall."""
    height = noise(1.1, 71)
    value = 0.83 * relief(1.2 * height, 0.035) + 0.012 * noise(1.9, 72)
    return tinted(value, (1.0, 0.975, 0.92))


def _grain(seed: int, *, size: int = SIZE) -> Array:
    """Wood's grain along x: rings that were cut almost along."""
    y = np.mgrid[0:size, 0:size][0] / size
    rings = np.sin(2.0 * np.pi * (9.0 * y + 0.9 * noise(2.2, seed, size=size, stretch=(1.0, 9.0))))
    fibre = noise(0.5, seed + 1, size=size, stretch=(0.4, 14.0))
    grain: Array = 0.09 * rings + 0.06 * fibre + 0.03 * noise(1.8, seed + 2, size=size)
    return grain


def wood() -> Array:
    """Furniture: one board, the grain across."""
    return np.clip(tinted(0.80 + _grain(81), (0.72, 0.50, 0.31)), 0.0, 1.0)


def planks() -> Array:
    """Eight weathered planks, one above the other."""
    count = 8
    high = SIZE / count
    y = np.mgrid[0:SIZE, 0:SIZE][0] + 0.5
    row = (y // high).astype(int)
    random = np.random.default_rng(91)
    grain = _grain(92)
    for each in range(count):
        band = row[:, 0] == each
        grain[band] = np.roll(grain[band], int(random.integers(SIZE)), axis=1)
    shade = random.normal(0.0, 0.06, count)[row]
    to_edge = np.minimum(y % high, high - y % high)
    value = (0.78 + shade + 1.1 * grain) * (0.35 + 0.65 * edge(to_edge, 0.6, 1.8))
    return np.clip(tinted(value, (0.66, 0.52, 0.37)), 0.0, 1.0)


def crate() -> Array:
    """A side of a wooden crate: boards in a frame, with nails."""
    size = 256
    boards = (
        np.asarray(Image.fromarray(_bytes(planks())).resize((size, size), Image.Resampling.LANCZOS), np.float64) / 255.0
    )
    y, x = np.mgrid[0:size, 0:size] + 0.5
    frame = 34.0
    inside = np.minimum.reduce([x, size - x, y, size - y])
    upright = np.minimum(x, size - x) < frame
    grain = _grain(95, size=size)
    board = np.where(upright, grain.T, grain)
    joint = edge(np.abs(np.minimum(x, size - x) - frame), 0.2, 1.6)
    band = tinted((0.86 + board) * (0.45 + 0.55 * np.where(inside < frame, joint, 1.0)), (0.70, 0.54, 0.36))
    shadow = 0.55 + 0.45 * edge(inside - frame, 0.0, 12.0)
    made = np.where((inside < frame)[..., None], band, boards * shadow[..., None])
    for nx in (11.0, 23.0, size - 11.0, size - 23.0):
        for ny in (13.0, 23.0, size - 13.0, size - 23.0):
            nail = 1.0 - edge(np.hypot(x - nx, y - ny), 1.2, 1.2)
            made = mixed(made, (0.22, 0.20, 0.19), nail)
    return np.clip(made * (0.55 + 0.45 * edge(inside, 0.0, 2.5))[..., None], 0.0, 1.0)


def cardboard() -> Array:
    """A side of a carton, with tape and marks."""
    size = 256
    y, x = np.mgrid[0:size, 0:size] + 0.5
    flutes = 0.010 * np.sin(2.0 * np.pi * x / 4.0)
    value = 0.76 + flutes + 0.014 * noise(1.3, 101, size=size) + 0.010 * noise(0.2, 102, size=size)
    made = tinted(value, (0.98, 0.78, 0.54))
    tape = 1.0 - edge(np.abs(y - size / 2.0), 17.0, 1.0)
    made = mixed(made, made * 0.62 + 0.30, 0.75 * tape)
    picture = Image.fromarray(_bytes(made))
    draw = ImageDraw.Draw(picture)
    ink = (88, 62, 40)
    for left in (168, 200):  # two arrows: this side up
        draw.polygon(((left, 44), (left + 12, 28), (left + 24, 44)), ink)
        draw.rectangle((left + 8, 44, left + 16, 64), ink)
    draw.line((166, 70, 226, 70), ink, 3)
    draw.rectangle((26, 184, 104, 230), None, ink, 2)
    for number, at in enumerate(range(34, 98, 4)):
        draw.line((at, 192, at, 214), ink, 1 + number * 7 % 3)
    draw.text((34, 215), "CE 114-7", ink, ImageFont.truetype(FONT, 11))
    inside = np.minimum.reduce([x, size - x, y, size - y])
    return np.clip(
        np.asarray(picture, np.float64) / 255.0 * (0.75 + 0.25 * edge(inside, 0.0, 3.0))[..., None], 0.0, 1.0
    )


def fabric() -> Array:
    """Woven cloth of a rucksack or a seat."""
    size = 256
    y, x = np.mgrid[0:size, 0:size]
    over = ((x // 4 + y // 4) % 2).astype(float)
    thread = np.where(over > 0.5, np.abs(x % 4 - 1.5), np.abs(y % 4 - 1.5)) / 1.5
    value = 0.80 - 0.22 * thread + 0.05 * noise(0.8, 111, size=size)
    return tinted(value, (1.0, 1.0, 1.0))


def metal() -> Array:
    """Galvanised sheet, grey; a material's colour tints it."""
    size = 256
    first, second, which = cells(70, 121, size=size)
    shade = np.random.default_rng(122).normal(0.0, 0.035, 70)[which]
    value = (
        0.80 + shade + 0.02 * noise(0.6, 123, size=size, stretch=(0.5, 6.0)) + 0.02 * edge(-(second - first), -1.5, 1.5)
    )
    return tinted(value, (0.985, 0.995, 1.0))


def rust() -> Array:
    """Old steel, for bins, drains and reinforcement."""
    size = 256
    a, b = noise(1.4, 131, size=size), noise(0.5, 132, size=size)
    brown = tinted(0.85 + 0.13 * b + 0.10 * a, (0.46, 0.255, 0.15))
    return np.clip(mixed(brown, tinted(0.9 + 0.1 * b, (0.30, 0.25, 0.23)), edge(a, 0.3, 1.2)), 0.0, 1.0)


def carpet() -> Array:
    """Short pile, two tones."""
    size = 256
    value = 0.85 + 0.10 * noise(0.1, 141, size=size) + 0.04 * noise(1.2, 142, size=size)
    y, x = np.mgrid[0:size, 0:size]
    line = edge(np.sin(2.0 * np.pi * x / 32.0) * np.sin(2.0 * np.pi * y / 32.0), 0.3, 0.4)
    return np.clip(mixed(tinted(value, (0.42, 0.20, 0.19)), tinted(value, (0.55, 0.40, 0.28)), 0.6 * line), 0.0, 1.0)


# --- decals ----------------------------------------------------------------------------------------------------------


def stripes() -> Array:
    """Warning stripes, black and yellow, 45 degrees."""
    size = 128
    y, x = np.mgrid[0:size, 0:size]
    wave = np.abs((x + y) % (size // 2) - size // 4) - size / 8.0
    made = mixed(np.full((size, size, 3), (0.93, 0.70, 0.03)), (0.06, 0.06, 0.06), edge(wave, -0.5, 1.0))
    dirty: Array = made * (1.0 + 0.02 * noise(1.0, 151, size=size))[..., None]
    return dirty


def _large(width: int, height: int, fill: tuple[int, int, int]) -> tuple[Image.Image, ImageDraw.ImageDraw]:
    """A picture four times as large as asked for, to be reduced by `_small`."""
    picture = Image.new("RGB", (4 * width, 4 * height), fill)
    return picture, ImageDraw.Draw(picture)


def _small(picture: Image.Image) -> Array:
    return (
        np.asarray(picture.resize((picture.width // 4, picture.height // 4), Image.Resampling.LANCZOS), np.float64)
        / 255.0
    )


def hazard() -> Array:
    """A warning sign: explosives. Fills a square; the triangle's outside is white."""
    picture, draw = _large(256, 256, (236, 236, 232))
    draw.polygon(((512, 60), (984, 900), (40, 900)), (20, 20, 20))
    draw.polygon(((512, 132), (918, 862), (106, 862)), (240, 186, 10))
    random = np.random.default_rng(161)
    draw.ellipse((432, 580, 612, 760), (20, 20, 20))
    for number in range(14):
        turn = 2.0 * np.pi * number / 14.0 + random.uniform(-0.08, 0.08)
        reach = random.uniform(150, 205)
        tip = (522 + reach * np.cos(turn), 670 + reach * np.sin(turn))
        sides = [(522 + 84 * np.cos(turn + d), 670 + 84 * np.sin(turn + d)) for d in (-0.16, 0.16)]
        draw.polygon((tip, *sides), (20, 20, 20))
    return _small(picture)


def paint() -> Array:
    """Lines on a road, worn where tyres roll: asphalt shows through; a material's colour tints it."""
    worn = noise(0.9, 181, low=4.0) + 0.5 * noise(0.3, 182)
    value = 0.93 + 0.03 * noise(0.8, 183)
    return np.clip(mixed(tinted(value, (1.0, 1.0, 1.0)), (0.40, 0.40, 0.40), 0.9 * edge(worn, 1.35, 0.5)), 0.0, 1.0)


def sign() -> Array:
    """A notice on a wall, 10 : 7: no entry while devices are tested."""
    picture, draw = _large(320, 224, (232, 232, 228))
    draw.rectangle((0, 0, 1280, 250), (236, 182, 12))
    draw.polygon(((150, 30), (262, 220), (38, 220)), (20, 20, 20))
    draw.polygon(((150, 66), (230, 202), (70, 202)), (236, 182, 12))
    draw.rectangle((143, 104, 157, 160), (20, 20, 20))
    draw.ellipse((142, 170, 158, 186), (20, 20, 20))
    draw.text((310, 52), "TEST RANGE", (20, 20, 20), ImageFont.truetype(FONT, 126))
    for row, text in enumerate(("Robots in operation.", "No entry while the", "lamp is lit.")):
        draw.text((60, 310 + 160 * row), text, (24, 26, 30), ImageFont.truetype(FONT, 96))
    draw.rectangle((0, 0, 1279, 895), None, (24, 26, 30), 16)
    return _small(picture)


# --- sky -------------------------------------------------------------------------------------------------------------

SUN: Final = (-0.303, -0.505, 0.808)
"""Where the sun is, as a unit vector: opposite to the direction of `sun` in look.xml."""


HAZE: Final = (0.84, 0.89, 0.92)
"""The colour of the sky at the horizon."""

FIELDS: Final = (0.50, 0.55, 0.43)
"""The colour of all below the horizon: that of `haze` in look.xml, in which the ground ends."""


def sky() -> Array:
    """A summer sky with some clouds, as a cross of six faces, four across and three down."""
    size = 512
    v, u = (np.mgrid[0:size, 0:size] + 0.5) / size * 2.0 - 1.0
    one = np.ones_like(u)
    # the direction of each pixel, x to the right of MuJoCo's box, z up
    faces = {
        "R": (one, u, -v),
        "L": (-one, -u, -v),
        "U": (u, -v, one),
        "D": (u, v, -one),
        "F": (u, -one, -v),
        "B": (-u, one, -v),
    }
    places = {"U": (0, 1), "L": (1, 0), "F": (1, 1), "R": (1, 2), "B": (1, 3), "D": (2, 1)}
    made = np.zeros((3 * size, 4 * size, 3))
    for name, (row, column) in places.items():
        direction = np.stack(faces[name], axis=-1)
        direction /= np.linalg.norm(direction, axis=-1, keepdims=True)
        made[row * size : (row + 1) * size, column * size : (column + 1) * size] = sky_colour(direction)
    return made


def sky_colour(direction: Array) -> Array:
    """Colours in directions (unit vectors, z up)."""
    z = direction[..., 2]
    up = np.clip(z, 0.0, 1.0)
    base = mixed(np.full((*z.shape, 3), HAZE), (0.24, 0.46, 0.78), 1.0 - (1.0 - up) ** 2.6)
    field = noise(1.75, 171, size=1024, low=3.0)
    plane = direction[..., :2] / np.maximum(z, 0.04)[..., None]  # clouds in a layer of height 1, 8 wide
    at = np.floor(plane / 9.0 * 1024).astype(int) % 1024
    density = field[at[..., 1], at[..., 0]]
    cloud = edge(density, 0.45, 1.7) * edge(z, 0.03, 0.22)
    bright = 0.97 - 0.10 * edge(density, 1.2, 1.8)
    base = mixed(base, tinted(bright, (1.0, 1.0, 1.01)), 0.85 * cloud)
    near = np.clip(direction @ np.array(SUN), 0.0, 1.0)
    base = base + (0.30 * near**24 + 0.8 * near**900)[..., None] * np.array((1.0, 0.95, 0.84))
    return np.clip(_landscape(base, direction), 0.0, 1.0)


def _landscape(base: Array, direction: Array) -> Array:
    """Hills, woods and fields before a sky: the nearer, the greener and the darker."""
    z = direction[..., 2]
    around = np.arctan2(direction[..., 1], direction[..., 0]) / (2.0 * np.pi) % 1.0

    def line(seed: int, slope: float, low: float, count: int = 2048) -> Array:
        values = noise(slope, seed, size=count, low=low)[0]
        values = values / np.abs(values).max()
        found: Array = np.interp(around, np.arange(count) / count, values, period=1.0)
        return found

    for top, rough, colour, width in (
        (0.046 + 0.022 * line(172, 1.6, 2.0), 0.0, (0.66, 0.74, 0.79), 0.004),
        (0.030 + 0.014 * line(173, 1.5, 4.0), 0.001, (0.55, 0.63, 0.64), 0.003),
        (0.017 + 0.007 * line(174, 1.2, 9.0), 0.002, (0.42, 0.50, 0.44), 0.003),
    ):
        base = mixed(base, colour, edge(top + rough * line(175, 0.3, 60.0) - z, 0.0, width))
    # the edge of a wood: crowns, lighter above, in groups with gaps
    crowns, groups = line(176, 0.45, 40.0), line(177, 1.0, 6.0)
    top = 0.007 + 0.007 * edge(groups, -0.45, 0.5) + 0.004 * crowns
    light = 0.86 + 0.20 * np.clip(z / 0.016, 0.0, 1.0) + 0.12 * line(178, 0.2, 90.0)
    base = mixed(base, tinted(light, (0.27, 0.34, 0.22)), edge(top - z, 0.0, 0.002))
    return mixed(base, FIELDS, edge(-z, -0.002, 0.004))


# --- files -----------------------------------------------------------------------------------------------------------

TEXTURES: Final[dict[str, tuple[Callable[[], Array], int]]] = {
    "asphalt": (asphalt, 24),
    "concrete": (concrete, 24),
    "apron": (apron, 20),
    "grass": (grass, 48),
    "soil": (soil, 40),
    "paving": (paving, 32),
    "tiles": (tiles, 24),
    "brick": (brick, 48),
    "plaster": (plaster, 16),
    "wood": (wood, 32),
    "planks": (planks, 32),
    "crate": (crate, 32),
    "cardboard": (cardboard, 48),
    "fabric": (fabric, 12),
    "metal": (metal, 16),
    "rust": (rust, 32),
    "carpet": (carpet, 24),
    "stripes": (stripes, 24),
    "hazard": (hazard, 24),
    "paint": (paint, 12),
    "sign": (sign, 16),
    "sky": (sky, 0),
}
"""The picture of each, and its number of colours; 0: all."""


def _bytes(picture: Array) -> NDArray[np.uint8]:
    return np.clip(np.rint(255.0 * picture), 0, 255).astype(np.uint8)


def save(name: str, folder: Path) -> Path:
    """Write a texture."""
    make, colours = TEXTURES[name]
    picture = Image.fromarray(_bytes(make()))
    if colours:
        picture = picture.quantize(colours, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    target = folder / f"{name}.png"
    picture.save(target, optimize=True)
    return target


def main(arguments: Sequence[str] | None = None) -> None:
    """Write the files."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", choices=[*TEXTURES, []])
    parser.add_argument("-o", "--output", type=Path, default=TARGET, metavar="FOLDER")
    options = parser.parse_args(arguments)
    options.output.mkdir(parents=True, exist_ok=True)
    for name in options.names or TEXTURES:
        made = save(name, options.output)
        print(f"{made.name}: {made.stat().st_size // 1024} KiB")


if __name__ == "__main__":
    main()
