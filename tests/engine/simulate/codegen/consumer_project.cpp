#include "tests/engine/simulate/codegen/consumer_project.hpp"

const std::string part_yaml = R"(stepwire: 1
title: a cart
inputs: {force: {unit: N}}
outputs: {position: {signal: cart.position, unit: m}}
parameters:
  mass: {value: 1 kg, above: 0 kg, doc: moved}
blocks:
  cart: {block: Mass, force: force, mass: $mass}
)";

const std::string rig_yaml = R"yaml(stepwire: 1
title: a rig
step: 1 ms
stop: 2 s
solver: rk4
inputs: {lift: {unit: N, default: 0.5 N}, force: {unit: N, default: [3 N, 4 N], doc: of the hand}}
outputs: {current: {signal: held, safe: 0}}
parameters:
  tau: {value: 0.3 s, above: 0 s, at_most: 3 s, doc: of the lag}
  half: "= tau / 2 + (tau > 0.2 ? 0.1 : 0)"
  amp: {value: [1 N, 2 N], doc: of the wave}
  wait: {value: 5 ms, doc: of the delay}
  mass: {value: 2 kg, above: 0 kg, doc: of the cart}
  start: -1
  gains: [[1, 2], [3, 4]]
  k: 2
  bias: 0.25 N
blocks:
  noise: {block: Noise, seed: 3, deviation: = tau / 3, every: 5 ms}
  push:  {block: Sum, u: [force, wave, $bias]}
  wave:  {block: Sine, frequency: = k * 1.5, amplitude: $amp}
  fast:  {block: Lag, tau: $tau, u: noise, initial: $start}
  late:  {block: Delay, delay: $wait, u: fast, every: 1 ms}
  vec:   {block: Lag, tau: [$tau, $half], gain: $k, u: push}
  mat:   {block: MatrixGain, gain: $gains, u: push}
  slow:  {block: Integrator, u: push, initial: [$start, 1]}
  pid:   {block: DiscretePID, kp: $k, tau: $half, kd: 0.1, u: fast, every: 5 ms}
  held:  {block: ZeroOrderHold, u: fast, every: 10 ms}
  cart:  {diagram: part.yaml, mass: $mass, force: lift_and_weight}
  g:     {block: Gain, gain: "= 3 * mass + tau", u: one}
  one:   {block: Constant, value: 1 N}
  lift_and_weight: {block: Sum, u: [lift, g]}
record: [slow, vec, mat, pid, cart.position, g, late, held]
)yaml";

const std::string rack_yaml = R"(stepwire: 1
title: a rack
step: 1 ms
stop: 1 s
solver: heun
inputs: {force: {unit: N, default: 0 N, doc: of the hand}}
parameters: {tau: {value: 0.1 s, above: 0 s}}
blocks:
  vec:  {block: Lag, tau: $tau, u: force, initial: 2}
  held: {block: ZeroOrderHold, u: vec, every: 7 ms}
record: [vec, held]
)";

const std::string cpp_consumer = R"(#include <cstdio>
#include <cstring>

#include "rack.hpp"
#include "rig.hpp"

using rig_diagram::Diagram;

static void write(Diagram& d) {
  d.inputs.lift_ = 0.01 * static_cast<double>(d.tick);
  d.evaluate();
  std::fwrite(&d.recorded, sizeof d.recorded, 1, stdout);
  d.advance();
}

static int wrong(int code) {
  std::fprintf(stderr, "wrong: %d\n", code);
  return code;
}

int main() {
  static Diagram d;
  static Diagram::State kept;
  for (int tick = 0; tick < 100; ++tick) {
    if (tick == 10) d.parameters.tau_ = 0.7;
    if (tick == 20) d.parameters.half_ = 0.05;
    if (tick == 30) d.parameters.tau_ = 0.15;  // half no longer follows
    if (tick == 40) {
      d.parameters.mass_ = 3.0;
      d.parameters.amp_[1] = -2.5;
      d.parameters.gains_[0][1] = 7.0;
      d.parameters.bias_ = 1.0;
      d.parameters.k_ = 2.5;
    }
    if (tick == 50) d.parameters.cart_mass_ = 5.0;
    if (tick == 55) d.parameters.mass_ = 4.0;  // that of the cart no longer follows
    if (tick == 60) d.save(kept);
    if (tick == 70) {
      Diagram::Parameters heavy = d.parameters;
      heavy.mass_ = -1.0;
      if (!d.check(heavy) || std::strcmp(d.check(heavy), "mass: must be above 0 kg") != 0) return wrong(1);
      if (d.check(d.parameters)) return wrong(2);
      d.parameters = heavy;
    }
    write(d);
    if ((d.parameter_fault() != nullptr) != (tick >= 70 && tick < 80)) return wrong(3);
    if (tick == 79) d.parameters.mass_ = 4.0;
  }
  if (d.parameters.cart_mass_ != 5.0 || d.parameters.half_ != 0.05) return wrong(4);
  if (!d.restore(kept) || d.tick != 60) return wrong(5);
  for (int tick = 60; tick < 100; ++tick) write(d);
  rig_diagram::Diagram::States states = d.states();
  states.cart_cart_position_ = 0.5;
  states.slow_x_[1] = -3.0;
  d.set_states(states);
  d.evaluate();
  if (d.recorded.cart_position_ != 0.5 || d.recorded.slow_[1] != -3.0) return wrong(6);
  d.parameters.start_ = 0.75;
  d.reset();
  if (d.states().fast_x_ != 0.75 || d.states().slow_x_[0] != 0.75 || d.states().slow_x_[1] != 1.0) return wrong(7);
  kept.layout ^= 1;
  if (d.restore(kept) || d.tick != 0) return wrong(8);
  static rack_diagram::Diagram other;
  other.step();
  return other.recorded.vec_ == 2.0 ? 0 : wrong(9);
}
)";

const std::string c_consumer = R"(#include <stdio.h>

#include "rack-c.h"
#include "rig-c.h"

static rack_diagram_instance d;
static rig_diagram_instance other;
static rack_diagram_state kept;

static void step(int tick) {
  rack_diagram_inputs inputs;
  rack_diagram_recorded recorded;
  inputs.force_ = 0.5 * tick;
  rack_diagram_set_inputs(&d, &inputs);
  rack_diagram_evaluate(&d);
  rack_diagram_get_recorded(&d, &recorded);
  fwrite(&recorded, sizeof recorded, 1, stdout);
  rack_diagram_advance(&d);
}

int main(void) {
  rack_diagram_parameters parameters;
  int tick;
  rack_diagram_init(&d);
  rig_diagram_init(&other);
  rig_diagram_step(&other);
  for (tick = 0; tick < 50; ++tick) {
    if (tick == 20) rack_diagram_save(&d, &kept);
    if (tick == 30) {
      rack_diagram_get_parameters(&d, &parameters);
      parameters.tau_ = 0.02;
      if (rack_diagram_check(&d, &parameters)) return 1;
      rack_diagram_set_parameters(&d, &parameters);
    }
    step(tick);
  }
  if (!rack_diagram_restore(&d, &kept) || rack_diagram_tick(&d) != 20) return 2;
  for (tick = 20; tick < 50; ++tick) step(tick);
  return rack_diagram_finite(&d) && !rack_diagram_fault(&d) && !rack_diagram_stops(&d) ? 0 : 3;
}
)";

const std::string project = R"(cmake_minimum_required(VERSION 3.21)
project(consumer LANGUAGES C CXX)
add_subdirectory(rig)
add_subdirectory(rack)
add_executable(cpp consumer.cpp)
target_link_libraries(cpp PRIVATE rig_diagram::rig_diagram rack_diagram::rack_diagram)
add_executable(c consumer.c)
set_target_properties(c PROPERTIES C_STANDARD 99 C_EXTENSIONS OFF)
target_compile_options(c PRIVATE -Wall -Wextra -Wpedantic -Werror)
target_link_libraries(c PRIVATE rig_diagram::rig_diagram rack_diagram::rack_diagram)
)";
