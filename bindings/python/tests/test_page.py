"""The Python of docs/python.md runs, block after block, and prints what its comments say."""

import contextlib
import io
import pathlib
import re

import matplotlib

matplotlib.use("Agg")

PAGE = pathlib.Path(__file__).parents[3] / "docs/python.md"


def test_the_page_does_as_it_says(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"^```python\n(.*?)^```", PAGE.read_text(), re.M | re.S)
    assert len(blocks) >= 5
    names = {}
    for block in blocks:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(block, names)
        assert printed.getvalue().splitlines() == re.findall(r"# prints (.*)", block)
    assert (tmp_path / "python.png").stat().st_size > 10_000
