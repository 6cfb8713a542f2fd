#include <catch2/catch.hpp>

#include "blocks/register.hpp"
#include "engine/model/block/declare.hpp"
#include "engine/model/block/registry.hpp"
#include "engine/model/diagram/flatten.hpp"
#include "engine/model/diagram/units.hpp"
#include "tests/engine/model/diagram/units_of.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::diagram {

namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;
const std::string pendulum =
    "step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  hold: {block: Mass, mass: 1 kg, force: 1 N}\n  x: "
    "{block: Ramp, slope: 1 mm/s}\n  theta: {block: Ramp, slope: 2 deg/s}\n"
    "  y: {block: Mux, u: [x, theta]}\n";

/// The last row of the recorded columns, after the time.
std::vector<double> last_row(const std::string& text, const std::vector<Setting>& settings = {}) {
  const auto result = result_of(text, settings);
  std::vector<double> row;
  const auto& columns = result.recordings.at(0).table.columns;
  for (std::size_t c = 1; c < columns.size(); ++c) row.push_back(columns[c].values.back());
  return row;
}

/// A block of a user: the sum of the elements of a vector.
struct TotalLoad {
  Input<> u{};
  Output<1> y{};

  void outputs() {
    double sum = 0.0;
    for (Index k = 0; k < u.size(); ++k) sum += u[k];
    y = sum;
  }
  static void declare(Declare<TotalLoad>& is);
};

void TotalLoad::declare(Declare<TotalLoad>& is) {
  is.block("TotalLoad", {.doc = "Sum of the elements."});
  is.input<&TotalLoad::u>({.unit = "'u", .doc = "vector", .one_unit = true});
  is.output<&TotalLoad::y>({.unit = "'u", .doc = "sum"});
}

}  // namespace

TEST_CASE("a list of numbers has a unit for each element, in SI") {
  const std::string constant = pendulum + "  c: {block: Constant, value: [5 mm, 20 deg, 3]}\nrecord: [c]\n";
  CHECK(units_of(constant, "c") == "m, rad, ?");
  const auto row = last_row(constant);
  REQUIRE(row.size() == 3);
  CHECK(row[0] == 5e-3);
  CHECK(row[1] == Approx(20.0 * degree).epsilon(1e-15));
  CHECK(row[2] == 3.0);
  CHECK(units_of(pendulum + "  g: {block: Gain, u: y, gain: [2 N/mm, 3 N m/deg]}\n", "g") == "N, N m");
}

TEST_CASE("limits, initial values and wires of several units fit the elements of their signal") {
  const std::string limited =
      pendulum + "  s: {block: Saturation, u: y, lower: [-1 mm, -1 deg], upper: [0.5 mm, 1 deg]}\n" +
      "  i: {block: Integrator, u: [1 mm/s, 2 deg/s], initial: [1 mm, 10 deg]}\nrecord: [s, i]\n";
  CHECK(units_of(limited, "s") == "m, rad");
  CHECK(units_of(limited, "i") == "m, rad");
  const auto row = last_row(limited);
  REQUIRE(row.size() == 4);
  CHECK(row[0] == Approx(0.5e-3));
  CHECK(row[1] == Approx(degree));
  CHECK(row[2] == Approx(2e-3));
  CHECK(row[3] == Approx(12.0 * degree));
}

TEST_CASE("an element in another unit than its place is refused with its number") {
  CHECK(
      faults_of(pendulum + "  s: {block: Saturation, u: y, upper: [1 mm, 2 N]}\n") ==
      std::vector<std::string>{"test.yaml:9:39: s.upper: element 2 is in N, but that of s.upper is in rad"});
  CHECK(faults_of(pendulum + "  l: {block: UnitDelay, u: y, every: 1 ms, initial: [1 s, 2 deg]}\n") ==
        std::vector<std::string>{
            "test.yaml:9:53: l.initial: element 1 is in s, but that of l.initial is in m"});
  CHECK(faults_of(pendulum + "  m: {block: Mass, mass: [2 kg, 3 N], force: [1 N, 1 N]}\n") ==
        std::vector<std::string>{"test.yaml:9:33: m.mass: element 2 of the list is in N; it must be in kg"});
  CHECK(faults_of(pendulum + "  t: {block: LookupTable, u: x, points: [0 mm, 3 s], values: [1 N, 2 N]}\n") ==
        std::vector<std::string>{"test.yaml:9:48: t.points: element 2 of the list is in s; it must be in m"});
  CHECK(faults_of(pendulum + "  c: {block: Constant, value: [5 mm, 20 degC]}\n") ==
        std::vector<std::string>{"test.yaml:9:31: c.value: has a temperature in degC beside elements in "
                                 "other units; write it in K"});
  CHECK(faults_of(pendulum + "  c: {block: Constant, value: {value: [5 mm, 2 N], unit: m}}\n").at(0) ==
        "test.yaml:9:58: c.value: the numbers have units already; leave the key 'unit' out, or write the "
        "numbers alone");
}

TEST_CASE("a number over a unit is answered with the number and its unit") {
  CHECK(faults_of(pendulum + "  g: {block: Gain, u: x, gain: 50/s}\n").at(0) ==
        "test.yaml:9:32: g.gain: there is no parameter 's'; a number with its unit is written '50 1/s'");
}

TEST_CASE("a parameter of several units passes them on, whole and by element") {
  const std::string text = "parameters: {start: [1 mm, 20 deg], first: = start.1}\n" + pendulum +
                           "  i: {block: Integrator, u: [1 mm/s, 2 deg/s], initial: $start}\n"
                           "  c: {block: Constant, value: $first}\nrecord: [i, c]\n";
  CHECK(units_of(text, "i") == "m, rad");
  CHECK(units_of(text, "c") == "m");
  CHECK(plan_text(text).diagram.parameters.at(0).text == "[1 mm, 20 deg]");
  CHECK(last_row(text)[2] == Approx(1e-3));
  const auto set = last_row(text, {{"start", "[2 mm, 30 deg]"}});
  CHECK(set[0] == Approx(3e-3));
  CHECK(set[1] == Approx(32.0 * degree));
  CHECK(set[2] == Approx(2e-3));
  CHECK(faults_of(text, {{"start", "[2 mm, 3 N]"}})
            .at(0)
            .ends_with("start: element 2 of the list is in N; it must be in rad"));
  CHECK(faults_of(text, {{"start", "[2 mm, 3 deg, 1 N]"}})
            .at(0)
            .ends_with("start: the list must have 2 elements, since the file gives one unit for each"));
  CHECK(last_row(text, {{"i.initial", "[0, 0]"}})[0] == Approx(1e-3));
}

TEST_CASE("a formula of a list of several units is refused, but for the list itself and its elements") {
  const auto with = [](const std::string& formula) {
    return "parameters: {k: [2 mm, 20 deg], d: '= " + formula + "'}\n" + pendulum +
           "  c: {block: Constant, value: $d}\nrecord: [c]\n";
  };
  CHECK(units_of(with("k"), "c") == "m, rad");
  CHECK(last_row(with("2*k.1"))[0] == Approx(4e-3));
  for (const char* formula : {"k + 1", "2*k", "k*k.1", "norm(k)"}) {
    INFO(formula);
    CHECK_THAT(faults_of(with(formula)).at(0), Catch::Contains("a list whose elements have several units"));
  }
}

TEST_CASE("a sweep of lists of several units runs each with its numbers") {
  const DiagramFolder folder;
  folder.write("sweep.yaml",
               "stepwire: 1\ntitle: t\nparameters: {start: [1 mm, 20 deg]}\n"
               "sweep: {start: [[2 mm, 0 deg], [3 mm, 30 deg]]}\n" +
                   pendulum + "  c: {block: Constant, value: $start}\nrecord: [c]\n");
  Loader loader(library());
  const auto result = run::run_job(run::make_job(loader, folder.path("sweep.yaml")), {});
  const auto& table = result.recordings.at(0).table;
  const auto& first = table.find("c.1")->values;
  CHECK(first.front() == Approx(2e-3));
  CHECK(first.back() == Approx(3e-3));
  CHECK(table.find("c.2")->values.back() == Approx(30.0 * degree));
}

TEST_CASE("a flattened diagram has the unit of each element, and reads back to the same numbers") {
  const plan::Plan plan =
      plan_text(pendulum + "  c: {block: Constant, value: [5 mm, 0.5 rad]}\n" +
                "  i: {block: Integrator, u: [1 mm/s, 2 rad/s], initial: [1 mm, 1 rad]}\n");
  const std::string text = flattened_text(plan.diagram);
  CHECK_THAT(text, Catch::Contains("c: {block: Constant, value: [0.005 m, 0.5 rad]}"));
  CHECK_THAT(text, Catch::Contains("u: [0.001 m/s, 2 rad/s], initial: [0.001 m, 1 rad]"));
  Loader loader(library());
  const plan::Plan again = plan::make_plan(loader.load_text(text, "flattened.yaml"));
  CHECK(units_of(again, "i") == "m, rad");
  CHECK(flattened_text(again.diagram) == text);
}

TEST_CASE("a block may declare that the elements of an input have one unit") {
  CHECK(
      faults_of(pendulum + "  n: {block: Norm, u: [1 mm, 2 deg]}\n") ==
      std::vector<std::string>{"test.yaml:9:23: n.u: the list has elements in m and rad, and Norm takes one "
                               "unit; give them one, as by a Gain for each"});
  CHECK(faults_of(pendulum + "  d: {block: Dot, u: [y, y]}\n") ==
        std::vector<std::string>{
            "test.yaml:9:23: d.u: the product has elements in m^2 and 1, and Dot takes one "
            "unit; give them one, as by a Gain for each"});
  CHECK(faults_of(pendulum + "  d: {block: Dot, u: [y, [1 N, 1 N m/rad]]}\n").empty());
  Registry registry = blocks();
  registry.add<TotalLoad>("tests");
  CHECK(faults_of(pendulum + "  n: {block: TotalLoad, u: y}\n", {}, registry) ==
        std::vector<std::string>{"test.yaml:9:28: n.u: y has elements in m and rad, and TotalLoad takes one "
                                 "unit; give them one, as by a Gain for each"});
  CHECK(faults_of(pendulum + "  n: {block: TotalLoad, u: x}\n", {}, registry).empty());
}

TEST_CASE("a number without unit beside one in mm is refused with its place in the list") {
  const auto fault = [](const std::string& list) {
    const auto all = faults_of(pendulum + "  c: {block: Constant, value: " + list + "}\n");
    return all.empty() ? std::string() : all.front();
  };
  CHECK(fault("[5 mm, 2]") ==
        "test.yaml:9:38: c.value: element 2 is 2, which has no unit beside 5 mm; give it one");
  CHECK_THAT(fault("[2, 20 degC]"), Catch::Contains("element 1 is 2, which has no unit beside 20 degC"));
  CHECK(fault("[1 mm, = 2*3]") ==
        "test.yaml:9:38: c.value: element 2 is = 2*3, which has no unit beside 1 mm; give it one");
  CHECK_THAT(fault("[[1 mm, 2 mm], [3, 4 mm]]"), Catch::Contains("element 2 is 3"));
  for (const char* right : {"[1 mm, = 2*3*(1 m)]", "[1 mm, = 0*3]", "[1 m, = 2*3]", "[5 mm, 0]", "[5 m, 2]",
                            "[5 mm, 20 deg, 3]", "[5 mm, 50 %]", "[5, 2]"})
    CHECK(fault(right) == "");
  const auto with = [](const std::string& list, const std::string& parameters) {
    return faults_of(pendulum + "  c: {block: Constant, value: " + list + "}\nparameters: " + parameters +
                     "\n");
  };
  CHECK(with("[1 mm, = 2*w]", "{w: 3 mm}").empty());
  CHECK(with("[1 mm, = w*n]", "{w: 3 mm, n: 2}").empty());
  CHECK(with("[1 mm, $w]", "{w: 3 mm}").empty());
  for (const char* bare : {"[1 mm, = 2*n]", "[1 mm, $n]"})
    CHECK_THAT(with(bare, "{n: 2}").at(0), Catch::Contains("which has no unit beside 1 mm"));
}

TEST_CASE("an element that is no number, or does not fit its signal, is named") {
  const auto fault = [](const std::string& block) { return faults_of(pendulum + "  " + block + "\n").at(0); };
  CHECK(fault("c: {block: Constant, value: [5 m, x]}") ==
        "test.yaml:9:37: c.value: element 2 of the list: 'x' is not allowed; it must be a finite number");
  CHECK(fault("c: {block: Constant, value: [2 foo, 1]}") ==
        "test.yaml:9:32: c.value: element 1 of the list: 'foo' is no unit; a product of units is written "
        "N s or N.s");
  CHECK(fault("c: {block: Constant, value: [1, \"2\"]}") ==
        "test.yaml:9:35: c.value: element 2 of the list: '2' is text because of its quotes; leave them out "
        "for a number");
  CHECK(faults_of("parameters:\n  k: [5 m, x]\nblocks:\n  c: {block: Constant, value: $k}\n",
                  {{"k", "[1 m, y]"}})
            .at(0) ==
        "--set k=[1 m, y]: k: element 2 of the list: 'y' is not allowed; it must be a finite "
        "number");
  const std::string rates = "i: {block: Integrator, u: [1 rad/s, 2 m/s], initial: ";
  CHECK(fault(rates + "[0.3 rad, 1]}") ==
        "test.yaml:9:56: i.initial: element 2 is in rad, but that of i.initial is in m");
  CHECK(fault(rates + "{value: [1, 2], unit: mm}}") ==
        "test.yaml:9:56: i.initial: element 1 is in m, but that of i.initial is in rad");
}

}  // namespace stepwire::diagram
