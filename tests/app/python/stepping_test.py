"""Tick by tick, and observers."""

import os
import signal
import threading
import time as clock

import numpy as np
import pytest
import stepwire


def test_steps_give_the_rows_of_a_run(cart_file):
    model = stepwire.load(cart_file)
    simulation = model.simulation()
    rows = [simulation["cart.position"] for _ in simulation]
    assert np.array_equal(rows, model.run()["cart.position"])
    assert simulation.finished
    with pytest.raises(stepwire.Error, match="ended"):
        simulation.step()
    simulation.reset()
    simulation.step(11)
    assert simulation.time == pytest.approx(0.01)


def test_inputs_hold_from_the_next_tick_on(cart_file):
    simulation = stepwire.load(cart_file, stiffness=0, values={"cart.initial_position": 0}).simulation()
    simulation.inputs["push"] = 2.0
    while not simulation.finished:
        simulation.step()
    assert simulation["cart.position"] == pytest.approx(0.5, rel=1e-9)
    assert simulation.inputs["push"] == 2.0 and list(simulation.inputs) == ["push"]


def test_a_value_is_set_between_two_ticks(cart_file):
    simulation = stepwire.load(cart_file).simulation()
    simulation.step(500)
    simulation.set("stiffness", "0 N/m")
    speed = simulation["cart.velocity"]
    simulation.step(400)
    assert simulation["cart.velocity"] == pytest.approx(speed, abs=0.02)
    simulation.set("cart.mass", 3.0)


def test_a_snapshot_is_returned_to(cart_file):
    model = stepwire.load(cart_file)
    simulation = model.simulation()
    simulation.step(100)
    moment = simulation.snapshot()
    simulation.step(100)
    there = simulation["cart.position"]
    simulation.restore(moment)
    simulation.step(100)
    assert simulation["cart.position"] == there
    other = model.simulation()
    other.restore(moment)
    other.step(100)
    assert other["cart.position"] == there
    with pytest.raises(ValueError, match="another model"):
        stepwire.load(cart_file).simulation().restore(moment)


def test_a_snapshot_outlives_its_simulation(cart_file):
    simulation = stepwire.load(cart_file).simulation()
    simulation.step(3)
    moment = simulation.snapshot()
    model = simulation.model
    del simulation
    again = model.simulation()
    again.restore(moment)
    assert again.time == pytest.approx(0.002)


def test_inputs_have_units_where_they_are_texts(cart_file):
    simulation = stepwire.load(cart_file).simulation()
    for text, number in (("3 N", 3.0), ("2 kN", 2000.0), ("5", 5.0), (["7 mN"], 0.007)):
        simulation.inputs["push"] = text
        simulation.step()
        assert simulation.inputs["push"] == pytest.approx(number, rel=1e-15)
    with pytest.raises(ValueError, match="push takes numbers in N, not '3 kg'"):
        simulation.inputs["push"] = "3 kg"


def test_wrong_steps_are_refused(cart_file):
    simulation = stepwire.load(cart_file).simulation()
    for wrong in (lambda: simulation.set("mas", 1), lambda: simulation.set("mass", "1 m"),
                  lambda: simulation.set("mass", -1), lambda: simulation["nothing"],
                  lambda: simulation.inputs.__setitem__("pus", 1.0),
                  lambda: simulation.inputs.__setitem__("push", [1.0, 2.0])):
        with pytest.raises(stepwire.Error):
            wrong()
    for wrong in (lambda: simulation.step("3"), lambda: simulation.set("mass", None),
                  lambda: simulation.inputs.__setitem__("push", "3 kg"),
                  lambda: simulation.inputs.__setitem__("push", "three"),
                  lambda: simulation.inputs.__setitem__("push", ["3 N", "x"]), lambda: simulation.restore(None)):
        with pytest.raises((TypeError, ValueError, RuntimeError)):
            wrong()
    with pytest.raises(ValueError):
        simulation.step(-1)
    with pytest.raises(KeyError, match="push"):
        simulation.inputs["pull"]
    simulation.step()
    assert simulation["cart.position"] == 1.0


def test_a_simulation_keeps_its_model(cart_file):
    simulation = stepwire.load(cart_file).simulation(engine="compiled", tuned=["stiffness"])
    simulation.step(2)
    assert simulation.compiled and simulation["cart.position"] == pytest.approx(np.cos(0.002))


def test_one_thread_at_a_time_steps(cart_file):
    simulation = stepwire.load(cart_file, values={"stop": 1000}).simulation()
    refused = []

    def step():
        try:
            simulation.step(200_000)
        except RuntimeError as error:
            refused.append(str(error))
    threads = [threading.Thread(target=step) for _ in range(3)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    assert all("one at a time" in text for text in refused)
    assert simulation.time == pytest.approx(((3 - len(refused)) * 200_000 - 1) * 1e-3)


def test_an_observer_sees_every_tick_and_steers(cart_file):
    seen = []

    def watch(run):
        seen.append((run.tick, run.time, run["cart.position"]))
        if run.tick == 499:
            run.set("stiffness", "0 N/m")
        if run.tick == 700:
            run.stop()
    run = stepwire.load(cart_file).run(observers=[watch])
    assert [tick for tick, _, _ in seen] == list(range(701))
    assert [position for _, _, position in seen] == list(run["cart.position"])
    speed = run["cart.velocity"]
    assert speed[-1] == speed[505] and speed[499] != speed[490]


def test_an_observer_has_methods(cart_file):
    class Watcher:
        def __init__(self):
            self.calls = {}

        def note(self, name):
            self.calls[name] = self.calls.get(name, 0) + 1

        def begin(self, run):
            self.note("begin")

        def before_tick(self, run):
            self.note("before_tick")
            run.write("push", 8.0)

        def row(self, run, recording, numbers):
            self.note("row")
            assert len(numbers) == 3 and numbers[0] == run.time

        def end(self, run):
            self.note("end")
    watcher = Watcher()
    run = stepwire.load(cart_file).run(observers=[watcher])
    assert watcher.calls == {"begin": 1, "before_tick": 1001, "row": 1001, "end": 1}
    assert np.allclose(run["cart.position"], 1.0, atol=1e-12)


def test_an_exception_of_an_observer_ends_the_run_and_comes_out(cart_file):
    model = stepwire.load(cart_file)

    def fail(run):
        if run.tick == 10:
            raise ZeroDivisionError("in the observer")
    with pytest.raises(ZeroDivisionError, match="in the observer") as caught:
        model.run(observers=[fail])
    assert len(caught.value.run["time"]) == 11
    assert len(model.run()["time"]) == 1001


def test_what_an_observer_sets_wrongly_is_an_error(cart_file):
    with pytest.raises(stepwire.Error, match="mass"):
        stepwire.load(cart_file).run(observers=[lambda run: run.set("mass", "1 m")])


def test_a_run_is_looked_at_during_the_call_alone(cart_file):
    kept = []
    stepwire.load(cart_file).run(observers=[kept.append])
    with pytest.raises(RuntimeError, match="during a call"):
        kept[0]["cart.position"]


def test_what_is_no_observer_is_refused(cart_file):
    with pytest.raises(TypeError, match="observer"):
        stepwire.load(cart_file).run(observers=[3])


def test_observers_of_a_sweep_are_called_from_several_threads(cart_file):
    counts = [0] * 8
    lock = threading.Lock()

    def count(run):
        with lock:
            counts[run.index] += 1
    stepwire.load(cart_file).sweep({"mass": list(range(1, 9))}, observers=[count])
    assert counts == [1001] * 8


def test_progress_ends_at_one_and_its_exception_comes_out(cart_file):
    model = stepwire.load(cart_file, values={"stop": 100})
    fractions = []
    model.run(progress=lambda fraction, what: fractions.append(fraction))
    assert fractions == sorted(fractions) and 0 < fractions[-1] <= 1

    def fail(fraction, what):
        raise OSError("no terminal")
    with pytest.raises(OSError, match="no terminal"):
        model.run(progress=fail)


def test_other_threads_go_on_while_a_run_does(cart_file):
    model = stepwire.load(cart_file, values={"stop": 2000})
    counts, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counts[0] += 1
            clock.sleep(0.001)
    thread = threading.Thread(target=count)
    thread.start()
    before = counts[0]
    model.run(engine="interpreted")
    during = counts[0] - before
    done.set()
    thread.join()
    assert during > 5


def test_an_interruption_keeps_what_was_recorded(cart_file):
    model = stepwire.load(cart_file, values={"stop": 2e4})
    timer = threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(stepwire.Interrupted) as caught:
        model.run(engine="interpreted")
    assert isinstance(caught.value, KeyboardInterrupt)
    run = caught.value.run
    assert run.interrupted and 0 < len(run["time"]) < 2e7 and run["cart.position"][0] == 1.0
    assert model.last_run is run
    assert len(model.run(stop=0.1)["time"]) == 101
