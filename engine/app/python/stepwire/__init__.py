"""Stepwire: block diagrams of files, run, swept, fitted, tuned, linearized and stepped from Python.

    model = stepwire.load("cart.yaml", mass="8 kg")
    run = model.run(stop="3 s")
    run["cart.position"]      # a numpy array, SI
    run.figures[0]            # shown by Jupyter
"""

import pathlib as _pathlib

try:
    from . import _core
except ImportError as _error:
    from ._missing import reason as _reason

    raise ImportError(_reason(_pathlib.Path(__file__).parent, _error)) from None


def _note_package() -> None:
    """What comes with the program lies in share/stepwire of the prefix, or of the build folder."""
    for folder in _pathlib.Path(__file__).absolute().parents:
        if (folder / "share" / "stepwire" / "headers").exists():
            return _core.note_package(str(folder / "share" / "stepwire"))


_note_package()

from .blocks import block  # noqa: E402
from .errors import EnvironmentError, Error, Fault, Interrupted, RunError  # noqa: E402
from .model import Input, Model, Parameter, Signal, load  # noqa: E402
from .records import Claim, FittedParameter, Notice, Record  # noqa: E402
from .results import Fit, Linear, Run, Study, Tuning  # noqa: E402
from .show import Picture  # noqa: E402
from .simulation import Inputs, Simulation  # noqa: E402

__version__: str = _core.version()
__all__ = ["Claim", "EnvironmentError", "Error", "Fault", "Fit", "FittedParameter", "Input", "Inputs", "Interrupted",
           "Linear", "Model", "Notice", "Parameter", "Picture", "Record", "Run", "RunError", "Signal", "Simulation", "Study",
           "Tuning", "block", "load"]
