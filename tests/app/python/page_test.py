"""The commands that the page of the module shows are run in their order."""

import pathlib
import re

import pytest
import stepwire

root = pathlib.Path(__file__).resolve().parents[3]
PAGE = root / "engine" / "app" / "python" / "README.md"


@pytest.fixture
def fences():
    text = PAGE.read_text().replace("/usr/share/stepwire/diagrams", str(root / "diagrams"))
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
    assert all(claim.holds or claim.disagrees for claim in names["push"].claims)
    assert names["sweep"].points[4] == {"mass": "2 kg", "stiffness": "50"}
    fit = names["fit"]
    assert fit.converged and fit["tau"] == pytest.approx(25 * 60, rel=0.02)
    low, high = fit.parameters["tau"].interval
    assert low < 25 * 60 < high
    assert fit.model.parameters["tau"].value == pytest.approx(fit["tau"], rel=1e-12)
    assert "<svg" in fit.figures[0].svg
    assert "tau" in capsys.readouterr().out
    assert isinstance(names["model"], stepwire.Model)
