# SPDX-License-Identifier: GPL-3.0-or-later
"""How much the pieces had to be stretched to lie flat: what is refused, and what a user should know."""

from __future__ import annotations

from collections.abc import Sequence

from meshlab_developable.errors import PatternError
from meshlab_developable.flattening import FlatteningResult

NOTABLE_STRAIN, NOTABLE_MISMATCH = 0.01, 0.5  # of a length; mm


def require_little_strain(flat: FlatteningResult, names: Sequence[str], max_strain: float) -> None:
    """Raise PatternError when an edge has changed its length by more than so many per cent, saying where."""
    bad = []
    for number, name in enumerate(names):
        strain = flat.edge_strain * (flat.pieces == number)
        if 100 * strain.max() > max_strain:
            bad.append((number, name, strain))
    if not bad:
        return
    number, name, strain = max(bad, key=lambda piece: piece[2].max())
    own_name = "" if name == f"Piece {number + 1}" else f" ({name})"
    place = ", ".join(f"{x:.4g}" for x in flat.model_vertices[strain.argmax()])
    raise PatternError(
        f"Piece {number + 1}{own_name} can't be laid flat without changing an edge at ({place}) of the model "
        f"by {in_per_cent(strain.max())} of its length; {len(bad)} of {len(names)} pieces are above the "
        f"limit of {max_strain:g} %. Make the panels developable first, give them seams, or allow more with "
        "max_strain."
    )


def strain_notes(flat: FlatteningResult, millimetres: float, borne: float = 0.0) -> list[str]:
    """What a user should know of changed lengths.

    millimetres: the unit of the mesh. borne: by how much the material lets edges change, per cent.
    """
    report, notes = flat.report, []
    if report.max_edge_strain > NOTABLE_STRAIN:
        within = 100 * report.max_edge_strain <= borne
        notes.append(
            f"Laid flat, edges change by up to {in_per_cent(report.max_edge_strain)}, "
            f"{in_per_cent(report.mean_edge_strain)} on average"
            + (", which the material bears." if within else ": make the panels developable first.")
        )
    mismatch = report.max_seam_mismatch * millimetres
    if mismatch > NOTABLE_MISMATCH:
        notes.append(f"The sides of a seam differ by up to {_two_digits(mismatch)} mm.")
    return notes


def in_per_cent(share: float) -> str:
    """Such as 0.012 %, 1.2 %, 120 %."""
    return f"{_two_digits(100 * share)} %"


def _two_digits(value: float) -> str:
    """At least two digits that count, and never as a power of ten when the value is large."""
    return f"{value:.0f}" if value >= 10 else f"{value:.2g}"
