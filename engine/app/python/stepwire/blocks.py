"""Blocks written in Python, for trying out."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar, Union

Port = Union[str, "tuple[Any, ...]"]
_Class = TypeVar("_Class")
Ports = Union[Mapping[str, Port], Sequence[str]]

_TIME, _PERIOD, _INPUT, _STATE, _MEMORY = range(5)  # as `Source` of the module has them
_METHODS = {"outputs": "output_method", "derivatives": "slope_method", "update": "update_method"}


def block(*, inputs: Ports = (), outputs: Ports = (), states: Ports = (), memory: Ports = (),
          parameters: Ports = (), name: str | None = None) -> Callable[[type[_Class]], type[_Class]]:
    """Declares a class as a kind of block, which `load(..., blocks=[Drag])` knows by the name of the class.

    Each argument maps names to units, ``{"v": "m/s"}``, or to units and sizes, ``{"v": ("m/s", 3)}``; a letter as
    size is the same for all ports that have it, and ``(3, 2)`` is a matrix of 3 rows. A list of names means numbers
    without unit. `states` are continuous, `memory` is changed by `update`. Their initial numbers are attributes.
    `parameters` are values of the file: an attribute of their name is the default, others are required.

    Methods take what their arguments name, inputs, states, memory, `t` (time [s]) and `period` [s], as a float or
    an array (n,) or (rows, columns), all in SI, and return one value for each output (`outputs`), slope of a state (`derivatives`) or
    number of the memory (`update`): several as a tuple. An input that `outputs` does not take has no effect on
    the outputs of the same instant. Arrays are valid during the call. Each run has an object of its own, which
    should remember nothing but its memory: a run may be put back.

        @stepwire.block(inputs={"v": "m/s"}, outputs={"F": "N"}, parameters={"c": "kg/m"})
        class Drag:
            c = 2.0

            def outputs(self, v):
                return -self.c * abs(v) * v
    """
    def declare(cls: type[_Class]) -> type[_Class]:
        declared = _declaration(cls, name or cls.__name__, inputs, outputs, states, memory, parameters)
        setattr(cls, "_stepwire_block", declared)
        return cls
    return declare


def declaration_of(cls: Any) -> dict[str, Any]:
    """What the module needs of a class."""
    declared: dict[str, Any] | None = getattr(cls, "_stepwire_block", None)
    if not isinstance(cls, type) or declared is None:
        raise TypeError(f"{cls!r} is no block; decorate a class with @stepwire.block(inputs=..., outputs=...)")
    if declared["class"] is not cls:
        raise TypeError(f"{cls.__name__} takes over the declaration of {declared['class'].__name__}; "
                        "decorate it with @stepwire.block, too")
    return declared


def _declaration(cls: type, name: str, inputs: Ports, outputs: Ports, states: Ports, memory: Ports,
                 parameters: Ports) -> dict[str, Any]:
    kinds = {"inputs": inputs, "outputs": outputs, "states": states, "memory": memory}
    ports = {kind: [_port(cls, kind, *item) for item in _items(given)] for kind, given in kinds.items()}
    _require_own_names(cls, [port[0] for listed in ports.values() for port in listed])
    known = {"t": (_TIME, 0), "period": (_PERIOD, 0)}
    for code, kind in ((_INPUT, "inputs"), (_STATE, "states"), (_MEMORY, "memory")):
        known |= {port[0]: (code, index) for index, port in enumerate(ports[kind])}
    declared: dict[str, Any] = {"name": name, "doc": inspect.getdoc(cls) or "A block in Python.", "class": cls,
                                "place": f"{cls.__module__}.{cls.__qualname__}"}
    declared |= {key: _arguments(cls, method, known) for method, key in _METHODS.items()}
    for method, kind in (("outputs", "outputs"), ("derivatives", "states"), ("update", "memory")):
        if ports[kind] and declared[_METHODS[method]] is None:
            raise TypeError(f"{cls.__name__} has {kind} and no method {method}()")
    taken = {index for code, index in declared["output_method"] or [] if code == _INPUT}
    ports["inputs"] = [port[:3] + (index in taken,) + port[4:] for index, port in enumerate(ports["inputs"])]
    declared |= ports
    declared["parameters"] = [_parameter(cls, *item) for item in _items(parameters)]
    return declared


def _items(given: Ports) -> list[tuple[str, Port]]:
    if isinstance(given, str):
        raise TypeError(f"{given!r}: names of ports are a dictionary with their units, or a list")
    return list(given.items()) if isinstance(given, Mapping) else [(each, "1") for each in given]


def _port(cls: type, kind: str, name: str, said: Port) -> tuple[str, str, str, bool, float]:
    unit, size = (said, 1) if isinstance(said, str) else (tuple(said) + (1,))[:2]
    if not isinstance(name, str) or not name.isidentifier():
        raise ValueError(f"{cls.__name__}: {name!r} among its {kind} is no name")
    if isinstance(size, (tuple, list)):
        if len(size) != 2 or not all(isinstance(each, int) and each > 0 for each in size):
            raise ValueError(f"{cls.__name__}.{name}: a matrix has whole numbers of rows and columns, as (3, 2)")
        size = f"{size[0]} x {size[1]}"
    initial = getattr(cls, name, 0.0) if kind in ("states", "memory") else 0.0
    return (name, str(unit), str(size), True, float(initial))


def _parameter(cls: type, name: str, unit: Port) -> tuple[str, str, Any, bool]:
    if not isinstance(unit, str):
        raise TypeError(f"{cls.__name__}.{name}: a parameter has a unit alone; its size is that of its default")
    value: Any = getattr(cls, name, None)
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        value = [float(each) for each in value]
    return (name, unit, 0.0 if value is None else value, value is None)


def _require_own_names(cls: type, names: list[str]) -> None:
    for name in names:
        if name in ("t", "period", "self"):
            raise ValueError(f"{cls.__name__}: {name!r} has a meaning of its own; give the port another name")
        if names.count(name) > 1:
            raise ValueError(f"{cls.__name__} has two ports or states with the name {name!r}")


def _arguments(cls: type, method: str, known: dict[str, tuple[int, int]]) -> list[tuple[int, int]] | None:
    function = getattr(cls, method, None)
    if function is None:
        return None
    if not callable(function):
        raise TypeError(f"{cls.__name__}.{method} has to be a method; ports are declared by @stepwire.block")
    arguments = []
    for name in list(inspect.signature(function).parameters)[1:]:
        if name not in known:
            raise TypeError(f"{cls.__name__}.{method}() takes {name!r}, which is no input, state or memory of the block; "
                            f"it has: {', '.join(known)}")
        arguments.append(known[name])
    return arguments
