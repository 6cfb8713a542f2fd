"""Records: the fields of results as attributes, with their units."""

import dataclasses
import math

import pytest
import stepwire
from stepwire import records

SECTION = {
    "parameters": {"stiffness": {"from": "1 N/m", "to": "50 N/m"}},
    "minimise": "abs(final(cart.velocity))",
}


def test_a_result_has_the_fields_of_its_json_file(cart_file):
    tuning = stepwire.load(cart_file).tune(SECTION, evaluations=9)
    assert list(tuning.result.to_dict()) == list(tuning.data)
    assert tuning.result.evaluations == tuning.data["evaluations"] == 9
    assert tuning.result.parameters[0].value == tuning["stiffness"]
    assert tuning.result.parameters[0].bounds == (1.0, 50.0)
    assert tuning.result.parameters[0].unit == "N/m" == tuning.data["parameters"][0]["unit"]


def test_a_missing_value_is_nan_an_empty_text_or_none(cart_file):
    tuning = stepwire.load(cart_file).tune(SECTION, evaluations=3)
    assert tuning.data["worst"] is None and tuning.result.worst == ""
    assert tuning.result.parameters[0].interval is None
    number = records.FittedParameter.read({"name": "m", "value": None, "interval": [None, 2.0]})
    assert math.isnan(number.value) and math.isnan(number.interval[0]) and number.interval[1] == 2.0
    assert number.record == "" and repr(number).startswith("FittedParameter(name='m', ")


def test_fields_have_units_and_meanings_and_do_not_change():
    assert records.TuneResult.field_units["duration"] == "s"
    assert records.Mode.field_units == {"pole": "rad/s", "natural_frequency": "rad/s"}
    assert records.FitResult.field_docs["file"] == "diagram file"
    assert stepwire.FittedParameter is records.FittedParameter and "fit" in records.FittedParameter.__doc__
    with pytest.raises(dataclasses.FrozenInstanceError):
        records.Mode.read({"pole": [-1.0, 0.0]}).damping = 1.0


def test_complex_numbers_and_margins_of_a_linear_system_are_values(cart_file):
    # x'' = -k/m x with 8 N/m and 2 kg: poles at +-2j.
    linear = stepwire.load(cart_file).linearize("push", "cart.position")
    assert sorted(pole.imag for pole in linear.result.poles) == pytest.approx([-2.0, 2.0])
    assert linear.result.modes[0].natural_frequency == pytest.approx(2.0)
    assert linear.result.point.time == 0.0 and linear.result.channels[0].output == "cart.position"
