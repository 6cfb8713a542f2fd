"""What is wrong, as exceptions with places."""

import pickle

import numpy as np
import pytest
import stepwire


def test_all_faults_of_a_file_come_together_with_their_lines(cart_file):
    cart_file.write_text(cart_file.read_text().replace("block: Gain", "block: Gian").replace("block: Mass", "block: Mas"))
    with pytest.raises(stepwire.Error) as caught:
        stepwire.load(cart_file)
    faults = caught.value.faults
    assert [fault.line for fault in faults] == [12, 14]
    assert caught.value.file == str(cart_file) and caught.value.line == 12 and caught.value.column > 0
    assert "Gian" in caught.value.text and "Gain" in str(caught.value)


def test_errors_can_be_pickled(cart_file):
    with pytest.raises(stepwire.Error) as caught:
        stepwire.load("/nowhere/no.yaml")
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.faults == caught.value.faults


@pytest.mark.parametrize("values, what", [
    ({"mas": 3}, "mass"), ({"mass": "3 m"}, "kg"), ({"mass": "-1 kg"}, "mass"), ({"mass": "heavy"}, "mass"),
    ({"mass": ""}, ""), ({"mass": [1, 2]}, ""), ({"mass": float("nan")}, ""), ({"": 1}, ""),
])
def test_wrong_parameters_are_refused(cart_file, values, what):
    with pytest.raises(stepwire.Error, match=what):
        stepwire.load(cart_file, values=values)
    model = stepwire.load(cart_file)
    with pytest.raises(stepwire.Error):
        model.run(values=values)
    assert model.run().early is False


@pytest.mark.parametrize("value", [None, object(), {"a": 1}, b"8 kg", 3j])
def test_what_is_no_value_is_a_type_error(cart_file, value):
    with pytest.raises(TypeError, match="mass"):
        stepwire.load(cart_file, mass=value)


def test_wrong_calls_name_what_would_be_right(cart_file):
    model = stepwire.load(cart_file)
    run = model.run()
    with pytest.raises(KeyError, match="cart.position"):
        run["cart.positon"]
    with pytest.raises(ValueError, match="interpreted"):
        model.run(engine="fast")
    with pytest.raises(stepwire.Error):
        model.run(stop="3 kg")
    with pytest.raises(stepwire.Error, match="fit"):
        model.fit()
    with pytest.raises(stepwire.Error, match="study"):
        model.study()
    with pytest.raises(TypeError):
        model.sweep({"mass": "1 kg"})
    with pytest.raises(TypeError):
        model.sweep({})
    with pytest.raises(stepwire.Error):
        model.sweep({"mas": [1]})
    with pytest.raises(stepwire.Error):
        model.sweep({"mass": [1, "2 m"]})
    with pytest.raises(stepwire.Error):
        model.linearize("push", "cart.positon")
    with pytest.raises(IndexError):
        run.figures[7]
    with pytest.raises(IndexError):
        run.table(3)
    with pytest.raises(IndexError):
        run.run(1)
    assert np.isfinite(model.run()["cart.position"]).all()


DIVERGES = """stepwire: 1
title: A state that grows beyond all numbers
step: 1 ms
stop: 10 s
solver: rk4
blocks:
  square: {block: Expression, expression: u^2, u: state}
  state: {block: Integrator, u: square, initial: 1}
record: [state]
"""


def test_a_fault_ends_a_run_and_keeps_what_was_recorded(tmp_path):
    file = tmp_path / "diverges.yaml"
    file.write_text(DIVERGES)
    model = stepwire.load(file)
    with pytest.raises(stepwire.RunError) as caught:
        model.run()
    error = caught.value
    assert error.line in (7, 8) and error.time == pytest.approx(1.0, abs=0.1) and error.block in ("state", "square")
    time, state = error.run["time"], error.run["state"]
    assert np.allclose(state[time < 0.9], 1.0 / (1.0 - time[time < 0.9]), rtol=1e-6)
    assert model.last_run is error.run
    run = model.run(check=False)
    assert run.early and run.faults[0].text == error.text and len(run.figures) == 0


def test_one_point_of_a_sweep_that_fails_leaves_the_others(tmp_path):
    file = tmp_path / "diverges.yaml"
    file.write_text(DIVERGES.replace("initial: 1}", "initial: $start}").replace("blocks:", "parameters:\n  start: 1\nblocks:"))
    sweep = stepwire.load(file).sweep({"start": [0.01, 1]}, check=False)
    assert len(sweep.faults) == 1
    assert sweep.run(0)["state"][-1] == pytest.approx(0.01 / (1 - 0.1), rel=1e-6)
