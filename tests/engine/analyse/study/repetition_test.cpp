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

TEST_CASE("an edited number is refused at its line, and a line that was cut is performed again") {
  const Scratch folder;
  Repetition repetition(columns);
  for (std::uint64_t seed = 1; seed < 4; ++seed) repetition.add(made_up(seed));
  const std::string text = repetition.csv();
  std::string edited = text;
  edited.replace(edited.find("0.05"), 4, "0.06");
  io::write_file(folder.path("edited.csv"), edited);
  Repetition again(columns);
  CHECK_THROWS_WITH(again.read(folder.path("edited.csv")),
                    Contains("edited.csv:3: this experiment is not as it was written") &&
                        Contains("delete the line; it is performed again"));
  for (const std::size_t missing : {1, 5, 40}) {
    io::write_file(folder.path("cut.csv"), text.substr(0, text.size() - missing));
    Repetition cut(columns);
    cut.read(folder.path("cut.csv"));
    CHECK(cut.has(2));
    CHECK_FALSE(cut.has(3));
  }
  io::write_file(folder.path("cut.csv"), text.substr(0, 6));
  Repetition none(columns);
  none.read(folder.path("cut.csv"));
  CHECK(none.size() == 0);
}

TEST_CASE("numbers that do not exist are kept, too") {
  const Scratch folder;
  Repetition repetition(columns), again(columns);
  repetition.add({7, {{"mean.NO", std::nan("")}, {"deviation.NO", INFINITY}}});
  io::write_file(folder.path("a.csv"), repetition.csv());
  again.read(folder.path("a.csv"));
  CHECK(std::isnan(again.outcomes().at(0).values.at(0).value));
  CHECK(again.csv() == repetition.csv());
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
