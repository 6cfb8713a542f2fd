"""Diagrams that several tests use."""

import pathlib

import pytest

root = pathlib.Path(__file__).resolve().parents[3]

CART = """stepwire: 1
title: A cart on a spring
step: 1 ms
stop: 1 s
solver: rk4
inputs:
  push: {unit: N, default: 0 N}
parameters:
  mass: {value: 2 kg, above: 0 kg, doc: of the cart}
  stiffness: {value: 8 N/m}
blocks:
  spring: {block: Gain, gain: = -stiffness, u: cart.position}
  net: {block: Sum, u: [push, spring]}
  cart: {block: Mass, force: net, mass: $mass, initial_position: 1 m}
record: [cart.position, cart.velocity]
figure: {plot: lines, x: time in s, y: [cart.position]}
claims:
  - {that: it swings, max: abs(cart.position), at_most: 1.001 m}
  - {that: it does not come back at once, final: cart.position, at_least: 2 m}
"""


@pytest.fixture
def examples():
    return root / "diagrams" / "examples"


@pytest.fixture
def cart_file(tmp_path):
    file = tmp_path / "cart.yaml"
    file.write_text(CART)
    return file
