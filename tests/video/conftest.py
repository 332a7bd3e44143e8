from __future__ import annotations

from collections.abc import Callable

import pytest


@pytest.fixture
def scene() -> Callable[[int, int, int], object]:
    """Pictures that move, and carry their number: scene(number, width, height)."""
    np = pytest.importorskip("numpy", reason="the extra 'video' is not installed")
    cv2 = pytest.importorskip("cv2", reason="the extra 'video' is not installed")
    pytest.importorskip("av", reason="the extra 'video' is not installed")
    from jauspy.video.imaging import draw_numbers

    def draw(number: int, width: int = 640, height: int = 480) -> object:
        noise = np.random.default_rng(7).integers(0, 255, (height // 8, width // 8, 3), dtype=np.uint8)
        image = np.roll(cv2.resize(noise, (width, height), interpolation=cv2.INTER_CUBIC), 4 * number, axis=1)
        draw_numbers(image, number)
        return image

    return draw
