"""A run tick by tick."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, NoReturn

from . import _core

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from .model import Model


class Inputs(Mapping[str, "float | NDArray[np.float64]"]):
    """The inputs of a simulation. Writing one, ``inputs["push"] = 3.0``, holds from the next tick on until it is
    written again; numbers are SI, a text has its unit ("3 mm"), and of an input of n numbers it is a list or an
    array, of a matrix an array (rows, columns). NaN and infinity are refused. Reading one gives its numbers at the
    tick that is shown."""

    def __init__(self, simulation: Simulation, names: list[str]):
        self._simulation = simulation
        self._names = names

    def __setitem__(self, name: str, value: Any) -> None:
        self._simulation._write(name, value)

    def __getitem__(self, name: str) -> float | NDArray[np.float64]:
        if name not in self._names:
            raise KeyError(f"there is no input {name!r}; inputs are: {', '.join(self._names) or 'none'}")
        return self._simulation[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


class Simulation(_core.Simulation):
    """A run tick by tick, with the file's own values in place of a sweep. ``step()`` computes the next tick, at
    first that of time 0; ``simulation["cart.position"]`` shows a signal of it. ``for time in simulation:`` steps to
    the end. One call at a time may use it."""

    def __init__(self, model: Model, engine: str = "interpreted", tuned: list[str] = []):
        super().__init__(model._file, engine, list(tuned))
        self.model = model
        self.inputs = Inputs(self, [name for name, *_ in model._file.inputs])

    def __iter__(self) -> Iterator[float]:
        while not self.finished:
            self.step()
            yield self.time

    def __repr__(self) -> str:
        return f"<Simulation of {self.model.file} at {self.time:g} s{', finished' if self.finished else ''}>"

    def __reduce__(self) -> NoReturn:
        raise TypeError("a simulation is not pickled; pickle its model")
