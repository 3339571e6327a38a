"""Libraries that are used where they are installed."""

from __future__ import annotations

import importlib

PACKAGES = {"matplotlib": "python3-matplotlib", "pandas": "python3-pandas", "scipy": "python3-scipy"}


class MissingLibrary(ImportError):
    """A library that was asked for is not installed."""


def library(module: str, purpose: str):
    """The module, imported. Raises MissingLibrary, which says what to install."""
    try:
        return importlib.import_module(module)
    except ImportError:
        name = module.partition(".")[0]
        cure = f"Debian: apt install {PACKAGES[name]}; else pip install {name}" if name in PACKAGES else f"pip install {name}"
        raise MissingLibrary(f"{purpose}: needs {name} ({cure})") from None
