"""What goes wrong: faults with their places, as exceptions."""

from __future__ import annotations

import os
import traceback
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .results import Run


@dataclass(frozen=True)
class Fault:
    """One thing that is wrong in a file or a call: where, in what, what is wrong, and what would be right."""

    file: str
    line: int  #: from 1; 0 means the file as a whole, or a call
    column: int
    subject: str  #: "lag.tau", or empty
    text: str
    cure: str = ""  #: what would be right; empty where nothing is known
    used_by: tuple[tuple[str, int, int], ...] = ()  #: lines that used the part in which the fault lies

    def __str__(self) -> str:
        place = self.file + (f":{self.line}:{self.column}" if self.line else "")
        parts = [part for part in (place, self.subject, self.text + (f"; {self.cure}" if self.cure else "")) if part]
        users = "".join(f" (used by {file}:{line}:{column})" for file, line, column in self.used_by)
        return ": ".join(parts) + users


class Error(Exception):
    """Something is wrong in what a user wrote. `faults` are all that one pass found; `file`, `line`, `column`,
    `text` and `cure` are those of the first one."""

    def __init__(self, faults: list[Fault]):
        super().__init__(faults)
        self.faults = list(faults)

    def __str__(self) -> str:
        return "\n".join(str(fault) for fault in self.faults)

    @property
    def file(self) -> str:
        return self.faults[0].file

    @property
    def line(self) -> int:
        return self.faults[0].line

    @property
    def column(self) -> int:
        return self.faults[0].column

    @property
    def text(self) -> str:
        return self.faults[0].text

    @property
    def cure(self) -> str:
        return self.faults[0].cure


class RunError(Error):
    """A run ended before its time. `run` has what was recorded until then, `time` [s] and `block` say when and
    where the first fault was."""

    def __init__(self, faults: list[Fault], run: Run, block: str, time: float):
        super().__init__(faults)
        self.run, self.block, self.time = run, block, time

    def __reduce__(self) -> tuple[type[Error], tuple[list[Fault]]]:
        return (Error, (self.faults,))


class EnvironmentError(OSError):
    """Something is wrong around a file: the disk, a program that is not installed, memory."""


class Interrupted(KeyboardInterrupt):
    """A run was interrupted. `run` has what was recorded until then."""

    def __init__(self, run: Run):
        super().__init__("the run was interrupted; .run of this exception, or last_run of the model, has what was recorded")
        self.run = run


def error_of(tuples: list[tuple[Any, ...]]) -> Error:
    """The exception of faults as the module _core gives them."""
    return Error([Fault(*each) for each in tuples])


def shown(error: BaseException) -> str:
    """An exception in one line, with the place where it was raised: "ValueError: no mass (drag.py:12)"."""
    text = "".join(traceback.format_exception_only(type(error), error)).strip().splitlines()
    frames = traceback.extract_tb(error.__traceback__)
    place = f" ({os.path.basename(frames[-1].filename)}:{frames[-1].lineno})" if frames else ""
    return (text[-1] if text else type(error).__name__) + place
