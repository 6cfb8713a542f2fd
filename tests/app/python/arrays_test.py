"""Vectors and matrices as arrays, and inputs that are no numbers."""

import copy

import numpy as np
import pytest
import stepwire

FILE = """stepwire: 1
title: Arrays
step: 0.1 s
stop: 0.2 s
solver: rk4
inputs:
  push: {unit: N, default: 0 N}
  wrench: {unit: N, shape: 3, default: [0, 0, 0]}
  map: {unit: "1", shape: 2 x 3, default: [[0, 0, 0], [0, 0, 0]]}
blocks:
  grown: {block: Integrator, u: {value: [[1, 2, 3], [4, 5, 6]]}}
  force: {block: Gain, u: wrench, gain: 2}
  twice: {block: Gain, u: map, gain: 2}
  net: {block: Gain, u: push, gain: 1}
record: RECORD
"""


@pytest.fixture
def load(tmp_path):
    def write(record="[grown, force, twice, net]"):
        file = tmp_path / "arrays.yaml"
        file.write_text(FILE.replace("RECORD", record))
        return stepwire.load(file)
    return write


def test_a_matrix_is_an_array_of_rows_and_columns_for_each_row_of_the_table(load):
    run = load().run()
    assert run["grown"].shape == (3, 2, 3) and run["force"].shape == (3, 3) and run["net"].shape == (3,)
    assert np.allclose(run["grown"][2], 0.2 * np.array([[1, 2, 3], [4, 5, 6]]))
    assert np.array_equal(run["grown"][:, 1, 0], run["grown.2.1"])
    assert "grown" in run and "grown.2.1" in run and "grown.1" not in run and 3 not in run


def test_signals_and_inputs_have_the_shape_of_their_arrays(load):
    model = load()
    assert model.signals["grown"].shape == (2, 3) and model.signals["grown"].size == 6
    assert model.signals["force"].shape == (3,) and model.signals["net"].shape == ()
    assert [one.shape for one in model.inputs.values()] == [(), (3,), (2, 3)]


def test_a_signal_that_is_recorded_in_part_is_no_array(load):
    run = load("[grown.2.1, grown.1.3]").run()
    assert "grown" not in run and len(run["grown.2.1"]) == 3
    with pytest.raises(KeyError, match="not recorded as a whole, grown.1.1, grown.1.2"):
        run["grown"]
    with pytest.raises(KeyError, match="nothing of the name 'gone'"):
        run["gone"]


def test_a_run_of_a_sweep_has_vectors_and_matrices_as_all_runs_do(load):
    sweep = load().sweep({"twice.gain": [1, 3]})
    second = sweep.run(1)
    assert second["grown"].shape == (3, 2, 3) and second["force"].shape == (3, 3)
    assert np.array_equal(second["grown"], sweep["grown"][3:]) and np.array_equal(second["grown.2.1"], second["grown"][:, 1, 0])
    assert "grown" in second and "grown.3" not in second and "grown" not in list(second)
    with pytest.raises(KeyError, match="nothing of the name 'gone' is recorded; recorded are: "):
        second["gone"]


def test_a_simulation_and_an_observer_show_single_elements(load):
    simulation = load().simulation()
    simulation.step(2)
    assert np.allclose([simulation["grown.2.1"], simulation["grown.1.3"]], [0.4, 0.3])
    simulation.inputs["wrench"] = [1, 2, 3]
    simulation.step()
    assert simulation["force.2"] == 4.0
    for wrong in ("force.4", "force.0", "force.1.1", "grown.3.1", "grown.1", "net.1"):
        with pytest.raises(stepwire.Error, match="there is no signal of this name"):
            simulation[wrong]
    seen = []
    load().run(observers=[lambda run: seen.append(run["grown.2.3"])])
    assert np.allclose(seen, [0, 0.6, 1.2])


def test_a_simulation_shows_and_takes_matrices(load):
    simulation = load().simulation()
    given = np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])
    simulation.inputs["map"] = given
    simulation.inputs["wrench"] = [1, 2, 3]
    simulation.step()
    assert np.array_equal(simulation["twice"], 2 * given) and np.array_equal(simulation.inputs["map"], given)
    simulation.inputs["map"] = given.tolist()
    for wrong in (given.T, given.ravel(), 3.0, "3 N"):
        with pytest.raises(TypeError, match=r"map takes an array \(2, 3\)"):
            simulation.inputs["map"] = wrong


def test_an_observer_sees_and_writes_matrices(load):
    seen = []

    def watch(run):
        seen.append((run["grown"].shape, run["twice"][1, 0]))
        run.write("map", np.array([[1, 2, 3], [4, 5, 6]]))
    load().run(observers=[watch])
    assert seen == [((2, 3), 0.0), ((2, 3), 8.0), ((2, 3), 8.0)]


def test_nan_given_as_an_input_names_the_input(load):
    simulation = load().simulation()
    simulation.inputs["push"] = 2.0
    for wrong in (float("nan"), np.float64("nan"), np.array(np.nan)):
        with pytest.raises(ValueError, match="push takes a number, not nan"):
            simulation.inputs["push"] = wrong
    with pytest.raises(ValueError, match="wrench takes numbers, and element 2 is nan"):
        simulation.inputs["wrench"] = [1, float("nan"), 3]
    simulation.step()
    assert simulation["net"] == 2.0

    def watch(run):
        run.write("push", float("nan"))
    with pytest.raises(ValueError, match="push takes a number, not nan"):
        load().run(observers=[watch])


def test_infinity_given_as_an_input_names_the_input(load):
    simulation = load().simulation()
    with pytest.raises(ValueError, match="push takes a number, not -inf"):
        simulation.inputs["push"] = -float("inf")
    with pytest.raises(ValueError, match="wrench takes numbers, and element 3 is inf"):
        simulation.inputs["wrench"] = np.array([1, 2, np.inf])


def test_a_copy_of_a_run_is_the_run_since_it_never_changes(load):
    run = load().run()
    assert copy.copy(run) is run and copy.deepcopy(run) is run
