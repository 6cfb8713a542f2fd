// Tasks of simulation that a program solves by the tools: plants and controllers, against closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/app/mcp/client.hpp"

using nlohmann::json;

namespace {

/// Blocks, records and claims behind a head.
std::string rest(const std::string& blocks, const std::string& record, const std::string& claims) {
  return "blocks:\n" + blocks + "record: [" + record + "]\nclaims:\n" + claims;
}

}  // namespace

TEST_CASE("task: a cart on a spring swings as F/k (1 - cos wt)") {
  const json found = Client().values(diagram("1 ms", "2 s",
                                             rest(
                                                 R"yaml(  net:    {block: Sum, signs: "+-", u: [10 N, spring]}
  cart:   {block: Mass, force: net, mass: 2 kg}
  spring: {block: Gain, u: cart.position, gain: 200 N/m}
)yaml",
                                                 "cart.position",
                                                 R"yaml(  - {that: cosine, 
     max: "abs(cart.position - 50 mm*(1 - cos(10 rad/s*time)))", at_most: 1e-9 m}
  - {that: peak, max: cart.position, equals: 0.1 m, within: 1e-4 m}
)yaml")));
  CHECK(found["peak"].get<double>() == Approx(0.1).epsilon(1e-4));
}

TEST_CASE("task: a cascade of two PIDs has a double pole at -2") {
  Client().values(diagram("1 ms", "5 s",
                          rest(
                              R"yaml(  outer_error: {block: Sum, signs: "+-", u: [1 m, axis.position]}
  outer: {block: PID, u: outer_error, kp: 1 1/s}
  inner_error: {block: Sum, signs: "+-", u: [outer, axis.velocity]}
  inner: {block: PID, u: inner_error, kp: 4 N s/m}
  axis: {block: Mass, force: inner, mass: 1 kg}
)yaml",
                              "axis.position",
                              R"yaml(  - {that: "1 - (1 + 2t) exp(-2t)",
     max: "abs(axis.position - 1 m*(1 - (1 + 2*time/1 s)*exp(-2*time/1 s)))", at_most: 1e-9 m}
)yaml")));
}

TEST_CASE("task: a quarter car without damper keeps its energy") {
  Client().values(diagram("0.1 ms", "2 s",
                          rest(
                              R"yaml(  travel: {block: Sum, signs: "+-", u: [wheel.position, body.position]}
  spring: {block: Gain, u: travel, gain: 20 kN/m}
  body:   {block: Mass, force: spring, mass: 300 kg, initial_position: 50 mm}
  tyre:   {block: Gain, u: wheel.position, gain: -200 kN/m}
  net:    {block: Sum, signs: "+-", u: [tyre, spring]}
  wheel:  {block: Mass, force: net, mass: 40 kg}
)yaml",
                              "body.position, body.velocity, wheel.position, wheel.velocity, travel",
                              R"yaml(  - {that: energy, at_most: 1e-6 J,
     spread: "150 kg*body.velocity^2 + 20 kg*wheel.velocity^2 + 10 kN/m*travel^2 + 100 kN/m*wheel.position^2"}
  - {that: start, at: {time: 0 s, value: "10 kN/m*travel^2"}, equals: 25 J, within: 1e-9 J}
)yaml")));
}

TEST_CASE("task: a thermostat with hysteresis has the period of its two exponentials") {
  // On: 100 s ln(10/8), off: 100 s ln(22/20): 31.845 s together. The first switching on is at
  // 100 s (ln(15/8) + ln(22/20)) = 72.39 s, so 600 s have 1 + floor(527.6/31.845) = 17 more.
  Client().values(
      diagram("0.1 s", "600 s",
              "events: locate\n" +
                  rest(R"yaml(  cold: {block: Gain, u: room, gain: -1}
  on:   {block: Hysteresis, u: cold, lower: -22, upper: -20}
  heat: {block: Gain, u: on, gain: 30}
  room: {block: Lag, u: heat, tau: 100 s, initial: 15}
)yaml",
                       "room, on",
                       R"yaml(  - {that: times, where: time > 10 s, count: on > 0.5, between: [17, 18]}
  - {that: high, max: room, equals: 22, within: 0.01}
  - {that: low, where: time > 70 s, min: room, equals: 20, within: 0.01}
)yaml")));
}

TEST_CASE("task: an LQG loop has the innovation of the Riccati equation") {
  // The plant is x[k+1] = x + u + w, y = x + v, with q = 0.01 and r = 1. Then P = (q + sqrt(q^2 + 4 q r))/2 =
  // 0.105125. The innovation has the variance P + r.
  const json found = Client().values(diagram("10 ms", "400 s",
                                             R"yaml(units: {kalman.estimate: "1"}
)yaml" + rest(R"yaml(  w:      {block: Noise, seed: 3, deviation: 0.1, every: 10 ms}
  v:      {block: Noise, seed: 4, deviation: 1, every: 10 ms}
  next:   {block: Sum, u: [x, u, w], every: 10 ms}
  x:      {block: UnitDelay, u: next, every: 10 ms}
  y:      {block: Sum, u: [x, v], every: 10 ms}
  kalman: {block: KalmanFilter, measured: y, u: last, A: [[1]], B: [[1]], C: [[1]], Q: [[0.01]],
           R: [[1]], P0: [[1]], every: 10 ms}
  u:      {block: MatrixGain, u: kalman.estimate, gain: [[-0.5]], every: 10 ms}
  last:   {block: ZeroOrderHold, u: u, every: 10 ms}
)yaml",
              "kalman.innovation, x",
              R"yaml(  - {that: innovation, rms: kalman.innovation, equals: 1.051249, within: 1.5 %}
)yaml"),
                                             ""));
  CHECK(found.size() == 1);
}

TEST_CASE("task: a pendulum that falls from the horizontal passes below at sqrt(2 g/l)") {
  Client().values(
      diagram("1 ms", "5 s",
              rest(R"yaml(  pull:  {block: Trig, function: sin, u: angle}
  accel: {block: Gain, u: pull, gain: -9.81}
  rate:  {block: Integrator, u: accel}
  angle: {block: Integrator, u: rate, initial: = pi/2}
)yaml",
                   "rate, angle", R"yaml(  - {that: speed, max: abs(rate), equals: sqrt(2*9.81), within: 1e-4}
  - {that: energy, spread: "rate^2/2 - 9.81*cos(angle)", at_most: 1e-8}
)yaml")));
}

TEST_CASE("task: a DC motor turns at k V / (b R + k^2)") {
  // k = 0.05, R = 2, b = 1e-4, V = 12: 0.6/0.0027 = 222.2222 rad/s.
  Client().values(
      diagram("0.1 ms", "2 s",
              rest(R"yaml(  emf:     {block: Gain, u: speed, gain: 0.05}
  drop:    {block: Gain, u: current, gain: 2}
  voltage: {block: Sum, signs: "+--", u: [12, drop, emf]}
  slope:   {block: Gain, u: voltage, gain: 1000}
  current: {block: Integrator, u: slope}
  torque:  {block: Gain, u: current, gain: 0.05}
  loss:    {block: Gain, u: speed, gain: 1e-4}
  net:     {block: Sum, signs: "+-", u: [torque, loss]}
  accel:   {block: Gain, u: net, gain: 10000}
  speed:   {block: Integrator, u: accel}
)yaml",
                   "speed", R"yaml(  - {that: speed, final: speed, equals: 222.22222222, within: 1e-6}
)yaml")));
}

TEST_CASE("task: an RC filter has 1/sqrt(2) of the amplitude at its corner") {
  Client().values(diagram(
      "0.1 ms", "200 ms",
      rest(R"yaml(  source: {block: Sine, amplitude: 1, frequency: 100 Hz}
  filter: {block: Lag, u: source, tau: "= 1/(2*pi*100 Hz)"}
)yaml",
           "filter",
           R"yaml(  - {that: amplitude, where: time > 0.1 s, max: filter, equals: 1/sqrt(2), within: 0.1 %}
  - {that: effective, where: time > 0.1 s, rms: filter, equals: 0.5, within: 0.1 %}
)yaml")));
}

TEST_CASE("task: a ball that keeps 0.8 of its speed rises to 0.64 of its height") {
  Client().values(diagram(
      "1 ms", "1.2 s",
      "events: locate\n" +
          rest(R"yaml(  v:      {block: Integrator, u: -9.81 m/s2, reset: hit, value: bounce}
  x:      {block: Integrator, u: v, initial: 1 m}
  hit:    {block: Compare, u: x, operator: less, to: 0 m}
  bounce: {block: Gain, gain: -0.8, u: v.before}
)yaml",
               "x",
               R"yaml(  - {that: second height, where: time > 0.46 s, max: x, equals: 0.64 m, within: 1e-5 m}
)yaml")));
}

TEST_CASE("task: a body on a belt sticks, and leaps once the spring has the breakaway force") {
  Client().values(
      diagram("1 ms", "0.4 s",
              "events: locate\n" +
                  rest(R"yaml(  belt:     {block: Ramp, slope: 0.1 m/s}
  stretch:  {block: Sum, u: [belt, body.position], signs: "+-"}
  spring:   {block: Gain, u: stretch, gain: 100 N/m}
  friction: {block: Friction, mass: 1 kg, coulomb: 1 N, breakaway: 1.5 N, force: spring,
             velocity: body.velocity}
  total:    {block: Sum, u: [spring, friction.y]}
  body:     {block: Mass, mass: 1 kg, force: total}
)yaml",
                       "body.position, spring",
                       R"yaml(  - {that: sticks, where: time <= 0.15 s, max: abs(body.position), at_most: 0 m}
  - {that: leap, max: spring, equals: 1 N + sqrt(1.25)*1 N, within: 1e-3 N}
)yaml")));
}

TEST_CASE("task: a controller that knows its limit does not wind up") {
  // The error is 1 for 10 s, then -1. With kp = ki = 1 and the limit 1 the integral part stays 0 with
  // clamping: -1.5 after 0.5 s. Without it the integral is 10, and the output is at its limit.
  const std::string text =
      diagram("1 ms", "10.5 s",
              "parameters: {mode: clamping}\n" +
                  rest(R"yaml(  error: {block: Step, time: 10 s, before: 1, after: -1}
  pid:   {block: PID, u: error, kp: 1, ki: 1, upper: 1, anti_windup: $mode}
)yaml",
                       "pid", R"yaml(  - {that: end, final: pid, equals: -1.5, within: 0.01}
)yaml"));
  const Client client;
  client.values(text);
  const json wound = client.on_text("run", text, {{"set", "mode=none"}});
  CHECK(wound["exit"] == 1);
  CHECK(wound["result"][0]["claims"][0]["value"] == 1.0);
}

TEST_CASE("task: a discrete controller follows its recursion") {
  // y[k+1] = a y[k] + (1 - a) 3 (1 - y[k]) with a = exp(-1/2).
  double y = 0.0;
  for (int k = 0; k < 5; ++k) y = std::exp(-0.5) * y + (1.0 - std::exp(-0.5)) * 3.0 * (1.0 - y);
  const json found =
      Client().values(diagram("1 ms", "250 ms",
                              rest(R"yaml(  error:   {block: Sum, signs: "+-", u: [1.0, plant], every: 50 ms}
  control: {block: Gain, u: error, gain: 3, every: 50 ms}
  plant:   {block: Lag, u: control, tau: 100 ms}
)yaml",
                                   "plant", "  - {that: end, final: plant, between: [0, 1]}\n")));
  CHECK(found["end"].get<double>() == Approx(y).epsilon(1e-9));
}

TEST_CASE("task: a stiff plant ends a run with rk4, and is right with rosenbrock") {
  const auto text = [](const std::string& solver) {
    return diagram(
        "1 ms", "3 s",
        rest(R"yaml(  sensor: {block: Lag, u: 1, tau: 10 us}
  heater: {block: Lag, u: sensor, tau: 0.5 s}
)yaml",
             "heater", R"yaml(  - {that: exponential, final: heater, equals: 1 - exp(-6), within: 1e-4}
)yaml"),
        solver);
  };
  const Client client;
  const json wrong = client.on_text("run", text("rk4"));
  CHECK(wrong["exit"] == 2);
  CHECK(wrong["notes"].dump().find("stiff solver") != std::string::npos);
  client.values(text("rosenbrock"));
}
