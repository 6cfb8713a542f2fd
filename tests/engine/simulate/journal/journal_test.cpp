#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <thread>

#include "engine/simulate/journal/journal.hpp"
#include "engine/simulate/journal/point_bytes.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::journal {

namespace {

run::Job swept_job(const Scratch& folder) {
  const std::string file = folder.file("lag.yaml", R"(stepwire: 1
title: a lag
step: 10 ms
stop: 50 ms
solver: rk4
parameters: {tau: 50 ms}
blocks:
  source: {block: Constant, value: 1}
  lag: {block: Lag, u: source, tau: $tau}
record: [lag]
sweep: {tau: {from: 10 ms, to: 80 ms, count: 8}}
)");
  static diagram::Loader loader(library());
  return run::make_job(loader, file);
}

/// Numbers that are unlike at each point, and each part of an end that a point may have.
run::PointResult result_of(const run::Job& job, std::size_t point) {
  run::PointResult result;
  result.point = point;
  const auto number = static_cast<double>(point);
  result.end.ticks = static_cast<std::int64_t>(point) + 5;
  result.end.events = {3, 2};
  result.end.faults.push_back(
      {"lag",
       "u",
       0.5 * number,
       {{"lag.yaml", {7, 3}}, "lag.u", {"is wrong", "right it"}, {{"top.yaml", {1, 2}}}}});
  result.end.diagnostics.push_back({"lag", "slow \n text", number});
  result.end.loops.push_back({"a -> b", 1, 2, 3, 4, 5, 0.25});
  record::Recording& recording = result.recordings.emplace_back();
  recording.table.columns = record::empty_columns(job.plan, job.plan.diagram.records.front());
  for (table::Column& column : recording.table.columns) column.values = {number, 1.0 / (1.0 + number), -0.0};
  return result;
}

bool same(const run::PointResult& a, const run::PointResult& b) {
  return bytes_of(a) == bytes_of(b);
}

/// Adds a point to a journal, which it opens for this alone, and returns how long the file is then.
std::uintmax_t keep_alone(const std::string& path, const run::Job& job, std::size_t point) {
  Journal(path, "head", job, nullptr, Journal::Use::write).add(result_of(job, point));
  return std::filesystem::file_size(path);
}

}  // namespace

TEST_CASE("a point's result has the same parts after it has been bytes") {
  const Scratch folder;
  const run::Job job = swept_job(folder);
  const run::PointResult given = result_of(job, 3);
  const auto back = point_of(bytes_of(given), job, nullptr);
  REQUIRE(back);
  CHECK(back->point == 3);
  CHECK(back->end.ticks == 8);
  CHECK(back->end.events.located == 3);
  REQUIRE(back->end.faults.size() == 1);
  CHECK(back->end.faults[0].fault.text() == given.end.faults[0].fault.text());
  CHECK(back->end.faults[0].time == 1.5);
  CHECK(back->end.diagnostics.at(0).text == "slow \n text");
  CHECK(back->end.loops.at(0).first_unsolved == 0.25);
  CHECK(back->recordings.at(0).table.columns.at(1).name == "lag");
  CHECK(back->recordings.at(0).table.columns.at(1).values == given.recordings[0].table.columns[1].values);
}

TEST_CASE("bytes that are cut, longer, or changed in a length are no point") {
  const Scratch folder;
  const run::Job job = swept_job(folder);
  const std::string bytes = bytes_of(result_of(job, 3));
  for (std::size_t size = 0; size < bytes.size(); ++size) CHECK_FALSE(point_of(bytes.substr(0, size), job, nullptr));
  CHECK_FALSE(point_of(bytes + "x", job, nullptr));
  for (std::size_t at = 0; at < bytes.size(); ++at) {  // any other answer will do, but no crash
    std::string changed = bytes;
    changed[at] = static_cast<char>(0xff);
    static_cast<void>(point_of(changed, job, nullptr));
  }
  std::string other = bytes;
  other[0] = 8;  // there are points 0 to 7
  CHECK_FALSE(point_of(other, job, nullptr));
}

TEST_CASE("a journal has its points in their order after it was closed, each once") {
  const Scratch folder;
  const run::Job job = swept_job(folder);
  const std::string path = folder.path("points");
  {
    Journal journal(path, "head", job, nullptr, Journal::Use::write);
    for (const std::size_t point : {5, 2, 7, 2}) journal.add(result_of(job, point));
    CHECK(journal.count() == 3);
  }
  CHECK(Journal::head_of(path) == "head");
  Journal journal(path, "head", job, nullptr, Journal::Use::write);
  CHECK(journal.count() == 3);
  CHECK(journal.has(7));
  CHECK_FALSE(journal.has(0));
  journal.add(result_of(job, 0));
  std::vector<std::size_t> points;
  for (std::size_t point = 0; point < job.points.size(); ++point)
    if (const auto result = journal.point(point)) {
      CHECK(same(*result, result_of(job, point)));
      points.push_back(point);
    }
  CHECK(points == std::vector<std::size_t>{0, 2, 5, 7});
}

TEST_CASE("a journal that was cut anywhere keeps the points before, and goes on behind them") {
  const Scratch folder;
  const run::Job job = swept_job(folder);
  const std::string path = folder.path("points");
  const auto one = keep_alone(path, job, 1), two = keep_alone(path, job, 4);
  for (auto size = one; size < two; size += 7) {
    std::filesystem::copy_file(path, path + "-cut", std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(path + "-cut", size);
    Journal journal(path + "-cut", "head", job, nullptr, Journal::Use::write);
    CHECK(journal.has(1));
    CHECK_FALSE(journal.has(4));
    journal.add(result_of(job, 4));
    for (const std::size_t point : {1, 4}) {
      const auto result = journal.point(point);
      REQUIRE(result);
      CHECK(same(*result, result_of(job, point)));
    }
    CHECK_FALSE(journal.point(0));
  }
}

TEST_CASE("a changed byte ends a journal before its record") {
  const Scratch folder;
  const run::Job job = swept_job(folder);
  const std::string path = folder.path("points");
  const auto one = keep_alone(path, job, 1);
  keep_alone(path, job, 4);
  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary)
      .seekp(static_cast<std::streamoff>(one) + 60)
      .put('\x55');
  const Journal journal(path, "head", job, nullptr, Journal::Use::read);
  CHECK(journal.has(1));
  CHECK_FALSE(journal.has(4));
}

TEST_CASE("a journal of another head is begun anew, and what is none has no head") {
  const Scratch folder;
  const run::Job job = swept_job(folder);
  const std::string path = folder.path("points");
  keep_alone(path, job, 1);
  CHECK(Journal(path, "another", job, nullptr, Journal::Use::write).count() == 0);
  CHECK(Journal::head_of(path) == "another");
  CHECK_FALSE(Journal::head_of(folder.path("none")));
  CHECK_FALSE(Journal::head_of(folder.file("text", "stepwire points 1 without an end")));
  CHECK_FALSE(Journal::head_of(folder.file("other", "a table\n1,2\n")));
}

TEST_CASE("a journal that is followed gives points as they come, until the last has come") {
  const Scratch folder;
  const run::Job job = swept_job(folder);
  Journal journal(folder.path("points"), "head", job, nullptr, Journal::Use::write);
  journal.follow();
  std::vector<std::size_t> points;
  std::thread follower([&] {
    for (std::size_t point = 0; point < 4; ++point)
      if (const auto result = journal.point(point)) points.push_back(result->point);
  });
  for (const std::size_t point : {3, 0, 2}) journal.add(result_of(job, point));
  journal.end_following();
  follower.join();
  CHECK(points == std::vector<std::size_t>{0, 2, 3});
}

}  // namespace stepwire::journal
