#include "engine/app/studio/live/sample_store.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

namespace stepwire::live {

namespace {

/// A wave with steps of its own at each tick, so that no two stretches of it are alike.
double wave(std::int64_t tick) {
  return std::sin(0.01 * static_cast<double>(tick)) + 0.1 * std::cos(1.7 * static_cast<double>(tick));
}

void fill(SampleStore& store, std::int64_t from, std::int64_t to, std::int64_t spike = -1) {
  std::vector<double> rows;
  for (std::int64_t tick = from; tick < to; ++tick) rows.push_back(tick == spike ? 7.0 : wave(tick));
  store.append(rows);
}

Extremes counted(std::int64_t from, std::int64_t to, std::int64_t spike) {
  Extremes all;
  for (std::int64_t tick = from; tick < to; ++tick) {
    const double value = tick == spike ? 7.0 : wave(tick);
    all.take({value, value});
  }
  return all;
}

const StoreOptions small{.chunks_in_memory = 2, .folder = {}};
const StoreOptions none{.bytes = 0, .folder = {}};

}  // namespace

TEST_CASE("a spike of one sample is in the answer wherever it is and however far the view is away") {
  constexpr std::int64_t ticks = 200'000;
  for (const std::int64_t spike : {0L, 63L, 64L, 4095L, 4096L, 77'777L, 131'072L, 199'998L, 199'999L}) {
    SampleStore store(1e-3, small);
    store.add(0);
    fill(store, 0, ticks, spike);
    for (const std::int64_t width : {100L, 5'000L, 40'000L, ticks})
      for (const std::size_t pixels : {1u, 7u, 100u, 1000u}) {
        const std::int64_t from = std::clamp<std::int64_t>(spike - width / 3, 0, ticks - width);
        const SampleRows rows = store.look({{0}, from, from + width, pixels});
        const std::vector<double>& most = rows.columns.back();
        INFO("spike at " << spike << ", " << width << " ticks on " << pixels << " pixels");
        CHECK(std::ranges::max(most) == 7.0);
        CHECK(std::ranges::count(most, 7.0) == 1);
      }
  }
}

TEST_CASE("each row of a far view has the extremes of exactly its ticks") {
  constexpr std::int64_t ticks = 150'000, spike = 100'100;
  SampleStore store(1e-3, small);
  store.add(0);
  fill(store, 0, ticks, spike);
  std::mt19937 random(1);
  for (int i = 0; i < 60; ++i) {
    std::uniform_int_distribution<std::int64_t> any(0, ticks);
    const auto [from, to] = std::minmax({any(random), any(random)});
    const SampleRows rows = store.look({{0}, from, to, i % 2 == 0 ? 50u : 1000u});
    for (std::size_t r = 0; rows.extremes && r < rows.ticks.size(); ++r) {
      const std::int64_t end = r + 1 < rows.ticks.size() ? rows.ticks[r + 1] : to;
      const Extremes right = counted(rows.ticks[r], end, spike);
      REQUIRE(rows.columns[0][r] == right.least);
      REQUIRE(rows.columns[1][r] == right.most);
    }
  }
}

TEST_CASE("an answer has at most four values of a signal for a pixel, and all samples where they are few") {
  SampleStore store(1e-3, small);
  store.add(0);
  fill(store, 0, 100'000);
  for (const std::int64_t width :
       {10L, 199L, 200L, 201L, 299L, 1'000L, 6'400L, 12'799L, 30'000L, 77'000L, 100'000L}) {
    const SampleRows rows = store.look({{0}, 0, width, 100});
    const std::size_t values = rows.ticks.size() * (rows.extremes ? 2 : 1);
    INFO(width);
    CHECK(values <= 400);
    CHECK(rows.extremes == (width > 200));
    if (!rows.extremes) CHECK(rows.ticks.size() == static_cast<std::size_t>(width));
  }
}

TEST_CASE("rows of a view that moves on stay where they are") {
  SampleStore store(1e-3, small);
  store.add(0);
  fill(store, 0, 60'000);
  const SampleRows before = store.look({{0}, 10'000, 50'000, 100}),
                   after = store.look({{0}, 10'123, 50'123, 100});
  CHECK(before.ticks[5] == after.ticks[5]);
  CHECK(before.columns[1][5] == after.columns[1][5]);
}

TEST_CASE("no sample is lost on the disk, and none comes back that was cut off") {
  SampleStore store(1e-3, GENERATE(small, none));
  store.add(0);
  fill(store, 0, 50'000);
  std::vector<double> all(50'000);
  store.read(0, 0, all);
  for (std::int64_t tick = 0; tick < 50'000; ++tick)
    REQUIRE(all[static_cast<std::size_t>(tick)] == wave(tick));
  for (const std::int64_t cut : {49'999L, 45'056L, 20'001L, 4'096L, 5L}) {
    store.cut(cut);
    REQUIRE(store.end_tick() == cut);
    fill(store, cut, 60'000, cut + 1);
    CHECK(store.look({{0}, 0, 60'000, 10}).columns[1].size() > 0);
    const SampleStatistics seen = store.statistics(0, 0, 60'000);
    CHECK(seen.most == 7.0);
    std::vector<double> again(4);
    store.read(0, cut - 1, again);
    CHECK(again == std::vector{wave(cut - 1), wave(cut), 7.0, wave(cut + 2)});
  }
}

TEST_CASE("a column that comes later has nothing before, and lies at the same ticks as the others") {
  SampleStore store(1e-3, small);
  store.add(0);
  fill(store, 0, 10'000);
  const std::size_t late = store.add(10'000);
  std::vector<double> rows;
  for (std::int64_t tick = 10'000; tick < 30'000; ++tick) {
    rows.push_back(wave(tick));
    rows.push_back(static_cast<double>(tick));
  }
  store.append(rows);
  const SampleRows seen = store.look({{0, late}, 0, 30'000, 100});
  REQUIRE(seen.extremes);
  CHECK(std::isnan(seen.columns[2].front()));
  CHECK(seen.columns[3].back() == 29'999.0);
  CHECK(store.look({{late}, 9'999, 10'002, 100}).columns[0][1] == 10'000.0);
  store.cut(5'000);
  CHECK(store.first_tick(late) == 5'000);
  CHECK(store.end_tick() == 5'000);
}

TEST_CASE("statistics are those of all samples between the cursors") {
  SampleStore store(1e-3, small);
  store.add(0);
  std::vector<double> line;
  for (int tick = 0; tick < 20'001; ++tick) line.push_back(1e6 + 0.5 * tick);
  store.append(line);
  const SampleStatistics seen = store.statistics(0, 100, 20'001);
  CHECK(seen.first == 1e6 + 50.0);
  CHECK(seen.last == 1e6 + 10'000.0);
  CHECK(seen.least == seen.first);
  CHECK(seen.most == seen.last);
  CHECK(seen.mean == Approx(1e6 + 0.5 * 10'050.0).epsilon(1e-12));
  CHECK(seen.slope == Approx(0.5).epsilon(1e-9));
  CHECK(seen.rms == Approx(1005029.0).epsilon(1e-5));
  CHECK(std::isnan(store.statistics(0, 30'000, 40'000).mean));
}

}  // namespace stepwire::live
