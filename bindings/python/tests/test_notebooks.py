"""The notebooks run from the first cell to the last, and are committed without outputs."""

import pathlib

import nbformat
import pytest
from nbclient import NotebookClient

NOTEBOOKS = sorted((pathlib.Path(__file__).parents[3] / "examples/notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(path, tmp_path):
    notebook = nbformat.read(path, 4)
    for cell in notebook.cells:
        assert not cell.get("outputs") and cell.get("execution_count") is None, "run `nbconvert --clear-output`"
    NotebookClient(notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": tmp_path}}).execute()
    assert sum(bool(cell.get("outputs")) for cell in notebook.cells) >= 3


def test_there_are_three():
    assert len(NOTEBOOKS) == 3
