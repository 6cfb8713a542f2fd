#include "engine/analyse/study/distribution.hpp"

#include <catch2/catch.hpp>

#include "engine/app/session/studies.hpp"
#include "engine/view/render/render.hpp"
#include "tests/engine/analyse/study/samples.hpp"

namespace stepwire::study {
using Catch::Contains;

namespace {

/// 99 experiments in which the mean of NO is 0.01, 0.02, ... 0.99 and that of HV half of it; haptic feedback
/// is significant in each, and raises the error in 24 of them.
std::vector<ExperimentOutcome> made_up() {
  std::vector<ExperimentOutcome> all;
  for (std::uint64_t seed = 1; seed <= 99; ++seed) {
    const double error = 0.01 * static_cast<double>(seed);
    all.push_back({seed,
                   {{"mean.NO", error},
                    {"mean.HV", 0.5 * error},
                    {"p.haptic", 1e-4},
                    {"effect.haptic", seed < 25 ? 0.1 : -0.1}}});
  }
  return all;
}

StudyRequest task_1() {
  StudyRequest request;
  request.task = "1";
  request.published = testing::published_task_1();
  return request;
}

}  // namespace

TEST_CASE("the table has the quantiles, and where the thesis' value lies among the experiments") {
  const text::TextTable table = experiments_table(made_up(), task_1());
  REQUIRE(table.rows.size() == 3);
  // Of 99 values the middle one is the 50th; 69 are below 0.698.
  CHECK(table.rows[0] == std::vector<std::string>{"mean.NO", "0.698", "0.5", "0.0545", "0.946", "69.7 %"});
  // 0.079/0.698, and ours is half in each.
  CHECK(table.rows[2] == std::vector<std::string>{"HV/NO", "0.113", "0.5", "0.5", "0.5", "0.0 %"});
}

TEST_CASE("significance is counted with its sign") {
  const text::TextTable table = experiments_significance_table(made_up(), task_1());
  REQUIRE(table.rows.size() == 1);
  CHECK(table.rows[0] == std::vector<std::string>{"p.haptic", "2.02e-05", "1.00e-04", "1.00e-04", "1.00e-04",
                                                  "0.0 %", "75 of 99", "24 of 99"});
}

TEST_CASE("the picture has a panel with a line for each value that the thesis prints") {
  const std::string svg = render::render(session::repetition_figure(made_up(), task_1())).svg;
  CHECK_THAT(
      svg, Contains("published: 0.698") && Contains("published: 2.02e-05") && Contains("log10 of P, haptic"));
  CHECK_THAT(svg, !Contains("published: 0.217"));
}

TEST_CASE("a study of which nothing is published has the distributions of its own means") {
  const text::TextTable table = experiments_table(made_up(), {});
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0] == std::vector<std::string>{"mean.NO", "–", "0.5", "0.0545", "0.946", "–"});
}

}  // namespace stepwire::study
