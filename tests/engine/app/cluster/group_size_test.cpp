#include "engine/app/cluster/item_server.hpp"

#include <catch2/catch.hpp>
#include <vector>

namespace stepwire::cluster {

namespace {

GroupSize known(double item, double answer) {
  GroupSize size;
  size.note_group(100, 100 * item);
  size.note_answer(answer);
  return size;
}

}  // namespace

TEST_CASE("while nothing is known a process is given a few items, and one at least") {
  const GroupSize size;
  CHECK(size.next(1'000'000, 10) == 8);
  CHECK(size.next(100, 10) == 2);
  CHECK(size.next(3, 10) == 1);
}

TEST_CASE("of long items a process is given a quarter of what is left for each, down to one") {
  const GroupSize size = known(1.0, 1e-5);
  CHECK(size.next(400, 10) == 10);  // no more than ten seconds of work
  CHECK(size.next(120, 10) == 3);
  CHECK(size.next(39, 10) == 1);
}

TEST_CASE(
    "of short items a process is given so many that answers to all take a quarter of the time at most") {
  constexpr double item = 1e-3, answer = 1e-5;
  for (const std::size_t processes : {10u, 100u, 1000u, 10'000u}) {
    const std::size_t many = known(item, answer).next(1'000'000'000, processes);
    // Every process sends one request within the time of one group.
    CHECK(answer * static_cast<double>(processes) <= 0.25 * item * static_cast<double>(many) * 1.0001);
  }
  // Where little is left, an even share is enough.
  CHECK(known(item, answer).next(20'000, 10'000) == 3);
}

TEST_CASE("a group takes ten seconds at most, which is what is lost with a process, if one item does not") {
  CHECK(known(0.1, 1e-5).next(1'000'000'000, 10) == 100);
  CHECK(known(60.0, 1e-5).next(1'000'000'000, 10) == 1);
}

TEST_CASE("what is given grows with nothing but what was noted, and forgets what is long ago") {
  GroupSize size = known(1.0, 1e-6);
  for (int i = 0; i < 100'000; ++i) size.note_group(1, 0.01);
  CHECK(size.next(1'000'000'000, 10) > 900);
}

}  // namespace stepwire::cluster
