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

}  // namespace stepwire::run
