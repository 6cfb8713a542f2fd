"""The notebooks run from their first cell to their last."""

import pathlib

import pytest

nbclient = pytest.importorskip("nbclient", reason="on Debian it is the package python3-nbclient")
nbformat = pytest.importorskip("nbformat", reason="on Debian it is the package python3-nbformat")
pytest.importorskip("ipykernel", reason="on Debian it is the package python3-ipykernel")

NOTEBOOKS = pathlib.Path(__file__).resolve().parents[3] / "diagrams" / "notebooks"


@pytest.mark.parametrize("path", sorted(NOTEBOOKS.glob("*.ipynb")), ids=lambda path: path.stem)
def test_a_notebook_runs(path):
    notebook = nbformat.read(path, as_version=4)
    assert all(not cell.outputs for cell in notebook.cells if cell.cell_type == "code"), "it is kept without outputs"
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3",
                            resources={"metadata": {"path": str(path.parent)}}).execute()
    shown = [output.data for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs
             if output.output_type == "execute_result"]
    assert sum("image/svg+xml" in data for data in shown) >= 4
