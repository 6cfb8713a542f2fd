#include "engine/analyse/study/repetition.hpp"
#include "engine/app/session/repetition_figure.hpp"
#include "engine/view/render/render.hpp"

#include <catch2/catch.hpp>

#include "engine/base/io/file.hpp"
#include "tests/engine/analyse/study/samples.hpp"
#include "tests/engine/base/table/scratch.hpp"

using namespace stepwire;
using Catch::Contains;

namespace {

/// 99 experiments in which the mean of NO is 0.01, 0.02, ... 0.99.
Repetition made_up() {
  Repetition repetition({"mean.NO", "p.haptic"});
  for (std::uint64_t seed = 99; seed > 0; --seed)
    repetition.add(seed, {{"mean.NO", 0.01 * static_cast<double>(seed)}, {"p.haptic", 1e-4}});
  return repetition;
}

StudyRequest task_1() {
  StudyRequest request;
  request.task = "1";
  request.published = testing::published_task_1();
  return request;
}

}  // namespace

TEST_CASE("experiments are read back from their file to the same bits, sorted by their seeds") {
  const Scratch folder;
  const Repetition repetition = made_up();
  write_file(folder.path("a.csv"), repetition.csv());
  Repetition again({"mean.NO", "p.haptic"});
  again.read(folder.path("a.csv"));
  CHECK(again.csv() == repetition.csv());
  CHECK(again.has(99));
  CHECK_FALSE(again.has(100));
  Repetition other({"mean.V"});
  CHECK_THROWS_WITH(other.read(folder.path("a.csv")), Contains("no experiments of this study"));
}

TEST_CASE("the table has the quantiles, and where the thesis' value lies among the experiments") {
  const TextTable table = made_up().table(task_1());
  REQUIRE(table.rows.size() == 2);
  // Of 99 values the middle one is the 50th; 69 are below 0.698.
  CHECK(table.rows[0] == std::vector<std::string>{"mean.NO", "0.698", "0.5", "0.0545", "0.946", "69.7 %"});
  CHECK(table.rows[1][5] == "0.0 %");
}

TEST_CASE("the picture has a panel with a line for each value that the thesis prints") {
  const std::string svg = render(repetition_figure(made_up(), task_1())).svg;
  CHECK_THAT(svg,
             Contains("thesis: 0.698") && Contains("thesis: 2.02e-05") && Contains("log10 of P, haptic"));
  CHECK_THAT(svg, !Contains("thesis: 0.217"));
}
