#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

/// A chain of blocks with a sweep.
std::string chain_yaml(int blocks) {
  std::string text =
      "stepwire: 1\ntitle: a chain\nstep: 1 ms\nstop: 50 ms\nparameters:\n  k: {value: 1}\nblocks:\n"
      "  g0: {block: Sine, frequency: 1 Hz, amplitude: $k}\n";
  for (int i = 1; i < blocks; ++i)
    text += "  g" + std::to_string(i) + ": {block: Gain, gain: 2, u: g" + std::to_string(i - 1) + "}\n";
  return text + "sweep: {k: [1, 2, 3]}\nrecord: [g1]\n";
}

}  // namespace

TEST_CASE("what a profiled run records and claims are the same bits as without") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "plain"}).code == 0);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "profiled", "--profile"}).code == 0);
  for (const std::string name : {"signals.csv", "claims.json", "figure.svg", "figure.json"}) {
    INFO(name);
    const std::string plain = content_of(folder.path("plain/" + name));
    CHECK_FALSE(plain.empty());
    CHECK((content_of(folder.path("profiled/" + name)) == plain));
  }
}

TEST_CASE(
    "the option --profile lists blocks and what the run does itself, and leaves a table and a picture") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const Done done = run_program(folder, {"run", "lag.yaml", "--profile", "--out", "out"});
  REQUIRE(done.code == 0);
  for (const std::string part :
       {"derivatives", "lag ", "solver", "finite check", "recording", "what is left"})
    CHECK_THAT(done.out, Contains(part));
  const auto lines = lines_of(content_of(folder.path("out/profile.csv")));
  CHECK_THAT(lines.at(0), Catch::StartsWith("name,type,calls,self [s],total [s],"));
  const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  for (const std::string& line : lines) CHECK(commas(line) == commas(lines.front()));
  CHECK_THAT(content_of(folder.path("out/profile.svg")), Contains("lag (Lag)") && Contains("</svg>"));
}

TEST_CASE("with --json the profile is part of the result, and all of it") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const nlohmann::json result =
      nlohmann::json::parse(run_program(folder, {"run", "lag.yaml", "--profile", "--json"}).out)[0];
  const nlohmann::json& profile = result["profile"];
  CHECK(profile["ticks"] == result["ticks"]);
  CHECK(profile["blocks"].size() == result["blocks"]);
  double sum = profile["left"];
  for (const nlohmann::json& block : profile["blocks"]) sum += block["self"].get<double>();
  for (const nlohmann::json& other : profile["others"]) sum += other["seconds"].get<double>();
  CHECK(sum == Approx(profile["seconds"].get<double>()));
}

TEST_CASE("of many blocks the most expensive are shown, of a sweep the file's own values") {
  const Scratch folder;
  folder.file("chain.yaml", chain_yaml(30));
  const Done done = run_program(folder, {"run", "chain.yaml", "--profile"});
  REQUIRE(done.code == 0);
  CHECK_THAT(done.out, Contains("of the file's own values, not of its sweep: 50 ticks"));
  CHECK_THAT(done.out, Contains("and 10 more"));
}
