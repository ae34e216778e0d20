# SPDX-License-Identifier: GPL-3.0-or-later
"""Short pants: four panels whose seams coincide exactly, with one T-junction of seams."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from shapes import Panels, ease
from triangulation import sample_curve, triangulate

Curve = Callable[[np.ndarray], np.ndarray]  # 0 to 1, to the layout
Seams = dict[str, np.ndarray]  # samples in the layout by name

WAIST, HEM = 26.0, -20.0  # heights
YOKE_LOW, YOKE_HIGH = 7.0, 17.0  # where the right side seam leaves the side, and where it ends
GIRTH = 10.0  # layout units a radian of a cross-section takes
FRONT, BACK = -1.0, 1.0  # sign of the layout's x


def opening(height: np.ndarray, side: float) -> np.ndarray:
    """Angle (rad) at which half a cross-section leaves the middle: 0 in the legs, a quarter turn where
    both halves make one ellipse. Its root at the crotch makes the middle seams run level through it."""
    top = 13.0 if side == FRONT else 19.0
    above = np.clip(np.asarray(height, dtype=float) / top, 0.0, 1.0)
    return np.pi / 2 * np.sqrt(1 - (1 - above) ** 2)


def pants_lift(layout: np.ndarray) -> np.ndarray:
    """The wearer's right half. Layout: x is the angle from the side line times GIRTH, negative in front;
    y is the height, 0 at the crotch."""
    turn, height = np.pi - np.abs(layout[:, 0]) / GIRTH, layout[:, 1]
    front = layout[:, 0] < 0
    start = np.where(front, opening(height, FRONT), opening(height, BACK))
    half_width = ease(height, [HEM, 4.0, WAIST], [17.5, 19.0, 14.0])
    gap = 0.11 * np.maximum(-height, 0.0)
    semi_axis = (half_width - gap) / (1 + np.cos(start))
    depth = np.where(
        front,
        ease(height, [HEM, 0.0, 14.0, WAIST], [9.5, 9.0, 11.5, 10.0]),
        ease(height, [HEM, -5.0, 7.0, WAIST], [9.5, 9.0, 14.5, 9.0]),
    )
    across = half_width - semi_axis - semi_axis * np.cos(turn)
    return np.column_stack([across, np.where(front, 1, -1) * depth * np.sin(turn), height])


def middle(height: np.ndarray, side: float) -> np.ndarray:
    """Layout of the seam in the middle of the front or back (above the crotch) and of the inside leg."""
    return np.column_stack([side * GIRTH * (np.pi - opening(height, side)), height])


def upright(height: np.ndarray) -> np.ndarray:
    """Layout of the line down the side."""
    return np.column_stack([np.zeros_like(height), height])


def yoke(t: np.ndarray) -> np.ndarray:
    """Layout of the seam from the right side line back to the middle: a quadratic Bezier curve."""
    controls = [[0.0, YOKE_LOW], [0.0, YOKE_HIGH - 1.0], middle(np.array([YOKE_HIGH]), BACK)[0]]
    weights = np.column_stack([(1 - t) ** 2, 2 * t * (1 - t), t**2])
    return weights @ np.array(controls)


def pants_seams(random: np.random.RandomState, spacing: float) -> Seams:
    """Layout samples of each seam and hem of one half; heights rise along seams."""
    quarter = GIRTH * np.pi / 2  # where the waist ends; hems end at twice that

    def level(height: float, begin: float, end: float) -> Curve:
        return lambda t: np.column_stack([begin + (end - begin) * t, np.full_like(t, height)])

    curves: dict[str, Curve] = {
        "front_rise": lambda t: middle(WAIST * t**2, FRONT),
        "back_rise_below": lambda t: middle(YOKE_HIGH * t**2, BACK),
        "back_rise_above": lambda t: middle(YOKE_HIGH + (WAIST - YOKE_HIGH) * t, BACK),
        "inside_leg": lambda t: middle(HEM * (1 - t), FRONT),
        "side": lambda t: upright(HEM + (WAIST - HEM) * t),
        "side_leg": lambda t: upright(HEM + (YOKE_LOW - HEM) * t),
        "yoke": yoke,
        "front_waist": level(WAIST, -quarter, 0.0),
        "back_waist": level(WAIST, 0.0, quarter),
        "front_hem": level(HEM, -2 * quarter, 0.0),
        "back_hem": level(HEM, 0.0, 2 * quarter),
    }
    return {name: sample_curve(curve, pants_lift, spacing, random) for name, curve in curves.items()}


def pants_borders(right: Seams, left: Seams) -> dict[str, list[np.ndarray]]:
    """The border of each panel in the layout, counter-clockwise, as a list of curves."""
    other = np.array([-1.0, 1.0])  # the inside leg as the back sees it
    return {
        "right_front": [
            right["inside_leg"][::-1],
            right["front_hem"],
            right["side_leg"],
            right["yoke"],
            right["back_rise_above"],
            right["back_waist"][::-1],
            right["front_waist"][::-1],
            right["front_rise"][::-1],
        ],
        "right_back": [
            right["back_hem"],
            right["inside_leg"] * other,
            right["back_rise_below"],
            right["yoke"][::-1],
            right["side_leg"][::-1],
        ],
        "left_front": [
            left["inside_leg"][::-1],
            left["front_hem"],
            left["side"],
            left["front_waist"][::-1],
            right["front_rise"][::-1],
        ],
        "left_back": [
            left["back_hem"],
            left["inside_leg"] * other,
            right["back_rise_below"],
            right["back_rise_above"],
            left["back_waist"][::-1],
            left["side"][::-1],
        ],
    }


def short_pants() -> Panels:
    """Short pants, the wearer looking along y. The right side seam turns back above the hip and ends on the
    seam in the middle of the back: there three panels meet. At the crotch four do."""
    spacing = 1.7
    right, left = (pants_seams(np.random.RandomState(seed), spacing) for seed in (3, 4))
    panels = {}
    for seed, (name, border) in enumerate(pants_borders(right, left).items()):
        outline = np.concatenate([curve[:-1] for curve in border])
        random = np.random.RandomState(5 + seed)
        layout, triangles = triangulate(outline, pants_lift, spacing, random)
        positions = pants_lift(layout)
        if name.startswith("right"):
            triangles = triangles[:, ::-1]
        else:
            positions = positions * [-1.0, 1.0, 1.0]
        panels[name] = (positions, triangles)
    return panels
