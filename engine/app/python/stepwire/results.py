"""What a run, a sweep, a study, a fit, a tuning or a linear analysis gave."""

from __future__ import annotations

import functools
import itertools
import json
import warnings
from collections.abc import Callable, Container, Iterable, Iterator, KeysView, Mapping
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar

from . import _core, show
from .errors import Fault, Interrupted, RunError
from .records import Claim, FitResult, FittedParameter, LinearResult, Notice, RunResult, StudyResult, TuneResult

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd  # type: ignore[import]
    from numpy.typing import NDArray

    from .model import Model


class RunColumns(dict[str, "NDArray[np.float64]"]):
    """The columns of one run by their names. A vector or a matrix is there as a whole, too, as in `Run`."""

    def __init__(self, shapes: Mapping[str, tuple[int, ...]]):
        super().__init__()
        self._shapes = shapes

    def __missing__(self, name: str) -> NDArray[np.float64]:
        return _whole(name, self._shapes, self, lambda element: self[element])

    def __contains__(self, name: object) -> bool:
        return super().__contains__(name) or (isinstance(name, str) and _has_whole(name, self._shapes, self.keys()))


class Run:
    """What a run, or all runs of a sweep one behind the other, recorded. Never changes.

    ``run["cart.position"]`` is a column as a numpy array (rows,) in SI, a view without copy that keeps the run
    alive; ``run["time"]`` is in s. A vector signal p is there element by element as p.1, p.2, ..., and as a
    whole, p, as a copy (rows, n); a matrix k of m x n numbers as k.1.1, k.2.1, ..., and as a copy (rows, m, n).
    """

    def __init__(self, results: _core.Results, model: Model):
        self._results = results
        self.model = model
        self._places: dict[str, tuple[int, int]] = {}
        self._units: dict[str, str] = {}
        for recording in range(results.recordings):
            for index, (name, unit) in enumerate(results.columns(recording)):
                self._places.setdefault(name, (recording, index))
                self._units.setdefault(name, unit)

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        place = self._places.get(name)
        if place is not None:
            return self._results.column(*place)
        return _whole(name, self._shapes, self._places, lambda element: self._results.column(*self._places[element]))

    @property
    def _shapes(self) -> dict[str, tuple[int, ...]]:
        return {name: shape for name, _, _, shape in self.model._file.signals if shape}

    def __contains__(self, name: object) -> bool:
        if name in self._places or not isinstance(name, str):
            return name in self._places
        return _has_whole(name, self._shapes, self._places)

    def __iter__(self) -> Iterator[str]:
        return iter(self._places)

    def __len__(self) -> int:
        return len(self._places)

    def keys(self) -> KeysView[str]:
        """The names of all columns."""
        return self._places.keys()

    @property
    def units(self) -> dict[str, str]:
        """The unit of each column, SI; empty where it has none."""
        return dict(self._units)

    def table(self, recording: int = 0) -> pd.DataFrame:
        """What one entry of `record` recorded, as a DataFrame: a column for each signal, `time` [s] first; of a
        sweep with its parameters, the runs one behind the other. ``attrs["units"]`` has the unit of each column."""
        import pandas as pd
        columns = self._results.columns(recording)
        words = self._results.categories(recording)
        data: dict[str, Any] = {}
        for index, (name, _) in enumerate(columns):
            values = self._results.column(recording, index)
            data[name] = pd.Categorical.from_codes(values.astype(int), words[name]) if _distinct(words.get(name)) else values
        table = pd.DataFrame(data)
        table.attrs["units"] = dict(columns)
        table.attrs["title"] = self.model.title
        return table

    @property
    def points(self) -> list[dict[str, str]]:
        """What each run of a sweep sets, as texts; empty without a sweep."""
        return self._results.points

    def run(self, index: int) -> RunColumns:
        """The columns of one run of a sweep, from 0: views without copy; vectors and matrices by their names as
        those of all runs."""
        count = max(len(self.points), 1)
        if not -count <= index < count:
            raise IndexError(f"there are {count} runs")
        index %= count
        columns = RunColumns(self._shapes)
        for name, (recording, column) in self._places.items():
            starts = self._results.starts(recording) + [None]
            columns[name] = self._results.column(recording, column)[starts[index]:starts[index + 1]]
        return columns

    @property
    def claims(self) -> list[Claim]:
        """The claims and invariants of the file, judged."""
        return [Claim.read(claim) for claim in json.loads(self._results.claims)]

    @property
    def ok(self) -> bool:
        """Did it come to its end, and does every claim hold that is expected to?"""
        return not self.early and not any(claim.fails for claim in self.claims)

    @property
    def figures(self) -> show.Pictures:
        """The figures of the file. Empty where the run ended early or the file has none."""
        pictures = [show.Picture(f"figure {index + 1}", functools.partial(self._results.figure, index))
                    for index in range(self._results.figures)]
        return show.Pictures(pictures, "the run ended early, so there is no picture of it" if self.early
                             else "the file has no section 'figure'")

    @property
    def faults(self) -> list[Fault]:
        """What ended the run before its time, at most one for each run of a sweep."""
        return [Fault(*fault) for _, _, _, fault in self._results.faults]

    @property
    def notices(self) -> list[Notice]:
        """What blocks had to say."""
        return list(self.result.notices)

    @property
    def early(self) -> bool:
        """Did a fault or an interruption end it before its time?"""
        return self._results.early

    @property
    def interrupted(self) -> bool:
        return self._results.interrupted

    @property
    def ticks(self) -> int:
        """Of all runs together."""
        return self._results.ticks

    @property
    def compiled_ticks(self) -> int:
        """Of them, those that compiled code made."""
        return self._results.compiled_ticks

    @property
    def seconds(self) -> float:
        """How long the run itself took [s]."""
        return self._results.seconds

    @functools.cached_property
    def result(self) -> RunResult:
        """The fields of run.json of `stepwire run`."""
        return RunResult.read(self.info)

    @property
    def info(self) -> dict[str, Any]:
        """What was run, as run.json of `stepwire run` has it."""
        return dict(json.loads(self._results.json))

    def write(self, folder: str) -> None:
        """Writes all files that `stepwire run --out` writes."""
        self._results.write(str(folder))

    def __str__(self) -> str:
        return self._results.words

    def __repr__(self) -> str:
        rows = len(self["time"]) if "time" in self._places else 0
        return f"<{type(self).__name__} of {self.model.file}: {len(self)} columns, {rows} rows{', ended early' if self.early else ''}>"

    def _repr_html_(self) -> str:
        rows = [(claim.that, claim.shown, "holds" if claim.holds else "does not hold") for claim in self.claims]
        claims = show.table(("claim", "value", ""), rows) if rows else ""
        return show.heading(repr(self)[1:-1]) + "".join(f"<p>{_escaped(fault)}</p>" for fault in self.faults) + claims

    def __copy__(self) -> Run:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Run:
        return self

    def __reduce__(self) -> NoReturn:
        raise TypeError("a run is not pickled; pickle run.table(), or write the run to a folder")


def _elements(name: str, shape: tuple[int, ...]) -> list[str]:
    """The columns of a vector or a matrix, row by row."""
    places = itertools.product(*(range(1, count + 1) for count in shape))
    return [".".join([name, *map(str, place)]) for place in places]


def _has_whole(name: str, shapes: Mapping[str, tuple[int, ...]], columns: Container[str]) -> bool:
    shape = shapes.get(name, ())
    return bool(shape) and all(element in columns for element in _elements(name, shape))


def _whole(name: str, shapes: Mapping[str, tuple[int, ...]], columns: Iterable[str],
           column: Callable[[str], NDArray[np.float64]]) -> NDArray[np.float64]:
    """A vector (rows, n) or a matrix (rows, m, n) made of its columns. Raises KeyError where one is missing."""
    known = list(columns)
    shape = shapes.get(name)
    if not shape:
        raise KeyError(f"nothing of the name {name!r} is recorded; recorded are: {', '.join(known)}")
    names = _elements(name, shape)
    missing = [element for element in names if element not in known]
    if missing:
        raise KeyError(f"{name!r} is not recorded as a whole, {', '.join(missing)} being left out; "
                       f"recorded are: {', '.join(known)}")
    import numpy as np
    values = np.stack([column(element) for element in names], axis=-1)
    return values.reshape(len(values), *shape)


def _escaped(fault: Fault) -> str:
    import html
    return html.escape(str(fault))


def _distinct(words: list[str] | None) -> bool:
    return words is not None and bool(words) and len(set(words)) == len(words)


class Study(Run):
    """What the study of a file gave: a run whose runs are the trials. `data` has all that was found, as
    study.json of `stepwire study` has it."""

    @functools.cached_property
    def study(self) -> StudyResult:
        """The fields of study.json; those of run.json are `result`."""
        return StudyResult.read(self.data)

    @property
    def data(self) -> dict[str, Any]:
        return dict(json.loads(self._results.study))


class _Found:
    """What a search for parameters found: `data` as the JSON file of its verb has it, and `model`, which has what was
    found. Derived classes set `parameters`, by name."""

    parameters: dict[str, Any]
    result: Any
    _deed = ""  #: what is done to a parameter, in messages

    def __init__(self, found: _core.Found, model: Model):
        self._found = found
        self._of = model
        self.data: dict[str, Any] = json.loads(found.json)

    def __getitem__(self, name: str) -> float:
        """The number of a parameter, SI."""
        if name not in self.parameters:
            raise KeyError(f"{name!r} was not {self._deed}; {self._deed} are: {', '.join(self.parameters)}")
        return self._value(self.parameters[name])

    @staticmethod
    def _value(parameter: Any) -> float:
        return float(parameter)

    @property
    def converged(self) -> bool:
        return bool(self.result.converged)

    @property
    def findings(self) -> list[str]:
        """What cannot be known, is at a bound, in the way or refused, or could not be run."""
        return list(self.result.findings)

    @property
    def model(self) -> Model:
        """The model with what was found."""
        return self._of.with_values(dict(self._found.settings))

    @property
    def figures(self) -> show.Pictures:
        pictures = [show.Picture(name, functools.partial(self._found.figure, index))
                    for index, name in enumerate(self._found.figures)]
        return show.Pictures(pictures, f"the {type(self).__name__.lower()} has no pictures")

    def __str__(self) -> str:
        return self._found.words

    def __repr__(self) -> str:
        numbers = ", ".join(f"{name}={self[name]:g} {getattr(one, 'unit', '')}".strip() for name, one in self.parameters.items())
        return f"<{type(self).__name__} of {self._of.file}: {numbers}>"


class Fit(_Found):
    """What the fit of a file found. `parameters` by name, `result` with all fields, `data` as fit.json of
    `stepwire fit` has them, `figures` of records and residuals, and `model`, which has what was found."""

    parameters: dict[str, FittedParameter]
    result: FitResult
    _deed = "fitted"

    def __init__(self, fit: _core.Found, model: Model):
        super().__init__(fit, model)
        self.result = FitResult.read(self.data)
        self.parameters = {one.name + (f" of {one.record}" if one.record else ""): one for one in self.result.parameters}

    @staticmethod
    def _value(parameter: FittedParameter) -> float:
        return parameter.value

    def table(self) -> pd.DataFrame:
        """The parameters as a DataFrame, by their names."""
        import pandas as pd
        rows = [{"value": one.value, "unit": one.unit, "standard_error": one.standard_error,
                 "low": one.interval[0], "high": one.interval[1]} for one in self.parameters.values()]
        return pd.DataFrame(rows, index=list(self.parameters))

    def _repr_html_(self) -> str:
        rows = [(name, f"{one.value:.6g}", one.unit, f"{one.interval[0]:.6g} .. {one.interval[1]:.6g}")
                for name, one in self.parameters.items()]
        return show.table(("parameter", "value", "unit", "95 %"), rows)


class Tuning(_Found):
    """What the tuning of a file found. `parameters` by name in SI, `objective`, `feasible` (do all claims hold?),
    `result` with all fields, `data` as tune.json of `stepwire tune` has them, and `model`, which has what was
    found."""

    parameters: dict[str, float]
    result: TuneResult
    _deed = "tuned"

    def __init__(self, tuning: _core.Found, model: Model):
        super().__init__(tuning, model)
        self.result = TuneResult.read(self.data)
        self.parameters = {one.name: one.value for one in self.result.parameters}
        self.objective = self.result.objective
        self.feasible = self.result.feasible

    def history(self) -> pd.DataFrame:
        """Each evaluation as a row of a DataFrame: the parameters, `objective`, `margin.1` and on of the claims,
        `start`, and why there is no objective."""
        import pandas as pd
        rows = []
        for values, objective, margins, start, fault in self._found.history:
            row = dict(zip(self.parameters, values))
            row["objective"] = objective
            row.update({f"margin.{i + 1}": margin for i, margin in enumerate(margins)})
            rows.append({**row, "start": start, "fault": fault})
        return pd.DataFrame(rows)

    def _repr_html_(self) -> str:
        rows = [(name, f"{value:.6g}") for name, value in self.parameters.items()]
        return show.table(("parameter", "value (SI)"), rows)


class Linear:
    """A linear system near a point of a run: x' = A x + B u, y = C x + D u as arrays (n, n), (n, m), (p, n),
    (p, m) in SI; sampled where `sample_time` [s] is above 0. `result` has all fields, `data` those of linear.json
    of `stepwire linearize`."""

    def __init__(self, text: str, words: str):
        import numpy as np
        self.data: dict[str, Any] = json.loads(text)
        self._words = words
        self.result = LinearResult.read(self.data)
        self.states, self.inputs, self.outputs = self.result.states, self.result.inputs, self.result.outputs
        n, m, p = len(self.states), len(self.inputs), len(self.outputs)
        shapes = {"A": (n, n), "B": (n, m), "C": (p, n), "D": (p, m)}
        self.A, self.B, self.C, self.D = (np.array(getattr(self.result, name), dtype=float).reshape(shape)
                                          for name, shape in shapes.items())
        self.poles = np.array(self.result.poles)
        self.sample_time = self.result.sample_time

    @property
    def stable(self) -> bool | None:
        return self.result.stable

    def scipy(self) -> Any:
        """The system as scipy.signal.StateSpace."""
        from scipy import signal  # type: ignore[import]
        sampled = {"dt": self.sample_time} if self.sample_time > 0 else {}
        return signal.StateSpace(self.A, self.B, self.C, self.D, **sampled)

    def __str__(self) -> str:
        return self._words

    def __repr__(self) -> str:
        return f"<Linear: {len(self.states)} states, from {', '.join(self.inputs)} to {', '.join(self.outputs)}>"


_Run = TypeVar("_Run", bound=Run)


def finished(results: _core.Results, run: _Run, check: bool) -> _Run:
    """The run, or what ended it as an exception that has it."""
    for note in results.notes:
        warnings.warn(note, RuntimeWarning, stacklevel=4)
    raised = results.raised
    if isinstance(raised, KeyboardInterrupt):
        raise Interrupted(run) from raised
    if raised is not None:
        setattr(raised, "run", run)
        raise raised
    if check and results.faults:
        block, _, time, _ = results.faults[0]
        raise RunError(run.faults, run, block, time) from results.cause
    return run
