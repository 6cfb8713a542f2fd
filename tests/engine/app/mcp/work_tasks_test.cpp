// Tasks of work with diagrams that a program solves by the tools: records, sweeps, analyses, faults and their
// cures.
#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "tests/engine/app/mcp/client.hpp"

using Catch::Contains;
using nlohmann::json;

namespace {

/// An oscillator with w = 2 rad/s and damping 0.5.
const std::string oscillator = diagram("1 ms", "1 s", R"yaml(inputs: {push: {default: 0}}
outputs: {x: x}
blocks:
  spring: {block: Gain, u: x, gain: -4}
  damper: {block: Gain, u: v, gain: -2}
  net:    {block: Sum, u: [push, spring, damper]}
  v:      {block: Integrator, u: net}
  x:      {block: Integrator, u: v}
)yaml");

json linear(const Client& client, const std::string& text, const json& more) {
  const json data = client.on_text("linearize", text, more);
  INFO(data.dump(1));
  REQUIRE(data["exit"] == 0);
  return data["result"];
}

}  // namespace

TEST_CASE("task: a fit finds gain and time constant of a lag in a record") {
  const Client client;
  std::string record = "time [s],y\n";
  for (int i = 0; i <= 100; ++i)
    record += fmt::format("{},{}\n", 0.02 * i, 2.0 * (1.0 - std::exp(-0.02 * i / 0.3)));
  client.folder().file("record.csv", record);
  const json data = client.on_text("fit", diagram("10 ms", "2 s", R"yaml(parameters: {tau: 1 s, gain: 1}
fit:
  parameters:
    tau:  {start: 1 s, bounds: [0.05 s, 5 s]}
    gain: {start: 1, bounds: [0.1, 10]}
  compare:
    - {model: model, measured: measured}
blocks:
  measured: {block: FromFile, file: record.csv, column: y}
  model:    {block: Lag, u: 1, tau: $tau, gain: $gain}
record: {every: 20 ms, signals: [measured, model]}
)yaml"));
  INFO(data.dump(1));
  REQUIRE(data["exit"] == 0);
  const json& fit = data["result"][0].contains("fit") ? data["result"][0]["fit"] : data["result"][0];
  std::map<std::string, double> found;
  for (const json& one : fit["parameters"]) found[one["name"]] = one["value"];
  CHECK(found["tau"] == Approx(0.3).epsilon(1e-4));
  CHECK(found["gain"] == Approx(2.0).epsilon(1e-4));
}

TEST_CASE("task: a sweep of the gain leaves the errors 1/(1 + k)") {
  const json data = Client().on_text("run", diagram("1 ms", "5 s", R"yaml(parameters: {k: 1}
sweep: {k: {from: 1, to: 5, count: 5}, keep: final}
blocks:
  error:   {block: Sum, signs: "+-", u: [1, plant]}
  control: {block: Gain, u: error, gain: $k}
  plant:   {block: Lag, u: control, tau: 0.5 s}
record: [plant]
claims:
  - {that: error, each_run: true, final: plant - k/(1 + k), equals: 0, within: 1e-6}
)yaml"),
                                     {{"rows", 10}});
  INFO(data.dump(1));
  CHECK(data["exit"] == 0);
  CHECK(data["result"][0]["runs"] == 5);
  CHECK(data["signals"]["of"] == 5);
}

TEST_CASE("task: the margins of a loop with a delay are pi/2 - T and pi/(2 T)") {
  // L = exp(-T s)/s with T = 0.5 s.
  const json found = linear(Client(), diagram("1 ms", "1 s", R"yaml(blocks:
  late: {block: TransportDelay, u: x, delay: 0.5 s}
  back: {block: Gain, u: late, gain: -1}
  x:    {block: Integrator, u: back}
)yaml"),
                            {{"from", "back"}, {"to", "back"}, {"open", "back"}});
  INFO(found["margins"].dump(1));
  CHECK(found["margins"]["gain"]["margin"].get<double>() == Approx(M_PI).epsilon(1e-6));
  CHECK(found["margins"]["phase"]["margin"].get<double>() == Approx(M_PI / 2 - 0.5).epsilon(1e-6));
  CHECK(found["margins"]["stable"] == true);
}

TEST_CASE("task: three lags in a loop have the gain margin 8 at sqrt(3) rad/s") {
  const json found = linear(Client(), diagram("1 ms", "1 s", R"yaml(blocks:
  back: {block: Gain, u: c, gain: -1}
  a:    {block: Lag, u: back, tau: 1 s}
  b:    {block: Lag, u: a, tau: 1 s}
  c:    {block: Lag, u: b, tau: 1 s}
)yaml"),
                            {{"from", "back"}, {"to", "back"}, {"open", "back"}});
  INFO(found["margins"].dump(1));
  CHECK(found["margins"]["gain"]["margin"].get<double>() == Approx(8.0).epsilon(1e-6));
  CHECK(found["margins"]["gain"]["frequency"].get<double>() == Approx(std::sqrt(3.0)).epsilon(1e-6));
}

TEST_CASE("task: an oscillator has the poles -1 +- i sqrt(3)") {
  const json found = linear(Client(), oscillator, json::object());
  REQUIRE(found["poles"].size() == 2);
  for (const json& pole : found["poles"]) {
    CHECK(pole[0].get<double>() == Approx(-1.0).epsilon(1e-9));
    CHECK(std::abs(pole[1].get<double>()) == Approx(std::sqrt(3.0)).epsilon(1e-9));
  }
  CHECK(found["stable"] == true);
}

TEST_CASE("task: a lookup table is straight between its points and holds beyond") {
  Client().values(diagram("10 ms", "10 s", R"yaml(blocks:
  x:     {block: Ramp, slope: 1}
  curve: {block: LookupTable, u: x, points: [0, 2, 4, 7], values: [0, 5, 3, 9], extrapolation: hold}
record: [curve]
claims:
  - {that: between, at: {time: 3 s, value: curve}, equals: 4, within: 1e-12}
  - {that: beyond, final: curve, equals: 9, within: 0}
)yaml",
                          ""));
}

TEST_CASE("task: a state machine is in each state as long as its guards say") {
  const json found = Client().values(diagram("10 ms", "20 s", R"yaml(blocks:
  light:
    block: StateMachine
    u: 1
    states:
      red:   {output: 1, to: {green: after >= 3 s}}
      green: {output: 2, to: {red: after >= 1 s}}
record: [light.y]
claims:
  - {that: green, fraction: light.y > 1.5, equals: 0.25, within: 0.01}
  - {that: cycles, count: light.y > 1.5, equals: 5}
)yaml",
                                             ""));
  CHECK(found["cycles"] == 5.0);
}

TEST_CASE("task: a switch hands over a whole bus") {
  Client().values(diagram("10 ms", "2 s", R"yaml(blocks:
  cruise: {fields: {speed: {value: 2 m/s}, lights: 0}}
  crawl:  {fields: {speed: {value: 0.5 m/s}, lights: 1}}
  late:   {block: Step, time: 1 s}
  chosen: {block: Switch, control: late, threshold: 0.5, then: crawl, else: cruise}
  way:    {block: DiscreteIntegrator, u: chosen.speed}
record: [chosen, way]
claims:
  - {that: way, final: way, equals: 2.5 m, within: 0.02 m}
  - {that: lights, final: chosen.lights, equals: 1}
)yaml",
                          ""));
}

TEST_CASE("task: a part is used twice with different parameters") {
  const Client client;
  client.folder().file("filter.yaml", R"yaml(stepwire: 1
parameters: {tau: {value: 1 s, above: 0 s, doc: time constant}}
inputs: {u: {doc: signal}}
outputs: {y: lag}
blocks:
  lag: {block: Lag, u: u, tau: $tau}
)yaml");
  client.values(diagram("1 ms", "1 s", R"yaml(blocks:
  one:  {block: Constant, value: 1}
  slow: {diagram: filter.yaml, u: one}
  fast: {diagram: filter.yaml, u: one, tau: 0.1 s}
record: [slow, fast]
claims:
  - {that: slow, final: slow, equals: 1 - exp(-1), within: 1e-9}
  - {that: fast, final: fast, equals: 1 - exp(-10), within: 1e-9}
)yaml"));
}

TEST_CASE("task: a record from a CSV is played back in SI units") {
  const Client client;
  client.folder().file("way.csv", "time [s],way [mm]\n0,0\n1,10\n2,40\n");
  client.values(diagram("10 ms", "2 s", R"yaml(blocks:
  way: {block: FromFile, file: way.csv, column: way}
record: [way]
claims:
  - {that: between, at: {time: 1.5 s, value: way}, equals: 25 mm, within: 1e-9 mm}
  - {that: end, final: way, equals: 0.04 m, within: 1e-12 m}
)yaml",
                        ""));
}

TEST_CASE("task: a claim that fails is a result with its value, not an error") {
  const json result = Client().call("claims", {{"text", diagram("1 ms", "1 s", R"yaml(blocks:
  x: {block: Ramp, slope: 3 m/s}
record: [x]
claims:
  - {that: it stays below two metres, max: x, at_most: 2 m}
)yaml",
                                                                "")}});
  CHECK(result["isError"] == false);
  const json& data = result["structuredContent"];
  CHECK(data["exit"] == 1);
  const json& claim = data["result"][0]["claims"][0];
  CHECK(claim["holds"] == false);
  CHECK(claim["value"].get<double>() == Approx(3.0));
  CHECK_THAT(result["content"][0]["text"].get<std::string>(), Contains("FAILS: it stays below two metres"));
}

TEST_CASE("task: a fault of units names the wire, and a gain with the unit mends it") {
  const auto text = [](const std::string& force) {
    return diagram(
        "1 ms", "1 s",
        "blocks:\n  cart: {block: Mass, force: " + force + R"yaml(, mass: 1 kg, initial_velocity: 1 m/s}
  drag: {block: Gain, u: cart.velocity, gain: -2 N s/m}
record: [cart.velocity, drag]
claims:
  - {that: speed, final: cart.velocity, equals: exp(-2)*1 m/s, within: 1e-9 m/s}
)yaml");
  };
  const Client client;
  const json wrong = client.on_text("check", text("cart.velocity"));
  CHECK(wrong["exit"] == 2);
  const json& fault = wrong["result"][0]["faults"][0];
  CHECK(fault["line"] == 6);
  CHECK(fault["block"] == "cart");
  CHECK(fault["port"] == "force");
  CHECK_THAT(fault["text"].get<std::string>(), Contains("m/s") && Contains("N"));
  client.values(text("drag"));
}

TEST_CASE("task: an unknown block is found by the tool 'blocks'") {
  const auto text = [](const std::string& block) {
    return diagram("1 ms", "3 s",
                   "blocks:\n  plant: {block: " + block + R"yaml(, u: 1, numerator: [1], denominator: [1, 1]}
record: [plant]
claims:
  - {that: end, final: plant, equals: 1 - exp(-3), within: 1e-9}
)yaml");
  };
  const Client client;
  CHECK(client.on_text("check", text("TransferFcn"))["exit"] == 2);
  const json answer = client.call("blocks", {{"name", "TransferFcn"}});
  CHECK_THAT(answer["structuredContent"]["text"].get<std::string>(), Contains("use TransferFunction"));
  const json page = client.call("blocks", {{"name", "TransferFunction"}})["structuredContent"]["result"];
  CHECK_THAT(page.dump(), Contains("denominator"));
  client.values(text("TransferFunction"));
}

TEST_CASE("task: the difference of two texts is the changed value and its ratio") {
  const auto text = [](const std::string& gain) {
    return diagram(
        "1 ms", "1 s",
        "blocks:\n  u: {block: Clock}\n  y: {block: Gain, u: u, gain: " + gain + "}\nrecord: [y]\n", "");
  };
  const Client client;
  const auto difference = [&](const std::string& from, const std::string& to) {
    return client.call("diff", {{"text", {text(from), text(to)}}})["structuredContent"];
  };
  CHECK(difference("2", "2.0")["exit"] == 0);
  const json data = difference("2", "3");
  CHECK(data["exit"] == 1);
  const json& change = data["result"]["files"][0]["changes"][0];
  CHECK(change["name"] == "y.gain");
  CHECK(change["ratio"] == 1.5);
}

TEST_CASE("task: an integrator is reset at the instant of its threshold") {
  // A sawtooth of height 0.3: 2 s are 6 teeth and 0.2.
  Client().values(diagram("7 ms", "2.002 s", R"yaml(events: locate
blocks:
  hit: {block: Compare, u: x.before, operator: greater_equal, to: 0.3}
  x:   {block: Integrator, u: 1, reset: hit}
record: [x]
claims:
  - {that: end, final: x, equals: 0.202, within: 1e-6}
)yaml"));
}

TEST_CASE("task: rms and Fourier coefficient of a signal are those of its sine") {
  Client().values(diagram("1 ms", "10 s", R"yaml(blocks:
  x: {block: Sine, amplitude: 3, frequency: 5 Hz, bias: 1}
record: [x]
claims:
  - {that: rms, rms: x - 1, equals: 3/sqrt(2), within: 1e-3}
  - {that: coefficient, mean: "2*x*sin(2*pi*5 Hz*time)", equals: 3, within: 1e-3}
  - {that: other frequency, mean: "2*x*sin(2*pi*7 Hz*time)", equals: 0, within: 1e-3}
)yaml",
                          ""));
}

TEST_CASE("task: the mean of F/k over an even k is F ln 3 / 200") {
  Client().values(diagram("10 ms", "10 ms", R"yaml(parameters: {k: 200}
sweep:
  k: {uniform: [100, 300]}
  design: {samples: 1024, kind: sobol, seed: 3}
  keep: {rest: final(y)}
blocks:
  y: {block: Constant, value: = 10/k}
record: [y]
claims:
  - {that: mean, mean: rest, equals: 0.0549306, within: 0.1 %}
  - {that: share, fraction_of_runs: rest < 0.06, equals: 2/3, within: 0.002}
)yaml",
                          ""));
}

TEST_CASE("task: a Simulink model is imported, its report is data, and the diagram runs") {
  const Client client;
  std::filesystem::copy(STEPWIRE_SOURCE_DIR "/diagrams/tank.slx", client.folder().path("tank.slx"));
  const json folder = {{"folder", client.folder().path("")}};
  json call = folder;
  call.update({{"file", "tank.slx"}, {"out", "made/tank.yaml"}});
  const json data = client.call("import", call)["structuredContent"];
  INFO(data.dump(1));
  CHECK(data["exit"] == 1);  // an S-Function has no counterpart
  CHECK(data["result"]["translated"] == 9);
  CHECK(data["result"]["notes"][0]["kind"] == "placeholder");
  CHECK(data["result"]["files"] == json({"made/tank.yaml", "made/tank-parts/Level_sensor.yaml"}));
  json check = folder;
  check["file"] = "made/tank.yaml";
  CHECK(client.call("check", check)["structuredContent"]["exit"] == 0);
  call["out"] = "../tank.yaml";
  CHECK(client.call("import", call)["isError"] == true);
  call["out"] = "text.yaml";
  call["text"] = "stepwire: 1";
  CHECK(client.call("import", call)["isError"] == true);
}
