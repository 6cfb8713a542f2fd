#include "engine/model/plan/worklist.hpp"

#include <catch2/catch.hpp>
#include <vector>

namespace stepwire::plan {

namespace {

/// Takes all items from a worklist, where `calls` may add others. Returns them in the order in which they
/// were taken.
template <class Calls>
std::vector<int> asked(Worklist& turns, const Calls& calls) {
  std::vector<int> order;
  while (const auto who = turns.next()) {
    order.push_back(*who);
    calls(*who, static_cast<int>(order.size()));
  }
  return order;
}

}  // namespace

TEST_CASE("all who were called are asked once, in their order and not in that of the calls") {
  Worklist turns;
  for (int who : {3, 1, 2, 1}) turns.call(who);
  CHECK(asked(turns, [](int, int) {}) == std::vector<int>{1, 2, 3});
}

TEST_CASE("who is called has a turn in this round if it is still to come, and in the next if it is over") {
  Worklist turns;
  for (int who : {1, 2, 3}) turns.call(who);
  const auto order = asked(turns, [&](int who, int turn) {
    if (turn == 2 && who == 2)
      for (int other : {4, 1, 2}) turns.call(other);
  });
  CHECK(order == std::vector<int>{1, 2, 3, 4, 1, 2});
}

TEST_CASE("once nobody is left, a round starts anew") {
  Worklist turns;
  turns.call(5);
  asked(turns, [](int, int) {});
  for (int who : {7, 2}) turns.call(who);
  CHECK(asked(turns, [](int, int) {}) == std::vector<int>{2, 7});
}

}  // namespace stepwire::plan
