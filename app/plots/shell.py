"""The unit sphere or hemisphere as glass with a light graticule, and the base disk."""

import numpy as np
import pyvista as pv

from app.plots.look import Look
from app.plots.space import fill, grid_faces, polyline

RADIUS = 0.998


class Dome:
    """Glass: clear where it is seen face on, denser towards its outline, so that it is a body and hides nothing."""

    def __init__(self, kind: str, look: Look, plotter: pv.Plotter):
        lowest = np.pi / 2 if kind == "hemisphere" else np.pi
        theta, phi = np.meshgrid(np.linspace(0, lowest, 33), np.linspace(0, 2 * np.pi, 73), indexing="ij")
        self.normals = sphere(theta, phi).reshape(-1, 3)
        self.mesh = pv.PolyData((RADIUS * self.normals).astype(np.float32), grid_faces(*theta.shape).ravel())
        self.ink = np.array(look.mixed(look.quiet, look.colour("estimate"), 0.35))
        self.mesh.point_data["glass"] = self.glass(np.array([0.0, -6.0, 2.0]))
        around = np.linspace(0, 2 * np.pi, 97)
        down = np.linspace(0, lowest, 97)
        parallels = np.radians(np.arange(30, min(np.degrees(lowest) + 1, 180), 30))
        rings = [sphere(np.full(97, t), around) for t in parallels]
        arcs = [sphere(down, np.full(97, p)) for p in np.radians(np.arange(0, 360, 30))]
        plotter.add_mesh(polyline(np.array(rings + arcs)), color=look.quiet, line_width=max(1.0, look.line / 2),
                         opacity=0.38, lighting=False)
        plotter.add_mesh(self.mesh, scalars="glass", rgb=True, lighting=False, show_scalar_bar=False)

    def glass(self, eye: np.ndarray) -> np.ndarray:
        to_eye = eye - self.normals
        facing = np.abs(np.sum(to_eye * self.normals, -1)) / np.linalg.norm(to_eye, axis=-1)
        alpha = 0.045 + 0.34 * (1 - facing) ** 3
        colours = np.concatenate([np.broadcast_to(self.ink, self.normals.shape), alpha[:, None]], -1)
        return np.round(255 * colours).astype(np.uint8)

    def seen_from(self, eye: np.ndarray) -> None:
        fill(self.mesh.point_data["glass"], self.glass(eye))


def sphere(theta: np.ndarray, phi: np.ndarray) -> np.ndarray:
    return np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], -1)


def base_disk(plotter: pv.Plotter, look: Look) -> None:
    radius, phi = np.meshgrid([0.0, 1.0], np.linspace(0, 2 * np.pi, 97), indexing="ij")
    flat = np.stack([radius * np.cos(phi), radius * np.sin(phi), np.zeros_like(phi)], -1)
    mesh = pv.PolyData(flat.reshape(-1, 3).astype(np.float32), grid_faces(2, 97).ravel())
    plotter.add_mesh(mesh, color=look.mixed(look.background, look.quiet, 0.35), opacity=0.55, lighting=False)
    rim = polyline(np.stack([np.cos(phi[0]), np.sin(phi[0]), np.zeros(97)], -1)[None])
    plotter.add_mesh(rim, color=look.quiet, line_width=look.line, lighting=False)
