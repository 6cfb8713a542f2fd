// A real-time loop under pages. No test looks at how well it keeps time: that is the machine's.
#include "engine/app/studio/live/loop_thread.hpp"

#include "engine/base/io/file.hpp"
#include "engine/simulate/run/run.hpp"
#include "tests/engine/app/studio/live/live_studio.hpp"

namespace stepwire::live {

namespace {

session::LoopSettings settings_of(const std::string& overrun = "skip") {
  session::LoopWords words;
  words.policy = "other";
  words.overrun = overrun;
  return session::read_loop_settings(words);
}

struct Rig {
  explicit Rig(LoopThread::Options options = {settings_of()})
      : loader(library()),
        plan(plan::make_plan(loader.load_text(swing, "swing.yaml"))),
        signals(plan),
        loop(plan, signals, std::move(options)) {}

  void wait_for(std::int64_t tick) {
    wait_until([&] { return loop.status().tick >= tick; });
  }
  std::vector<double> stored(const std::string& signal, std::size_t count) {
    std::vector<double> values(count);
    loop.store().read(loop.stored(*signals.find(signal)), 0, values);
    return values;
  }
  /// True if any stored sample has this value; polling the newest one may miss a short-lived value.
  bool had(const std::string& signal, double value) {
    const std::vector<double> all = stored(signal, static_cast<std::size_t>(loop.store().end_tick()));
    return std::ranges::find(all, value) != all.end();
  }
  double newest(const std::string& signal) {
    double value = 0.0;
    loop.store().read(loop.stored(*signals.find(signal)), loop.store().end_tick() - 1, {&value, 1});
    return value;
  }

  diagram::Loader loader;
  plan::Plan plan;
  SignalList signals;
  LoopThread loop;
};

/// Returns a signal of a run with these events, tick by tick, computed without a thread.
std::vector<double> replayed(const plan::Plan& plan, const EventLog& log, std::size_t offset,
                             std::size_t count) {
  run::Executor run(plan);
  log.each(before_start, 0, [&](const LiveEvent& event) { apply(event, run); });
  run.reset();
  std::vector<double> values;
  for (std::size_t tick = 0; tick < count; ++tick) {
    log.each(run.tick(), run.tick() + 1, [&](const LiveEvent& event) { apply(event, run); });
    run.evaluate();
    values.push_back(run.values()[offset]);
    run.advance();
  }
  return values;
}

}  // namespace

TEST_CASE("the page's types of a loop's news are those of the declaration") {
  const std::string file = STEPWIRE_SOURCE_DIR "/engine/app/studio/page/src/loop/loop_news.ts";
  INFO("the content of " << file << " should be the text on the right");
  CHECK(io::read_file(file) == loop_news_typescript());
}

TEST_CASE("a loop stands still until it is played, and goes on beyond the file's stop", "[full]") {
  Rig rig;
  CHECK(rig.loop.status().state == RunStatus::State::paused);
  CHECK(rig.loop.store().end_tick() == 0);
  rig.loop.play(1.0);
  CHECK(rig.loop.status().state == RunStatus::State::playing);
  rig.wait_for(3200);  // the file stops at 3000
  rig.loop.pause();
  const std::int64_t tick = rig.loop.status().tick;
  CHECK(rig.loop.store().end_tick() == tick + 1);
  rig.loop.play(1.0);
  rig.wait_for(tick + 20);
  CHECK(rig.loop.status().run == 0);
}

TEST_CASE("values and inputs of a loop are logged with their ticks, and the log gives the same bits again") {
  Rig rig;
  CHECK(rig.loop.set("mass", "3 kg").tick == 0);
  rig.loop.play(1.0);
  for (int i = 1; i <= 4; ++i) {
    rig.loop.input({1, 0.0, "push", {2.0 * i}});
    rig.wait_for(100 * i);
    const SetResult set = rig.loop.set("mass", std::to_string(3 + i) + " kg");
    CHECK(set.value == 3.0 + i);
    CHECK(set.tick > 100 * i);
    CHECK(rig.loop.set("spring.gain", std::to_string(-100 - i)).tick > set.tick);
  }
  rig.wait_for(600);
  rig.loop.pause();
  CHECK(rig.loop.timing()->find("lost")->as_number() == 0.0);
  const EventLog log = rig.loop.log();
  CHECK(log.events().size() >= 1 + 4 * 3);
  const auto count = static_cast<std::size_t>(rig.loop.store().end_tick());
  const std::size_t offset = rig.signals.all()[*rig.signals.find("slide.position")].offset;
  CHECK(rig.stored("slide.position", count) == replayed(rig.plan, log, offset, count));
}

TEST_CASE("a value that a loop refuses changes nothing") {
  Rig rig;
  rig.loop.play(1.0);
  CHECK_THROWS_WITH(rig.loop.set("mass", "10 kg"), Catch::Contains("mass"));
  CHECK_THROWS_WITH(rig.loop.set("mas", "1 kg"), Catch::Contains("did you mean 'mass'"));
  rig.loop.pause();
  CHECK(rig.loop.value("mass") == 2.0);
  CHECK(rig.loop.log().events().empty());
}

TEST_CASE("a loop cannot be slowed, stepped or sent back, and begins anew with the values that are set") {
  Rig rig;
  CHECK_THROWS_WITH(rig.loop.play(2.0), Catch::Contains("its rate is 1"));
  CHECK_THROWS_WITH(rig.loop.one_tick(), Catch::Contains("single ticks"));
  CHECK_THROWS_WITH(rig.loop.seek(0.1), Catch::Contains("does not go back"));
  rig.loop.play(1.0);
  rig.loop.set("mass", "5 kg");
  rig.wait_for(300);
  rig.loop.restart();
  CHECK(rig.loop.status().run == 1);
  CHECK(rig.loop.status().state == RunStatus::State::playing);
  CHECK(rig.loop.value("mass") == 5.0);
  rig.wait_for(20);
  rig.loop.pause();
  const auto count = static_cast<std::size_t>(rig.loop.store().end_tick());
  const std::size_t offset = rig.signals.all()[*rig.signals.find("slide.position")].offset;
  CHECK(rig.stored("slide.position", count) == replayed(rig.plan, rig.loop.log(), offset, count));
}

TEST_CASE("an input has its default again once the page that wrote it has left") {
  Rig rig;
  rig.loop.play(1.0);
  wait_until([&] { return rig.had("push", 1.0); });
  rig.loop.input({7, 0.0, "push", {9.0}});
  wait_until([&] { return rig.had("push", 9.0); });
  rig.loop.release(7);
  wait_until([&] { return rig.newest("push") == 1.0; });
}

TEST_CASE(
    "an input has its default again once the page that wrote it says nothing, and no word brings it back") {
  Rig rig({settings_of(), {}, 0, {}, 0.1});
  rig.loop.play(1.0);
  wait_until([&] { return rig.had("push", 1.0); });
  rig.loop.input({7, 0.0, "push", {9.0}});
  wait_until([&] { return rig.had("push", 9.0); });
  wait_until([&] { return rig.newest("push") == 1.0; });
  rig.loop.heard(7);
  const std::int64_t tick = rig.loop.status().tick;
  rig.wait_for(tick + 100);
  CHECK(rig.newest("push") == 1.0);
}

TEST_CASE("an input that a page holds keeps its value for as long as the page says something") {
  Rig rig({settings_of(), {}, 0, {}, 1.0});
  rig.loop.play(1.0);
  rig.loop.input({7, 0.0, "push", {9.0}});
  wait_until([&] {
    rig.loop.heard(7);
    return rig.newest("push") == 9.0;
  });
  const std::int64_t tick = rig.loop.status().tick;
  wait_until([&] {
    rig.loop.heard(7);
    return rig.loop.status().tick >= tick + 1500;
  });
  CHECK(rig.newest("push") == 9.0);
}

TEST_CASE("the loop itself ends what a page wrote, also where the hub is stuck") {
  Rig rig;
  realtime::SystemClock clock;
  PageDevice device(rig.plan, clock);
  double push = 0.0;
  device.read(&push);
  CHECK(push == 1.0);
  device.put(0, {9.0}, clock.now() + 3'600'000'000'000);
  device.read(&push);
  CHECK(push == 1.0);  // it was not given yet
  device.give();
  device.read(&push);
  CHECK(push == 9.0);
  device.extend(0, clock.now() - 1);
  device.give();
  device.read(&push);
  CHECK(push == 1.0);
}

TEST_CASE("a signal that is asked for while a loop runs has samples from then on") {
  Rig rig;
  rig.loop.play(1.0);
  rig.wait_for(50);
  const std::size_t column = rig.loop.stored(*rig.signals.find("net"));
  const std::int64_t from = rig.loop.store().end_tick();
  rig.wait_for(from + 100);
  rig.loop.pause();
  const std::int64_t end = rig.loop.store().end_tick();
  std::vector<double> net(static_cast<std::size_t>(end));
  rig.loop.store().read(column, 0, net);
  CHECK(std::isnan(net.front()));
  CHECK(std::isfinite(net.back()));
  const auto first = std::ranges::find_if(net, [](double value) { return std::isfinite(value); });
  CHECK(std::all_of(first, net.end(), [](double value) { return std::isfinite(value); }));
}

TEST_CASE("what is loaded under --loop is a loop, which a second page joins") {
  Studio studio(swing, settings_of());
  const Json loaded = studio.call("run.load", R"({"file": 1})");
  CHECK(*loaded.find("loop")->find("rate")->as_number() == 1000.0);
  CHECK(loaded.find("stop")->is_null());
  CHECK(loaded.find("claims")->items().empty());
  studio.call("run.play", R"({"rate": 1})");
  wait_until([&] { return studio.received.last("loop").has_value(); });
  const Json again = studio.call("run.load", R"({"file": 1})", 2);
  CHECK(*again.find("run")->as_number() == *loaded.find("run")->as_number());
  wait_until([&] { return *studio.received.last("run")->find("state")->as_text() == "playing"; });
  CHECK_THROWS_WITH(studio.call("profile"), Catch::Contains("might disturb"));
  wait_until([&] { return *studio.call("loop").find("served")->as_number() > 100.0; });
  const Json timing = studio.call("loop");
  const Json& lateness = *timing.find("lateness");
  double count = 0.0;
  for (const Json& bin : lateness.find("counts")->items()) count += *bin.as_number();
  CHECK(lateness.find("edges")->items().size() == lateness.find("counts")->items().size() + 1);
  CHECK(count >= *timing.find("served")->as_number());
  CHECK(*lateness.find("p50")->as_number() <= *lateness.find("p999")->as_number());
  CHECK_FALSE(timing.find("costs")->items().empty());
  studio.call("run.pause");
  CHECK(*studio.call("loop").find("policy")->as_text() == "other");
}

TEST_CASE("a diagram that is not fit for a loop is refused with why, and the loop before goes on") {
  Studio studio(swing, settings_of());
  session::LoopSettings odd = settings_of();
  odd.rate = 700.0;
  Studio wrong(swing, odd);
  CHECK_THROWS_WITH(wrong.call("run.load", R"({"file": 1})"),
                    Catch::Contains("no whole multiple of the step"));
}

TEST_CASE("a model that is no loop has no timing") {
  Studio studio(swing);
  studio.call("run.load", R"({"file": 1})");
  CHECK_THROWS_WITH(studio.call("loop"), Catch::Contains("--loop"));
}

}  // namespace stepwire::live
