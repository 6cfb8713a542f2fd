#include "engine/analyse/study/trials.hpp"

#include <catch2/catch.hpp>

#include "engine/base/table/table_file.hpp"
#include "tests/engine/analyse/study/samples.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::study {
using namespace testing;
using Catch::Matchers::EndsWith;

namespace {

const std::string head = "subject,task,condition,time [s],x [mm],y [mm]\n";

std::vector<Trial> trials_of(const std::string& text) {
  const Scratch scratch;
  return read_trials(scratch.file("trials.csv", text));
}

std::string refusal(const std::string& text) {
  try {
    trials_of(text);
  } catch (const table::TableError& error) {
    return error.what();
  }
  return "nothing is wrong";
}

}  // namespace

TEST_CASE("trials are read in SI, one for each subject, task and condition") {
  const auto trials = trials_of(
      head +
      "Ann,1,NO,0,1,2\nAnn,1,NO,0.5,3,4\nAnn,1,V,0,5,6\nAnn,1,V,1,7,8\nBo,1,NO,0,9,1\nBo,1,NO,1,2,3\n");
  REQUIRE(trials.size() == 3);
  CHECK(trials[0].subject == "Ann");
  CHECK(trials[1].condition == "V");
  CHECK(trials[0].time == std::vector<double>{0.0, 0.5});
  CHECK(trials[1].points(1, 1) == Approx(0.008));
  CHECK(trials[2].subject == "Bo");
}

TEST_CASE("columns may stand in any order and have any unit of their kind") {
  const auto trials =
      trials_of("y [m];x [in];time [ms];condition;task;subject\n0.5;1;0;V;2;7\n0.25;0;100;V;2;7\n");
  REQUIRE(trials.size() == 1);
  CHECK(trials[0].points(0, 0) == Approx(0.0254));
  CHECK(trials[0].points(1, 0) == 0.5);
  CHECK(trials[0].time[1] == Approx(0.1));
}

TEST_CASE("what is written is read back") {
  const Scratch scratch;
  const std::vector<Trial> trials{circle_drawing("a, b", "NO", 0.0, 0.1 * mm),
                                  straight_return("c", "V", 0.3)};
  const auto again = read_trials(scratch.file("trials.csv", trials_csv(trials)));
  REQUIRE(again.size() == 2);
  CHECK(again[0].subject == "a, b");
  CHECK(again[1].time == trials[1].time);
  CHECK((again[0].points - trials[0].points).cwiseAbs().maxCoeff() < 1e-16);
}

TEST_CASE("a file of trials that is wrong is refused with its row and what would be right") {
  CHECK_THAT(
      refusal("subject,task,time [s],x [mm],y [mm]\n1,1,0,1,1\n"),
      EndsWith(".csv:1: there is no column 'condition'; trials have subject, task, condition, time [s], x "
               "[mm], y [mm]"));
  CHECK_THAT(refusal("subject,task,condition,time [s],x,y [mm]\n1,1,V,0,1,1\n"),
             EndsWith(".csv:1: the column 'x' needs a unit: 'x [mm]', not ''"));
  CHECK_THAT(refusal("subject,task,condition,time [mm],x [mm],y [mm]\n1,1,V,0,1,1\n"),
             EndsWith(".csv:1: the column 'time' needs a unit: 'time [s]', not 'mm'"));
  CHECK_THAT(refusal(head), EndsWith(".csv: there are no rows below the header"));
  CHECK_THAT(refusal(head + "1,1,V,0,1,1\n1,1,V,0,1,1\n"),
             EndsWith(".csv:3: the time does not rise: 0 s after 0 s"));
  CHECK_THAT(refusal(head + "1,1,V,0,1,1\n1,1,V,1,nan,1\n"), EndsWith(".csv:3: 'x' is no finite number"));
  CHECK_THAT(refusal(head + "1,1,V,0,1,1\n1,1,V,1,oops,1\n"),
             EndsWith(".csv:3: 'oops' is no number (column 'x')"));
  CHECK_THAT(refusal(head + ",1,V,0,1,1\n,1,V,1,1,1\n"), EndsWith(".csv:2: the subject is missing"));
  CHECK_THAT(refusal(head + "1,1,V,0,1,1\n1,1,H,0,1,1\n"),
             EndsWith(".csv:2: subject 1, task 1, condition V has one row only; a trial needs two or more"));
  CHECK_THAT(
      refusal(head + "1,1,V,0,1,1\n1,1,V,1,1,1\n1,1,H,0,1,1\n1,1,H,1,1,1\n1,1,V,0,1,1\n1,1,V,1,1,1\n"),
      EndsWith(".csv:6: subject 1, task 1, condition V starts again; its first trial is at line 2, and a "
               "repeated trial replaces the first one"));
}

}  // namespace stepwire::study
