
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "engine/analyse/study/trial_runs.hpp"

namespace stepwire::study {

namespace {

StudyRequest request_of(const std::string& first, const std::vector<std::string>& conditions) {
  StudyRequest request;
  for (const std::string& name : conditions) request.conditions.push_back({{name}, {}});
  if (!first.empty()) request.circle = CircleHandover{first, "x", "y", "r"};
  return request;
}

}  // namespace

TEST_CASE("drawn numbers are the same again, differ by each of their numbers and by their order") {
  CHECK(drawn_number({1, 2, 3}) == drawn_number({1, 2, 3}));
  std::set<std::uint64_t> drawn;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (std::uint64_t subject = 1; subject <= 10; ++subject) drawn.insert(drawn_number({1, seed, subject}));
  CHECK(drawn.size() == 200);
  CHECK(drawn_number({1, 2, 3}) != drawn_number({1, 3, 2}));
  for (const std::uint64_t number : drawn) CHECK(number < 1'000'000'000);
}

TEST_CASE("the condition of the circle comes first, and each order of the others about equally often") {
  const StudyRequest request = request_of("NO", {"NO", "H", "V", "HV"});
  std::map<std::vector<std::size_t>, int> counts;
  for (std::size_t subject = 1; subject <= 6000; ++subject)
    ++counts[order_of_conditions(request, 1, subject)];
  CHECK(counts.size() == 6);
  for (const auto& [order, count] : counts) {
    CHECK(order.front() == 0);
    CHECK(std::abs(count - 1000) < 120);  // four standard deviations, sqrt(6000 (1/6) (5/6)) = 29 each
  }
  CHECK(order_of_conditions(request_of("", {"H", "V"}), 1, 1).size() == 2);
}

}  // namespace stepwire::study
