// Refusals of preparation steps name the place in the diagram, the file and its row.
#include <catch2/catch.hpp>

#include "tests/blocks/records/played.hpp"
#include "tests/engine/base/table/scratch.hpp"

using namespace stepwire;
using Catch::Contains;

namespace {

std::string even_record(const Scratch& scratch, std::size_t rows) {
  return scratch.file("even.csv", record_text(rows, 0.1, [](double t) { return t * t; }));
}

std::string refused_step(const std::string& file, const std::string& step) {
  return refusal(file, "prepare: [" + step + "]");
}

}  // namespace

TEST_CASE("a preparation is a list of known steps with known keys") {
  const Scratch scratch;
  const std::string file = even_record(scratch, 20);
  CHECK_THAT(refusal(file, "prepare: {remove: mean}"), Contains("y.prepare") && Contains("list of steps"));
  CHECK_THAT(refused_step(file, "{smooth: 3}"), Contains("no such step") && Contains("low_pass: 40 Hz"));
  CHECK_THAT(refused_step(file, "remove"), Contains("no such step"));
  CHECK_THAT(refused_step(file, "{low_pass: 1 Hz, ordre: 2}"), Contains("has no 'ordre'"));
  CHECK_THAT(refused_step(file, "{resample: 0.1 s, method: cubic}"),
             Contains("'cubic' is not allowed") && Contains("linear, band_limited"));
}

TEST_CASE("numbers of a step are in their ranges and have their units") {
  const Scratch scratch;
  const std::string file = even_record(scratch, 20);
  CHECK_THAT(refused_step(file, "{remove: 5 N}"), Contains("remove: 5 N is in N, but must be in m"));
  CHECK_THAT(refused_step(file, "{remove: often}"), Contains("'often' is no number"));
  CHECK_THAT(refused_step(file, "{low_pass: 1 s}"), Contains("1 s is in s"));
  CHECK_THAT(refused_step(file, "{low_pass: -1 Hz}"), Contains("must be above 0"));
  CHECK_THAT(refused_step(file, "{low_pass: 1 Hz, order: 2.5}"), Contains("whole number from 1 to 12"));
  CHECK_THAT(refused_step(file, "{low_pass: 5 Hz}"), Contains("half of the rows' rate, 5 Hz"));
  CHECK_THAT(refused_step(file, "{differentiate: 3}"), Contains("whole number from 1 to 2"));
  CHECK_THAT(refused_step(file, "{resample: 5 s}"), Contains("resample: 5 s") && Contains("lasts 1.9"));
  CHECK_THAT(refused_step(file, "{trim: y, threshold: 120 %}"), Contains("below 100 %"));
}

TEST_CASE("uneven rows are told with the row of the file and the cure, also behind rows that are cut off") {
  const Scratch scratch;
  const std::string file =
      scratch.file("uneven.csv", "time,y\n-5,1\n0,1\n0.1,1\n0.2,1\n0.3,1\n0.45,1\n0.5,1\n0.6,1\n");
  for (const std::string step :
       {"{differentiate: 1}", "{low_pass: 1 Hz, order: 1}", "{resample: 0.2 s, method: band_limited}"}) {
    const std::string message = refusal(file, "from: 0 s, prepare: [" + step + "]");
    CHECK_THAT(message, Contains("uneven.csv:7") && Contains("resample: 0.1"));
    CHECK(refusal(file, "from: 0 s, prepare: [{resample: 0.1 s}, " + step + "]").empty());
  }
}

TEST_CASE("a record that is too short for a step is refused with what it needs") {
  const Scratch scratch;
  CHECK_THAT(refused_step(even_record(scratch, 15), "{low_pass: 1 Hz}"),
             Contains("15 rows left, but order 4 needs 16 or more"));
  CHECK(refused_step(even_record(scratch, 16), "{low_pass: 1 Hz}").empty());
  CHECK_THAT(refused_step(even_record(scratch, 2), "{differentiate: 1}"), Contains("needs 3 or more"));
  CHECK_THAT(refused_step(even_record(scratch, 3), "{differentiate: 2}"), Contains("needs 4 or more"));
}

TEST_CASE("a record that trimming leaves nothing of is refused") {
  const Scratch scratch;
  const std::string file = even_record(scratch, 20);
  CHECK_THAT(refused_step(file, "{trim: y, margin: -1 s}"), Contains("no two rows are left"));
  CHECK_THAT(refused_step(file, "{trim: Y}"), Contains("no column 'Y'; did you mean 'y'?"));
  CHECK_THAT(refused_step(scratch.file("still.csv", "time,y\n0,3\n1,3\n2,3\n"), "{trim: y}"),
             Contains("does not move: it is 3 in all rows"));
}

TEST_CASE("a step whose result no number can hold is refused") {
  const Scratch scratch;
  const std::string file = scratch.file("huge.csv", "time,y\n0,-1e308\n0.1,1e308\n0.2,-1e308\n0.3,1e308\n");
  CHECK_THAT(refused_step(file, "{differentiate: 1}"),
             Contains("y of ") && Contains("larger than numbers can be"));
}
