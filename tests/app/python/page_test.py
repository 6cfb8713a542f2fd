"""What the pages of the module show is done, in their order."""

import pathlib
import re

import pytest
import stepwire

root = pathlib.Path(__file__).resolve().parents[3]
PAGES = [root / "engine" / "app" / "python" / name for name in ("README.md", "records.md")]


@pytest.fixture
def fences():
    text = "\n".join(page.read_text() for page in PAGES)
    return re.findall(r"([^\n]*)\n\n```(\w+)\n(.*?)```", text, re.DOTALL)


def test_the_page_holds(fences, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    names = {}
    for lead, language, text in fences:
        if language in ("yaml", "csv"):
            name = re.search(r"`([\w-]+\.(?:yaml|csv))`", lead)[1]
            pathlib.Path(name).write_text(text)
        elif language == "python":
            exec(compile(text, f"page: {text.splitlines()[0]}", "exec"), names)
    assert names["sweep"].points[4] == {"mass": "2 kg", "stiffness": "50"}
    fit = names["fit"]
    assert fit.converged and fit["mass"] == pytest.approx(3.0, rel=0.01)
    low, high = fit.parameters["mass"].interval
    assert low < 3.0 < high
    assert fit.model.parameters["mass"].value == pytest.approx(fit["mass"], rel=1e-12)
    assert "<svg" in fit.figures[0].svg
    assert "kg" in capsys.readouterr().out
    assert isinstance(names["model"], stepwire.Model)
