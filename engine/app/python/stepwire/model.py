"""A diagram file that is loaded."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from . import _core, show
from .blocks import declaration_of
from .results import Fit, Linear, Run, Study, Tuning, finished
from .simulation import Simulation
from .texts import Value, names_of, text_of, tree_of

_ENGINES = ("auto", "interpreted", "compiled")


@dataclass(frozen=True)
class Signal:
    """An output or a state of a block, or a port of a part."""

    name: str
    unit: str  #: SI; empty where it has none
    size: int
    shape: tuple[int, ...] = ()  #: () of one number, (n,), or (rows, columns) of a matrix


@dataclass(frozen=True)
class Input:
    """An input of the diagram itself."""

    name: str
    unit: str
    size: int
    doc: str
    shape: tuple[int, ...] = ()  #: () of one number, (n,), or (rows, columns) of a matrix


@dataclass(frozen=True)
class Parameter:
    """A parameter of the diagram or of one of its parts."""

    name: str
    text: str  #: its value as it is written or set: "8 kg"
    value: Any  #: evaluated, SI: a float, a text, an array (n,) or (rows, columns)
    unit: str
    doc: str


class Named(Mapping[str, Any]):
    """Things of a model by name, in their order."""

    def __init__(self, kind: str, items: Iterable[Any]):
        self._kind = kind
        self._items = {item.name: item for item in items}

    def __getitem__(self, name: str) -> Any:
        if name not in self._items:
            raise KeyError(f"there is no {self._kind} {name!r}; there are: {', '.join(self._items) or 'none'}")
        return self._items[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._items)

    def __len__(self) -> int:
        return len(self._items)

    def __repr__(self) -> str:
        return "\n".join(map(repr, self._items.values())) or f"no {self._kind}"

    def _repr_html_(self) -> str:
        items = list(self._items.values())
        if not items:
            return f"no {self._kind}"
        keys = list(items[0].__dataclass_fields__)
        return show.table(keys, [[getattr(item, key) for key in keys] for item in items])


def load(file: str | os.PathLike[str], *, blocks: Sequence[type] = (), block_folders: Sequence[str] = (),
         values: Mapping[str, Value] | None = None, **parameters: Value) -> Model:
    """Loads and checks a diagram file. Parameters are numbers in SI or texts with their unit, ``mass="8 kg"``;
    `values` takes names that are no words of Python, ``{"rig.mass": 8}``. `blocks` are classes declared with
    `stepwire.block`, `block_folders` folders with blocks in C++. Raises Error with all that is wrong."""
    return Model(os.path.abspath(os.fspath(file)), _texts(values, parameters), tuple(blocks), tuple(map(str, block_folders)))


class Model:
    """A diagram that is loaded and checked. Never changes; runs of it may go on in several threads. The files are
    kept as they were when it was loaded."""

    last_run: Run | None = None  #: the newest run of this model, also one that was interrupted or ended early

    def __init__(self, file: str, texts: dict[str, str], blocks: tuple[type, ...], folders: tuple[str, ...],
                 loaded: _core.File | None = None):
        self._texts, self._blocks, self._folders = texts, blocks, folders
        if loaded is None:
            declared = [declaration_of(cls) for cls in blocks]
            if folders or os.environ.get("STEPWIRE_BLOCKS"):
                _share_symbols()
            loaded = _core.load(file, list(texts.items()), None, {}, declared, list(folders))
        self._file = loaded

    def with_values(self, values: Mapping[str, Value] | None = None, **parameters: Value) -> Model:
        """The same files with other values of parameters."""
        return self._again(_texts(values, parameters), None, {})

    def _again(self, texts: dict[str, str], stop: Value | None, sections: dict[str, Any],
               without: Iterable[str] = ()) -> Model:
        if not texts and stop is None and not sections:
            return self
        all_texts = {name: text for name, text in {**self._texts, **texts}.items() if name not in without}
        end = None if stop is None else text_of(stop, "stop")
        loaded = _core.load_again(self._file, list(all_texts.items()), end, sections)
        return Model(self.file, all_texts, self._blocks, self._folders, loaded)

    @property
    def file(self) -> str:
        return self._file.path

    @property
    def title(self) -> str:
        return self._file.title

    @property
    def step(self) -> float:
        """[s]"""
        return self._file.step

    @property
    def stop(self) -> float:
        """[s]"""
        return self._file.stop

    @property
    def signals(self) -> Named:
        """All signals by name, each with its unit and size."""
        return Named("signal", (Signal(*signal) for signal in self._file.signals))

    @property
    def inputs(self) -> Named:
        """The inputs of the diagram, which a simulation or an observer writes."""
        return Named("input", (Input(*each) for each in self._file.inputs))

    @property
    def parameters(self) -> Named:
        """The parameters, each with its value as it is written or set."""
        return Named("parameter", (Parameter(*parameter) for parameter in self._file.parameters))

    def run(self, *, stop: Value | None = None, engine: str = "auto", observers: Sequence[Any] = (),
            progress: Callable[[float, str], Any] | None = None, check: bool = True,
            values: Mapping[str, Value] | None = None, **parameters: Value) -> Run:
        """Runs the model, or all points of its sweep, to its end or to `stop` ("3 s", or a number in s), and judges
        its claims. Other parameters, as `load` takes them, hold for this run.

        `engine` is "interpreted", "compiled", or "auto": compiled once that is worth it; all to the same bits.
        `observers` are called with a `Running` after the outputs of each tick are computed, or have methods
        `begin`, `before_tick`, `evaluated`, `row` and `end`. `progress` is called with the fraction done.

        Raises RunError where a fault ends the run, with `check=False` not; Interrupted (a KeyboardInterrupt) where
        it is interrupted; and what an observer raises. Each has `run`, what was recorded until then."""
        model = self._again(_texts(values, parameters), stop, {})
        results = model._file.run(_engine(engine), list(observers), progress)
        run = self.last_run = Run(results, model)
        return finished(results, run, check)

    def sweep(self, axes: Mapping[str, Sequence[Value]], **options: Any) -> Run:
        """Runs all combinations of these values, ``{"mass": ["1 kg", "2 kg"], "gain": [1, 2, 3]}``, in parallel,
        in the place of the file's own sweep. The last name runs fastest. Options are those of `run`."""
        if not isinstance(axes, Mapping) or not axes:
            raise TypeError("a sweep is a dictionary of names and their values: {'mass': ['1 kg', '2 kg']}")
        tree = {name: _axis(name, values) for name, values in axes.items()}
        swept = self._again({}, options.pop("stop", None), {"sweep": tree}, without=axes)
        try:
            return swept.run(**options)
        finally:
            self.last_run = swept.last_run

    def fit(self, section: Mapping[str, Any] | None = None, *, engine: str = "auto", starts: int | None = None,
            seed: int | None = None, threads: int = 0, progress: Callable[[float, str], Any] | None = None) -> Fit:
        """Finds the parameters that the section `fit` names, of the file or as a dictionary of the same keys."""
        model = self if section is None else self._again({}, None, {"fit": tree_of(section, "fit")})
        return Fit(model._file.fit(_engine(engine), starts, seed, threads, progress), model)

    def tune(self, section: Mapping[str, Any] | None = None, *, engine: str = "auto", starts: int | None = None,
             evaluations: int | None = None, seed: int | None = None, repeat: int | None = None, threads: int = 0,
             progress: Callable[[float, str], Any] | None = None) -> Tuning:
        """Finds the parameters that make the objective of the section `tune` small while its claims hold; the
        section is that of the file, or a dictionary of the same keys. `repeat` counts the experiments of one
        evaluation of a study."""
        model = self if section is None else self._again({}, None, {"tune": tree_of(section, "tune")})
        return Tuning(model._file.tune(_engine(engine), starts, evaluations, seed, repeat, threads, progress), model)

    def study(self, *, engine: str = "auto", threads: int = 0, observers: Sequence[Any] = (),
              progress: Callable[[float, str], Any] | None = None, check: bool = True) -> Study:
        """Performs the study of the file's section `study`."""
        results = self._file.study(_engine(engine), threads, list(observers), progress)
        run = self.last_run = Study(results, self)
        return finished(results, run, check)

    def linearize(self, inputs: str | Sequence[str] = (), outputs: str | Sequence[str] = (), *,
                  open: str | Sequence[str] = (), time: float = 0.0, difference: float | None = None,
                  feedback: int | None = None, trim: bool = False) -> Linear:
        """The linear system from some signals to others, all inputs and outputs of the diagram without them, at a
        time of the run [s] or at the point of the section `trim`; wires of the signals `open` are cut."""
        text, words = self._file.linearize(names_of(inputs), names_of(outputs), names_of(open), float(time),
                                           difference, feedback, trim)
        return Linear(text, words)

    def simulation(self, *, engine: str = "interpreted", tuned: Sequence[str] = ()) -> Simulation:
        """A run tick by tick. Compiled code goes on to be used after values in `tuned` are set, and no others."""
        return Simulation(self, _engine(engine), list(tuned))

    def generate(self, folder: str | os.PathLike[str], name: str = "") -> None:
        """Writes the diagram as C++ that is built without stepwire, as `stepwire generate` does. Raises Error for
        blocks of which no code can be made, such as those in Python."""
        self._file.generate(os.fspath(folder), name)

    def loop(self, duration: Value = "10 s", *, rate: Value = 1000, policy: str = "fifo:80",
             out: str | os.PathLike[str] = "") -> str:
        """Runs the model by the clock of this machine, as `stepwire loop` does; returns what was measured, in words.
        `rate` is in Hz. Raises Error for blocks that are not fit for it, such as those in Python."""
        return self._file.loop(text_of(duration, "duration"), text_of(rate, "rate"), policy, os.fspath(out))

    def draw(self, *, open: str | Sequence[str] = (), depth: int = 0, hide: str | Sequence[str] = (),
             units: bool = False) -> show.Picture:
        """The diagram as a picture; `open` names parts whose inside is drawn, `depth` opens all down to there."""
        opened, hidden = names_of(open), names_of(hide)
        return show.Picture("diagram", lambda: self._file.draw(opened, depth, hidden, units))

    def __repr__(self) -> str:
        return f"<Model {self.title!r} of {self.file}>"

    def _repr_html_(self) -> str:
        return show.heading(self.title) + self.parameters._repr_html_() + self.draw()._repr_html_()

    def __reduce__(self) -> tuple[type[Model], tuple[Any, ...]]:
        return (Model, (self.file, self._texts, self._blocks, self._folders))


def _share_symbols() -> None:
    """Blocks from outside use functions of the module, whose symbols Python keeps to it."""
    ctypes.CDLL(_core.__file__, mode=os.RTLD_GLOBAL | os.RTLD_NOLOAD)


def _texts(values: Mapping[str, Value] | None, parameters: Mapping[str, Value]) -> dict[str, str]:
    both = {**(values or {}), **parameters}
    return {str(name): text_of(value, str(name)) for name, value in both.items()}


def _axis(name: str, values: Any) -> Any:
    tree = tree_of(values, name)
    if isinstance(tree, str):
        raise TypeError(f"sweep of {name}: a list of values; one value alone is set: run({name}={values!r})")
    return tree


def _engine(engine: str) -> str:
    if engine not in _ENGINES:
        raise ValueError(f"there is no engine {engine!r}; there are: {', '.join(_ENGINES)}")
    return engine
