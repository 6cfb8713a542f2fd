"""The types of the package, as mypy sees them."""

import os
import pathlib
import shutil
import subprocess
import sys

import pytest
import stepwire

mypy = shutil.which("mypy")
pytestmark = pytest.mark.skipif(mypy is None, reason="on Debian it is the package mypy")
package = pathlib.Path(stepwire.__file__).parent

PROGRAM = """import numpy as np
import stepwire


@stepwire.block(inputs={"v": "m/s"}, outputs={"F": "N"})
class Drag:
    def outputs(self, v: float) -> float:
        return -v


model = stepwire.load("cart.yaml", blocks=[Drag], mass="8 kg")
run: stepwire.Run = model.run(stop="3 s")
largest: float = float(np.max(run["cart.position"]))
study: stepwire.Study = model.study()
error: float = model.fit().parameters["mass"].standard_error
svg: str = run.figures[0].svg
simulation = model.simulation()
simulation.inputs["push"] = 3.0
"""


def checked(folder, *options):
    environment = {**os.environ, "MYPYPATH": str(package.parent)}
    command = [mypy, "--python-executable", sys.executable, "--cache-dir", str(folder / "cache"), *options]
    done = subprocess.run(command, env=environment, cwd=folder, capture_output=True, text=True)
    return done.returncode, done.stdout


def test_a_program_of_a_user_passes_and_what_is_wrong_in_it_is_found(tmp_path):
    (tmp_path / "right.py").write_text(PROGRAM)
    code, text = checked(tmp_path, "--strict", "right.py")
    assert code == 0, text
    (tmp_path / "wrong.py").write_text(PROGRAM + "model.run(stopp=3)\nrun.figures[0].svgg\nx: str = run.ticks\n")
    code, text = checked(tmp_path, "wrong.py")
    assert code == 1 and '"Picture" has no attribute "svgg"' in text and "wrong.py:21" in text, text
