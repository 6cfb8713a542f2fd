#include "engine/simulate/realtime/deadlines.hpp"

#include <catch2/catch.hpp>

namespace stepwire::realtime {

namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t end = 1'000;

Deadlines each_ms(Overrun overrun) {
  Deadlines deadlines(1000.0, overrun);
  deadlines.start_at(100 * ms);
  return deadlines;
}

}  // namespace

TEST_CASE("deadlines are where their number says, however many there were") {
  Deadlines thirds(3.0, {});
  CHECK(thirds.at(1) == 333'333'333);
  CHECK(thirds.at(2) == 666'666'667);
  CHECK(thirds.at(3'000'000'000) == 1'000'000'000'000'000'000);
}

TEST_CASE("a deadline is met whose outputs are written before the next one, and missed by those on it") {
  Deadlines deadlines = each_ms({});
  deadlines.served(deadlines.at(1) - 1);
  CHECK(deadlines.missed() == 0);
  deadlines.served(deadlines.at(2));
  CHECK(deadlines.late() == 1);
  CHECK(deadlines.index() == 2);
  CHECK(deadlines.longest_row() == 1);
}

TEST_CASE("skip drops the deadlines whose period is over, and keeps the one in whose period it is") {
  Deadlines deadlines = each_ms({});
  CHECK(deadlines.drop_missed(deadlines.at(0) + ms - 1, end) == 0);
  CHECK(deadlines.drop_missed(deadlines.at(0) + ms, end) == 1);
  CHECK(deadlines.index() == 1);
  CHECK(deadlines.drop_missed(deadlines.at(4) + 1, end) == 3);
  CHECK(deadlines.index() == 4);
  CHECK(deadlines.dropped() == 4);
  CHECK(deadlines.longest_row() == 4);
}

TEST_CASE("nothing is dropped from the end on") {
  Deadlines deadlines = each_ms({});
  CHECK(deadlines.drop_missed(deadlines.at(50), 3) == 3);
  CHECK(deadlines.index() == 3);
}

TEST_CASE("catch-up drops nothing, and what it serves late is missed") {
  Deadlines deadlines = each_ms({Overrun::Kind::catch_up, 0});
  const std::int64_t now = deadlines.at(2) + ms / 2;
  CHECK(deadlines.drop_missed(now, end) == 0);
  for (int k = 0; k < 3; ++k) deadlines.served(now);
  CHECK(deadlines.late() == 2);  // those of 0 and 1; that of 2 is still in its period
  CHECK(deadlines.dropped() == 0);
  CHECK(deadlines.longest_row() == 2);
}

TEST_CASE("a row of misses ends with a deadline that is met, and the longest is kept") {
  Deadlines deadlines = each_ms({});
  for (const bool met : {false, false, false, true, false, true})
    deadlines.served(deadlines.at(deadlines.index()) + (met ? 0 : 2 * ms));
  CHECK(deadlines.missed() == 4);
  CHECK(deadlines.longest_row() == 3);
}

TEST_CASE("stop has enough after so many misses in a row, late and dropped alike") {
  Deadlines deadlines = each_ms({Overrun::Kind::stop, 3});
  deadlines.served(deadlines.at(0) + 2 * ms);
  CHECK_FALSE(deadlines.must_stop());
  deadlines.served(deadlines.at(1));
  deadlines.served(deadlines.at(2) + ms);
  CHECK_FALSE(deadlines.must_stop());
  CHECK(deadlines.drop_missed(deadlines.at(5), end) == 2);
  CHECK(deadlines.must_stop());
}

TEST_CASE("a pause moves the deadlines that are left, and no other") {
  Deadlines deadlines = each_ms({});
  deadlines.served(deadlines.at(0));
  deadlines.start_at(500 * ms);
  CHECK(deadlines.index() == 1);
  CHECK(deadlines.at(1) == 500 * ms);
  CHECK(deadlines.at(3) == 502 * ms);
}

TEST_CASE("the words for overruns are read, and nothing else") {
  CHECK(parse_overrun("skip") == Overrun{Overrun::Kind::skip, 0});
  CHECK(parse_overrun("catch-up") == Overrun{Overrun::Kind::catch_up, 0});
  CHECK(parse_overrun("stop:12") == Overrun{Overrun::Kind::stop, 12});
  for (const char* text : {"", "Skip", "stop", "stop:", "stop:0", "stop:-1", "stop:3x", "stop: 3"}) {
    INFO(text);
    CHECK_FALSE(parse_overrun(text));
  }
}

}  // namespace stepwire::realtime
