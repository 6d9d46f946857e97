"""A sphere of a model under one distant light, seen from infinitely far: what a material looks like."""

import numpy as np
from PIL import Image

from app.board.models import BoardModel
from app.optics.colour import linear_to_srgb, srgb_to_linear

LIGHT = np.array([-0.5, 0.5, 0.7071])  # 45 degrees from the eye's direction +z, from the upper left
IRRADIANCE = np.pi  # W/m^2 on what faces the light: a white matte surface then has the radiance 1, white on screen
FILL, FINE = 0.94, 2  # of the picture's side; samples a pixel and direction
NOT_FINITE = 1.0, 0.18, 0.82  # magenta, as in scenes and plots


def sphere(model: BoardModel, values: dict, side: int, background: tuple[int, int, int]) -> Image.Image:
    """side x side pixels; black where the light does not reach."""
    at = ((np.arange(FINE * side) + 0.5) / (FINE * side) * 2 - 1) / FILL
    x, y = np.meshgrid(at, -at)
    inside = x * x + y * y < 1
    n = np.stack([x, y, np.sqrt(np.maximum(1 - x * x - y * y, 0))], -1)[inside]
    light, eye = LIGHT / np.linalg.norm(LIGHT), np.array([0.0, 0.0, 1.0])
    cosine = np.maximum(n @ light, 0)
    lit = cosine > 0
    radiance = np.zeros((len(n), 3))
    with np.errstate(all="ignore"):
        x = np.cross(np.array([0.0, 1.0, 0.0]), n[lit])  # along growing azimuth, as on the board's balls
        x[:, 0] += 1e-5
        x /= np.linalg.norm(x, axis=-1, keepdims=True)
        rgb = np.asarray(model.rgb(n[lit], np.broadcast_to(light, n[lit].shape), np.broadcast_to(eye, n[lit].shape),
                                   values, x), float)
    radiance[lit] = rgb * (IRRADIANCE * cosine[lit])[:, None]
    radiance = np.where(np.isfinite(radiance), radiance, srgb_to_linear(np.array(NOT_FINITE)))
    picture = np.broadcast_to(srgb_to_linear(np.array(background) / 255), (*inside.shape, 3)).copy()
    picture[inside] = np.clip(radiance, 0, 1)
    mean = picture.reshape(side, FINE, side, FINE, 3).mean((1, 3))
    return Image.fromarray(np.round(255 * linear_to_srgb(mean)).astype(np.uint8))
