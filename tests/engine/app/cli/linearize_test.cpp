#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "engine/base/mat/mat_file.hpp"
#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

/// A pendulum that hangs, with a torque at its joint.
const std::string pendulum_yaml = R"(stepwire: 1
title: A pendulum
step: 1 ms
stop: 2 s
solver: rk4
inputs: {torque: {unit: N m, default: 0 N m}}
outputs: {angle: angle}
blocks:
  weight: {block: Expression, u: angle, expression: -2*sin(u1)}
  lost:   {block: Gain, u: rate, gain: -0.1}
  both:    {block: Sum, u: [torque, weight, lost]}
  turned: {block: Gain, u: both, gain: 4}
  rate:   {block: Integrator, u: turned}
  angle:  {block: Integrator, u: rate}
  drive:  {block: Constant, value: 0}
  unused: {block: Terminator, u: drive}
units: {weight: N m, lost: N m}
record: [angle]
)";

nlohmann::json json_file(const Scratch& folder, const std::string& name) {
  return nlohmann::json::parse(content_of(folder.path(name)));
}

}  // namespace

TEST_CASE("linearize writes matrices with names, poles and zeros for programs") {
  const Scratch folder;
  folder.file("a.yaml", pendulum_yaml);
  const Done done = run_program(folder, {"linearize", "a.yaml", "--at", "1 s", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("natural frequency") && Contains("gain margin"));
  const nlohmann::json found = json_file(folder, "out/linear.json");
  CHECK(found["inputs"] == nlohmann::json{"torque"});
  CHECK(found["outputs"] == nlohmann::json{"angle"});
  CHECK(found["states"].size() == 2);
  CHECK(found["sample_time"] == 0.0);
  CHECK(found["poles"][0].size() == 2);
  CHECK(found["zeros"].empty());
  double largest = 0.0;
  for (const auto& row : found["A"])
    for (const auto& number : row) largest = std::max(largest, std::abs(number.get<double>()));
  CHECK(largest == Approx(8.0).epsilon(1e-9));
  const auto table = stepwire::mat::read_mat(folder.path("out/linear.mat"));
  CHECK(table.find("A(1)") != nullptr);
}

TEST_CASE("linearize refuses names, times and files without ports with what would be right") {
  const Scratch folder;
  folder.file("a.yaml", pendulum_yaml);
  folder.file("b.yaml", "stepwire: 1\ntitle: x\nstep: 1 s\nstop: 2 s\nblocks: {c: {block: Constant}}\n");
  const Done name = run_program(folder, {"linearize", "a.yaml", "--from", "torqe", "--to", "angel"});
  CHECK(name.code == 2);
  CHECK_THAT(name.err, Contains("did you mean 'torque'") && Contains("did you mean 'angle'"));
  CHECK_THAT(run_program(folder, {"linearize", "a.yaml", "--at", "9s"}).err, Contains("from 0 to 2 s"));
  CHECK_THAT(run_program(folder, {"linearize", "a.yaml", "--at", "soon"}).err, Contains("is no time"));
  CHECK_THAT(run_program(folder, {"linearize", "b.yaml"}).err, Contains("give --from SIGNAL"));
  CHECK_THAT(run_program(folder, {"trim", "b.yaml"}).err, Contains("has no section 'trim'"));
}

TEST_CASE("trim finds a point, whose file puts a run there, and linearize takes it") {
  const Scratch folder;
  folder.file("a.yaml", pendulum_yaml +
                            "trim: {states: {angle: 0.5}, inputs: {torque: free}}\n"
                            "claims: [{that: it stands still, spread: angle, at_most: 1e-9}]\n");
  const Done done = run_program(folder, {"trim", "a.yaml", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  const nlohmann::json found = json_file(folder, "out/trim.json");
  CHECK(found["converged"] == true);
  CHECK(found["inputs"][0]["value"].get<double>() == Approx(2.0 * std::sin(0.5)).epsilon(1e-9));
  const Done run = run_program(folder, {"run", "a.yaml", "--set-from", "out/parameters.yaml"});
  INFO(run.err << run.out);
  CHECK(run.code == 0);
  const Done linear = run_program(folder, {"linearize", "a.yaml", "--trim", "--json"});
  INFO(linear.err);
  const auto point = nlohmann::json::parse(linear.out)["point"];
  CHECK(point["outputs"]["angle"].get<double>() == Approx(0.5).epsilon(1e-9));
}

TEST_CASE("a point of operation that is one of many is noted") {
  const Scratch folder;
  folder.file("a.yaml", pendulum_yaml + "trim: {inputs: {torque: free}}\n");
  const Done done = run_program(folder, {"trim", "a.yaml"});
  CHECK(done.code == 0);
  CHECK_THAT(done.out,
             Contains("note: the point is one of many, since the conditions leave 1 free number open"));
}

TEST_CASE("what follows from other signals is no input of an operating point") {
  const Scratch folder;
  folder.file("a.yaml", pendulum_yaml + "trim: {states: {angle: 0.5}, inputs: {turned: free}}\n");
  const Done done = run_program(folder, {"trim", "a.yaml"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("a.yaml:19:39: trim.inputs: 'turned' follows from other signals"));
}

TEST_CASE("a point that is not there is told, and is no point to be linearized at") {
  const Scratch folder;
  folder.file("a.yaml", pendulum_yaml +
                            "trim: {states: {angle.x: 0.5}, inputs: {torque: {bounds: [0 N m, 0.1 N "
                            "m]}}}\n");
  const Done done = run_program(folder, {"trim", "a.yaml"});
  CHECK(done.code == 1);
  CHECK_THAT(done.out, Contains("NOT found") && Contains("at its bound"));
  CHECK(run_program(folder, {"linearize", "a.yaml", "--trim"}).code == 2);
}

TEST_CASE("figures and claims read linear analyses in each run of a sweep") {
  const Scratch folder;
  folder.file("a.yaml", R"(stepwire: 1
title: A loop of three lags
step: 10 ms
stop: 1 s
solver: rk4
parameters: {gain: 2}
sweep: {gain: [2, 4, 16]}
blocks:
  error: {block: Sum, signs: "+-", u: [1, c]}
  pid:   {block: Gain, u: error, gain: $gain}
  a: {block: Lag, u: pid, tau: 1 s}
  b: {block: Lag, u: a, tau: 1 s}
  c: {block: Lag, u: b, tau: 1 s}
record: [c]
linear:
  loop: {from: error, to: c, open: error}
figure:
  - {plot: bode, of: loop}
  - {plot: bode, of: loop, where: gain == 4}
  - {panels: [{plot: nyquist, of: loop}, {plot: poles, of: loop}, {plot: root_locus, of: loop}, {plot: step_response, of: loop}]}
claims:
  - {that: the border is a gain of 8, final: loop.margin.gain*gain, equals: 8, within: 1e-9}
  - {that: "16 is beyond it", where: gain > 8, final: loop.stable, equals: 0}
  - {that: others are not, where: gain < 8, final: loop.stable, equals: 1}
  - {that: the worst run is named, final: loop.margin.gain, at_least: 100}
)");
  const Done done = run_program(folder, {"run", "a.yaml", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 1);  // by the last claim alone
  const nlohmann::json claims = json_file(folder, "out/claims.json");
  for (const std::size_t i : {0, 1, 2}) CHECK(claims[i]["holds"] == true);
  CHECK(claims[3]["worst"] == "gain=16");
  CHECK_THAT(content_of(folder.path("out/figure.svg")), Contains("frequency") && Contains("phase"));
  // With one run its margins are drawn, 20 log10(8 / 4) dB; with three none.
  CHECK_THAT(content_of(folder.path("out/figure.svg")), !Contains("6.02 dB"));
  CHECK_THAT(content_of(folder.path("out/figure-2.svg")), Contains("6.02 dB"));
  CHECK(std::filesystem::exists(folder.path("out/figure-3.svg")));
}

TEST_CASE("numbers of an analysis have the unit that its picture draws, and ratios are no angles") {
  const Scratch folder;
  const auto file_of = [](const std::string& claims) {
    return R"(stepwire: 1
title: A lag
step: 10 ms
stop: 1 s
solver: rk4
blocks:
  u: {block: Constant, value: 1}
  lag: {block: Lag, u: u, tau: 0.5 s}
record: [lag]
linear: {p: {from: u, to: lag}}
figure: {plot: lines, x: p.pole.real in 1/s, y: p.pole.imaginary in rad/s}
claims:
)" + claims;
  };
  folder.file("a.yaml",
              file_of("  - {that: fast, max: p.pole.real, at_most: -1 1/s}\n"
                      "  - {that: one pole, final: p.pole.real in 1/s, equals: -2 1/s, within: 1 %}\n"
                      "  - {that: phase, min: p.phase, at_least: -90 deg}\n"));
  const Done done = run_program(folder, {"run", "a.yaml", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  folder.file("b.yaml", file_of("  - {that: a, final: p.margin.gain_db, at_least: 6 deg}\n"
                                "  - {that: b, final: p.damping, at_least: 5 deg}\n"
                                "  - {that: c, final: p.margin.phase, at_least: 5 %}\n"));
  const Done refused = run_program(folder, {"check", "b.yaml"});
  CHECK_THAT(refused.err + refused.out, Contains("6 deg is in deg, but the claim's value has no unit") &&
                                            Contains("5 deg is in deg, but the claim's value has no unit") &&
                                            Contains("5 % is a share, but the claim's value is an angle"));
}

TEST_CASE("crossings of a delay beyond the listed ones are mentioned in the text and in linear.json") {
  const Scratch folder;
  folder.file("a.yaml", R"(stepwire: 1
title: A fast lag behind a delay
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  e: {block: Sum, signs: "+-", u: [1, y]}
  a: {block: Lag, u: e, tau: 10 ms, gain: 100}
  y: {block: TransportDelay, u: a, delay: 310 ms}
record: [e, y]
)");
  const Done done =
      run_program(folder, {"linearize", "a.yaml", "--from", "e", "--to", "e", "--open", "e", "--out", "out"});
  INFO(done.err << done.out);
  CHECK_THAT(done.out, Contains("crossings beyond") && Contains("rad/s are not listed"));
  const nlohmann::json margins = json_file(folder, "out/linear.json")["channels"][0]["margins"];
  CHECK(margins["gain_crossings_up_to"].get<double>() > 1e4);
  CHECK(margins["gain_crossings_left_out"] == 0);
  CHECK(margins["gain_crossings"].size() > 494);
}

TEST_CASE("legends of linear analyses have the unit of the file, as those of lines") {
  const Scratch folder;
  folder.file("a.yaml", R"(stepwire: 1
title: A lag of two time constants
step: 1 ms
stop: 100 ms
solver: rk4
parameters: {tau: 0.1 s}
sweep: {tau: [50 ms, 200 ms]}
blocks:
  u: {block: Constant, value: 20 mm}
  lag: {block: Lag, u: u, tau: $tau}
record: [lag]
linear: {p: {from: u, to: lag}}
figure:
  - {plot: bode, of: p}
  - {plot: nyquist, of: p}
  - {plot: step_response, of: p}
  - {plot: poles, of: p}
  - {plot: root_locus, of: p}
  - {plot: lines, x: time, y: lag, by: tau}
)");
  const Done done = run_program(folder, {"run", "a.yaml", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  for (const char* file : {"figure", "figure-2", "figure-3", "figure-4", "figure-5", "figure-6"}) {
    INFO(file);
    const std::string json = content_of(folder.path(std::string("out/") + file + ".json"));
    CHECK_THAT(json, Contains("tau = 50 ms") && Contains("tau = 200 ms"));
  }
}

TEST_CASE("a number of each run is drawn over a parameter as points") {
  const Scratch folder;
  folder.file("a.yaml", R"(stepwire: 1
title: A lag of two time constants
step: 1 ms
stop: 100 ms
solver: rk4
parameters: {tau: 0.1 s}
sweep: {tau: [50 ms, 200 ms]}
blocks:
  u: {block: Constant, value: 1}
  lag: {block: Lag, u: u, tau: $tau}
record: [lag]
linear: {p: {from: u, to: lag}}
figure:
  - {plot: lines, x: tau, y: p.bandwidth}
  - {plot: lines, x: tau, y: p.margin.phase}
)");
  const Done done = run_program(folder, {"run", "a.yaml", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  const nlohmann::json points = json_file(folder, "out/figure.json")["panels"][0]["marks"][0];
  INFO(points.dump());
  CHECK(points["dots"].get<double>() > 0.0);
  CHECK(points["curves"].size() == 2);
  CHECK(points["curves"][0]["x"].size() == 1);
  CHECK(points["curves"][0]["y"][0].get<double>() == Approx(20.0));
  CHECK_THAT(content_of(folder.path("out/figure-2.json")), Contains("no rows to draw"));
}

TEST_CASE("equal poles are one line, and of many singular values the first are printed") {
  const Scratch folder;
  folder.file("a.yaml", R"(stepwire: 1
title: A delayed loop
step: 1 ms
stop: 10 ms
inputs: {r: {default: 1}}
outputs: {y: y}
blocks:
  y: {block: Delay, u: r, delay: 20 ms}
record: [y]
)");
  const Done done = run_program(folder, {"linearize", "a.yaml"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  CHECK_THAT(done.out,
             Contains("0 (20 times)  inf rad/s") &&
                 Contains("20 states of 20 are controllable (singular values 1, 1, 1, 1, 1, 1, 1, 1 "
                          "and 12 others)"));
}

TEST_CASE("figures of poles, loci, circles and steps have no logarithmic axes") {
  for (const std::string kind : {"poles", "root_locus", "nyquist", "step_response"}) {
    const Scratch folder;
    folder.file("a.yaml", pendulum_yaml + "linear: {loop: {from: torque, to: angle}}\nfigure: {plot: " +
                              kind + ", of: loop, log: x}\n");
    const Done done = run_program(folder, {"run", "a.yaml"});
    CHECK(done.code == 2);
    CHECK_THAT(done.err, Contains("a plot '" + kind + "' has no 'log'; it has: plot, of, "));
  }
}
