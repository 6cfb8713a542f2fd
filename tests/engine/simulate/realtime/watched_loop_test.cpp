// A loop whose signals another thread sees and whose values it sets, while it runs.
#include <catch2/catch.hpp>
#include <thread>

#include "engine/simulate/realtime/exchange.hpp"
#include "tests/engine/simulate/realtime/fakes.hpp"

namespace stepwire::realtime {

namespace {

const std::string swing_yaml = R"(step: 1 ms
solver: rk4
inputs: {push: {unit: N, default: 1 N}}
outputs: {way: {signal: slide.position, safe: 7 m}}
parameters: {mass: {value: 2 kg, above: 0 kg}}
blocks:
  noise: {block: Noise, seed: 1, every: 2 ms}
  spring: {block: Gain, u: slide.position, gain: -100 N/m}
  net: {block: Sum, u: [push, spring, noise]}
  slide: {block: Mass, force: net, mass: $mass}
  late: {block: Delay, u: slide.position, delay: 3 ms}
)";

std::size_t place_of(const plan::Plan& plan, const std::string& block) {
  for (std::size_t i = 0; i < plan.blocks.size(); ++i)
    if (plan.diagram.blocks[i].name == block) return plan.blocks[i].outputs.front().offset;
  return 0;
}

/// A loop that is watched, with a clock of the test's own.
struct Watched {
  explicit Watched(std::int64_t deadlines, std::size_t room = 1 << 16) : tap(room), values(plan) {
    options.deadlines = deadlines;
    options.tap = &tap;
    options.values = &values;
    options.pause = &pause;
    loop.emplace(plan, options, device, clock, nullptr);
    device.size = 1;
    device.input = [](std::int64_t read) { return 0.1 * static_cast<double>(read); };
    for (const char* name : {"slide", "late", "push"}) places.push_back(place_of(plan, name));
  }
  void set(const std::string& name, const std::string& text) {
    values.offer([=](run::Executor& run) { REQUIRE(run.set(name, text) == run::Executor::Setting::done); });
  }
  /// Rows of tick and values.
  std::vector<std::vector<double>> rows() {
    std::vector<std::vector<double>> all;
    tap.take_all([&](std::int64_t tick, const auto&, std::span<const double> row) {
      all.push_back({static_cast<double>(tick)});
      all.back().insert(all.back().end(), row.begin(), row.end());
    });
    return all;
  }

  plan::Plan plan = plan_text(swing_yaml);
  FakeClock clock;
  FakeDevice device{clock};
  SignalTap tap;
  ValueExchange values;
  std::atomic<bool> pause = false;
  LoopOptions options;
  std::optional<Loop> loop;
  std::vector<std::size_t> places;
};

}  // namespace

TEST_CASE("a value that is set while a loop runs gives the bits of a run in which it was set at that tick") {
  Watched watched(300);
  watched.tap.select(watched.places);
  std::vector<std::int64_t> ticks;
  watched.clock.at_sleep = [&](std::int64_t sleeps) {
    if (const auto tick = watched.values.taken(); tick && (ticks.empty() || ticks.back() != *tick)) {
      ticks.push_back(*tick);
      const std::string mass = ticks.size() == 1 ? "3 kg" : "5 kg";
      watched.values.follow(
          [&](run::Executor& run) { CHECK(run.set("mass", mass) == run::Executor::Setting::done); });
    }
    if (sleeps == 51) watched.set("mass", "3 kg");
    if (sleeps == 151) watched.set("mass", "5 kg");
  };
  watched.loop->serve(300);
  CHECK(ticks == std::vector<std::int64_t>{50, 150});

  run::Executor reference(watched.plan);
  const auto rows = watched.rows();
  REQUIRE(rows.size() == 300);
  for (std::int64_t tick = 0; tick < 300; ++tick) {
    if (tick == 50) CHECK(reference.set("mass", "3 kg") == run::Executor::Setting::done);
    if (tick == 150) CHECK(reference.set("mass", "5 kg") == run::Executor::Setting::done);
    const double push = 0.1 * static_cast<double>(tick);
    reference.write_input(0, &push);
    reference.evaluate();
    const auto& row = rows[static_cast<std::size_t>(tick)];
    CHECK(row[0] == static_cast<double>(tick));
    for (std::size_t i = 0; i < watched.places.size(); ++i)
      CHECK(row[1 + i] == reference.values()[watched.places[i]]);
    reference.advance();
  }
}

TEST_CASE("a value that is refused changes nothing and is not offered") {
  Watched watched(10);
  const auto below = [](run::Executor& run) { static_cast<void>(run.set("mass", "-1 kg")); };
  CHECK_THROWS_WITH(watched.values.offer(below), Catch::Contains("mass"));
  watched.loop->serve(10);
  CHECK_FALSE(watched.values.taken());
}

TEST_CASE("signals may be selected while a loop runs, and each row says which it has") {
  Watched watched(40);
  watched.clock.at_sleep = [&](std::int64_t sleeps) {
    if (sleeps == 11) watched.tap.select({watched.places[0]});
    if (sleeps == 21) watched.tap.select(watched.places);
  };
  watched.loop->serve(40);
  std::vector<std::size_t> widths;
  std::vector<std::int64_t> ticks;
  watched.tap.take_all([&](std::int64_t tick, const auto& places, std::span<const double> row) {
    CHECK(places.size() == row.size());
    ticks.push_back(tick);
    widths.push_back(row.size());
  });
  REQUIRE(ticks.size() == 30);
  CHECK(ticks.front() == 10);
  CHECK(std::ranges::count(widths, 1u) == 10);
  CHECK(std::ranges::count(widths, 3u) == 20);
}

TEST_CASE("ticks that nobody takes from the ring are lost and counted, and the loop goes on") {
  Watched watched(500, 100);
  watched.tap.select(watched.places);
  watched.loop->serve(500);
  const auto rows = watched.rows();
  CHECK(rows.size() == 20);  // of five numbers each
  CHECK(watched.tap.lost() == 480);
  CHECK(watched.loop->deadlines().missed() == 0);
}

TEST_CASE("a loop that is paused gives the safe values, and goes on from where it stands") {
  Watched watched(100);
  watched.clock.at_sleep = [&](std::int64_t sleeps) { watched.pause = sleeps == 30; };
  watched.loop->serve(100);
  CHECK_FALSE(watched.loop->ended());
  CHECK(watched.device.last.front() == 7.0);
  CHECK(watched.loop->simulation().tick() == 30);
  watched.pause = false;
  watched.loop->serve(100);
  CHECK(watched.loop->ended());
  CHECK(watched.loop->simulation().tick() == 100);
}

TEST_CASE("a loop asks for no memory where values are taken and signals selected") {
  Watched watched(200);
  watched.device.written.reserve(1000);
  watched.device.written_at.reserve(1000);
  watched.device.last.reserve(2);
  watched.tap.select(watched.places);
  watched.set("mass", "3 kg");  // taken at the first deadline
  watched.loop->serve(200);
  CHECK(watched.values.taken() == 0);
  CHECK(watched.loop->counts().allocations.value_or(0) == 0);
}

TEST_CASE("of rows that one thread gives another takes the newest, and never half of one") {
  constexpr int most = 200'000;
  LatestValues latest({0.0, 0.0, 0.0});
  std::thread giver([&] {
    for (int i = 1; i <= most; ++i) latest.give(std::vector<double>(3, i));
  });
  double last = 0.0;
  bool whole = true, rises = true;
  while (last < most) {
    const std::span<const double> row = latest.take();
    whole = whole && row[0] == row[1] && row[1] == row[2];
    rises = rises && row[0] >= last;
    last = row[0];
  }
  giver.join();
  CHECK(whole);
  CHECK(rises);
}

TEST_CASE("what a loop counts may be read while it runs") {
  Watched watched(20'000);
  std::atomic<bool> done = false;
  std::int64_t least = 0;
  bool rises = true;
  std::thread reader([&] {
    while (!done) {
      const std::int64_t count = watched.loop->measurements().wake_up().count();
      rises = rises && count >= least;
      least = count;
      static_cast<void>(watched.loop->measurements().step().quantile(0.999));
      static_cast<void>(watched.loop->group_costs());
    }
  });
  watched.loop->serve(20'000);
  done = true;
  reader.join();
  CHECK(rises);
  CHECK(watched.loop->measurements().wake_up().count() == 20'000);
}

}  // namespace stepwire::realtime
