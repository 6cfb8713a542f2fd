"""Pictures and tables for Jupyter."""

from __future__ import annotations

import html
import os
from collections.abc import Callable, Sequence
from typing import overload


class Picture:
    """A picture as SVG, drawn when it is first looked at. Jupyter shows it."""

    def __init__(self, name: str, draw: Callable[[], str]):
        self.name = name
        self._draw = draw
        self._svg: str | None = None

    @property
    def svg(self) -> str:
        """The picture as SVG text. Raises EnvironmentError where what draws it is not installed."""
        if self._svg is None:
            self._svg = self._draw()
        return self._svg

    def save(self, path: str) -> None:
        """Writes the SVG file, whole or not at all. Raises OSError where the system refuses."""
        text, path = self.svg, os.path.realpath(path)
        part = f"{path}.{os.getpid()}.part"
        try:
            with open(part, "x", encoding="utf-8") as file:
                file.write(text)
            os.replace(part, path)
        except BaseException:
            if os.path.exists(part):
                os.remove(part)
            raise

    def _repr_svg_(self) -> str:
        return self.svg

    def _repr_html_(self) -> str:
        start = self.svg.find("<svg")
        return self.svg[max(start, 0):]

    def __repr__(self) -> str:
        return f"<{self.name}: a picture; .svg has its text, .save(path) writes it>"


class Pictures(Sequence[Picture]):
    """Pictures by their number, from 0."""

    def __init__(self, pictures: Sequence[Picture], why_none: str):
        self._pictures = list(pictures)
        self._why_none = why_none

    def __len__(self) -> int:
        return len(self._pictures)

    @overload
    def __getitem__(self, index: int) -> Picture: ...

    @overload
    def __getitem__(self, index: slice) -> list[Picture]: ...

    def __getitem__(self, index: int | slice) -> Picture | list[Picture]:
        if not self._pictures and isinstance(index, int):
            raise IndexError(self._why_none)
        return self._pictures[index]

    def __repr__(self) -> str:
        return repr(self._pictures)


def table(head: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """A table as HTML, whose texts are escaped."""
    def line(cells: Sequence[object], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag} style='text-align:left'>{html.escape(str(cell))}</{tag}>" for cell in cells) + "</tr>"
    return "<table>" + line(head, "th") + "".join(line(row, "td") for row in rows) + "</table>"


def heading(text: str) -> str:
    """A line of HTML in bold."""
    return f"<p><b>{html.escape(text)}</b></p>"
