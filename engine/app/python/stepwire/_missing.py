"""Why the compiled part of the package cannot be loaded, and how it comes."""

from __future__ import annotations

import pathlib
import sys


def reason(folder: pathlib.Path, error: ImportError) -> str:
    """Returns the message of an import without the module _core, which lies in `folder`."""
    here = f"Python {sys.version_info.major}.{sys.version_info.minor} ({sys.executable})"
    modules = sorted(folder.glob("_core.*.so"))
    if not modules:
        return (f"the compiled part of stepwire, _core, is not in {folder}; './stepwire python' in a checkout "
                "builds it for Debian's /usr/bin/python3")
    if (sys.implementation.cache_tag or "") not in modules[0].name:
        return f"{modules[0].name} in {folder} was built for another Python than {here}; call /usr/bin/python3"
    return f"{modules[0]} cannot be loaded: {error}"
