"""An environment for reinforcement learning on a diagram, with the calls of Gym and of nothing else."""

import numpy as np


class Environment:
    """`action` and `observation` are names of inputs and signals; each step holds an action for `ticks` ticks."""

    def __init__(self, model, action, observation, reward, ticks=10):
        self.simulation = model.simulation()
        self.action, self.observation, self.reward, self.ticks = action, observation, reward, ticks

    def reset(self, **values):
        self.simulation.reset()
        for name, value in values.items():
            self.simulation.set(name, value)
        self.simulation.step()
        return self._observed(), {}

    def step(self, action):
        for name, number in zip(self.action, np.atleast_1d(action)):
            self.simulation.inputs[name] = number
        for _ in range(self.ticks):
            if not self.simulation.finished:
                self.simulation.step()
        seen = self._observed()
        return seen, self.reward(seen, action), False, self.simulation.finished, {"time": self.simulation.time}

    def _observed(self):
        return np.array([self.simulation[name] for name in self.observation])
