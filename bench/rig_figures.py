"""Figures 33 to 37 on a rig in software: `stepwire rig` has the plant, `stepwire loop --io` the controller.

Each runs by the clock behind shared memory; the same plant and controller in one file, without a clock, is what they
are compared with. Maps and laws are those of the figures. Prints a table; with a folder it keeps all files there.
"""
import csv
import json
import math
import os
import subprocess
import sys
import tempfile
import time

import numpy

BEGIN = 3.0  # the push begins [s]; until then the controller starts and tares the load cell
TARE = 0.05  # of the figures, in place of that

BAND = "{left: 216 mm, right: 232 mm, y: [-60 mm, 60 mm]}"
BELOW = "{polygon: [[160 mm, -90 mm], [290 mm, -90 mm], [290 mm, -7 mm], [160 mm, -7 mm]]}"
LAYER_1 = ("{corridor: [[206 mm, -22 mm], [224 mm, -6 mm], [238 mm, 6.4444 mm], [224 mm, 20 mm]], "
           "half_width: 3 mm}")
LAYER_2 = ("{corridor: [[224 mm, 20 mm], [210 mm, 6.4444 mm], [224 mm, -6 mm], [242 mm, -22 mm]], "
           "half_width: 3 mm}")
RUN_1 = [(216, -25), (210, -18.444), (224, -6), (236, 4.6667), (243, 14), (224, 20)]


def ray(degrees):
    """Points of a push of figure 36."""
    angle = math.radians(degrees)
    return [(224, 9), (224 + 15 * math.sin(angle), 9 - 15 * math.cos(angle))]


# name, points in mm, seconds, acceleration in m/s2, and for each layer its region and law
FIGURES = [
    ("33", [(224, 0), (249, 0)], 2.55, 0.5, [(BAND, "P1, offset: 5 N, slope: 1 N/mm, directionality: D2")]),
    ("34", [(224, 0), (249, 0)], 2.55, 0.5, [(BAND, "P2, W: -5 mm, maximum: 20 N, directionality: D2")]),
    ("35", [(224, 0), (249, 0), (224, 0)], 5.7, 0.5,
     [(BAND, "P1, offset: 5 N, slope: 0.8 N/mm, directionality: D1, polar: 1")]),
    *((f"36, ray {degrees}", ray(degrees), 1.58, 0.5,
       [(BELOW, "P1, offset: 8 N, directionality: D2, told_by: motion")]) for degrees in (30, 90, 180)),
    ("37", RUN_1 + RUN_1[-2::-1], 17.05, 0.1,
     [(region, "P1, offset: 5 N, slope: 0.1 N/mm, directionality: D2") for region in (LAYER_1, LAYER_2)]),
]

HEAD = "stepwire: 1\ntitle: Figure {}, {}\nstep: {}\nstop: {:.6g} s\nsolver: rk4\n"
ENDS = {
    "plant": ("inputs: {linear: {unit: A, default: 0 A}, rotary: {unit: A, default: 0 A}}\n"
              "outputs: {channels: plant.channels, counter: plant.counter, at: plant.at}\n"),
    "controller": ("inputs: {channels: {default: [4041, 0, 0, 0, 0, 0, 0]}, counter: {default: 0}, "
                   "at: {unit: m, default: [224 mm, 0 mm]}}\n"
                   "outputs: {linear: {signal: control.linear, safe: 0 A}, "
                   "rotary: {signal: control.rotary, safe: 0 A}}\n"),
    "both": "",
}
RECORDS = {
    "plant": ["plant.pusher.position", "plant.platform.external"],
    "controller": ["at", "control.position", "control.cause"],
}


def plant_blocks(root, figure):
    """The plant of example 158, pushed along the points of a figure."""
    points = ", ".join(f"[{x:.9g} mm, {y:.9g} mm]" for x, y in figure[1])
    return [f"plant: {{diagram: {root}/diagrams/examples/158-rig-plant.yaml, linear: linear, rotary: rotary, "
            f"points: [{points}], acceleration: {figure[3]} m/s2, begin: {BEGIN} s}}"]


def controller_blocks(root, figure):
    """Maps and laws of a figure, before the control of example 159."""
    parts = root + "/diagrams/parts"
    lines = []
    layers = figure[4]
    for i, (region, law) in enumerate(layers, 1):
        lines.append(f"map_{i}: {{block: Region, shape: {region}, position: control.position, every: 1 ms}}")
        lines.append(f"law_{i}: {{diagram: {parts}/resistance-law.yaml, distance: map_{i}.distance, "
                     f"direction: map_{i}.direction, force: control.force, position: control.position, "
                     f"proportionality: {law}}}")
    if len(layers) > 1:
        lines.append("layers: {block: LayerActivator, u: [law_1.wanted, law_2.wanted], position: control.position, "
                     "blend: 50 ms, every: 1 ms, "
                     "switches: [{from: 1, to: 2, when: {pass: [224 mm, 20 mm], within: 2 mm}}]}")
    wanted = "layers.y" if len(layers) > 1 else "law_1.wanted"
    lines.append(f"control: {{diagram: {parts}/polar-board-control.yaml, channels: channels, counter: counter, "
                 f"other: at, wanted: {wanted}}}")
    return lines


def write_diagrams(root, folder, figure):
    """Writes the two sides, and both in one file."""
    stop = BEGIN + figure[2] - TARE
    both = ["plant: {diagram: plant.yaml, linear: controller.linear, rotary: controller.rotary}",
            "controller: {diagram: controller.yaml, channels: plant.channels, counter: plant.counter, at: plant.at}"]
    contents = {"plant": ("0.1 ms", plant_blocks(root, figure), RECORDS["plant"]),
                "controller": ("1 ms", controller_blocks(root, figure), RECORDS["controller"]),
                "both": ("0.1 ms", both, ["plant." + name for name in RECORDS["plant"]] + ["controller.control.position"])}
    for name, (step, blocks, record) in contents.items():
        text = HEAD.format(figure[0], name, step, stop) + ENDS[name]
        text += "blocks:\n" + "".join(f"  {line}\n" for line in blocks)
        text += f"record: {{every: 1 ms, signals: [{', '.join(record)}]}}\n"
        with open(os.path.join(folder, name + ".yaml"), "w") as file:
            file.write(text)
    return stop


def write_rig(root, folder, name):
    """The wires of the example, to the shared memory of this name."""
    with open(root + "/diagrams/examples/polar-rig/rig.yaml") as file:
        wires = file.read().replace("name: polar}", f"name: {name}}}")
    with open(os.path.join(folder, "rig.yaml"), "w") as file:
        file.write(wires)


def call(program, folder, *words):
    """Runs the program; ends the script where it fails."""
    done = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(words)} in {folder}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def run_by_the_clock(program, folder, name, stop):
    """Runs both sides; the rig is there before the controller, and ends after it."""
    words = [program, "rig", "plant.yaml", "--shared", name, "--rate", "1000", "--duration", f"{stop + 2:.6g}",
             "--out", "rig-out"]
    with open(os.path.join(folder, "rig.txt"), "w") as log:
        rig = subprocess.Popen(words, cwd=folder, stdout=log, stderr=log)
    while rig.poll() is None and not os.path.exists("/dev/shm/" + name):
        time.sleep(0.01)
    time.sleep(0.2)
    call(program, folder, "loop", "controller.yaml", "--io", "rig.yaml", "--rate", "1000", "--duration", f"{stop:.6g}",
         "--out", "loop-out")
    if rig.wait() != 0:
        sys.exit(f"the rig in {folder} has ended with {rig.returncode}")


def columns(path, *names):
    """Columns of a CSV file whose heads begin with these names, in order."""
    with open(path) as file:
        heads = next(csv.reader(file))
    data = numpy.genfromtxt(path, delimiter=",", skip_header=1)
    return [data[:, [i for i, head in enumerate(heads) if head.split(" ")[0].split("[")[0].startswith(name)]]
            for name in names]


def rms(values):
    """Root mean square of the lengths of the rows."""
    return math.sqrt(numpy.mean(numpy.sum(values**2, axis=1)))


def best_shift(place, reference):
    """Rows by which the controller's record is later than the file's, by the place of the motor."""
    moves = numpy.flatnonzero(numpy.abs(place - place[0]).max(axis=1) > 1e-3)[0]
    first = numpy.flatnonzero(numpy.abs(reference - reference[0]).max(axis=1) > 1e-3)[0]
    candidates = range(int(first - moves) - 20, int(first - moves) + 21)
    return min(candidates, key=lambda shift: rms(shifted(place, reference, shift)))


def shifted(values, reference, shift):
    """Differences of a record from the reference `shift` rows later, from the beginning of the push on."""
    rows = numpy.arange(len(values)) + shift
    inside = (rows >= int(1000 * BEGIN)) & (rows < len(reference))
    return values[inside] - reference[rows[inside]]


def missed(folder):
    """Missed deadlines of a side."""
    with open(folder + "/loop.json") as file:
        return json.load(file)["deadlines"]["missed"]


def compare(program, folder, name):
    """Prints a row: force and path of the motor by the clock, against the file without one."""
    begin = int(1000 * BEGIN)
    path, force = columns(folder + "/rig-out/signals.csv", *RECORDS["plant"])
    path_there, force_there, seen_there = columns(
        folder + "/both-out/signals.csv", *("plant." + name for name in RECORDS["plant"]), "controller.control.position")
    end = min(len(path), len(path_there))
    force_rms, signal = rms(force[begin:end] - force_there[begin:end]), rms(force_there[begin:end])
    at, seen, cause = columns(folder + "/loop-out/signals.csv", *RECORDS["controller"])
    shift = best_shift(at, path_there)
    seen_rms = rms(shifted(seen, seen_there, shift))
    if cause.max() > 0:
        print(f"figure {name}: the safety part has cut the currents off, cause {cause.max():.0f}", file=sys.stderr)
    verdict = call(program, folder, "verify", "loop-out").strip().splitlines()[-1]
    path_rms = rms(path[begin:end] - path_there[begin:end])
    misses = f"{missed(folder + '/rig-out')}, {missed(folder + '/loop-out')}"
    print(f"| {name} | {force_rms:.3f} | {100 * force_rms / signal:.2f} | {1e3 * path_rms:.3g} | {1e3 * seen_rms:.3f} "
          f"| {misses} | {verdict} |", flush=True)


def main():
    """Runs all figures in one folder after the other."""
    root = sys.argv[1]
    program = root + "/build/stepwire"
    top = sys.argv[2] if len(sys.argv) > 2 else tempfile.mkdtemp(prefix="rig-figures-")
    print("| figure | force, rms of the difference in N | in % of its rms | path of the pin in mm | path as measured in mm "
          "| missed deadlines of rig, controller | verify |\n|---|---|---|---|---|---|---|")
    for number, figure in enumerate(FIGURES):
        name = f"stepwire-figures-{os.getpid()}"
        folder = os.path.join(os.path.abspath(top), str(number))
        os.makedirs(folder)
        stop = write_diagrams(root, folder, figure)
        write_rig(root, folder, name)
        call(program, folder, "run", "both.yaml", "--out", "both-out")
        run_by_the_clock(program, folder, name, stop)
        compare(program, folder, figure[0])


if __name__ == "__main__":
    main()
