# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the package's table of the colours of maps, which is the plugin's: python generate_colours.py"""

from __future__ import annotations

import ctypes
import json
from pathlib import Path

from meshlab_developable import plugin

TABLE = Path(plugin.__file__).with_name("colours.json")
SIZES = {"one_sided": 256, "signed": 511}  # a step a byte; the middle of the signed ramp is 0


def colour_table() -> str:
    """The ramps and the share of the values that they show in full, as the plugin has them, in JSON."""
    plugin.load()  # which brings the host's libraries along
    library = ctypes.CDLL(str(plugin.find_plugin(plugin.pymeshlab_version(), plugin.plugin_folders())))
    library.developable_shown_share.restype = ctypes.c_double
    table: dict[str, float | str] = {"shown_share": library.developable_shown_share()}
    for name, size in SIZES.items():
        ramp = (ctypes.c_ubyte * (3 * size))()
        library.developable_colours(ctypes.c_int(name == "signed"), ctypes.c_int(size), ramp)
        table[name] = bytes(ramp).hex()
    return json.dumps(table, indent=1) + "\n"


if __name__ == "__main__":
    TABLE.write_text(colour_table(), encoding="utf-8")
