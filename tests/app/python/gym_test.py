"""The example of an environment for reinforcement learning."""

import importlib.util
import pathlib

import numpy as np
import pytest
import stepwire

root = pathlib.Path(__file__).resolve().parents[3]


def test_an_episode_of_a_controller_by_hand(cart_file):
    spec = importlib.util.spec_from_file_location("gym_example", root / "diagrams" / "notebooks" / "gym.py")
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    environment = example.Environment(stepwire.load(cart_file), ["push"], ["cart.position", "cart.velocity"],
                                      lambda seen, action: -seen[0] ** 2)
    seen, _ = environment.reset()
    assert np.array_equal(seen, [1.0, 0.0])
    done, total = False, 0.0
    while not done:
        seen, reward, _, done, info = environment.step(-8.0 * seen[1])
        total += reward
    assert info["time"] == pytest.approx(1.0) and total < 0 and abs(seen[0]) < 0.9
    assert np.array_equal(environment.reset()[0], [1.0, 0.0])
