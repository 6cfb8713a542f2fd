"""Blocks written in Python."""

import ctypes

import numpy as np
import pytest
import stepwire

FALL = """stepwire: 1
title: A ball falls through air
step: 1 ms
stop: 1 s
solver: rk4
parameters:
  drag: {value: 2 kg/m}
units: {weight: N}
blocks:
  weight: {block: Constant, value: 10}
  air: {block: Drag, v: ball.velocity, c: $drag}
  net: {block: Sum, u: [weight, air]}
  ball: {block: Mass, force: net, mass: 1 kg}
record: [ball.velocity, air]
"""


@stepwire.block(inputs={"v": "m/s"}, outputs={"F": "N"}, parameters={"c": "kg/m"})
class Drag:
    """F = -c |v| v."""

    def outputs(self, v):
        return -self.c * abs(v) * v


@stepwire.block(inputs={"u": "1"}, outputs={"y": "1"}, states={"x": "1"}, parameters={"tau": "s"})
class Behind:
    tau = 0.5

    def outputs(self, x):
        return x

    def derivatives(self, x, u):
        return (u - x) / self.tau


@stepwire.block(inputs=["u"], outputs=["y"], memory=["total"], parameters={"step": "1"})
class Total:
    step = 1.0
    total = 3

    def outputs(self, total):
        return total

    def update(self, total, u):
        return total + self.step * u


def written(tmp_path, text):
    file = tmp_path / "diagram.yaml"
    file.write_text(text)
    return file


def test_a_block_computes_outputs(tmp_path):
    model = stepwire.load(written(tmp_path, FALL), blocks=[Drag])
    run = model.run()
    rate = np.sqrt(10 * 2.0)
    assert np.allclose(run["ball.velocity"], np.sqrt(5.0) * np.tanh(rate * run["time"]), atol=1e-9)
    assert run.table().attrs["units"]["air"] == "N"
    assert model.run(drag="0 kg/m")["ball.velocity"][-1] == pytest.approx(10.0)


ONE = """stepwire: 1
title: one block
step: 10 ms
stop: 1 s
solver: rk4
blocks:
  one: {{block: Constant, value: 1}}
  it: {{block: {block}}}
record: [it]
"""


def test_a_block_has_continuous_states(tmp_path):
    run = stepwire.load(written(tmp_path, ONE.format(block="Behind, u: one, tau: 0.2 s")), blocks=[Behind]).run()
    assert np.allclose(run["it"], 1 - np.exp(-run["time"] / 0.2), atol=1e-6)


def test_a_block_has_memory_that_a_snapshot_keeps(tmp_path):
    model = stepwire.load(written(tmp_path, ONE.format(block="Total, u: one, every: 20 ms")), blocks=[Total])
    assert list(model.run()["it"][:5]) == [3, 3, 4, 4, 5]
    simulation = model.simulation()
    simulation.step(21)
    moment = simulation.snapshot()
    simulation.step(20)
    assert simulation["it"] == 23
    simulation.restore(moment)
    simulation.step(20)
    assert simulation["it"] == 23
    simulation.set("it.step", 5.0)
    simulation.step(10)
    assert simulation["it"] == 24 + 4 * 5


def test_a_block_has_vectors_time_and_several_outputs(tmp_path):
    @stepwire.block(inputs={"u": ("1", "n")}, outputs={"double": ("1", "n"), "sum": "1"}, parameters={"w": "1"})
    class Several:
        w = [1.0, 10.0, 100.0]

        def outputs(self, u, t):
            assert isinstance(u, np.ndarray) and not u.flags.writeable
            return 2 * u, float(self.w @ u) + t
    text = ONE.format(block="Several, u: many").replace("value: 1}", "value: 1}\n  many: {block: Constant, value: [1, 2, 3]}")
    run = stepwire.load(written(tmp_path, text.replace("[it]", "[it.double, it.sum]")), blocks=[Several]).run()
    assert np.array_equal(run["it.double"][-1], [2, 4, 6])
    assert np.allclose(run["it.sum"], 321 + run["time"])


MATHS = ctypes.CDLL("libm.so.6")
UPWARD = 0x800  # FE_UPWARD of x86-64


def test_a_rounding_mode_that_python_code_sets_changes_no_other_block(tmp_path):
    @stepwire.block(inputs=["u"], outputs=["y"], parameters={"mode": "1"})
    class Rounding:
        mode = 0.0

        def outputs(self, u):
            MATHS.fesetround(int(self.mode))
            return u

    text = ONE.format(block="Rounding, u: wave, mode: $mode").replace("blocks:", "parameters: {mode: 0}\nblocks:").replace(
        "record: [it]",
        "  wave: {block: Sine, amplitude: 1, frequency: 3 Hz}\n  third: {block: Gain, u: wave, gain: 0.1}\n"
        "  lag: {block: Lag, u: third, tau: 0.3 s}\nrecord: [third, lag, it]")
    model = stepwire.load(written(tmp_path, text), blocks=[Rounding])
    right = model.run()
    block, observer = model.run(mode=str(UPWARD)), model.run(observers=[lambda run: MATHS.fesetround(UPWARD)])
    MATHS.fesetround(UPWARD)
    try:
        outside = stepwire.load(written(tmp_path, text), blocks=[Rounding]).run()
        assert MATHS.fegetround() == UPWARD
    finally:
        MATHS.fesetround(0)
    for run in (block, observer, outside):
        for name in ("third", "lag"):
            assert np.array_equal(run[name], right[name])


def test_a_sweep_runs_blocks_in_parallel(tmp_path):
    model = stepwire.load(written(tmp_path, FALL), blocks=[Drag])
    sweep = model.sweep({"drag": [0.5, 1, 2, 4]})
    for index, drag in enumerate([0.5, 1, 2, 4]):
        assert sweep.run(index)["ball.velocity"][-1] == pytest.approx(np.sqrt(10 / drag) * np.tanh(np.sqrt(10 * drag)))


def failing(method, act):
    def outputs(self, u):
        return act(u) if method == "outputs" else u

    def update(self, m, u):
        return act(u) if method == "update" else m
    cls = type("Failing", (), {"outputs": outputs, "update": update})
    return stepwire.block(inputs=["u"], outputs=["y"], memory=["m"])(cls)


def refuse(u):
    raise ValueError("no such number")


@pytest.mark.parametrize("method", ["outputs", "update"])
@pytest.mark.parametrize("act, what", [
    (refuse, "no such number"), (lambda u: "three", "could not convert|must be real|float"), (lambda u: None, "real number|float"),
    (lambda u: [1, 2], "2 numbers"), (lambda u: float("nan"), ""), (lambda u: refuse, "")])
def test_what_a_method_raises_is_a_fault_of_the_block(tmp_path, method, act, what):
    model = stepwire.load(written(tmp_path, ONE.format(block="Failing, u: one")), blocks=[failing(method, act)])
    for _ in range(2):
        try:
            model.run()
        except stepwire.RunError as error:
            assert error.block == "it" and error.line == 8
            if act is refuse:
                assert isinstance(error.__cause__, ValueError) and "no such number (block_test.py:" in error.text
        else:
            assert method == "update" and act(1.0) != act(1.0)  # nan in a memory that nothing reads
    simulation = model.simulation()
    if act is refuse:
        with pytest.raises(stepwire.Error) as caught:
            simulation.step(3)
        assert isinstance(caught.value.__cause__, ValueError)
        assert simulation.finished


def test_an_init_that_raises_is_refused_when_it_is_loaded(tmp_path):
    @stepwire.block(outputs=["y"], parameters={"n": "1"})
    class Checked:
        n = 1.0

        def __init__(self):
            if self.n < 0:
                raise ValueError("n is negative")

        def outputs(self):
            return self.n
    assert stepwire.load(written(tmp_path, ONE.format(block="Checked, n: 4")), blocks=[Checked]).run()["it"][0] == 4
    with pytest.raises(stepwire.Error, match="n is negative") as caught:
        stepwire.load(written(tmp_path, ONE.format(block="Checked, n: -4")), blocks=[Checked])
    assert caught.value.line == 8


def test_wrong_declarations_are_refused():
    class Plain:
        def outputs(self, u):
            return u
    with pytest.raises(TypeError, match="'u'"):
        stepwire.block(outputs=["y"])(Plain)
    with pytest.raises(TypeError, match="derivatives"):
        stepwire.block(inputs=["u"], outputs=["y"], states=["x"])(Plain)
    with pytest.raises(ValueError, match="two ports"):
        stepwire.block(inputs=["u"], outputs=["u"])(Plain)
    with pytest.raises(ValueError, match="meaning"):
        stepwire.block(inputs=["u", "t"], outputs=["y"])(Plain)
    with pytest.raises(TypeError, match="dictionary"):
        stepwire.block(inputs="u", outputs=["y"])(Plain)
    with pytest.raises(ValueError, match="no name"):
        stepwire.block(inputs=["a b"], outputs=["y"])(Plain)


def test_wrong_classes_are_refused(tmp_path):
    file = written(tmp_path, FALL)
    with pytest.raises(TypeError, match="stepwire.block"):
        stepwire.load(file, blocks=[int])
    with pytest.raises(TypeError, match="Drag"):
        stepwire.load(file, blocks=[type("Child", (Drag,), {})])
    with pytest.raises(ValueError, match="Drag"):
        stepwire.load(file, blocks=[Drag, Drag])
    with pytest.raises(stepwire.Error, match="Drag"):
        stepwire.load(file)
    bad = stepwire.block(inputs={"u": "furlongs/nothing"}, outputs=["y"])(type("Bad", (), {"outputs": lambda self, u: u}))
    with pytest.raises(ValueError, match="no unit"):
        stepwire.load(written(tmp_path, ONE.format(block="Bad, u: one")), blocks=[bad])


TWICE = """
#include <stepwire/block.hpp>
#include <stepwire/declare.hpp>
#include <stepwire/registry.hpp>

namespace yard {
struct Twice {
  stepwire::Input<1> u{};
  stepwire::Output<1> y{};
  void outputs() { y = 2.0 * u; }
  static void declare(stepwire::Declare<Twice>& is) {
    is.block("Twice", {.doc = "y = 2 u."});
    is.input<&Twice::u>({.doc = "input"});
    is.output<&Twice::y>({.doc = "output"});
  }
};
}
void register_blocks(stepwire::Registry& known) { known.add<yard::Twice>("yard"); }
"""


def test_blocks_of_a_folder_are_known(tmp_path):
    (tmp_path / "yard").mkdir()
    (tmp_path / "yard" / "twice.cpp").write_text(TWICE)
    file = written(tmp_path, ONE.format(block="Twice, u: one"))
    assert stepwire.load(file, block_folders=[tmp_path / "yard"]).run(engine="interpreted")["it"][-1] == 2.0
    with pytest.raises(stepwire.EnvironmentError):
        stepwire.load(file, block_folders=[tmp_path / "nowhere"])


def test_it_is_refused_by_generate_and_loop(tmp_path):
    model = stepwire.load(written(tmp_path, FALL), blocks=[Drag])
    with pytest.raises(stepwire.Error, match="Drag cannot be generated: its methods are Python's"):
        model.generate(tmp_path / "generated")
    with pytest.raises(stepwire.Error, match="its methods are Python's"):
        model.loop("0.1 s", policy="other")


def test_a_run_with_it_is_interpreted_and_says_so(tmp_path):
    model = stepwire.load(written(tmp_path, FALL), blocks=[Drag])
    with pytest.warns(RuntimeWarning, match="its methods are Python's"):
        assert model.run(engine="compiled").compiled_ticks == 0


@stepwire.block(inputs={"R": ("1", (2, 3)), "k": ("1", 1)}, outputs={"y": ("1", (3, 2))}, memory={"sum": ("1", (2, 3))})
class Turned:
    """A matrix, turned over, times k, and its sum over time."""

    def outputs(self, R, k):
        assert R.shape == (2, 3)
        return k * R.T

    def update(self, sum, R):
        return sum + R


TURNED = """stepwire: 1
step: 1 s
stop: 2 s
blocks:
  given: {block: Constant, value: [[1, 2, 3], [4, 5, 6]]}
  turned: {block: Turned, R: given, k: 10, every: 1 s}
  square: {block: MatrixMultiply, a: given, b: turned}
record: [turned, square]
"""


def test_ports_and_memory_are_matrices(tmp_path):
    run = stepwire.load(written(tmp_path, TURNED), blocks=[Turned]).run()
    matrix = np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])
    recorded = np.array([[run[f"turned.{row}.{column}"][-1] for column in (1, 2)] for row in (1, 2, 3)])
    assert np.array_equal(recorded, 10.0 * matrix.T)
    assert run["square.2.1"][-1] == (matrix @ (10.0 * matrix.T))[1, 0]


def test_a_matrix_of_another_shape_is_refused(tmp_path):
    @stepwire.block(inputs={"R": ("1", (2, 3)), "k": ("1", 1)}, outputs={"y": ("1", (3, 2))})
    class Turned:
        def outputs(self, R, k):
            return R

    with pytest.raises(stepwire.RunError, match="matrix of 3 x 2"):
        stepwire.load(written(tmp_path, TURNED), blocks=[Turned]).run()
    with pytest.raises(ValueError, match="rows and columns"):
        stepwire.block(inputs={"R": ("1", (2, "n"))})(type("Half", (), {}))
