"""What Python costs beside the program: called by bench/python, which sets the path to the module.

    runs      the same run, by model.run() and by `stepwire run`: seconds of the run itself, and of the whole call
    ticks     processor time of a tick by simulation.step(), beside many ticks by one call of it
    blocks    a method of a block in Python, beside the same method called by Python
"""

import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import stepwire

root = pathlib.Path(__file__).resolve().parent.parent
W1 = root / "bench" / "w1.yaml"


def seconds(act, clock=time.perf_counter):
    start = clock()
    act()
    return clock() - start


def processor_seconds(act):
    """Of all threads, which other work on the machine does not change much."""
    return seconds(act, time.process_time)


def run_ratios(rounds):
    """Python over the program: the run itself as both report it, and all of it from the text to the verdicts."""
    program = root / "build" / "stepwire"
    inner: list[float] = []
    outer: list[float] = []
    for engine in ("interpreted", "compiled"):
        call = [str(program), "run", str(W1), "--stop", "400s", "--engine", engine, "--json"]
        for _ in range(rounds):
            told = []
            whole = seconds(lambda: told.append(subprocess.run(call, check=True, capture_output=True).stdout))
            runs = []
            mine = seconds(lambda: runs.append(stepwire.load(W1).run(stop="400 s", engine=engine)))
            inner.append(runs[0].seconds / json.loads(told[0])[0]["duration"])
            outer.append(mine / whole)
        yield engine, statistics.median(inner), statistics.median(outer)
        inner.clear()
        outer.clear()


def tick_cost(rounds, ticks=200_000):
    """What a tick by a call of its own takes beyond one of many by one call [us]."""
    model, beyond = stepwire.load(W1, values={"stop": 1e4}), []
    for _ in range(rounds):
        simulation = model.simulation()
        together = processor_seconds(lambda: simulation.step(ticks))
        step = simulation.step

        def one_by_one():
            for _ in range(ticks):
                step()
        beyond.append((processor_seconds(one_by_one) - together) / ticks * 1e6)
    return statistics.median(beyond)


@stepwire.block(inputs=["u"], outputs=["y"], parameters={"gain": "1"})
class Gained:
    gain = 2.0

    def outputs(self, u):
        return self.gain * u


DIAGRAM = """stepwire: 1
title: a block in Python
step: 1 ms
stop: 200 s
blocks:
  source: {block: Sine, frequency: 1 Hz}
  it: {block: %s, u: source, gain: 2}
record: {every: 1 s, signals: it}
"""


def block_cost(rounds):
    """What a call of a method takes in a run beyond the same call by Python [us]."""
    beyond = []
    with tempfile.TemporaryDirectory() as folder:
        models = []
        for name in ("Gained", "Gain"):
            path = os.path.join(folder, name + ".yaml")
            pathlib.Path(path).write_text(DIAGRAM % name)
            models.append(stepwire.load(path, blocks=[Gained]))
        for _ in range(rounds):
            runs = [processor_seconds(lambda: model.run(engine="interpreted")) for model in models]
            block = Gained()

            def call():
                outputs = block.outputs
                for _ in range(200_001):
                    outputs(0.5)
            beyond.append((runs[0] - runs[1] - processor_seconds(call)) / 200_001 * 1e6)
    return statistics.median(beyond)


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 7
    print(f"medians of {rounds} rounds\n\n| what | value | goal |\n|---|---|---|")
    for engine, inner, outer in run_ratios(rounds):
        print(f"| run of W1 {engine}, time over that of the program | {inner:.3f} | 1.05 |")
        print(f"| the same with loading and judging, over the whole program | {outer:.3f} | 1.05 |")
    print(f"| a tick by a call of its own, beyond the tick | {tick_cost(rounds):.3f} us | 1.5 us |")
    print(f"| a method of a block, beyond its call in Python | {block_cost(rounds):.3f} us | 0.3 us |")


main()
