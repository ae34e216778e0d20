# SPDX-License-Identifier: GPL-3.0-or-later
"""The upper of a shoe: one layer, strongly doubly curved at the toe, open at sole, top and heel."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from shapes import Panels, ease
from triangulation import sample_curve, triangulate

Curve = Callable[[np.ndarray], np.ndarray]  # 0 to 1, to the layout

TOE, HEEL_START, HEEL_RADIUS = 21.5, 17.5, 3.3  # toe's centre on the x axis; rest along the layout
TOE_LENGTH, TOE_WIDTH = 5.2, 4.2
THROAT, BACK_EDGE = 8.0, HEEL_START + 1.4 * HEEL_RADIUS


def shoe_sections(layout: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """For each point of the layout the section that it lies on: its foot on the sole's outline (n x 2),
    its top on the centre line (n x 3) and its length from top to foot.

    Ahead of the toe's centre sections fan out; behind it they stand square to the centre line, and
    round the heel they fan in again.
    """
    back = np.maximum(-layout[:, 0], 0.0)
    turn = np.arctan2(layout[:, 1], np.maximum(layout[:, 0], 0.0))
    side = np.where(layout[:, 1] < 0, -1.0, 1.0)
    half_width = ease(back, [0.0, 4.5, 12.0, HEEL_START], [TOE_WIDTH, 4.9, 3.4, HEEL_RADIUS])
    wrap = np.maximum(back - HEEL_START, 0.0) / HEEL_RADIUS
    straight = np.minimum(back, HEEL_START)
    foot = np.where(
        (layout[:, 0] > 0)[:, None],
        np.column_stack([TOE + TOE_LENGTH * np.cos(turn), TOE_WIDTH * np.sin(turn)]),
        np.column_stack([TOE - straight - HEEL_RADIUS * np.sin(wrap), side * half_width * np.cos(wrap)]),
    )
    height = ease(straight, [0.0, 11.0, HEEL_START], [4.4, 9.8, 13.0])
    top = np.column_stack([TOE - straight, np.zeros_like(height), height])
    reach = np.linalg.norm(foot - top[:, :2], axis=1)
    length = np.pi / 4 * np.sqrt(2 * (reach**2 + height**2))
    return foot, top, length


def shoe_lift(layout: np.ndarray) -> np.ndarray:
    """Each section is a quarter of an ellipse; then the sole is curved as a foot's is, the toe lifted."""
    foot, top, length = shoe_sections(layout)
    along = np.where(layout[:, 0] > 0, np.linalg.norm(layout, axis=1), np.abs(layout[:, 1]))
    angle = np.pi / 2 * (1 - along / length)
    plan = top[:, :2] + (foot - top[:, :2]) * np.cos(angle)[:, None]
    lift = 0.015 * np.maximum(plan[:, 0] - 17.0, 0.0) ** 2
    inward = 0.012 * (plan[:, 0] - 12.0) ** 2
    return np.column_stack([plan[:, 0], plan[:, 1] + inward, top[:, 2] * np.sin(angle) + lift])


def sole(t: np.ndarray) -> np.ndarray:
    """The sole's edge in the layout, from the right end at the heel round the toe to the left end."""
    run = np.abs(2 * t - 1) * (BACK_EDGE + 1.0)  # the toe takes the first unit
    turn = np.pi / 2 * np.minimum(run, 1.0)
    back = np.maximum(run - 1.0, 0.0)
    direction = np.column_stack([np.cos(turn), np.sin(turn)])
    direction[run >= 1.0, 0] = 0.0
    length = shoe_sections(direction - np.column_stack([back, 0 * back]))[2]
    edge = direction * length[:, None] - np.column_stack([back, 0 * back])
    return edge * np.column_stack([np.ones_like(t), np.where(t < 0.5, -1.0, 1.0)])


def top_line(t: np.ndarray) -> np.ndarray:
    """The opening for the foot in the layout, from the left end at the heel round the throat to the right."""
    fall = (2 * t - 1) ** 2
    ahead = np.column_stack([-THROAT - fall * (BACK_EDGE - THROAT), np.ones_like(t)])
    reach = 0.6 * np.sqrt(1 - (1 - fall) ** 4) * shoe_sections(ahead)[2]
    return np.column_stack([ahead[:, 0], np.where(t < 0.5, 1.0, -1.0) * reach])


def line(begin: np.ndarray, end: np.ndarray) -> Curve:
    """A straight line in the layout."""
    return lambda t: begin + t[:, None] * (end - begin)


def shoe_upper() -> Panels:
    """Example II, one panel."""
    random, spacing = np.random.RandomState(2), 0.7
    ends = np.array([0.0, 1.0])
    (sole_right, sole_left), (top_left, top_right) = sole(ends), top_line(ends)
    border = [sole, line(sole_left, top_left), top_line, line(top_right, sole_right)]
    pieces = [sample_curve(curve, shoe_lift, spacing, random)[:-1] for curve in border]
    layout, triangles = triangulate(np.concatenate(pieces), shoe_lift, spacing, random)
    return {"upper": (shoe_lift(layout), triangles)}
