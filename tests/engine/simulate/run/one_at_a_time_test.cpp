#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {
using Catch::Contains;

namespace {

record::Recording swept(const std::string& yaml, const std::vector<diagram::Setting>& settings = {}) {
  const DiagramFolder folder;
  folder.write("sweep.yaml", "stepwire: 1\nstep: 1 s\nstop: 1 s\n" + yaml);
  diagram::Loader loader(library());
  const Job job = make_job(loader, folder.path("sweep.yaml"), settings);
  return run_job(job).recordings.at(0);
}

const std::string two =
    "parameters: {a: 2, b: 3 mm, c: = 5*a}\nblocks:\n  y: {block: Constant, value: [$a, $c]}\n"
    "  z: {block: Constant, value: $b}\nrecord: [y, z]\n";

std::vector<std::string> words_of(const record::Recording& recording, const std::string& name) {
  std::vector<std::string> texts;
  for (const record::Categories& words : recording.categories)
    if (words.column == name)
      for (const double number : column(recording.table, name))
        texts.push_back(words.texts.at(static_cast<std::size_t>(number)));
  return texts;
}

}  // namespace

TEST_CASE("one parameter at a time leaves the file's value") {
  const record::Recording all = swept(two + "sweep: {one_at_a_time: {a: [1, 4], b: [1 mm, 5 mm, 9 mm]}}\n");
  CHECK(column(all.table, "a") == std::vector<double>{2, 2, 1, 1, 4, 4, 2, 2, 2, 2, 2, 2});
  const std::vector<double> b{0.003, 0.003, 0.003, 0.003, 0.003, 0.003,
                              0.001, 0.001, 0.005, 0.005, 0.009, 0.009};
  CHECK(column(all.table, "b") == b);
  CHECK(column(all.table, "z") == b);
  CHECK(column(all.table, "y.1") == column(all.table, "a"));
}

TEST_CASE("each point says which parameter differs, and to what") {
  const record::Recording all = swept(two + "sweep: {one_at_a_time: {a: [1, 4], b: [1 mm, 5 mm]}}\n");
  CHECK(words_of(all, "differs") ==
        std::vector<std::string>{"base", "base", "a", "a", "a", "a", "b", "b", "b", "b"});
  CHECK(words_of(all, "differs_to") ==
        std::vector<std::string>{"", "", "1", "1", "4", "4", "1 mm", "1 mm", "5 mm", "5 mm"});
}

TEST_CASE("what follows from a parameter follows it, and has its own range where it is varied itself") {
  const record::Recording all =
      swept(two + "sweep: {one_at_a_time: {a: [1], b: {from: 1 mm, to: 2 mm, count: 2}}}\n");
  CHECK(column(all.table, "y.2") == std::vector<double>{10, 10, 5, 5, 10, 10, 10, 10});
  const record::Recording own = swept(two + "sweep: {one_at_a_time: {c: [1, 20]}}\n");
  CHECK(column(own.table, "y.2") == std::vector<double>{10, 10, 1, 1, 20, 20});
}

TEST_CASE("values of the call are those from which one parameter at a time differs") {
  const std::string yaml = two + "sweep: {one_at_a_time: {b: [1 mm]}}\n";
  CHECK(column(swept(yaml, {{"a", "7"}}).table, "y.1") == std::vector<double>{7, 7, 7, 7});
}

TEST_CASE("what one parameter at a time cannot be is refused in words") {
  CHECK_THROWS_WITH(swept(two + "sweep: {one_at_a_time: {q: [1]}}\n"),
                    Contains("one_at_a_time.q: is no parameter"));
  CHECK_THROWS_WITH(swept(two + "sweep: {one_at_a_time: {a: [1]}, b: [1 mm]}\n"), Contains("stands alone"));
  CHECK_THROWS_WITH(swept(two + "sweep: {one_at_a_time: [a]}\n"), Contains("is a map of parameters"));
  CHECK_THROWS_WITH(swept(two + "sweep: {one_at_a_time: {a: []}}\n"), Contains("has no values"));
  CHECK_THROWS_WITH(swept(two + "sweep: {one_at_a_time: {b: [1 N]}}\n"), Contains("b"));
}

}  // namespace stepwire::run
