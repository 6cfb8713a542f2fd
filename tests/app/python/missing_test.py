"""The package without its compiled part."""

import pathlib
import shutil
import subprocess
import sys

import stepwire

package = pathlib.Path(stepwire.__file__).parent


def imported(tmp_path, module=""):
    folder = tmp_path / "stepwire"
    shutil.copytree(package, folder, ignore=shutil.ignore_patterns("_core.*.so", "__pycache__"))
    if module:
        (folder / module).write_bytes(b"")
    done = subprocess.run([sys.executable, "-c", "import stepwire"], cwd=tmp_path, env={}, capture_output=True, text=True)
    return done.stderr.splitlines()[-1]


def test_a_package_without_its_module_says_where_it_was_looked_for_and_how_it_comes(tmp_path):
    message = imported(tmp_path)
    assert f"_core, is not in {tmp_path / 'stepwire'}" in message and "'./stepwire python'" in message


def test_a_module_for_another_python_is_named_with_this_one(tmp_path):
    message = imported(tmp_path, "_core.cpython-27-x86_64-linux-gnu.so")
    assert "_core.cpython-27-x86_64-linux-gnu.so" in message and sys.executable in message
    assert "call /usr/bin/python3" in message


def test_a_module_that_cannot_be_loaded_is_named_with_the_reason(tmp_path):
    name = next(package.glob("_core.*.so")).name
    assert f"{tmp_path / 'stepwire' / name} cannot be loaded" in imported(tmp_path, name)
