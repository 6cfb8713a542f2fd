#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "engine/base/math/normal_quantile.hpp"
#include "engine/simulate/run/run.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {
using Catch::Contains;

namespace {

const std::string head =
    "stepwire: 1\nstep: 1 s\nstop: 1 s\n"
    "parameters: {k: 200 N/m, m: {value: 2 kg, above: 0 kg}, road: 0, list: 0}\n"
    "blocks:\n  k_is: {block: Constant, value: $k}\n  m_is: {block: Constant, value: $m}\n"
    "  other: {block: Sum, u: [$road, $list]}\nrecord: [k_is, m_is, other]\nsweep: ";

record::Recording drawn(const std::string& sweep) {
  const DiagramFolder folder;
  folder.write("sweep.yaml", head + sweep + "\n");
  diagram::Loader loader(library());
  return run_job(make_job(loader, folder.path("sweep.yaml"))).recordings.at(0);
}

/// A column at the first row of each run.
std::vector<double> of_runs(const record::Recording& recording, const std::string& name) {
  std::vector<double> values;
  for (const std::size_t start : recording.starts)
    values.push_back(recording.table.find(name)->values[start]);
  return values;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

std::string refusal(const std::string& sweep) {
  try {
    drawn(sweep);
  } catch (const yaml::Error& error) {
    const std::string text = error.faults().front().text();
    return text.substr(text.find("sweep.yaml"));
  }
  return "was taken";
}

}  // namespace

TEST_CASE("a sweep draws its points, and the runs have them") {
  const record::Recording all = drawn(
      "{k: {uniform: [100 N/m, 300 N/m]}, m: {lognormal: [2 kg, 0.2]}, design: {samples: 1024, kind: sobol, "
      "seed: 3}}");
  REQUIRE(all.starts.size() == 1024);
  CHECK(of_runs(all, "k") == of_runs(all, "k_is"));
  CHECK(of_runs(all, "m") == of_runs(all, "m_is"));
  CHECK(mean(of_runs(all, "k")) == Approx(200.0).epsilon(1e-4));
  CHECK(mean(of_runs(all, "m")) == Approx(2.0 * std::sqrt(1.04)).epsilon(1e-3));
  CHECK(all.table.find("k")->unit == "N/m");
}

TEST_CASE("a drawn point runs alone with the same bits") {
  const DiagramFolder folder;
  folder.write("sweep.yaml", head +
                                 "{k: {normal: [0.2 N/mm, 0.01 N/mm]}, design: {samples: 50, kind: "
                                 "latin_hypercube}}\n");
  diagram::Loader loader(library());
  const Job job = make_job(loader, folder.path("sweep.yaml"));
  const std::vector<double> all = of_runs(run_job(job).recordings.at(0), "k_is");
  for (const std::size_t point : {0, 17, 49}) {
    const auto settings = job.settings_of(point);
    CHECK_THAT(settings.at(0).value, Catch::EndsWith(" N/mm"));
    const Job alone = make_job(loader, folder.path("sweep.yaml"), {{"k", settings[0].value}});
    CHECK(run_job(alone).recordings.at(0).table.find("k_is")->values.front() == all[point]);
  }
}

TEST_CASE("more samples go on where fewer ended, and another parameter leaves the others") {
  const auto few = drawn("{k: {uniform: [1 N/m, 3 N/m]}, design: {samples: 20, kind: sobol}}");
  const auto many =
      drawn("{k: {uniform: [1 N/m, 3 N/m]}, m: {uniform: [1 kg, 3 kg]}, design: {samples: 90, kind: sobol}}");
  const std::vector<double> a = of_runs(few, "k"), b = of_runs(many, "k");
  CHECK(std::equal(a.begin(), a.end(), b.begin()));
}

TEST_CASE("each value of a list meets each sample") {
  const auto all = drawn(
      "{list: [1, 2], k: {uniform: [1 N/m, 3 N/m]}, m: {triangular: [1 kg, 2 kg, 4 kg]}, "
      "design: {samples: 10}}");
  REQUIRE(all.starts.size() == 20);
  const std::vector<double> list = of_runs(all, "list"), k = of_runs(all, "k"), m = of_runs(all, "m");
  for (std::size_t i = 0; i < 10; ++i) {
    CHECK(list[i] == 1);
    CHECK(list[10 + i] == 2);
    CHECK(k[i] == k[10 + i]);
    CHECK(m[i] == m[10 + i]);
  }
  const auto paired =
      drawn("{together: true, list: [1, 2, 3], k: {uniform: [1 N/m, 3 N/m]}, design: {samples: 3}}");
  CHECK(of_runs(paired, "list") == std::vector<double>{1, 2, 3});
  CHECK(of_runs(paired, "k") == std::vector<double>(k.begin(), k.begin() + 3));
}

TEST_CASE("correlated parameters go together as the file says") {
  const std::string pair =
      "k: {normal: [200 N/m, 10 N/m]}, m: {lognormal: [2 kg, 0.2]}, design: {samples: 4096, "
      "kind: sobol}";
  const auto all = drawn("{" + pair + ", correlation: {k: {m: -0.8}}}");
  const std::vector<double> k = of_runs(all, "k"), m = of_runs(all, "m");
  const double s = std::sqrt(std::log(1.04));
  double sum = 0.0;
  for (std::size_t i = 0; i < k.size(); ++i) sum += (k[i] - 200.0) / 10.0 * std::log(m[i] / 2.0) / s;
  CHECK(sum / 4096.0 == Approx(-0.8).margin(0.005));
  const auto by_matrix = drawn("{" + pair + ", correlation: [[1, -0.8], [-0.8, 1]]}");
  CHECK(of_runs(by_matrix, "m") == m);
}

TEST_CASE("words are drawn by their weights") {
  const auto all = drawn("{road: {words: {1: 1, 2: 3}}, design: {samples: 400, kind: latin_hypercube}}");
  const std::vector<double> road = of_runs(all, "other");
  CHECK(std::ranges::count(road, 1.0) == 100);
  CHECK(std::ranges::count(road, 2.0) == 300);
}

TEST_CASE("what is wrong with a design is one sentence with its place") {
  const std::string design = ", design: {samples: 10}}";
  CHECK_THAT(refusal("{k: {uniform: [3 N/m, 1 N/m]}" + design),
             Contains("sweep.k.uniform: 'high' 1 N/m is below 'low' 3 N/m; it must be above it"));
  CHECK_THAT(refusal("{k: {normal: [3 N/m, -1 N/m]}" + design),
             Contains("sweep.k.normal: 'deviation' is -1 N/m; it must be above 0"));
  CHECK_THAT(refusal("{k: {normal: [3 N/m, 1 s]}" + design),
             Contains("'deviation' is in s; it must be in N/m"));
  CHECK_THAT(refusal("{k: {lognormal: [3 N/m, 1 s]}" + design), Contains("'variation' is in s"));
  CHECK_THAT(
      refusal("{k: {lognormal: [20 degC, 0.1]}" + design),
      Contains("0.1 of a temperature in degC is a share of its kelvins; write normal: [20 degC, 2 K]"));
  CHECK_THAT(refusal("{k: {uniform: [1 s, 2 s]}" + design),
             Contains("k: 1.") && Contains("it must be in N/m"));
  CHECK_THAT(refusal("{m: {uniform: [-1 kg, 2 kg]}" + design), Contains("it must be above 0 kg"));
  CHECK_THAT(refusal("{k: {unifrom: [1 N/m, 2 N/m]}" + design), Contains("did you mean 'uniform'?"));
  CHECK_THAT(refusal("{k: {uniform: [1 N/m]}" + design), Contains("is a list of [low, high]"));
  CHECK_THAT(refusal("{k: {triangular: [1 N/m, 5 N/m, 2 N/m]}" + design),
             Contains("'high' 2 N/m is below 'mode' 5 N/m"));
  CHECK_THAT(refusal("{road: {words: {1: 1, 2: -3}}" + design),
             Contains("sweep.road.words.2: -3 is not allowed"));
  CHECK_THAT(refusal("{k: {uniform: [1 N/m, 2 N/m]}}"),
             Contains("'k' is drawn; say how often: design: {samples: 1000}"));
  CHECK_THAT(refusal("{k: [1 N/m, 2 N/m]" + design), Contains("there is nothing to draw"));
  const std::string k = "{k: {uniform: [1 N/m, 2 N/m]}, ";
  CHECK_THAT(refusal(k + "design: {samples: 0}}"),
             Contains("sweep.design.samples: '0' is no whole number from 1"));
  CHECK_THAT(refusal(k + "design: {seed: 3}}"), Contains("'samples' is missing"));
  CHECK_THAT(refusal(k + "design: {samples: 5, seed: 1.5}}"), Contains("'1.5' is no whole number"));
  CHECK_THAT(refusal(k + "design: {samples: 5, kind: sobel}}"), Contains("did you mean 'sobol'?"));
  CHECK_THAT(refusal(k + "one_at_a_time: {m: [1 kg]}, design: {samples: 5}}"),
             Contains("sweep.one_at_a_time: stands alone in its sweep"));
  CHECK_THAT(refusal(k + "m: {uniform: [1 kg, 2 kg]}, correlation: {k: {m: 1}}, design: {samples: 5}}"),
             Contains("sweep.correlation: is not positive definite"));
  CHECK_THAT(refusal(k + "road: {words: {1: 1, 2: 1}}, correlation: {k: {road: 0.5}}, design: {samples: 5}}"),
             Contains("'road' has words, which have no correlation"));
  CHECK_THAT(refusal(k + "list: [1, 2], correlation: {k: {list: 0.5}}, design: {samples: 5}}"),
             Contains("'list' is not drawn; it has the values of its list"));
  CHECK_THAT(
      refusal(k + "m: {uniform: [1 kg, 2 kg]}, correlation: [[1, 0.5], [0.4, 1]], design: {samples: 5}}"),
      Contains("is not symmetric"));
}

}  // namespace stepwire::run
