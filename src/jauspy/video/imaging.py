"""Applies lens, shutter and sensor of a camera to rendered pictures, and draws numbers into them.

The numbers survive coding: they count and time images. Import it after `need_video`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import cv2
import numpy as np
from numpy.typing import NDArray

from jauspy.platform.camera import CameraFrame
from jauspy.platform.imaging_settings import (
    FocusMode,
    ImagingMode,
    ImagingSettings,
    MeteringMode,
    WhiteBalance,
    narrowed,
)

if TYPE_CHECKING:
    from jauspy.platform.camera import CameraSession, CameraSetup, Distances, Image


WHITE_BALANCE: Final = {
    WhiteBalance.AUTO: (1.0, 1.0, 1.0),
    WhiteBalance.DAYLIGHT: (1.0, 1.0, 1.0),
    WhiteBalance.CLOUDY: (1.12, 1.0, 0.88),
    WhiteBalance.SHADE: (1.25, 1.0, 0.75),
    WhiteBalance.TUNGSTEN: (0.6, 1.0, 1.7),
    WhiteBalance.FLUORESCENT: (0.8, 0.95, 1.3),
    WhiteBalance.FLASH: (1.08, 1.0, 0.92),
}
"""Factors of red, green and blue light, with which that kind of light would be white."""

DARK: Final = 0.1
BRIGHT: Final = 0.7
"""Mean light between which the automatic exposure leaves a picture as it is."""

METERED: Final = 8
"""Step, in rows and columns, between the pixels that the automatic exposure measures."""

ADAPTATION: Final = 0.3
"""Fraction of the way to the right exposure, in stops, that each picture takes."""

ITERATIONS: Final = 60
"""Steps to the inverse of a lens's distortion, computed once for each size of picture and zoom."""
MIN_RADIAL: Final = 0.1
"""Smallest factor by which a lens moves a point towards the middle."""

BLUR_SIZES: Final = ((1.5, 3), (4.0, 7), (9.0, 15))
"""Diameters of the blur circle in pixels, each with the size of the filter from there on."""

MAX_SPREAD: Final = math.tan(math.radians(80.0))
"""Half of the width of the widest picture that is rendered for a distorting lens, at a distance of one."""

INVISIBLE_NOISE: Final = 0.5
"""Standard deviation of a grey pixel, in steps of 255, below which noise is left out."""

NOISE_MARGIN: Final = 61
"""Rows and columns by which the stored noise is larger than a picture; each picture shows another part of it."""


class Imaging:
    """The lens and the sensor of one camera: takes pictures of a session with the present settings.

    Each step that the settings do not need is left out: with initial settings and an ideal lens, a picture in daylight
    stays as it is.
    """

    def __init__(self, camera: CameraSetup) -> None:
        self._fov, self._setup = camera.fov, camera.imaging
        self.settings: ImagingSettings = camera.imaging.initial
        self._exposure: float | None = None
        self._lens: tuple[tuple[int, int, float], _Lens] | None = None
        self._noise = _Noise(camera.imaging.seed)

    def take(
        self, session: CameraSession, width: int, height: int, *, supersampling: int = 1, thoroughly: bool = False
    ) -> CameraFrame:
        """A picture of that size, reduced from one that is wider and higher by `supersampling`."""
        settings = self.settings
        optical, digital = self._setup.zoom_factors(settings)
        fov = narrowed(self._fov, optical)
        lens = self._distorting(width, height, fov)
        frame = session.look(
            supersampling * width,
            supersampling * height,
            thoroughly=thoroughly,
            fov=lens.fov if lens else fov,
            distances=settings.focus_mode is FocusMode.MANUAL_FOCUS,
        )
        if supersampling > 1:
            frame = _reduced(frame, width, height)
        image = frame.image
        if settings.focus_mode is FocusMode.MANUAL_FOCUS and frame.distances is not None:
            image = _blurred(image, self._blur_circles(frame.distances, fov, width))
        exposure = self._expose(image, frame.light)
        image = exposed(image, frame.light, exposure, settings.white_balance)
        if lens is not None:
            image = lens.bend(image)
        gain = self._setup.gain(settings, exposure)
        image = self._noise.added(image, self._setup.shot_noise, self._setup.read_noise, gain)
        if digital > 1.0:
            image = enlarged(image, digital)
        if settings.imaging_mode is ImagingMode.GREYSCALE:
            image = np.asarray(cv2.cvtColor(cv2.cvtColor(image, cv2.COLOR_RGB2GRAY), cv2.COLOR_GRAY2RGB), np.uint8)
        return CameraFrame(image, frame.taken)

    def _expose(self, image: Image, light: NDArray[np.float32] | float) -> float:
        """The exposure of this picture, a factor of the normal one."""
        low, high = self._setup.exposures(self.settings)
        if high <= low:
            self._exposure = low
            return low
        metered = max(_metered(image, light, self.settings.metering_mode), 1e-9)
        wanted = min(max(1.0, DARK / metered), BRIGHT / metered)
        wanted = min(max(wanted, low), high)
        if self._exposure is not None and wanted != self._exposure:
            before = min(max(self._exposure, low), high)
            wanted = wanted if abs(wanted / before - 1.0) < 0.02 else before * (wanted / before) ** ADAPTATION
        self._exposure = wanted
        return wanted

    def _blur_circles(self, distances: Distances, fov: float, width: int) -> NDArray[np.float32]:
        """Diameters of the circles, in pixels, in which a thin lens shows points at these distances."""
        setup = self._setup
        length = setup.focal_length(fov)
        number = max(self.settings.aperture, setup.aperture[0])
        scale = length**2 / number * width / setup.sensor_width
        focus = (1.0 - self.settings.focus) / setup.nearest_focus
        circles: NDArray[np.float32] = np.abs(np.float32(scale) / distances - np.float32(scale * focus))
        return circles

    def _distorting(self, width: int, height: int, fov: float) -> _Lens | None:
        if not any(self._setup.distortion):
            return None
        key = (width, height, fov)
        if self._lens is None or self._lens[0] != key:
            self._lens = key, _Lens.of(width, height, fov, self._setup.distortion)
        return self._lens[1]


@dataclass(frozen=True, slots=True)
class _Lens:
    """A lens that bends straight lines."""

    fov: float
    """Horizontal field of view, in radians, of the rendered picture that it bends."""
    bend: Callable[[Image], Image]

    @staticmethod
    def of(width: int, height: int, fov: float, coefficients: tuple[float, ...]) -> _Lens:
        """OpenCV's model (k1, k2, p1, p2, k3); `fov` is what the lens would show without distortion."""
        length = width / 2.0 / math.tan(fov / 2.0)
        middle = np.array([(width - 1) / 2.0, (height - 1) / 2.0])
        bent = np.stack(np.meshgrid(np.arange(width), np.arange(height)), axis=-1)
        straight = _straightened((bent - middle) / length, coefficients)
        needed = max(float(np.abs(straight[..., 0]).max()), float(np.abs(straight[..., 1]).max()) * width / height)
        spread = min(needed, MAX_SPREAD)
        source = (straight * (width / 2.0 / spread) + middle).astype(np.float32)
        columns, down = cv2.convertMaps(source[..., 0], source[..., 1], cv2.CV_16SC2)
        return _Lens(
            2.0 * math.atan(spread),
            lambda image: np.asarray(
                cv2.remap(image, columns, down, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE), np.uint8
            ),
        )


def _straightened(bent: NDArray[np.float64], coefficients: tuple[float, ...]) -> NDArray[np.float64]:
    """The directions, as x and y at a distance of one, that the lens shows at these places.

    By fixed-point iteration with half steps; whole ones oscillate where the lens enlarges towards its edge. OpenCV's
    function does too few iterations for the corners of wide lenses, and its signature depends on the version.
    """
    k1, k2, p1, p2, k3 = coefficients
    found = bent.copy()
    for _ in range(ITERATIONS):
        x, y = found[..., 0], found[..., 1]
        squared = x * x + y * y
        radial = 1.0 + squared * (k1 + squared * (k2 + squared * k3))
        sideways = np.stack(
            [2.0 * p1 * x * y + p2 * (squared + 2.0 * x * x), p1 * (squared + 2.0 * y * y) + 2.0 * p2 * x * y], axis=-1
        )
        place = (bent - sideways) / np.maximum(radial, MIN_RADIAL)[..., None]
        found = (found + np.clip(place, -MAX_SPREAD, MAX_SPREAD)) / 2.0
    return found


class _Noise:
    """Noise of a sensor: the number of photons is random, and reading a pixel adds an error; both are amplified."""

    def __init__(self, seed: int) -> None:
        self._random = np.random.default_rng(seed)
        self._stored: NDArray[np.float32] = np.empty((0, 0, 3), np.float32)

    def added(self, image: Image, shot: float, read: float, gain: float) -> Image:
        """The picture with noise, from the deviations at ISO 100 and the amplification."""
        # A pixel is the root of its light, so the deviation of the light is divided by twice the pixel.
        pixels = np.maximum(np.arange(256) / 255.0, math.sqrt(read * gain) or 1.0)
        deviations = 255.0 * np.sqrt(shot**2 * gain / 4.0 + (read * gain / (2.0 * pixels)) ** 2)
        if deviations[128] < INVISIBLE_NOISE:
            return image
        height, width = image.shape[:2]
        if self._stored.shape[:2] != (height + NOISE_MARGIN, width + NOISE_MARGIN):
            shape = (height + NOISE_MARGIN, width + NOISE_MARGIN, 3)
            self._stored = self._random.standard_normal(shape, np.float32)
        top, left = self._random.integers(0, NOISE_MARGIN + 1, 2)
        part = np.ascontiguousarray(self._stored[top : top + height, left : left + width])
        strength = cv2.LUT(image, deviations.astype(np.float32))
        return np.asarray(cv2.add(image, cv2.multiply(strength, part), dtype=cv2.CV_8U), np.uint8)


def exposed(image: Image, light: NDArray[np.float32] | float, exposure: float, balance: WhiteBalance) -> Image:
    """The picture of surfaces in that light (1 is that in which they were rendered)."""
    factors = [math.sqrt(exposure * factor) for factor in WHITE_BALANCE[balance]]
    if isinstance(light, np.ndarray):
        root = np.sqrt(light)
        scales = cv2.merge([root * np.float32(factor) for factor in factors])
        return np.asarray(cv2.multiply(image, scales, dtype=cv2.CV_8U), np.uint8)
    factors = [math.sqrt(light) * factor for factor in factors]
    if all(abs(factor - 1.0) < 1e-3 for factor in factors):
        return image
    table = np.clip(np.rint(np.outer(np.arange(256), factors)), 0, 255).astype(np.uint8)
    return np.asarray(cv2.LUT(image, table[:, None, :]), np.uint8)


def enlarged(image: Image, factor: float) -> Image:
    """The middle of the picture in the size of the whole one."""
    height, width = image.shape[:2]
    # Pixel centres keep their places relative to the middle.
    shift = [(size - 1) / 2.0 * (1.0 - factor) for size in (width, height)]
    turn = np.array([[factor, 0.0, shift[0]], [0.0, factor, shift[1]]])
    return np.asarray(cv2.warpAffine(image, turn, (width, height), flags=cv2.INTER_LINEAR), np.uint8)


def _metered(image: Image, light: NDArray[np.float32] | float, mode: MeteringMode) -> float:
    """The mean light, limited to what the display can show, of the part of the picture that is measured."""
    height, width = image.shape[:2]
    share = {MeteringMode.AUTO: 1.0, MeteringMode.CENTER_WEIGHTED: 0.5, MeteringMode.SPOT: 0.125}[mode]
    rows, columns = (
        slice(int(size * (1.0 - share) / 2.0), max(int(size * (1.0 + share) / 2.0), 1), METERED)
        for size in (height, width)
    )
    part = (image[rows, columns].astype(np.float32) / np.float32(255.0)) ** 2
    levels = part.mean(axis=2)
    return float((levels * light[rows, columns]).mean() if isinstance(light, np.ndarray) else levels.mean() * light)


def _blurred(image: Image, circles: NDArray[np.float32]) -> Image:
    """The picture with each pixel blurred by its circle, in four steps."""
    made = image.copy()
    largest = float(circles.max())
    for diameter, size in BLUR_SIZES:
        if largest < diameter:
            break
        mask = (circles >= diameter).view(np.uint8)
        cv2.copyTo(cv2.GaussianBlur(image, (size, size), 0), mask, made)
    return made


def _reduced(frame: CameraFrame, width: int, height: int) -> CameraFrame:
    image = np.asarray(cv2.resize(frame.image, (width, height), interpolation=cv2.INTER_AREA), np.uint8)
    light, distances = frame.light, frame.distances
    if isinstance(light, np.ndarray):
        light = np.asarray(cv2.resize(light, (width, height), interpolation=cv2.INTER_AREA), np.float32)
    if distances is not None:
        distances = np.asarray(cv2.resize(distances, (width, height), interpolation=cv2.INTER_NEAREST), np.float32)
    return CameraFrame(image, frame.taken, light, distances)


STAMP_BITS: Final = 32
"""Squares of a row, most significant bit on the left; a row takes the whole width of the image."""

_BLACK, _WHITE = 16, 235


def draw_numbers(image: Image, *numbers: int) -> None:
    """Draw each number modulo 2**32 as a row of squares, from the top edge of the image down."""
    side = image.shape[1] // STAMP_BITS
    for row, number in enumerate(numbers):
        bits = np.array([number >> shift & 1 for shift in reversed(range(STAMP_BITS))], dtype=np.uint8)
        line = np.where(np.repeat(bits, side), _WHITE, _BLACK).astype(np.uint8)
        image[row * side : (row + 1) * side, : STAMP_BITS * side] = line[None, :, None]


def read_numbers(image: Image, rows: int = 1) -> list[int]:
    """The numbers of the first rows; `image` has the shape (height, width) or (height, width, channels)."""
    side = image.shape[1] // STAMP_BITS
    grey = image if image.ndim == 2 else image.mean(axis=2)
    tops = grey[: rows * side, : STAMP_BITS * side].reshape(rows, side, STAMP_BITS, side)
    edge = side // 4
    middles = tops[:, edge : side - edge, :, edge : side - edge].mean(axis=(1, 3)) > (_BLACK + _WHITE) / 2
    return [int("".join("01"[bit] for bit in row.astype(int)), 2) for row in middles]
