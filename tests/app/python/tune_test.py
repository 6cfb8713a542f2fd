"""Tunings: what is found, looked at and refused."""

import math

import numpy as np
import pytest
import stepwire

SECTION = {
    "parameters": {"stiffness": {"from": "1 N/m", "to": "50 N/m"}},
    "minimise": "abs(final(cart.velocity))",
    "subject_to": [{"that": "it has swung once to the other side", "min": "cart.position", "at_most": "-0.99 m"}],
}


def test_a_spring_is_tuned_so_that_the_cart_stands_at_the_end(cart_file):
    # Half a period in 1 s: sqrt(k/m) = pi, with 2 kg.
    model = stepwire.load(cart_file)
    tuning = model.tune(SECTION, starts=3, threads=2)
    assert tuning.feasible and tuning.objective < 1e-2
    assert tuning["stiffness"] == pytest.approx(2.0 * math.pi**2, rel=1e-2)
    assert tuning.model.parameters["stiffness"].value == pytest.approx(tuning["stiffness"], rel=1e-12)
    assert tuning.data["claims"][0]["holds"] is True
    assert "stiffness" in str(tuning) and "<svg" in tuning.figures[0].svg
    assert "stiffness" in tuning._repr_html_()


def test_the_history_is_a_table_of_all_evaluations(cart_file):
    holds = [{"that": "it does not leave", "max": "cart.position", "at_most": "1.5 m"}]
    tuning = stepwire.load(cart_file).tune({**SECTION, "subject_to": holds}, evaluations=9)
    history = tuning.history()
    assert len(history) == tuning.data["evaluations"] == 9
    assert list(history.columns) == ["stiffness", "objective", "margin.1", "start", "fault"]
    assert history["stiffness"][0] == 8.0 and np.all(history["start"] == 1)


def test_a_file_without_the_section_is_refused(cart_file):
    with pytest.raises(stepwire.Error, match="has no section 'tune'"):
        stepwire.load(cart_file).tune()
    with pytest.raises(stepwire.Error, match="is no number of a run"):
        stepwire.load(cart_file).tune({**SECTION, "minimise": "cart.position"})
    with pytest.raises(KeyError, match="tuned are: stiffness"):
        stepwire.load(cart_file).tune(SECTION, evaluations=3)["mass"]
