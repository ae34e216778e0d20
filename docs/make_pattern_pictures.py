# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of `patterns.md`: the pants made developable, as a pattern on a sheet and in tiles.

.venv/bin/python docs/make_pattern_pictures.py
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import pypdfium2
from meshlab_developable import make_developable
from meshlab_developable.mesh_sets import open_mesh
from meshlab_developable.patterns import make_patterns
from PIL import Image

DOCS = Path(__file__).resolve().parent
PANTS = DOCS.parent / "meshes" / "short_pants.obj"
POINTS = 72 / 25.4  # in a millimetre
TILES = 6  # shown, the cover with them


def pages(file: Path, pixels: float) -> list[Image.Image]:
    """The pages of a PDF, with that many pixels a millimetre."""
    document = pypdfium2.PdfDocument(file)
    return [page.render(scale=pixels / POINTS).to_pil() for page in document]


def side_by_side(images: list[Image.Image], columns: int, gap: int = 8) -> Image.Image:
    """Images on a grey table."""
    width, height = (max(image.size[axis] for image in images) + gap for axis in (0, 1))
    rows = -(-len(images) // columns)
    table = Image.new("RGB", (columns * width + gap, rows * height + gap), "#bbbbbb")
    for index, image in enumerate(images):
        table.paste(image, (gap + index % columns * width, gap + index // columns * height))
    return table


def main() -> None:
    """Write the pictures."""
    meshes = open_mesh(PANTS)
    mesh = meshes.current_mesh()  # which dies with its set
    faces = mesh.face_matrix()
    developed = make_developable(mesh.vertex_matrix(), faces)
    with tempfile.TemporaryDirectory() as folder:
        make_patterns(
            developed.vertices,
            faces,
            folder=folder,
            name="pants",
            unit="cm",
            grain=(0, 0, 1),
        )
        (sheet,) = pages(Path(folder) / "pants.pdf", 0.9)
        sheet.save(DOCS / "pictures" / "pattern_sheet.png", optimize=True)
        tiles = pages(Path(folder) / "pants-A4.pdf", 1.0)[:TILES]
        side_by_side(tiles, 3).save(DOCS / "pictures" / "pattern_tiles.png", optimize=True)


if __name__ == "__main__":
    main()
