"""Lens and sensor: what settings do to the pixels of known scenes."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

cv2 = pytest.importorskip("cv2", reason="the extra 'video' is not installed")
np = pytest.importorskip("numpy", reason="the extra 'video' is not installed")

from jauspy.platform.camera import CameraFrame, CameraSetup  # noqa: E402
from jauspy.platform.imaging_settings import (  # noqa: E402
    ExposureMode,
    FocusMode,
    ImagingMode,
    ImagingSetup,
    MeteringMode,
    WhiteBalance,
    ZoomMode,
)
from jauspy.video.imaging import Imaging  # noqa: E402

FOV = math.radians(80.0)
WIDTH, HEIGHT = 320, 240


class Scene:
    """A `CameraSession` that paints what is at (x, y) at a distance of one: x to the right, y down."""

    def __init__(self, paint, light=1.0, distance=1.0):
        self._paint, self.light, self.distance = paint, light, distance

    def look(self, width, height, *, thoroughly=False, fov=None, distances=False):
        pixel = 2.0 * math.tan(fov / 2.0) / width
        x, y = np.meshgrid(
            pixel * (np.arange(width) - (width - 1) / 2.0), pixel * (np.arange(height) - (height - 1) / 2.0)
        )
        image = np.repeat(self._paint(x, y).astype(np.uint8)[..., None], 3, axis=2)
        far = np.full((height, width), self.distance, np.float32) if distances else None
        return CameraFrame(image, 0.0, self.light, far)


def grey(level):
    return lambda x, y: np.full_like(x, level)


def square(x, y):
    return np.where((abs(x) < 0.1) & (abs(y) < 0.1), 200, 20)


def picture(scene, setup=ImagingSetup(), **settings):
    made = Imaging(CameraSetup("front", "link", FOV, setup))
    made.settings = replace(setup.initial, **settings)
    return made.take(scene, WIDTH, HEIGHT).image


def light_of(image):
    return float(((image / 255.0) ** 2).mean())


def test_initial_settings_leave_daylight_as_it_is():
    gradient = Scene(lambda x, y: 60.0 + 60.0 * (x - x.min()))
    assert (picture(gradient) == gradient.look(WIDTH, HEIGHT, fov=FOV).image).all()


@pytest.mark.parametrize("shutter", [0.005, 0.01, 0.02, 0.04])
def test_light_is_proportional_to_exposure_until_it_clips(shutter):
    made = picture(Scene(grey(100)), exposure_mode=ExposureMode.MANUAL, shutter=shutter)
    assert light_of(made) == pytest.approx(min(1.0, shutter / 0.01 * (100 / 255) ** 2), rel=0.02)
    bright = picture(Scene(grey(200)), exposure_mode=ExposureMode.MANUAL, shutter=0.06)
    assert (bright == 255).all()


def test_sensitivity_and_aperture_change_the_light_as_photographers_expect():
    setup = ImagingSetup(aperture=(2.8, 11.2))
    once = picture(Scene(grey(60)), setup, exposure_mode=ExposureMode.MANUAL, iso=100)
    faster = picture(Scene(grey(60)), setup, exposure_mode=ExposureMode.MANUAL, iso=400)
    darker = picture(Scene(grey(240)), setup, exposure_mode=ExposureMode.MANUAL, aperture=11.2)
    assert light_of(faster) == pytest.approx(4.0 * light_of(once), rel=0.03)
    assert light_of(darker) == pytest.approx((240 / 255) ** 2 / 16.0, rel=0.05)


def test_automatic_exposure_brightens_the_dark_within_its_limits():
    dim = 0.002
    camera = Imaging(CameraSetup("front", "link", FOV, ImagingSetup()))
    made = light_of(camera.take(Scene(grey(180), light=dim), WIDTH, HEIGHT).image)
    assert made == pytest.approx(0.1, rel=0.05)
    fixed = picture(Scene(grey(180), light=dim), exposure_mode=ExposureMode.MANUAL)
    assert light_of(fixed) < 0.01 * made + 1e-3
    poor = picture(Scene(grey(180), light=dim), ImagingSetup(max_iso=100))
    assert light_of(poor) == pytest.approx(6.6 * dim * (180 / 255) ** 2, rel=0.15)


def test_exposure_follows_a_change_of_light_over_several_pictures():
    camera, scene = Imaging(CameraSetup("front", "link", FOV)), Scene(grey(180))
    camera.take(scene, WIDTH, HEIGHT)
    scene.light = 0.01
    levels = [light_of(camera.take(scene, WIDTH, HEIGHT).image) for _ in range(20)]
    assert levels[0] < 0.4 * levels[-1]
    assert levels == sorted(levels)
    assert levels[-1] == pytest.approx(0.1, rel=0.05)


def test_spot_metering_measures_the_middle():
    scene = Scene(lambda x, y: np.where((abs(x) < 0.2) & (abs(y) < 0.2), 40, 190))
    spot = picture(scene, metering_mode=MeteringMode.SPOT)
    assert spot[HEIGHT // 2, WIDTH // 2, 0] > 70
    assert picture(scene)[HEIGHT // 2, WIDTH // 2, 0] == 40


def width_of_square(image):
    return int((image[HEIGHT // 2, :, 0] > 110).sum())


@pytest.mark.parametrize(("mode", "setup"), [
    (ZoomMode.DIGITAL_ONLY, ImagingSetup()),
    (ZoomMode.ANALOG_ONLY, ImagingSetup(optical_zoom=4.0)),
    (ZoomMode.MIXED, ImagingSetup(optical_zoom=1.5)),
])  # fmt: skip
def test_zoom_2_doubles_the_size_of_a_known_object(mode, setup):
    once = width_of_square(picture(Scene(square), setup))
    twice = width_of_square(picture(Scene(square), setup, zoom_mode=mode, zoom=2.0))
    assert once == pytest.approx(0.1 / math.tan(FOV / 2) * WIDTH, abs=1.5)
    assert twice == pytest.approx(2 * once, abs=2)


def test_zoom_off_ignores_the_factor():
    assert width_of_square(picture(Scene(square), zoom_mode=ZoomMode.OFF, zoom=3.0)) == width_of_square(
        picture(Scene(square))
    )


def test_white_balance_shifts_the_colours():
    tungsten = picture(Scene(grey(120)), white_balance=WhiteBalance.TUNGSTEN).reshape(-1, 3).mean(axis=0)
    shade = picture(Scene(grey(120)), white_balance=WhiteBalance.SHADE).reshape(-1, 3).mean(axis=0)
    assert tungsten[2] > 140
    assert tungsten[0] < 100
    assert shade[0] > 125
    assert shade[2] < 115


def test_greyscale_has_equal_channels():
    made = picture(Scene(square), white_balance=WhiteBalance.TUNGSTEN, imaging_mode=ImagingMode.GREYSCALE)
    assert (made[..., 0] == made[..., 1]).all()
    assert (made[..., 0] == made[..., 2]).all()


def sharpness(image):
    return float(np.abs(np.diff(image[HEIGHT // 2, :, 0].astype(int))).max())


def test_manual_focus_blurs_what_is_elsewhere():
    setup = ImagingSetup(optical_zoom=4.0, nearest_focus=0.1)
    settings = {"focus_mode": FocusMode.MANUAL_FOCUS, "zoom_mode": ZoomMode.ANALOG_ONLY, "zoom": 4.0}
    at_half_a_metre = 1.0 - 0.1 / 0.5
    sharp = picture(Scene(square, distance=0.5), setup, focus=at_half_a_metre, **settings)
    near = picture(Scene(square, distance=0.15), setup, focus=at_half_a_metre, **settings)
    assert sharpness(sharp) > 170
    assert sharpness(near) < 60
    automatic = picture(Scene(square, distance=0.15), setup, **(settings | {"focus_mode": FocusMode.AUTO_FOCUS}))
    assert sharpness(automatic) > 170


@pytest.mark.parametrize("coefficients", [(-0.3, 0.1, 0.0, 0.0, 0.0), (0.2, 0.0, 0.01, -0.01, 0.02)])
def test_a_straight_edge_bends_as_opencv_projects_it(coefficients):
    edge = -0.4
    made = picture(Scene(lambda x, y: np.where(x > edge, 220, 20)), ImagingSetup(distortion=coefficients))
    length = WIDTH / 2 / math.tan(FOV / 2)
    camera = np.array([[length, 0, (WIDTH - 1) / 2], [0, length, (HEIGHT - 1) / 2], [0, 0, 1]])
    points = np.array([[edge, y, 1.0] for y in np.linspace(-0.7, 0.7, 15)])
    places, _ = cv2.projectPoints(points, np.zeros(3), np.zeros(3), camera, np.array(coefficients))
    checked = 0
    for across, down in places.reshape(-1, 2):
        if 5 < down < HEIGHT - 5 and 5 < across < WIDTH - 5:
            row = made[round(float(down)), :, 0]
            assert int((row < 120).sum()) == pytest.approx(float(across) + 0.5, abs=1.5)
            checked += 1
    assert checked > 8
    straight = picture(Scene(lambda x, y: np.where(x > edge, 220, 20)))
    assert len(set((straight[:, :, 0] < 120).sum(axis=1).tolist())) == 1


def test_a_lens_that_enlarges_towards_its_corners_shows_each_direction_once():
    """From left to right, what is further right."""
    made = picture(Scene(lambda x, y: 120.0 + 60.0 * x), ImagingSetup(distortion=(-0.5, 0.2, 0.0, 0.0, 0.0)))
    assert (np.diff(made[:, :, 0].astype(int), axis=1) >= 0).all()


NOISY = ImagingSetup(shot_noise=0.02, read_noise=0.0002, seed=7)


def test_noise_grows_with_sensitivity_and_is_the_same_for_the_same_seed():
    once = picture(Scene(grey(120)), NOISY, exposure_mode=ExposureMode.MANUAL, iso=100)
    loud = picture(Scene(grey(30)), NOISY, exposure_mode=ExposureMode.MANUAL, iso=1600)
    again = picture(Scene(grey(120)), NOISY, exposure_mode=ExposureMode.MANUAL, iso=100)
    other = picture(Scene(grey(120)), replace(NOISY, seed=8), exposure_mode=ExposureMode.MANUAL, iso=100)
    assert (once == again).all()
    assert (once != other).any()
    assert once.std() == pytest.approx(255 * 0.02 / 2, rel=0.15)
    assert loud.std() == pytest.approx(4 * 255 * 0.02 / 2, rel=0.3)


def test_no_two_pictures_have_the_same_noise():
    camera, scene = Imaging(CameraSetup("front", "link", FOV, NOISY)), Scene(grey(120))
    assert (camera.take(scene, WIDTH, HEIGHT).image != camera.take(scene, WIDTH, HEIGHT).image).any()


def test_light_of_lamps_falls_on_parts_of_a_picture():
    light = np.full((HEIGHT, WIDTH), 0.04, np.float32)
    light[:, WIDTH // 2 :] = 1.0
    made = picture(Scene(grey(200), light=light), exposure_mode=ExposureMode.MANUAL)
    assert made[0, 0, 0] == pytest.approx(0.2 * 200, abs=1)
    assert made[0, -1, 0] == 200
