#include "engine/analyse/claim/likeness.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "engine/analyse/tuning/constraint.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::claim {
using namespace testing;
using Catch::Contains;

namespace {

/// Names of a diagram in a folder that records rig.x [m] and gate.
query::SymbolTable names_in(const Scratch& folder) {
  query::SymbolTable names = sample_names();
  names.file = folder.path("d.yaml");
  return names;
}

struct ReadClaims {
  std::vector<Claim> claims;
  std::string faults;
};

ReadClaims read_in(const Scratch& folder, const std::string& text) {
  yaml::Faults faults;
  const yaml::Document document = yaml::parse_document("- {that: a, " + text + "}", folder.path("d.yaml"));
  ReadClaims read;
  read.claims = read_claims(document.root, Claim::Kind::statement, names_in(folder), faults);
  read.faults = all_text(faults);
  return read;
}

Verdict verdict_in(const Scratch& folder, const std::string& text,
                   const std::vector<record::Recording>& recordings) {
  const ReadClaims read = read_in(folder, text);
  INFO(read.faults);
  REQUIRE(read.faults.empty());
  return judge(read.claims.at(0), recordings);
}

/// Runs of x = factor * t at 0, 0.1 s, ..., 1 s.
std::vector<record::Recording> ramps(const std::vector<double>& factors) {
  record::Recording recording;
  recording.starts.clear();
  auto& columns = recording.table.columns;
  columns = {column("time", "s", {}), column("rig.x", "m", {})};
  for (const double factor : factors) {
    recording.starts.push_back(columns[0].values.size());
    for (int i = 0; i <= 10; ++i) {
      columns[0].values.push_back(0.1 * i);
      columns[1].values.push_back(factor * 0.1 * i);
    }
  }
  return {recording};
}

const std::string ramp_csv = "time [s],rig.x [mm]\n0,0\n0.5,500\n1,1000\n";

}  // namespace

TEST_CASE("a claim is like a baseline within a share of it, or within a tolerance with unit") {
  const Scratch folder;
  folder.file("ramp.csv", ramp_csv);
  const Verdict near = verdict_in(folder, "like: ramp.csv, within: 1 %", ramps({1.009}));
  CHECK(near.holds);
  CHECK(near.value == Approx(0.9));
  CHECK(near.check == "like ramp.csv within 1 %");
  const Verdict far = verdict_in(folder, "like: ramp.csv, within: 1 %", ramps({1.011}));
  CHECK_FALSE(far.holds);
  CHECK_THAT(far.shown, Contains("rig.x: differs by 11 mm (1.1 %) at 1 s"));
  CHECK(verdict_in(folder, "like: ramp.csv, within: 11.1 mm", ramps({1.011})).holds);
  CHECK_FALSE(verdict_in(folder, "like: ramp.csv, within: 10.9 mm", ramps({1.011})).holds);
  CHECK_FALSE(verdict_in(folder, "like: ramp.csv", ramps({1.011})).holds);
  CHECK(verdict_in(folder, "like: ramp.csv", ramps({1.0})).holds);
}

TEST_CASE("each run of a sweep is compared with the baseline, and the worst is shown") {
  const Scratch folder;
  folder.file("ramp.csv", ramp_csv);
  const Verdict verdict = verdict_in(folder, "like: ramp.csv, within: 1 %", ramps({1.0, 1.02, 1.01}));
  CHECK_FALSE(verdict.holds);
  CHECK(verdict.run == 1u);
  CHECK_THAT(verdict.shown, Contains("the worst of 3 runs"));
}

TEST_CASE("a run that ends before its baseline is not like it") {
  const Scratch folder;
  folder.file("ramp.csv", "time [s],rig.x [mm]\n0,0\n0.5,500\n2,2000\n");
  const Verdict verdict = verdict_in(folder, "like: ramp.csv, within: 1 %", ramps({1.0}));
  CHECK_FALSE(verdict.holds);
  CHECK_THAT(verdict.shown, Contains("ends at 2 s in A and at 1 s in B"));
}

TEST_CASE("an edge within the jitter is like the baseline") {
  const Scratch folder;
  folder.file("step.csv", "time [s],rig.x [m]\n0,0\n0.4,0\n0.41,1\n1,1\n");
  auto run = ramps({0.0});
  for (std::size_t i = 5; i <= 10; ++i) run[0].table.columns[1].values[i] = 1.0;
  CHECK_FALSE(verdict_in(folder, "like: step.csv, within: 1 %", run).holds);
  CHECK(verdict_in(folder, "like: step.csv, within: 1 %, jitter: 110 ms", run).holds);
}

TEST_CASE("a baseline that is missing, of other signals or units, and other keys beside it are refused") {
  const Scratch folder;
  folder.file("ramp.csv", ramp_csv);
  folder.file("other.csv", "time [s],rig.y [mm]\n0,0\n1,1\n");
  folder.file("force.csv", "time [s],rig.x [N]\n0,0\n1,1\n");
  folder.file("runs.csv", "time [s],rig.x [m]\n0,0\n1,1\n0,0\n1,1\n");
  CHECK_THAT(read_in(folder, "like: ramb.csv").faults, Contains("there is no file") && Contains("ramp.csv"));
  folder.file("ramp.h5", "no HDF5");
  CHECK_THAT(read_in(folder, "like: ramp.h5").faults, Contains("ramp.h5"));
  folder.file("ramp.doc", "time [s],rig.x [mm]\n");
  CHECK_THAT(read_in(folder, "like: ramp.doc").faults, Contains("a table is a .csv"));
  std::filesystem::create_symlink("loop.csv", folder.path("loop.csv"));
  CHECK_THAT(read_in(folder, "like: loop.csv").faults, Contains("there is no file"));
  CHECK_THAT(read_in(folder, "like: /dev/full").faults, Contains("a table is a .csv"));
  CHECK_THAT(read_in(folder, "like: other.csv").faults, Contains("'rig.y' of other.csv is not recorded"));
  CHECK_THAT(read_in(folder, "like: force.csv").faults, Contains("cannot be converted"));
  CHECK_THAT(read_in(folder, "like: runs.csv").faults, Contains("has 2 runs"));
  CHECK_THAT(read_in(folder, "like: ramp.csv, within: 1 N").faults, Contains("its tolerance is 1 N"));
  CHECK_THAT(read_in(folder, "like: ramp.csv, at_most: 1").faults, Contains("both"));
  CHECK_THAT(read_in(folder, "like: ramp.csv, final: rig.x").faults, Contains("both"));
  CHECK_THAT(read_in(folder, "like: ramp.csv, signals: rig.z").faults, Contains("has no 'rig.z'"));
  CHECK_THAT(read_in(folder, "final: rig.x, at_most: 1 m, jitter: 1 ms").faults, Contains("jitter"));
  CHECK(read_in(folder, "like: ramp.csv, signals: [rig.x], within: 1 %").faults.empty());
}

TEST_CASE("a search has no baseline among its constraints") {
  const Scratch folder;
  folder.file("ramp.csv", ramp_csv);
  yaml::Faults faults;
  const auto names = names_in(folder);
  const yaml::Document document =
      yaml::parse_document("- {that: a, like: ramp.csv, within: 1 %}", folder.path("d.yaml"));
  tuning::read_constraints(document.root, {}, {"tune.constraints", names, faults});
  CHECK_THAT(all_text(faults), Contains("which no search follows"));
}

}  // namespace stepwire::claim
