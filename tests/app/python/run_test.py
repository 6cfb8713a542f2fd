"""Runs of a file: what is recorded, shown, judged and refused."""

import gc
import pickle
import threading

import numpy as np
import pytest
import stepwire


def test_a_cart_on_a_spring_swings_as_a_cosine(cart_file):
    run = stepwire.load(cart_file).run()
    time = run["time"]
    assert len(time) == 1001
    assert np.allclose(run["cart.position"], np.cos(2.0 * time), atol=1e-11)


def test_a_parameter_is_a_text_with_a_unit_or_a_number_in_si(cart_file):
    by_text = stepwire.load(cart_file, mass="8000 g").run()["cart.position"]
    by_number = stepwire.load(cart_file, mass=8).run()["cart.position"]
    by_numpy = stepwire.load(cart_file).run(mass=np.float64(8.0))["cart.position"]
    assert np.array_equal(by_text, by_number) and np.array_equal(by_text, by_numpy)
    assert np.allclose(by_text, np.cos(np.linspace(0, 1, 1001)), atol=1e-11)


def test_a_run_ends_at_the_stop_that_the_call_gives(cart_file):
    model = stepwire.load(cart_file)
    assert model.run(stop="0.25 s")["time"][-1] == pytest.approx(0.25)
    assert model.run(stop=0.5)["time"][-1] == pytest.approx(0.5)
    assert model.run()["time"][-1] == pytest.approx(1.0)


def test_columns_are_views_that_keep_the_run_alive(cart_file):
    run = stepwire.load(cart_file).run()
    first, second = run["cart.position"], run["cart.position"]
    assert np.shares_memory(first, second) and not first.flags.owndata
    with pytest.raises(ValueError):
        first[0] = 3.0
    expected = first.copy()
    del run, second
    gc.collect()
    junk = [np.ones(1001) for _ in range(200)]
    assert np.array_equal(first, expected) and len(junk) == 200


def test_a_table_has_the_units_of_its_columns(cart_file):
    table = stepwire.load(cart_file).run().table()
    assert list(table.columns) == ["time", "cart.position", "cart.velocity"]
    assert table.attrs["units"] == {"time": "s", "cart.position": "m", "cart.velocity": "m/s"}


def test_a_vector_signal_is_an_array_of_its_elements(examples):
    run = stepwire.load(examples / "123-lqg-design.yaml").run(stop="0.1 s")
    assert run["plant"].shape == (101, 4)
    assert np.array_equal(run["plant"][:, 2], run["plant.3"])


def test_claims_are_judged_and_a_failure_is_no_exception(cart_file):
    run = stepwire.load(cart_file).run()
    assert [claim.holds for claim in run.claims] == [True, False]
    assert run.claims[1].fails and not run.ok
    assert run.claims[1].value == pytest.approx(np.cos(2.0), abs=1e-11)


def test_signals_parameters_and_inputs_have_units(cart_file):
    model = stepwire.load(cart_file, mass="3 kg")
    assert model.signals["cart.velocity"].unit == "m/s"
    assert model.parameters["mass"].text == "3 kg" and model.parameters["mass"].value == 3.0
    assert model.parameters["mass"].doc == "of the cart"
    assert model.inputs["push"].unit == "N"
    with pytest.raises(KeyError, match="cart.position"):
        model.signals["cart.positon"]


def test_pictures_are_svg(cart_file):
    model = stepwire.load(cart_file)
    run = model.run()
    assert len(run.figures) == 1
    assert "<svg" in run.figures[0]._repr_svg_()
    assert run.figures[0]._repr_html_().startswith("<svg")
    assert "<svg" in model.draw().svg
    assert "does not hold" in run._repr_html_()


def test_html_has_no_markup_of_the_file(tmp_path, cart_file):
    cart_file.write_text(cart_file.read_text().replace("that: it swings", "that: <script>alert(1)</script>"))
    assert "<script>" not in stepwire.load(cart_file).run()._repr_html_()


def test_a_sweep_runs_all_combinations(cart_file):
    model = stepwire.load(cart_file)
    sweep = model.sweep({"mass": ["2 kg", "8 kg"], "stiffness": [8, 32.0]})
    assert sweep.points[1] == {"mass": "2 kg", "stiffness": "32.0"}
    for index, rate in enumerate([2.0, 4.0, 1.0, 2.0]):
        run = sweep.run(index)
        assert np.allclose(run["cart.position"], np.cos(rate * run["time"]), atol=1e-9)
    assert np.shares_memory(sweep.run(1)["cart.position"], sweep["cart.position"])
    assert sorted(set(sweep.table()["mass"])) == [2.0, 8.0]


def test_what_is_swept_was_perhaps_set_before(cart_file):
    sweep = stepwire.load(cart_file, mass="8 kg").sweep({"mass": [2, 8]}, stop="0.5 s")
    assert len(sweep.points) == 2
    assert np.allclose(sweep.run(0)["cart.position"], np.cos(2 * sweep.run(0)["time"]), atol=1e-9)


def test_a_model_is_the_file_as_it_was_when_it_was_loaded(cart_file):
    model = stepwire.load(cart_file)
    cart_file.write_text("no diagram at all")
    assert model.run(stop="0.1 s", mass=8)["time"][-1] == pytest.approx(0.1)
    assert len(model.sweep({"mass": [1, 2]}).points) == 2


def test_a_run_has_the_same_bits_however_it_is_computed(examples):
    model = stepwire.load(examples / "31-linkage.yaml")
    runs = [model.run(engine=engine) for engine in ("interpreted", "compiled")]
    assert runs[1].compiled_ticks > 0
    for name in runs[0]:
        assert runs[0][name].tobytes() == runs[1][name].tobytes()


def test_runs_of_one_model_go_on_in_several_threads(cart_file):
    model = stepwire.load(cart_file)
    expected = model.run()["cart.position"].tobytes()
    found = []
    threads = [threading.Thread(target=lambda: found.append(model.run()["cart.position"].tobytes())) for _ in range(6)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    assert found == [expected] * 6


def test_a_model_is_pickled_by_its_file_and_a_run_is_refused(cart_file):
    model = pickle.loads(pickle.dumps(stepwire.load(cart_file, mass="8 kg")))
    assert model.parameters["mass"].value == 8.0
    with pytest.raises(TypeError, match="table"):
        pickle.dumps(model.run())
    with pytest.raises(TypeError, match="pickle"):
        pickle.dumps(model.simulation())


def test_a_run_writes_what_the_program_writes(cart_file, tmp_path):
    run = stepwire.load(cart_file).run()
    run.write(tmp_path / "out")
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert {"signals.csv", "run.json", "claims.json", "figure.svg", "diagram.yaml"} <= names
    assert run.info["ticks"] == run.ticks
