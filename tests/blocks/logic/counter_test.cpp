#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("A counter counts edges, wraps around, counts downwards and is reset") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 2 s
solver: euler
blocks:
  beat: {block: Pulse, period: 0.1 s, width: 0.5, delay: 50 ms}
  back: {block: Step, time: 1 s}
  r: {block: Step, time: 1.5 s}
  plain: {block: Counter, u: beat}
  ten: {block: Counter, u: beat, lower: 0, upper: 3, beyond: wrap}
  held: {block: Counter, u: beat, upper: 3}
  two: {block: Counter, u: beat, down: back, step: 2}
  anew: {block: Counter, u: beat, reset: r, initial: 7}
  ticks: {block: Counter, every: 0.1 s}
  both: {block: Counter, u: beat, count_at: either}
record: [plain, ten, held, two, anew, ticks, both]
)");
  // Rising edges at 0.05, 0.15, ...: ten until 1 s.
  CHECK(column(table, "plain")[4] == 0.0);
  CHECK(column(table, "plain")[5] == 1.0);
  CHECK(column(table, "plain")[100] == 10.0);
  CHECK(column(table, "ten")[100] == 2.0);
  CHECK(column(table, "held")[100] == 3.0);
  CHECK(column(table, "two")[99] == 20.0);
  CHECK(column(table, "two")[200] == 0.0);
  CHECK(column(table, "anew")[149] == 22.0);
  CHECK(column(table, "anew")[150] == 7.0);
  CHECK(column(table, "anew")[155] == 8.0);
  CHECK(column(table, "ticks")[200] == 20.0);
  CHECK(column(table, "both")[100] == 20.0);
}

TEST_CASE("A counter that wraps needs both ends") {
  CHECK(error_of(R"(
step: 10 ms
stop: 2 s
solver: euler
blocks:
  c: {block: Counter, upper: 3, beyond: wrap}
record: [c]
)")
            .find("'wrap' needs both") != std::string::npos);
}
