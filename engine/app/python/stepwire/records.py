"""Records of results: classes made of the declarations of the results in C++."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable, Mapping
from typing import Any

from . import _core

_MISSING: dict[str, Callable[[], Any]] = {"number": lambda: float("nan"), "text": str, "list": list, "map": dict}


class Record:
    """Named values of a result. A missing number is nan, a missing text empty."""

    field_units: dict[str, str]
    field_docs: dict[str, str]
    _fields: dict[str, tuple[str, dict[str, Any]]]  # attribute: name in JSON and type

    @classmethod
    def read(cls, data: Mapping[str, Any]) -> Any:
        return cls(**{attribute: _value(kind, data.get(name, False if kind["kind"] == "flag" else None))
                      for attribute, (name, kind) in cls._fields.items()})

    def to_dict(self) -> dict[str, Any]:
        return dataclasses.asdict(self)  # type: ignore[call-overload, no-any-return]


def _value(type_: dict[str, Any], data: Any) -> Any:
    kind = type_["kind"]
    if data is None:
        return _MISSING.get(kind, lambda: None)()
    if kind == "record":
        return globals()[type_["record"]].read(data)
    if kind == "list":
        return [_value(type_["item"], item) for item in data]
    if kind == "map":
        return {name: _value(type_["item"], item) for name, item in data.items()}
    if kind == "complex":
        return complex(*(_value({"kind": "number"}, part) for part in data))
    if kind == "pair":
        return tuple(_value({"kind": "number"}, part) for part in data)
    if kind == "matrix":
        return [[_value({"kind": "number"}, number) for number in row] for row in data]
    return data


def _class(record: dict[str, Any]) -> type:
    fields = record["fields"]
    made = dataclasses.make_dataclass(record["name"], [field["attribute"] for field in fields], bases=(Record,),
                                      frozen=True)
    made.__doc__ = record["doc"]
    made.__module__ = __name__
    attributes: dict[str, Any] = {
        "field_units": {field["attribute"]: field["unit"] for field in fields if field["unit"]},
        "field_docs": {field["attribute"]: field["doc"] for field in fields},
        "_fields": {field["attribute"]: (field["name"], field["type"]) for field in fields},
    }
    for name, value in attributes.items():
        setattr(made, name, value)
    return made


for _record in json.loads(_core.results()):
    globals()[_record["name"]] = _class(_record)
