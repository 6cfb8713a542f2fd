"""Values of Python as a diagram file writes them."""

from __future__ import annotations

import numbers
import os
from collections.abc import Mapping, Sequence
from typing import Any, Union

Value = Union[str, float, int, bool, Sequence[Any], "os.PathLike[str]"]


def text_of(value: Any, name: str) -> str:
    """A number (SI), a text with its unit ("8 kg"), a flag, a path, or a list of these, as a file has it."""
    if isinstance(value, str):
        return value
    if isinstance(value, os.PathLike):
        return str(os.fspath(value))
    if isinstance(value, bool) or type(value).__name__ == "bool_":
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if hasattr(value, "tolist"):  # an array
        return text_of(value.tolist(), name)
    if isinstance(value, Sequence) and not isinstance(value, (bytes, bytearray)):
        return "[" + ", ".join(text_of(item, name) for item in value) + "]"
    raise TypeError(f"{name}: {value!r} is no value of a diagram: a number in SI, a text such as '8 kg', a flag, or a list")


def tree_of(value: Any, name: str) -> Any:
    """The same for a section: dictionaries and lists of texts."""
    if isinstance(value, Mapping):
        return {str(key): tree_of(item, f"{name}.{key}") for key, item in value.items()}
    if hasattr(value, "tolist") and getattr(value, "ndim", False):
        value = value.tolist()
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [tree_of(item, name) for item in value]
    return text_of(value, name)


def names_of(value: str | Sequence[str]) -> list[str]:
    """One name or several."""
    return [value] if isinstance(value, str) else [str(name) for name in value]
