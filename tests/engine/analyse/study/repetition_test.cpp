#include "engine/analyse/study/repetition.hpp"

#include <catch2/catch.hpp>

#include "engine/base/io/file.hpp"
#include "tests/engine/analyse/study/samples.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::study {
using Catch::Contains;

namespace {

const std::vector<OutcomeColumn> columns{{"mean.NO"}, {"deviation.NO", "m"}};

ExperimentOutcome made_up(std::uint64_t seed) {
  return {seed, {{"mean.NO", 0.1 / static_cast<double>(seed)}, {"deviation.NO", 1e-3}}};
}

}  // namespace

TEST_CASE("experiments are read back from their file to the same bits, sorted by their seeds") {
  const Scratch folder;
  Repetition repetition(columns);
  for (std::uint64_t seed = 9; seed > 0; --seed) repetition.add(made_up(seed));
  io::write_file(folder.path("a.csv"), repetition.csv());
  Repetition again(columns);
  again.read(folder.path("a.csv"));
  CHECK(again.csv() == repetition.csv());
  CHECK(again.has(9));
  CHECK_FALSE(again.has(10));
  CHECK(again.outcomes().at(2).seed == 3);
  CHECK(again.outcomes().at(2).values.at(0).value == 0.1 / 3.0);
  Repetition other({{"mean.V"}});
  CHECK_THROWS_WITH(other.read(folder.path("a.csv")), Contains("no experiments of this study"));
}

TEST_CASE("an experiment of a sweep is there once all its points are") {
  Repetition repetition(columns);
  repetition.add(made_up(1), 0);
  CHECK_FALSE(repetition.has(1, 2));
  repetition.add(made_up(1), 1);
  repetition.add(made_up(2), 1);
  CHECK(repetition.has(1, 2));
  CHECK(repetition.outcomes(1).size() == 2);
}

}  // namespace stepwire::study
