#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <set>
#include <tuple>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

const std::string head = "stepwire: 1\nstep: 1 s\nstop: 1 s\n";

RunResult swept(const std::string& yaml, unsigned threads = 0) {
  const DiagramFolder folder;
  folder.write("sweep.yaml", head + yaml);
  diagram::Loader loader(library());
  const Job job = make_job(loader, folder.path("sweep.yaml"));
  RunOptions options;
  options.threads = threads;
  return run_job(job, options);
}

bool same_bits(const table::Table& a, const table::Table& b) {
  if (a.columns.size() != b.columns.size()) return false;
  for (std::size_t i = 0; i < a.columns.size(); ++i) {
    const auto &x = a.columns[i].values, &y = b.columns[i].values;
    if (a.columns[i].name != b.columns[i].name || x.size() != y.size()) return false;
    if (std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) != 0) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a sweep over several parameters makes the grid, the last one fastest") {
  const RunResult result = swept(R"(parameters: {a: 0, b: 0 m}
blocks:
  y: {block: Sum, u: [$a, = b]}
  z: {block: Constant, value: $b}
sweep: {a: {values: [10, 20]}, b: {from: 1 m, to: 3 m, count: 3}}
record: y
)");
  const record::Recording& all = result.recordings.at(0);
  CHECK(column(all.table, "a") == std::vector<double>{10, 10, 10, 10, 10, 10, 20, 20, 20, 20, 20, 20});
  CHECK(column(all.table, "b") == std::vector<double>{1, 1, 2, 2, 3, 3, 1, 1, 2, 2, 3, 3});
  CHECK(column(all.table, "y") == std::vector<double>{11, 11, 12, 12, 13, 13, 21, 21, 22, 22, 23, 23});
  CHECK(all.starts == std::vector<std::size_t>{0, 2, 4, 6, 8, 10});
  CHECK(all.table.columns[0].name == "time");
  CHECK(result.ticks == 6);
}

TEST_CASE("parameters swept together are paired") {
  const RunResult result = swept(
      "parameters: {a: 0, b: 0}\nblocks:\n  y: {block: Sum, u: [$a, $b]}\nrecord: y\n"
      "sweep: {a: [1, 2, 3], b: [10, 20, 30], together: true}\n");
  CHECK(column(result.recordings.at(0).table, "y") == std::vector<double>{11, 11, 22, 22, 33, 33});
}

TEST_CASE("lists of different length cannot be paired") {
  const auto refused = faults_of(
      "parameters: {a: 0, b: 0}\nblocks:\n  y: {block: Sum, u: [$a, $b]}\nsweep: {a: [1, 2, 3], b: [1], "
      "together: true}\n");
  REQUIRE(refused.size() == 1);
  CHECK_THAT(refused[0], Catch::StartsWith("test.yaml:4:23: sweep.b: has 1 value, 'a' has 3"));
}

TEST_CASE("words are swept as numbers that stand for them") {
  const RunResult result = swept(
      "parameters: {kind: normal}\nblocks:\n  y: {block: Noise, seed: 1, distribution: $kind}\nrecord: y\n"
      "sweep: {kind: {values: [normal, uniform]}}\n");
  const record::Recording& all = result.recordings.at(0);
  CHECK(column(all.table, "kind") == std::vector<double>{0, 0, 1, 1});
  REQUIRE(all.categories.size() == 1);
  CHECK(all.categories[0].column == "kind");
  CHECK(all.categories[0].texts == std::vector<std::string>{"normal", "uniform"});
}

TEST_CASE("a sweep gives the same bits at any number of threads") {
  const std::string yaml = R"(solver: rk4
parameters: {w: 1, seed: 1}
blocks:
  noise: {block: Noise, seed: $seed}
  force: {block: Gain, gain: $w, u: noise}
  x: {block: TransferFunction, numerator: [1], denominator: [1, 0.1, 4], u: force}
record: all
sweep: {w: {from: 0.3, to: 7, count: 9}, seed: [1, 2]}
)";
  const RunResult serial = swept(yaml, 1);
  for (unsigned threads : {2u, 5u}) {
    const RunResult parallel = swept(yaml, threads);
    CHECK(same_bits(serial.recordings.at(0).table, parallel.recordings.at(0).table));
    CHECK(serial.recordings.at(0).starts == parallel.recordings.at(0).starts);
  }
}

TEST_CASE("a run that ends early leaves the others of its sweep whole") {
  const RunResult result = swept(
      "parameters: {a: 1}\nblocks:\n  t: {block: Clock}\n  left: {block: Sum, signs: \"+-\", u: [= a, t]}\n"
      "  y: {block: Divide, numerator: 1, denominator: left}\nrecord: y\nsweep: {a: [1, 5]}\n");
  CHECK(result.faults.size() == 1);
  CHECK(column(result.recordings.at(0).table, "a") == std::vector<double>{1, 5, 5});
}

TEST_CASE("a number without unit beside numbers with units is refused") {
  const DiagramFolder folder;
  const auto refused = [&](const std::string& sweep) {
    folder.write(
        "sweep.yaml",
        head + "parameters: {wall: 1 mm}\nblocks: {y: {block: Gain, u: $wall}}\nsweep: {" + sweep + "}\n");
    diagram::Loader loader(library());
    try {
      make_job(loader, folder.path("sweep.yaml"));
    } catch (const yaml::Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string cure = "2 has no unit beside 5 mm; write 2 mm";
  CHECK_THAT(refused("wall: [5 mm, 2]"), Catch::Contains("sweep.wall: " + cure));
  CHECK_THAT(refused("wall: {from: 5 mm, to: 2, count: 3}"), Catch::Contains(cure));
  CHECK_THAT(refused("wall: {normal: [5 mm, 2]}, design: {samples: 3}"), Catch::Contains(cure));
  CHECK_THAT(refused("wall: {uniform: [2, 5 mm]}, design: {samples: 3}"), Catch::Contains(cure));
  CHECK_THAT(refused("cases: {a: {wall: 5 mm}, b: {wall: 2}}"), Catch::Contains(cure));
  CHECK(refused("wall: [5 mm, 0, 1 cm]").empty());
  CHECK(refused("wall: {lognormal: [5 mm, 0.2]}, design: {samples: 3}").empty());
  CHECK(refused("wall: [0.005, 0.002]").empty());
}

TEST_CASE("what is swept must be something that can be set") {
  const DiagramFolder folder;
  folder.write(
      "sweep.yaml",
      head +
          "parameters: {gain: 1}\nblocks:\n  y: {block: Gain, gain: $gain, u: 1}\nsweep: {gian: [1, 2]}\n");
  diagram::Loader loader(library());
  REQUIRE_THROWS_WITH(make_job(loader, folder.path("sweep.yaml")),
                      Catch::Contains("there is no parameter 'gian'; did you mean 'gain'?"));
}

TEST_CASE("what is wrong with one value of a sweep is told at that value") {
  const DiagramFolder folder;
  const auto refused = [&](const std::string& sweep,
                           const std::string& parameter = "a: {value: 1 N, above: 0 N}") {
    folder.write("sweep.yaml", head + "parameters: {" + parameter +
                                   "}\nblocks: {y: {block: Gain, u: $a}}\nsweep: " + sweep + "\n");
    diagram::Loader loader(library());
    try {
      make_job(loader, folder.path("sweep.yaml"));
    } catch (const yaml::Error& error) {
      const std::string text = error.what();
      return text.substr(text.find("sweep.yaml"));
    }
    return std::string("none");
  };
  CHECK(refused("{a: [1 N, -1 N]}") ==
        "sweep.yaml:6:18: a: -1 N is not allowed; it must be above 0 N (in the run with a=-1 N)");
  CHECK(refused("{a: {values: [1 N, 2 s]}}") ==
        "sweep.yaml:6:27: a: 2 s is in s; it must be in N (in the run with a=2 s)");
  CHECK(refused("{a: {from: 1 s, to: 2 s, count: 2}}") ==
        "sweep.yaml:6:12: a: 1 s is in s; it must be in N (in the run with a=1 s)");
  CHECK(refused("{a: {from: 1 N, to: 2 s, count: 2}}") ==
        "sweep.yaml:6:28: sweep.a: 'to' is in s; it must be in N");
  CHECK(refused("{a: {from: 1 N, to: 2 N}}") ==
        "sweep.yaml:6:12: sweep.a: 'count' is missing (how many values, both ends included): {from: 1 N, to: "
        "9 N, count: 5}");
  CHECK(refused("{a: [1, 2], together: yes}") ==
        "sweep.yaml:6:30: sweep.together: 'yes' is neither true nor false");
  CHECK(refused("{a: [1, 2]}\nrecord: {signals: {a: y}}") ==
        "sweep.yaml:7:23: record: 'a' is a swept parameter as well, and both would be a column 'a'; give the "
        "signal another name: {a_y: a}");
}

TEST_CASE("what is set from outside is not swept any more") {
  const DiagramFolder folder;
  folder.write("sweep.yaml",
               head +
                   "parameters: {a: 0, b: 0}\nblocks: {y: {block: Sum, u: [$a, $b]}}\nrecord: y\n"
                   "sweep: {a: [1, 2, 3], b: [10, 20, 30]}\n");
  diagram::Loader loader(library());
  const RunResult result = run_job(make_job(loader, folder.path("sweep.yaml"), {{"a", "7"}}));
  CHECK(column(result.recordings.at(0).table, "y") == std::vector<double>{17, 17, 27, 27, 37, 37});
}

TEST_CASE("ranges of whole numbers are whole, up and down, and end where they say") {
  for (const auto& [from, to, count] : {std::tuple{1, 1000, 1000},
                                        {1, 200, 200},
                                        {1, 100, 100},
                                        {0, 63, 64},
                                        {1000, 1, 1000},
                                        {-7, 13, 21},
                                        {3, 99, 33}}) {
    const RunResult result =
        swept(fmt::format("parameters: {{a: 0}}\nblocks:\n  y: {{block: Constant, value: $a}}\n"
                          "sweep: {{a: {{from: {}, to: {}, count: {}}}}}\nrecord: y\n",
                          from, to, count));
    const auto& values = result.recordings.front().table.find("a")->values;
    REQUIRE(values.size() == 2 * static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
      CHECK(values[2 * static_cast<std::size_t>(i)] == from + i * (to - from) / (count - 1));
  }
}

TEST_CASE("a range in a unit has the values that its numbers in that unit have") {
  const RunResult result = swept(R"(parameters: {a: 0 mm}
blocks:
  y: {block: Constant, value: $a}
sweep: {a: {from: 1 mm, to: 100 mm, count: 100}}
record: y
)");
  const auto& values = result.recordings.front().table.find("a")->values;
  for (int i = 1; i <= 100; ++i)
    CHECK(values[2 * static_cast<std::size_t>(i - 1)] ==
          unit::parse_quantity(fmt::format("{} mm", i))->value);
}

TEST_CASE("a thousand subjects of a range are a thousand people") {
  const RunResult result = swept(R"yaml(parameters:
  seed: 1
  reach: "= lognormal(seed, 1, 0.3)"
blocks:
  y: {block: Constant, value: $reach}
sweep: {seed: {from: 1, to: 1000, count: 1000}}
record: y
)yaml");
  const auto& values = result.recordings.front().table.find("y")->values;
  CHECK(std::set<double>(values.begin(), values.end()).size() == 1000);
}

TEST_CASE("a sweep that changes the number of recorded elements is refused, with the run and the cure") {
  const std::string delays =
      "parameters: {p: 5 s}\nsweep: {p: [5 s, 2 s]}\nblocks:\n  t: {block: Clock}\n"
      "  d: {block: Delay, u: t, delay: $p, every: 1 s}\n";
  CHECK_THROWS_WITH(swept("title: t\n" + delays + "record: [d, d.samples]\n"),
                    Catch::Matchers::Contains("d.samples") &&
                        Catch::Matchers::Contains("it has 2 elements and not 5") &&
                        Catch::Matchers::Contains("p=2 s"));
  CHECK_NOTHROW(swept("title: t\n" + delays + "record: d\n"));
}

TEST_CASE("elements of swept lists have units together") {
  const DiagramFolder folder;
  const auto refused = [&](const std::string& sweep) {
    folder.write("sweep.yaml", head +
                                   "parameters: {k: [1 mm, 20 deg]}\nblocks: {y: {block: Constant, value: "
                                   "$k}}\nsweep: {k: " +
                                   sweep + "}\n");
    diagram::Loader loader(library());
    try {
      make_job(loader, folder.path("sweep.yaml"));
    } catch (const yaml::Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(refused("[[1 mm, 10 deg], [3, 20 deg]]"), Catch::Contains("sweep.k: 3 has no unit beside 1 mm"));
  CHECK_THAT(refused("[[1 mm, 10 deg], [3 mm, 20]]"), Catch::Contains("20 has no unit beside 10 deg"));
  CHECK(refused("[[1 mm, 10 deg], [3 mm, 20 deg]]").empty());
  CHECK(refused("[[1 mm, 10 deg], [0 mm, 20 deg]]").empty());
}

}  // namespace stepwire::run
