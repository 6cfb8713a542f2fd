// Reactions of a loop to missed deadlines, with a clock and delays of the test's own.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/simulate/realtime/fakes.hpp"

namespace stepwire::realtime {

namespace {

std::vector<double> column_of(const std::vector<std::vector<double>>& rows, std::size_t index) {
  std::vector<double> column;
  for (const auto& row : rows) column.push_back(row[index]);
  return column;
}

constexpr std::size_t row_width = 5;  // file, time, tick, wall, count

}  // namespace

TEST_CASE("a loop that is always on time misses nothing and writes at its deadlines") {
  LoopRig rig(counting_yaml, options_of(5));
  rig.loop.serve(5);
  CHECK(rig.loop.end() == Loop::End::done);
  CHECK(rig.loop.deadlines().missed() == 0);
  CHECK(rig.loop.steps() == 5);
  CHECK(rig.device.written == std::vector<double>{1, 2, 3, 4, 5, -1});
  CHECK(rig.device.written_at == std::vector<std::int64_t>{0, ms, 2 * ms, 3 * ms, 4 * ms, 4 * ms});
}

TEST_CASE(
    "skip: a step of two and a half periods is late, the next deadline is dropped, and diagram time waits") {
  LoopRig rig(counting_yaml, options_of(8));
  rig.device.read_takes[2] = 5 * ms / 2;
  rig.loop.serve(8);
  const Deadlines& deadlines = rig.loop.deadlines();
  CHECK(deadlines.late() == 1);     // 2, written at 4.5 ms
  CHECK(deadlines.dropped() == 1);  // 3, whose period was over at 4.5 ms
  CHECK(deadlines.longest_row() == 2);
  CHECK(rig.loop.steps() == 7);
  CHECK(rig.device.written_at ==
        std::vector<std::int64_t>{0, ms, 9 * ms / 2, 9 * ms / 2, 5 * ms, 6 * ms, 7 * ms, 7 * ms});
  const auto rows = rig.rows(row_width);
  CHECK(column_of(rows, 2) == std::vector<double>{0, 1, 2, 3, 4, 5, 6});
  CHECK(column_of(rows, 4) == std::vector<double>{1, 2, 3, 4, 5, 6, 7});
  CHECK(rows[3][1] == Approx(0.003));   // diagram time
  CHECK(rows[3][3] == Approx(0.0045));  // by the clock
  CHECK(rows[6][3] == Approx(0.007));
}

TEST_CASE("catch-up: the same step makes two deadlines late, and no tick is left out") {
  LoopRig rig(counting_yaml, options_of(8, Overrun::Kind::catch_up));
  rig.device.read_takes[2] = 5 * ms / 2;
  rig.loop.serve(8);
  CHECK(rig.loop.deadlines().late() == 2);  // 2 and 3, both written at 4.5 ms
  CHECK(rig.loop.deadlines().dropped() == 0);
  CHECK(rig.loop.deadlines().longest_row() == 2);
  CHECK(rig.loop.steps() == 8);
  const auto rows = rig.rows(row_width);
  CHECK(column_of(rows, 2) == std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(rows[7][1] == Approx(rows[7][3]));  // diagram time is the clock's again
}

TEST_CASE("catch-up: a device gets no burst of commands, and the newest one at last") {
  LoopRig rig(counting_yaml, options_of(12, Overrun::Kind::catch_up));
  rig.clock.late_after[3] = 27 * ms / 5;  // of deadline 3, until 8.4 ms: 3 to 7 have passed
  rig.loop.serve(12);
  CHECK(rig.loop.steps() == 12);
  CHECK(rig.loop.deadlines().late() == 5);
  CHECK(rig.device.written == std::vector<double>{1, 2, 3, 4, 9, 10, 11, 12, -1});
  CHECK(rig.device.written_at == std::vector<std::int64_t>{0, ms, 2 * ms, 42 * ms / 5, 42 * ms / 5, 9 * ms,
                                                           10 * ms, 11 * ms, 11 * ms});
  CHECK(rig.loop.measurements().response().count() == 12);
}

TEST_CASE("a thread that oversleeps counts at each deadline that it slept through, not only at one") {
  LoopRig rig(counting_yaml, options_of(6));
  rig.clock.late_after[1] = 16 * ms / 5;  // of deadline 1, until 4.2 ms
  rig.loop.serve(6);
  CHECK(rig.loop.deadlines().dropped() == 3);  // 1, 2 and 3
  CHECK(rig.loop.deadlines().late() == 0);
  CHECK(rig.loop.deadlines().longest_row() == 3);
  const Histogram& wake_up = rig.loop.measurements().wake_up();
  CHECK(wake_up.count() == 6);
  CHECK(wake_up.max() == 16 * ms / 5);
  CHECK(wake_up.mean() == Approx((3.2 + 2.2 + 1.2 + 0.2) * ms / 6.0));
  const Histogram& response = rig.loop.measurements().response();
  CHECK(response.count() == 6);
  CHECK(response.mean() == Approx((3.2 + 2.2 + 1.2 + 0.2) * ms / 6.0));
  CHECK(rig.loop.measurements().step().count() == 3);
}

TEST_CASE("a step that is too long makes every later deadline late by what it lacks") {
  LoopRig rig(counting_yaml, options_of(40, Overrun::Kind::catch_up));
  for (int read = 0; read < 40; ++read) rig.device.read_takes[read] = 6 * ms / 5;
  rig.loop.serve(40);
  const Histogram& wake_up = rig.loop.measurements().wake_up();
  CHECK(wake_up.count() == 40);
  CHECK(wake_up.max() == 39 * ms / 5);
  CHECK(wake_up.mean() == Approx(39 * ms / 10.0));
  CHECK(rig.loop.measurements().step().min() == 6 * ms / 5);
}

TEST_CASE("stop ends the loop after so many misses in a row, and safe values are out within one period") {
  LoopRig rig(counting_yaml, options_of(100, Overrun::Kind::stop, 3));
  for (const int read : {10, 11}) rig.device.read_takes[read] = 11 * ms / 10;
  for (const int read : {20, 21, 22, 23}) rig.device.read_takes[read] = 11 * ms / 10;
  rig.loop.serve(100);
  CHECK(rig.loop.end() == Loop::End::stopped);
  CHECK(rig.loop.deadlines().longest_row() == 3);
  CHECK(rig.loop.deadlines().missed() == 5);
  CHECK(rig.loop.steps() == 23);
  CHECK(rig.device.written.back() == -1);
  const std::int64_t third_missed = 23 * ms;  // the outputs of deadline 22 were due by 23
  CHECK(rig.device.written_at.back() >= third_missed);
  CHECK(rig.device.written_at.back() <= third_missed + ms);
}

TEST_CASE("stop counts deadlines that were slept through, and then takes no further step") {
  LoopRig rig(counting_yaml, options_of(100, Overrun::Kind::stop, 4));
  rig.clock.late_after[7] = 9 * ms / 2;
  rig.loop.serve(100);
  CHECK(rig.loop.end() == Loop::End::stopped);
  CHECK(rig.loop.steps() == 7);
  CHECK(rig.loop.deadlines().dropped() == 4);
  CHECK(rig.device.written == std::vector<double>{1, 2, 3, 4, 5, 6, 7, -1});
  CHECK(rig.loop.measurements().response().count() == 11);
}

TEST_CASE("deadlines that were dropped at the end count, and none beyond it") {
  LoopRig rig(counting_yaml, options_of(5));
  rig.clock.late_after[3] = 50 * ms;
  rig.loop.serve(5);
  CHECK(rig.loop.end() == Loop::End::done);
  CHECK(rig.loop.deadlines().dropped() == 2);
  CHECK(rig.loop.measurements().wake_up().count() == 5);
  CHECK(rig.loop.measurements().response().count() == 5);
}

TEST_CASE("the worst of each stretch of deadlines is kept where it happened") {
  LoopRig rig(counting_yaml, options_of(1000));
  rig.clock.late_after[503] = ms / 4;
  rig.device.read_takes[998] = ms / 2;
  rig.loop.serve(1000);
  const auto& worst = rig.loop.measurements().worst();
  REQUIRE(worst.size() == 200);
  CHECK(worst[100].wake_up == ms / 4);
  CHECK(worst[101].wake_up == 0);
  CHECK(worst[199].step == ms / 2);
  CHECK(worst[199].response == ms / 2);
  CHECK(worst[199].wake_up == 0);
}

}  // namespace stepwire::realtime
