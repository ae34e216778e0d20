# SPDX-License-Identifier: GPL-3.0-or-later
"""What can go wrong, as exceptions whose text a user can act on."""


class DevelopableError(Exception):
    """Base of all errors of this package."""


class PluginNotFoundError(DevelopableError, ImportError):
    """No build of the plugin fits the running pymeshlab."""


class InvalidParameterError(DevelopableError, ValueError):
    """A parameter that the method has not, or a value that it does not take."""


class InvalidMeshError(DevelopableError, ValueError):
    """Arrays that do not describe a triangle mesh."""


class FilterError(DevelopableError, RuntimeError):
    """The filter refused the mesh or the parameters; the text is its own."""


class WriteError(DevelopableError, OSError):
    """A file that cannot be written, or not whole; what was there before is as it was."""


class LostFacesWarning(UserWarning):
    """A file was read, but not all of its faces."""


class PatternError(DevelopableError, ValueError):
    """Pieces that can't be made into a pattern, or don't fit where they are to go."""
