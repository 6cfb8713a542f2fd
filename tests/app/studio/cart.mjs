/** Cart on a spring, with a live parameter. */
export const cartText = (record) => `stepwire: 1
title: a cart
step: 1 ms
stop: 2 s
solver: rk4
parameters:
  mass: {value: 2 kg, at_least: 1 kg, at_most: 9 kg}
record: [${record}]
blocks:
  cart: {block: Mass, mass: $mass, force: spring, initial_position: 0.1 m}
  spring: {block: Gain, gain: -200 N/m, u: cart.position}
`;
