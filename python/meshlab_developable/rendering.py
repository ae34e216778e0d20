# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of maps on shapes, off screen, with a scale. Needs the extra `render`.

Shapes are drawn by VTK (through pyvista), titles and scale by matplotlib, in the colours that the plugin
paints maps in.
"""

from __future__ import annotations

import dataclasses
import os
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from meshlab_developable.colours import colour_map, colour_range

Array = npt.NDArray[np.float64]
IndexArray = npt.NDArray[np.integer[Any]]

PICTURE_SIZE = 640, 560  # of one shape, pixels
HEADING, FOOTING = 40, 100  # heights of the titles above and of the scale below


@dataclasses.dataclass(frozen=True)
class ColourScale:
    """What the first and the last colour stand for, and what is written beside them."""

    label: str  # with the unit
    low: float
    high: float
    signed: bool


@dataclasses.dataclass(frozen=True)
class Picture:
    """A triangle mesh with a value a vertex, or with faces in colours of their own, and a title."""

    title: str
    vertices: Array  # n x 3
    faces: IndexArray  # m x 3
    values: Array  # n; or m x 3, the colours (sRGB, 0 to 1)
    marks: Sequence[tuple[float, float, float]] = ()  # points with a ring round them, hidden ones too


@dataclasses.dataclass(frozen=True)
class View:
    """From where to look: a vector from the shape to the eye, and the direction that is up."""

    eye: tuple[float, float, float] = (1.0, -2.0, 1.0)
    up: tuple[float, float, float] = (0.0, 0.0, 1.0)


def robust_scale(label: str, values: Iterable[Array], signed: bool) -> ColourScale:
    """The scale that shows 98 % of the values in full; the few beyond it take the last colour.

    Give the values of every picture that is to be compared. Values that are all 0 get a scale up to 1.
    """
    together = np.concatenate([np.ravel(v) for v in values])
    high = colour_range(together) if together.any() else 1.0
    return ColourScale(label, -high if signed else 0.0, high, signed)


def render(
    path: Path, pictures: Sequence[Picture], scale: ColourScale | None, view: View | None = None
) -> None:
    """Write the pictures side by side, all with the same eye and the same scale, to a PNG.

    Without a scale there is none below; then all faces have colours of their own.
    """
    from matplotlib.figure import Figure

    images = [_draw(picture, pictures, scale, view or View()) for picture in pictures]
    width, height = PICTURE_SIZE
    footing = FOOTING if scale else 0
    total, dots = height + HEADING + footing, 100
    figure = Figure(figsize=(width * len(pictures) / dots, total / dots), dpi=dots)
    axes = figure.subplots(1, len(pictures), squeeze=False)[0]
    figure.subplots_adjust(left=0, right=1, bottom=footing / total, top=1 - HEADING / total, wspace=0)
    for axis, picture, image in zip(axes, pictures, images, strict=True):
        axis.imshow(image)
        if picture.marks:
            across, down = _frame(pictures, view or View()).pixels(np.array(picture.marks))
            axis.scatter(across, down, s=260, facecolors="none", edgecolors="#00695c", linewidths=2.5)
        axis.set_axis_off()
        axis.set_title(picture.title, fontsize=18)
    if scale:
        _add_scale(figure, scale, figure.add_axes((0.25, 66 / total, 0.5, 22 / total)), len(pictures))
    figure.savefig(path, pil_kwargs={"compress_level": 4})  # 6 takes twice as long for 4 %


def _add_scale(figure: Any, scale: ColourScale, bar: Any, pictures: int) -> None:
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize
    from matplotlib.ticker import MaxNLocator

    colour_bar = figure.colorbar(
        ScalarMappable(Normalize(scale.low, scale.high), colour_map(scale.signed)),
        cax=bar,
        orientation="horizontal",
        extend="both" if scale.signed else "max",
        ticks=MaxNLocator(5 if pictures > 1 else 3),
        format="%.3g",
    )
    colour_bar.set_label(scale.label, fontsize=16)
    bar.tick_params(labelsize=15)


def _draw(
    picture: Picture, together: Sequence[Picture], scale: ColourScale | None, view: View
) -> npt.NDArray[np.uint8]:
    """One shape without text, framed so that all the pictures' shapes would fit."""
    if sys.platform == "linux" and not os.environ.get("DISPLAY"):
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
    import pyvista

    surface = pyvista.PolyData.from_regular_faces(picture.vertices, picture.faces)
    if scale:
        surface.point_data["values"] = picture.values
        look = {"cmap": colour_map(scale.signed), "clim": (scale.low, scale.high)}
    else:
        surface.cell_data["values"] = picture.values
        look = {"rgb": True}
    plotter = pyvista.Plotter(off_screen=True, window_size=PICTURE_SIZE)
    plotter.set_background("white")
    plotter.enable_anti_aliasing("ssaa")
    plotter.add_mesh(
        surface,
        scalars="values",
        show_scalar_bar=False,
        smooth_shading=True,
        split_sharp_edges=True,
        ambient=0.3,
        diffuse=0.75,
        **look,
    )
    borders = surface.extract_feature_edges(
        boundary_edges=True, feature_edges=False, manifold_edges=False, non_manifold_edges=False
    )
    if borders.n_points:
        plotter.add_mesh(borders, color="#404040", line_width=2)
    _aim(plotter, _frame(together, view), together)
    image = np.array(plotter.screenshot(None, return_img=True))
    plotter.close()
    return image


@dataclasses.dataclass(frozen=True)
class _Frame:
    """What a picture shows: a parallel projection."""

    centre: Array
    right: Array  # unit vectors
    up: Array
    eye: Array
    half_height: float  # of what the picture shows, in the shapes' unit

    def pixels(self, points: Array) -> tuple[Array, Array]:
        """Column and row of each point, from the upper left corner."""
        width, height = PICTURE_SIZE
        scale = height / (2 * self.half_height)
        from_centre = points - self.centre
        return width / 2 + scale * (from_centre @ self.right), height / 2 - scale * (from_centre @ self.up)


def _frame(pictures: Sequence[Picture], view: View) -> _Frame:
    """From the view's direction, such that all the pictures' shapes just fit."""
    points = np.concatenate([picture.vertices for picture in pictures])
    eye = np.array(view.eye) / np.linalg.norm(view.eye)
    right = np.cross(view.up, eye)
    right /= np.linalg.norm(right)
    up = np.cross(eye, right)
    across, along = points @ right, points @ up
    centre = (
        (across.min() + across.max()) / 2 * right
        + (along.min() + along.max()) / 2 * up
        + (points @ eye).mean() * eye
    )
    width, height = PICTURE_SIZE
    half_height = 1.06 * max(np.ptp(along), np.ptp(across) * height / width) / 2
    return _Frame(centre, right, up, eye, float(half_height))


def _aim(plotter: Any, frame: _Frame, pictures: Sequence[Picture]) -> None:
    size = max(float(np.ptp(picture.vertices, axis=0).max()) for picture in pictures)
    camera = plotter.camera
    camera.parallel_projection = True
    camera.focal_point = frame.centre
    camera.position = frame.centre + frame.eye * 2 * size
    camera.up = frame.up
    camera.parallel_scale = frame.half_height
    plotter.renderer.ResetCameraClippingRange()
