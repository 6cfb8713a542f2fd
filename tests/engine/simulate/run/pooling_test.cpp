#include "engine/simulate/run/pooling.hpp"

#include <catch2/catch.hpp>

namespace stepwire::run {

namespace {

record::Recording recording_of(std::vector<double> times, std::vector<std::size_t> starts) {
  return {{{{"time", "s", std::move(times)}}}, std::move(starts), {}};
}

}  // namespace

TEST_CASE("runs that are put behind others keep where each of them starts") {
  record::Recording all;
  append_runs(all, recording_of({0, 1, 0, 1, 2}, {0, 2}));
  append_runs(all, recording_of({0, 3, 0}, {0, 2}));
  CHECK(all.starts == std::vector<std::size_t>{0, 2, 5, 7});
  CHECK(all.table.columns.front().values == std::vector<double>{0, 1, 0, 1, 2, 0, 3, 0});
}

TEST_CASE("points are told apart by as few settings as differ, and by no more than the shortest has") {
  const auto point = [](const std::vector<std::string>& values) {
    std::vector<diagram::Setting> settings;
    for (std::size_t i = 0; i < values.size(); ++i)
      settings.push_back({std::string(1, static_cast<char>('a' + i)), values[i]});
    return settings;
  };
  CHECK(telling_settings({}) == 0);
  CHECK(telling_settings({point({"1", "5"}), point({"2", "5"})}) == 1);
  CHECK(telling_settings({point({"1", "5"}), point({"1", "6"}), point({"2", "5"})}) == 2);
  CHECK(telling_settings({point({"1", "1", "1", "1"}), point({"1", "1"}), point({"1", "1", "2"})}) == 2);
}

}  // namespace stepwire::run
