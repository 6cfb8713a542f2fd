#include "engine/analyse/linear/linearize.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "blocks/register.hpp"
#include "engine/analyse/linear/analysis.hpp"
#include "engine/analyse/linear/frequency_response.hpp"
#include "tests/support/plan_text.hpp"

using Catch::Contains;

namespace stepwire::linear {

namespace {

const std::string cart = R"(step: 1 ms
stop: 3 s
solver: rk4
inputs:
  push: {unit: N, default: 0 N}
blocks:
  spring: {block: Gain, u: cart.position, gain: -400 N/m}
  damper: {block: Gain, u: cart.velocity, gain: -3 N s/m}
  sum: {block: Sum, u: [spring, damper, push]}
  cart: {block: Mass, force: sum, mass: 2 kg, initial_position: 20 mm}
)";

Linearization linear(const std::string& yaml, std::vector<std::string> from, std::vector<std::string> to,
                     std::vector<std::string> open = {}, double time = 0.0) {
  const DiagramFolder folder;
  folder.write("a.yaml", "stepwire: 1\ntitle: x\n" + yaml);
  diagram::Loader loader(library());
  Request request;
  for (auto& name : from) request.from.push_back({std::move(name), {"call", {}}, "from"});
  for (auto& name : to) request.to.push_back({std::move(name), {"call", {}}, "to"});
  for (auto& name : open) request.open.push_back({std::move(name), {"call", {}}, "open"});
  request.time = time;
  return linearize(loader.load(folder.path("a.yaml")), request);
}

bool mentions(const Linearization& result, const std::string& text) {
  return std::ranges::any_of(result.notes,
                             [&](const std::string& note) { return note.find(text) != note.npos; });
}

}  // namespace

TEST_CASE("a cart on a spring has the matrices of its equations, at any time of its run") {
  for (const double time : {0.0, 0.7}) {
    const Linearization cart_at = linear(cart, {"push"}, {"cart.position"}, {}, time);
    const StateSpace& system = cart_at.system;
    REQUIRE(system.states.size() == 2);
    CHECK(system.states[0].name == "cart.position");
    CHECK(system.states[0].unit == "m");
    CHECK(system.states[1].unit == "m/s");
    CHECK(system.inputs[0].unit == "N");
    Eigen::Matrix2d A;
    A << 0, 1, -200, -1.5;
    CHECK(system.A.isApprox(A, 1e-11));
    CHECK(system.B.isApprox(Eigen::Vector2d(0, 0.5), 1e-11));
    CHECK(system.C.isApprox(Eigen::RowVector2d(1, 0), 1e-11));
    CHECK(system.D(0, 0) == 0.0);
    CHECK(system.sample_time == 0.0);
    CHECK(cart_at.error.A.cwiseAbs().maxCoeff() < 1e-6);
    CHECK(mentions(cart_at, "no equilibrium"));
  }
}

TEST_CASE("a delay beside an integrator leaves the equations of the integrator as they are") {
  const std::string yaml = R"(step: 10 ms
stop: 1 s
solver: rk4
blocks:
  e: {block: Constant, value: 0}
  p: {block: TransferFunction, u: e, numerator: [1], denominator: [1, 2, 1]}
  late: {block: TransportDelay, u: p, delay: 0.1 s}
  b: {block: Integrator, u: p}
)";
  const StateSpace system = linear(yaml, {"e"}, {"b"}).system;
  REQUIRE(system.states.size() == 3);
  Eigen::Matrix3d A;
  A << -2, -1, 0, 1, 0, 0, 0, 1, 0;
  CHECK(system.A.isApprox(A, 1e-11));
}

TEST_CASE("a system has the same matrices with every solver") {
  for (const std::string solver :
       {"euler", "rk4", "dop853", "radau", "rodas", "auto", "{name: sdirk, relative: 1e-6}",
        "{name: rosenbrock, relative: 1e-6, absolute: 1e-9}", "{name: dormand_prince, relative: 1e-8}"}) {
    INFO(solver);
    const StateSpace system = linear("step: 10 ms\nstop: 1 s\nsolver: " + solver + R"(
blocks:
  e: {block: Constant, value: 0}
  g: {block: Lag, u: e, gain: 3, tau: 0.5 s}
)",
                                     {"e"}, {"g"})
                                  .system;
    CHECK(system.A(0, 0) == Approx(-2.0).epsilon(1e-11));
    CHECK(system.B(0, 0) * system.C(0, 0) == Approx(6.0).epsilon(1e-11));
  }
}

TEST_CASE("something is added to a wire, and a cut wire gives the loop") {
  // Around the spring: its force comes back over the cart.
  const Linearization loop = linear(cart, {"spring"}, {"spring"}, {"spring"});
  CHECK(loop.feedback == 1.0);
  CHECK(loop.system.A(1, 0) == 0.0);
  CHECK(loop.system.B(1, 0) == Approx(0.5));
  CHECK(loop.system.C(0, 0) == Approx(-400.0));
  const Analysis analysis = analyse(loop);
  CHECK(analysis.channels[0].margins.stable);
  CHECK(analysis.channels[0].margins.closed_poles[0].imag() ==
        Approx(std::sqrt(200.0 - 0.75 * 0.75)).epsilon(1e-9));
  // Closed, what is added shows behind the place where it is added: the sensitivity 1/(1 + L).
  const Linearization closed = linear(cart, {"spring"}, {"spring"});
  CHECK(closed.system.D(0, 0) == Approx(1.0));
  CHECK(closed.system.A(1, 0) == Approx(-200.0));
  CHECK(closed.feedback == -1.0);
}

TEST_CASE("an element of a vector is an input or output by its number, the whole vector all of them") {
  const std::string two = R"(step: 1 ms
stop: 1 s
solver: rk4
blocks:
  c: {block: Constant, value: [1, 2]}
  x: {block: Integrator, u: c}
  s: {block: Sum, u: [x, x]}
)";
  const Linearization all = linear(two, {"c"}, {"s"});
  REQUIRE(all.system.inputs.size() == 2);
  CHECK(all.system.inputs[1].name == "c.2");
  CHECK(all.system.B.isApprox(Eigen::Matrix2d::Identity(), 1e-12));
  const Linearization one = linear(two, {"c.2"}, {"s.2"});
  CHECK(one.system.B.isApprox(Eigen::Vector2d(0, 1), 1e-12));
  CHECK(one.system.C.isApprox(Eigen::RowVector2d(0, 2), 1e-12));
  CHECK_THROWS_WITH(linear(two, {"c.3"}, {"s"}), Contains("'c.3' has") || Contains("c.3"));
}

TEST_CASE("names that are not there have the nearest one as a cure") {
  CHECK_THROWS_WITH(linear(cart, {"pusch"}, {"cart.position"}), Contains("did you mean 'push'"));
  CHECK_THROWS_WITH(linear(cart, {"push"}, {"cart.positon"}), Contains("did you mean 'cart.position'"));
  CHECK_THROWS_WITH(linear(cart, {"push"}, {"cart"}, {"sprin"}), Contains("did you mean 'spring'"));
  CHECK_THROWS_WITH(linear(cart, {"push"}, {"cart.position"}, {}, 9.0), Contains("goes from 0 to 3 s"));
}

TEST_CASE("a sampled loop is the map of one base period, of several rates their least common multiple") {
  // x' = -x + u over 20 ms of a hold, by the diagram's own rk4: the exponential to its last digits.
  const std::string loop = R"(step: 1 ms
stop: 1 s
solver: rk4
inputs:
  r: {default: 0}
blocks:
  hold: {block: ZeroOrderHold, u: r, every: 20 ms}
  plant: {block: Lag, u: hold, tau: 1 s}
)";
  const Linearization one = linear(loop, {"r"}, {"plant"});
  CHECK(one.system.sample_time == Approx(0.02));
  REQUIRE(one.system.states.size() == 1);
  CHECK(one.system.A(0, 0) == Approx(std::exp(-0.02)).epsilon(1e-12));
  CHECK(one.system.B(0, 0) == Approx(1.0 - std::exp(-0.02)).epsilon(1e-9));
  CHECK_THAT(one.method, Contains("0.02 s") && Contains("rk4"));
  const Linearization two =
      linear(loop + "  slow: {block: UnitDelay, u: plant, every: 30 ms}\n", {"r"}, {"slow"});
  CHECK(two.system.sample_time == Approx(0.06));
  CHECK(two.system.states.size() == 2);
}

TEST_CASE("delays are states in the order of their age, at any phase of their memory") {
  const std::string delayed = R"(step: 10 ms
stop: 1 s
inputs:
  r: {default: 1}
blocks:
  d: {block: Delay, u: r, delay: 50 ms}
)";
  for (const double time : {0.0, 0.03}) {
    const Linearization found = linear(delayed, {"r"}, {"d"}, {}, time);
    REQUIRE(found.system.states.size() == 5);
    const Analysis analysis = analyse(found);
    for (const Mode& mode : analysis.modes) CHECK(mode.pole == 0.0);
    const FrequencyResponse response(found.system);
    for (const double w : {1.0, 20.0, 200.0})
      CHECK(std::abs(response.at(w) - std::polar(1.0, -w * 0.05)) < 1e-12);
  }
}

TEST_CASE("memory that each update overwrites is no state") {
  const Linearization found = linear(R"(step: 10 ms
stop: 1 s
inputs:
  r: {default: 1}
blocks:
  x: {block: DiscreteStateSpace, u: r, A: [[0.5, 0.1], [0, 0.6]], B: [[0], [2]], C: [[1, 0]]}
)",
                                     {"r"}, {"x"});
  REQUIRE(found.system.states.size() == 2);
  CHECK(found.system.A.isApprox(Eigen::Matrix2d{{0.5, 0.1}, {0.0, 0.6}}, 1e-12));
  CHECK(found.system.B.isApprox(Eigen::Vector2d(0.0, 2.0), 1e-12));
  CHECK(analyse(found).controllable.rank == 2);
  CHECK(analyse(found).channels[0].gain_at_rest == Approx(2.0 * 0.1 / 0.5 / 0.4));
}

TEST_CASE("a discrete PID has the transfer function of its recursion") {
  // scipy: none needed; y = kp u + ki T/(z - 1) u, forward Euler or trapezoid: a pole at 1 in each case.
  const Linearization pid = linear(R"(step: 1 ms
stop: 1 s
inputs:
  e: {default: 0}
blocks:
  c: {block: DiscretePID, u: e, kp: 2, ki: 10 1/s, every: 10 ms}
)",
                                   {"e"}, {"c"});
  const Analysis analysis = analyse(pid);
  const auto at_one =
      std::ranges::count_if(analysis.modes, [](const Mode& m) { return std::abs(m.pole - 1.0) < 1e-12; });
  CHECK(at_one == 1);
  const FrequencyResponse response(pid.system);
  CHECK(std::abs(response.at(1e-3)) == Approx(10.0 / 1e-3).epsilon(1e-3));
}

TEST_CASE("at the first instant, too, a linear analysis sees the derivative part") {
  const std::complex<double> s(0.0, 7.0);
  const auto response = [](const std::string& block) {
    return FrequencyResponse(
               linear("step: 1 ms\nstop: 1 s\nsolver: rk4\ninputs:\n  e: {default: 3}\nblocks:\n  c: " +
                          block + "\n",
                      {"e"}, {"c"})
                   .system)
        .at(7.0);
  };
  CHECK(std::abs(response("{block: Derivative, u: e, tau: 20 ms}") - s / (0.02 * s + 1.0)) < 1e-9);
  CHECK(std::abs(response("{block: PID, u: e, kp: 2, ki: 3, kd: 0.5, tau: 20 ms}") -
                 (2.0 + 3.0 / s + 0.5 * s / (0.02 * s + 1.0))) < 1e-9);
  // D = (1 - 1/z) / ((tau + T) - tau/z), I = ki T / (z - 1)
  const std::complex<double> z = std::exp(0.01 * s);
  CHECK(std::abs(response("{block: DiscretePID, u: e, kp: 2, ki: 3, kd: 0.5, tau: 20 ms, every: 10 ms}") -
                 (2.0 + 0.03 / (z - 1.0) + 0.5 * (1.0 - 1.0 / z) / (0.03 - 0.02 / z))) < 1e-9);
}

TEST_CASE("limits, play and friction at the point are told") {
  const auto with = [](const std::string& block) {
    return linear("step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  c: {block: Constant, value: 1}\n  s: " +
                      block + "\n  x: {block: Integrator, u: s}\n",
                  {"c"}, {"x"});
  };
  CHECK(mentions(with("{block: Saturation, u: c, lower: -1, upper: 1}"), "not smooth"));
  CHECK_FALSE(mentions(with("{block: Saturation, u: c, lower: -2, upper: 2}"), "not smooth"));
  CHECK(mentions(with("{block: Quantizer, u: c, interval: 1e-5}"), "sizes disagree"));
}

TEST_CASE("a transport delay among continuous blocks is exact, wherever it lies") {
  const std::string diagram = R"(step: 1 ms
stop: 1 s
solver: rk4
inputs: {push: {default: 0}}
blocks:
  sum: {block: Sum, signs: "+-", u: [push, late]}
  lag: {block: Lag, u: sum, tau: 0.5 s}
  late: {block: TransportDelay, u: lag, delay: 0.3 s}
  shown: {block: TransportDelay, u: lag, delay: 0.1 s}
)";
  const auto response = [&](const std::string& to, double w) {
    return FrequencyResponse(linear(diagram, {"push"}, {to}, {}, 0.2).system).at(w);
  };
  for (const double w : {0.1, 3.0, 40.0}) {
    const std::complex<double> s(0.0, w), lag = 1.0 / (0.5 * s + 1.0),
                                          loop = lag / (1.0 + lag * std::exp(-0.3 * s));
    CHECK(std::abs(response("lag", w) - loop) < 1e-9);
    CHECK(std::abs(response("late", w) - loop * std::exp(-0.3 * s)) < 1e-9);
    CHECK(std::abs(response("shown", w) - loop * std::exp(-0.1 * s)) < 1e-9);
  }
  const Linearization at_delay = linear(diagram, {"late"}, {"late"}, {"late"});
  const std::complex<double> s(0.0, 2.0);
  CHECK(std::abs(FrequencyResponse(at_delay.system.channel(0, 0)).at(2.0) +
                 std::exp(-0.3 * s) / (0.5 * s + 1.0)) < 1e-9);
}

namespace {

/// An exact delay with names of its own.
struct Pipe {
  Input<1> flow{}, travel{};
  Output<1> end{};
  void outputs() { end = 0.0; }
  static void declare(Declare<Pipe>& is) {
    is.block("Pipe", {.doc = "a test", .timing = Timing::continuous, .delayed_by = "travel"});
    is.input<&Pipe::flow>({.doc = "flow into the pipe", .feedthrough = false});
    is.input<&Pipe::travel>({.unit = "s", .doc = "time in the pipe", .feedthrough = false});
    is.output<&Pipe::end>({.doc = "flow at the end"});
  }
};

}  // namespace

TEST_CASE("any block type that declares a delay time is an exact delay") {
  Registry types = blocks();
  types.add<Pipe>("test");
  const DiagramFolder folder;
  folder.write("a.yaml",
               "stepwire: 1\ntitle: x\nstep: 1 ms\nstop: 1 s\nsolver: rk4\ninputs: {push: {default: 0}}\n"
               "blocks:\n  lag: {block: Lag, u: push, tau: 0.5 s}\n"
               "  pipe: {block: Pipe, flow: lag, travel: 0.3 s}\n");
  diagram::Loader loader(types);
  Request request;
  request.from = {{"push", {"call", {}}, "from"}};
  request.to = {{"pipe", {"call", {}}, "to"}};
  const Linearization result = linearize(loader.load(folder.path("a.yaml")), request);
  REQUIRE(result.system.delays.size() == 1);
  CHECK(result.system.delays[0].out.name == "pipe.flow");
  CHECK(result.system.delays[0].in.name == "pipe.end");
  const std::complex<double> s(0.0, 7.0);
  CHECK(std::abs(FrequencyResponse(result.system).at(7.0) - std::exp(-0.3 * s) / (0.5 * s + 1.0)) < 1e-9);
}

TEST_CASE("a point beyond the end of the run is refused with the cure") {
  CHECK_THROWS_WITH(linear(cart, {"push"}, {"cart.position"}, {}, 4.0),
                    Contains("4 s is not within the run; it goes from 0 to 3 s") &&
                        Contains("give a time within it, or a later 'stop'"));
  CHECK_THROWS_WITH(linear(cart + "stop_when: cart.position < 0 m\n", {"push"}, {"cart.position"}, {}, 2.0),
                    Contains("'stop_when' ends it at") && Contains("give an earlier time"));
}

TEST_CASE("a transport delay beside blocks that act at ticks is refused with the block that is right there") {
  CHECK_THROWS_WITH(linear(R"(step: 1 ms
stop: 1 s
solver: rk4
inputs: {push: {default: 0}}
blocks:
  held: {block: Gain, gain: 2, u: push, every: 10 ms}
  late: {block: TransportDelay, u: held, delay: 0.3 s}
)",
                           {"push"}, {"late"}),
                    Contains("late: TransportDelay cannot be linearised here") && Contains("put a Delay"));
}

TEST_CASE("a delay of too many samples for matrices is refused at its block") {
  const std::string loop =
      "step: 1 ms\nstop: 10 s\ninputs: {u: {unit: \"1\", default: 0}}\nblocks:\n"
      "  late: {block: Delay, u: u, delay: 5 s, every: 1 ms}\n";
  CHECK_THROWS_WITH(linear(loop, {"u"}, {"late"}),
                    Contains("a.yaml:7:") && Contains("late: a linear system") &&
                        Contains("at most 4000 states") && Contains("a longer period 'every'"));
}

TEST_CASE("a time between two ticks is refused with both") {
  CHECK_THROWS_WITH(linear(cart, {"push"}, {"cart.position"}, {}, 0.0004),
                    Contains("0.0004 s is between two ticks, which are 0.001 s apart; write 0 s or 0.001 s"));
  const std::string sampled =
      "step: 10 ms\nstop: 1 s\nsolver: rk4\nblocks:\n"
      "  u: {block: Constant, value: 1}\n  x: {block: UnitDelay, u: u, every: 30 ms}\n"
      "  y: {block: UnitDelay, u: x, every: 20 ms}\n";
  CHECK(linear(sampled, {"u"}, {"y"}, {}, 0.12).time == Approx(0.12));
  CHECK_THROWS_WITH(
      linear(sampled, {"u"}, {"y"}, {}, 0.1),
      Contains("common ticks of the blocks that act at ticks, which are 0.06 s apart; write 0.06 s or "
               "0.12 s"));
  CHECK_THROWS_WITH(linear(sampled, {"u"}, {"y"}, {}, 1.0),
                    Contains("apart; write 0.96 s") && !Contains(" or "));
}

TEST_CASE("a delay beside the way from an input to an output is no obstacle") {
  const std::string text =
      "step: 10 ms\nstop: 1 s\nsolver: rk4\nblocks:\n"
      "  u: {block: Constant, value: 1}\n  x: {block: UnitDelay, u: u, every: 10 ms}\n"
      "  y: {block: Gain, u: x, gain: 3}\n"
      "  late: {block: TransportDelay, u: x, delay: 50 ms}\n  z: {block: Gain, u: late, gain: 2}\n";
  const Linearization found = linear(text, {"u"}, {"y"});
  CHECK(found.system.C(0, 0) * found.system.B(0, 0) == Approx(3.0));
  CHECK(mentions(found, "without states here: late"));
  CHECK_THROWS_WITH(linear(text, {"u"}, {"z"}), Contains("TransportDelay cannot be linearised here"));
}

TEST_CASE("a pole at rest off the way counts nowhere, and one on the way everywhere") {
  const auto found = [](const std::string& matrices) {
    return analyse(
        linear("step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  r: {block: Constant, value: 0}\n"
               "  g: {block: StateSpace, u: r, " +
                   matrices + ", D: [[0]]}\n",
               {"r"}, {"g"}));
  };
  const Analysis off = found("A: [[-1, 0], [1, 0]], B: [[1], [0]], C: [[2, 0]]");
  CHECK(off.stability.stable);
  CHECK(off.channels[0].margins.stable);
  CHECK(std::ranges::any_of(off.notes,
                            [](const std::string& note) { return note.find("at rest") != note.npos; }));
  // 1/s - (1 - s)/(s (s + 1)) = 2/(s + 1): both states are on the way, and the pole at 0 is cancelled.
  const Analysis cancelled = found("A: [[0, 0], [1, -1]], B: [[1], [-1]], C: [[1, -1]]");
  CHECK_FALSE(cancelled.stability.stable);
  CHECK_FALSE(cancelled.channels[0].margins.stable);
  const Analysis grows = found("A: [[-1, 0], [1, 0.5]], B: [[1], [0]], C: [[2, 0]]");
  CHECK_FALSE(grows.stability.stable);
  REQUIRE(grows.stability.hidden);
  CHECK(grows.stability.hidden->real() == Approx(0.5));
  CHECK_FALSE(grows.channels[0].margins.stable);
}

}  // namespace stepwire::linear
