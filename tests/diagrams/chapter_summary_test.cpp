// The sentences about chapter 4 on the front page of the gallery, compared with the stored experiments.
#include <algorithm>
#include <catch2/catch.hpp>
#include <regex>

#include "engine/app/thesis/thesis_contents.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/table/table_file.hpp"

using Catch::Contains;

namespace stepwire {
namespace {

const std::string thesis_folder = STEPWIRE_SOURCE_DIR "/diagrams/thesis";

std::vector<std::string> sentences() {
  for (const gallery::ChapterSummary& summary : thesis::read_contents(thesis_folder).summaries)
    if (summary.chapter == "4") return summary.sentences;
  return {};
}

/// Experiments of one study, a row for each.
class Experiments {
 public:
  /// At one point of a study that is swept, where the file has several.
  explicit Experiments(const std::string& file, double point = 1)
      : table_(table::read_csv(thesis_folder + "/chapter-4/" + file)) {
    const std::vector<double> points = table_.find("point")->values;
    for (table::Column& column : table_.columns) {
      std::vector<double> kept;
      for (std::size_t row = 0; row < points.size(); ++row)
        if (points[row] == point) kept.push_back(column.values[row]);
      column.values = kept;
    }
  }

  const std::vector<double>& mean(const std::string& condition) const {
    return table_.find("mean." + condition)->values;
  }
  /// In how many the first condition has the larger error.
  double larger(const std::string& one, const std::string& other) const {
    double count = 0.0;
    for (std::size_t row = 0; row < table_.rows(); ++row) count += mean(one)[row] > mean(other)[row] ? 1 : 0;
    return count;
  }
  /// In how many the first condition has less error than each of the others.
  double least(const std::string& one, const std::vector<std::string>& others) const {
    double count = 0.0;
    for (std::size_t row = 0; row < table_.rows(); ++row)
      count += std::ranges::all_of(
          others, [&](const std::string& other) { return mean(one)[row] < mean(other)[row]; });
    return count;
  }
  double count() const { return static_cast<double>(table_.rows()); }

 private:
  table::Table table_;
};

/// Words of the sentences, and the number that is in them, as it follows from what is kept.
struct Fact {
  std::size_t sentence;
  std::string words;
  double said, kept;
};

std::vector<Fact> facts() {
  const Experiments calibrated("task-1.csv", 1), walls("task-1.csv", 2), brakes("task-1.csv", 3);
  const Experiments misjudged("task-2.csv", 1), sure("task-2.csv", 2);
  return {{0, "(law D1) lower the error of the circle in 20", 20, calibrated.larger("NO", "H")},
          {0, "(law D1) lower the error of the circle in 20", 20, walls.larger("NO", "H")},
          {0, "in 20 of 20 experiments", 20, walls.count()},
          {0, "walls and screen together are best in 20", 20, calibrated.least("HV", {"NO", "H", "V"})},
          {0, "walls and screen together are best in 20", 20, walls.least("HV", {"NO", "H", "V"})},
          {1, "(law D2) lower it in none", 0, brakes.larger("NO", "H")},
          {1, "in none of 20", 20, brakes.count()},
          {2, "touch alone is better than the screen alone in 5", 5, misjudged.larger("V", "H")},
          {2, "in 5 of 20 experiments where people misjudge the way by 18 degrees", 20, misjudged.count()},
          {2, "in 0 where they misjudge it by 8", 0, sure.larger("V", "H")}};
}

std::string in_one_line(const std::string& text) {
  return std::regex_replace(text, std::regex("\\s+"), " ");
}

/// All that is a number in a text, words for small ones aside.
std::vector<std::string> numbers_of(const std::string& text) {
  const std::regex number("[0-9]+(\\.[0-9]+)?");
  std::vector<std::string> numbers;
  for (std::sregex_iterator match(text.begin(), text.end(), number), none; match != none; ++match)
    numbers.push_back(match->str());
  return numbers;
}

}  // namespace

TEST_CASE("chapter 4 is summed up in three sentences, which its page has word for word") {
  REQUIRE(sentences().size() == 3);
  const std::string page = in_one_line(io::read_file(thesis_folder + "/README.md"));
  for (const std::string& sentence : sentences()) {
    CHECK_THAT(page, Contains(sentence));
    CHECK(sentence.ends_with("."));
    CHECK_THAT(sentence, !Contains(". "));
  }
}

TEST_CASE("the sentences have the numbers of the experiments that are kept, and no others") {
  std::vector<std::vector<std::string>> known(3);
  for (const Fact& fact : facts()) {
    INFO(fact.words);
    CHECK_THAT(sentences().at(fact.sentence), Contains(fact.words));
    CHECK(fact.said == Approx(fact.kept).margin(1e-9));
    for (const std::string& number : numbers_of(fact.words)) known.at(fact.sentence).push_back(number);
  }
  for (std::size_t i = 0; i < known.size(); ++i)
    for (const std::string& number : numbers_of(sentences().at(i))) {
      INFO(number << " in sentence " << i + 1);
      const bool of_name = number == "1" || number == "2";  // task 2, law D1
      CHECK((of_name || std::ranges::count(known[i], number) > 0));
    }
}

TEST_CASE("the screen and the guiding path lower the error in every edition") {
  for (const double point : {1.0, 2.0, 3.0})
    CHECK(Experiments("task-1.csv", point).larger("NO", "V") >= 15.0);
  for (const double point : {1.0, 2.0, 3.0, 4.0}) {
    const Experiments returns("task-2.csv", point);
    CHECK(returns.larger("V", "V_gp") >= 15.0);
    CHECK(returns.larger("HV", "HV_gp") >= 15.0);
  }
}

}  // namespace stepwire
