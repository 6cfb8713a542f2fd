#include "engine/simulate/run/run_pool.hpp"

#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"

namespace stepwire::run {

namespace {

using Settings = std::vector<diagram::Setting>;

/// A file with dx/dt = k from x = 0 on, which ends at the time `t` and so has the structure of `t`.
struct Ramps {
  Ramps() {
    folder.write("ramp.yaml",
                 "stepwire: 1\nstep: 1 s\nstop: $t\nsolver: euler\n"
                 "parameters: {k: {value: 1, above: 0}, t: 2 s}\n"
                 "blocks:\n  slope: {block: Constant, value: $k}\n  x: {block: Integrator, u: slope}\n"
                 "record: x\n");
    base.emplace(plan::make_plan(loader.load(folder.path("ramp.yaml"))));
    family.emplace(loader, folder.path("ramp.yaml"), Settings{}, *base);
  }

  DiagramFolder folder;
  diagram::Loader loader{library()};
  std::optional<plan::Plan> base;
  std::optional<PlanFamily> family;
};

std::vector<double> x_of(RunPool& pool, const PooledRun& run) {
  return pool.run(run, 0).recordings.front().table.find("x")->values;
}

}  // namespace

TEST_CASE("values that change the structure have a plan of their own, others the plan of the family") {
  Ramps ramps;
  const std::size_t member = ramps.family->add({{"k", "1"}, {"t", "2 s"}}, {});
  RunPool pool(*ramps.family, {});
  const PooledRun longer = pool.begin(member, {{"k", "3"}, {"t", "4 s"}});
  CHECK(longer.has_own_plan());
  CHECK(x_of(pool, longer) == std::vector<double>{0, 3, 6, 9, 12});
  const PooledRun alike = pool.begin(member, {{"k", "5"}, {"t", "2 s"}});
  CHECK_FALSE(alike.has_own_plan());
  CHECK(x_of(pool, alike) == std::vector<double>{0, 5, 10});
  CHECK(ramps.family->size() == 1);
}

TEST_CASE("a member has its fixed settings beside the values that its runs set") {
  Ramps ramps;
  for (const auto& [stop, rows] : {std::pair{"3 s", 4u}, {"1 s", 2u}}) {
    const std::size_t member = ramps.family->add({{"k", "1"}}, {{"t", stop}});
    RunPool pool(*ramps.family, {});
    const std::vector<double> set = x_of(pool, pool.begin(member, {{"k", "2"}}));
    CHECK(set.size() == rows);
    CHECK(set.back() == 2.0 * (rows - 1));
    CHECK(x_of(pool, pool.begin_anew(member, {{"k", "2"}})) == set);
  }
}

TEST_CASE("an executor whose values were refused serves the next run") {
  Ramps ramps;
  const std::size_t member = ramps.family->add({{"k", "1"}}, {});
  RunPool pool(*ramps.family, {});
  const Executor* first = &pool.begin(member, {{"k", "1"}}).simulation();
  CHECK_THROWS_AS(pool.begin(member, {{"k", "-1"}}), yaml::Error);
  const PooledRun next = pool.begin(member, {{"k", "4"}});
  CHECK(&next.simulation() == first);
  CHECK(x_of(pool, next) == std::vector<double>{0, 4, 8});
}

TEST_CASE("runs from several threads have their own values") {
  Ramps ramps;
  const std::size_t member = ramps.family->add({{"k", "1"}}, {});
  RunPool pool(*ramps.family, {});
  std::vector<double> ends(40);
  pool.in_parallel(ends.size(), 4, [&](std::size_t i) {
    ends[i] = x_of(pool, pool.begin(member, {{"k", std::to_string(i + 1)}})).back();
  });
  for (std::size_t i = 0; i < ends.size(); ++i) CHECK(ends[i] == 2.0 * static_cast<double>(i + 1));
}

TEST_CASE("an interrupted pool ends its runs and says so") {
  Ramps ramps;
  const std::size_t member = ramps.family->add({{"k", "1"}}, {{"t", "1000 s"}});
  const std::atomic<bool> interrupt = true;
  RunOptions options;
  options.interrupt = &interrupt;
  RunPool pool(*ramps.family, options);
  const RunResult result = pool.run(pool.begin(member, {{"k", "1"}}), 0);
  CHECK(result.interrupted);
  CHECK(result.ticks < 1000);
}

}  // namespace stepwire::run
