#include "checks.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <stdexcept>

static std::atomic<long> allocations = 0;

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace {

/// No spring and no flow: x = F t^2 / 2 m.
sw::Model free_cart() {
  return cart({{"spring.gain", "0 N/m"}, {"drag.c", "0 N s^2/m^2"}, {"mass", "8 kg"}});
}

bool near(double value, double expected) {
  return std::abs(value - expected) < 1e-12;
}

std::vector<double> path(sw::Simulation& run, sw::SignalId signal, sw::InputId push, int steps) {
  std::vector<double> values;
  for (int k = 0; k < steps && !run.finished(); ++k) {
    run.set(push, std::sin(0.1 * k));
    run.step();
    values.push_back(run[signal][0]);
  }
  return values;
}

}  // namespace

void check_model() {
  const sw::Model model = cart();
  const auto& signals = model.signals();
  const auto position = std::ranges::find(signals, "cart.position", &sw::SignalInfo::name);
  CHECK(position != signals.end() && position->unit == "m" && position->size == 1);
  CHECK(std::ranges::count(signals, "cart.body.position", &sw::SignalInfo::name) == 1);
  CHECK(std::ranges::count(signals, "drag.F", &sw::SignalInfo::name) == 1);
  CHECK(model.inputs().size() == 1 && model.inputs()[0].name == "push" && model.inputs()[0].unit == "N");
  CHECK(model.parameters().front().name == "mass" && model.parameters().front().doc == "of the cart");
  CHECK(contains(refusal([&] { model.signal("cart.positon"); }), "did you mean 'cart.position'?"));
  CHECK(contains(refusal([&] { model.input("psh"); }), "did you mean 'push'?"));
  CHECK(contains(refusal([&] { cart({{"mas", "1 kg"}}); }), "did you mean 'mass'?"));
  CHECK(contains(refusal([&] { cart({{"mass", "1 m"}}); }), "mass"));
  CHECK(contains(refusal([] { sw::load(CONSUMER_DIR "/cart.yaml"); }), "cart.yaml:13:"));  // knows no Drag
}

void check_steps() {
  auto run = [] {
    sw::Model model = free_cart();  // lives on in the simulation
    return sw::Simulation(model);
  }();
  const sw::SignalId x = run.model().signal("cart.position"), drag = run.model().signal("drag");
  const sw::InputId push = run.model().input("push");
  int ticks = 0;
  long before = 0;
  while (!run.finished()) {
    run.set(push, 10.0);
    run.step();
    if (ticks++ == 0) before = allocations;
    CHECK(near(run.time(), 1e-3 * (ticks - 1)));
    CHECK(near(run[x][0], 10.0 * run.time() * run.time() / 16.0));
    CHECK(run[drag].size() == 1 && run[drag][0] == 0.0);
  }
  CHECK(allocations == before);
  CHECK(ticks == 1001 && run.time() == 1.0);
  CHECK(contains(refusal([&] { run.step(); }), "has ended"));
  run.reset();
  CHECK(run.time() == 0.0 && !run.finished());
  run.step();
  run.step();
  CHECK(run[x][0] == 0.0);  // nothing pushes any more
}

void check_values() {
  sw::Simulation run(free_cart());
  const sw::SignalId x = run.model().signal("cart.position"), spring = run.model().signal("spring");
  const sw::InputId push = run.model().input("push");
  run.set(push, 16.0);
  for (int k = 0; k <= 500; ++k) run.step();
  const double shown = run[x][0];
  CHECK(near(shown, 0.25));  // 16 t^2 / 16 at 0.5 s
  run.set("mass", 4.0);
  CHECK(run[x][0] == shown && run.time() == 0.5);  // the tick that was computed is shown until the next one
  run.set("spring.gain", "-0.1 kN/m");
  run.step();
  CHECK(near(run[spring][0], -100.0 * run[x][0]));
  CHECK(contains(refusal([&] { run.set("mass", -1.0); }), "mass"));
  CHECK(contains(refusal([&] { run.set("mass", "1 m"); }), "mass"));
  CHECK(contains(refusal([&] { run.set("mas", 1.0); }), "did you mean 'mass'?"));
  CHECK(contains(refusal([&] { run.set("stop", "2 s"); }), "load the model with this value"));
  CHECK(contains(refusal([&] { run.set(push, {1.0, 2.0}); }), "takes 1 number, not 2"));
  run.set(push, {3.0});
  bool refused = false;
  try {
    run[cart().signal("drag")];
  } catch (const std::logic_error&) {
    refused = true;
  }
  CHECK(refused);
}

void check_snapshots() {
  const sw::Model model = cart();
  const sw::SignalId x = model.signal("cart.position");
  const sw::InputId push = model.input("push");
  sw::Simulation run(model), other(model);
  path(run, x, push, 300);
  const sw::Snapshot here = run.snapshot();
  const double at = run.time(), shown = run[x][0];
  const std::vector<double> first = path(run, x, push, 400);
  run.restore(here);
  CHECK(run.time() == at && run[x][0] == shown);
  CHECK(path(run, x, push, 400) == first);
  other.restore(here);  // of another run of the same model
  CHECK(path(other, x, push, 400) == first);
  sw::Simulation whole(model);
  path(whole, x, push, 300);
  CHECK(path(whole, x, push, 400) == first);  // and a snapshot changes nothing
}

/// Pushes the cart, and looks where it is.
struct Pusher : sw::Observer {
  explicit Pusher(const sw::Model& model) : x(model.signal("cart.position")), push(model.input("push")) {}

  sw::Flow before_tick(sw::Running& run) override {
    run.set(push, std::sin(0.1 * static_cast<double>(run.tick())));
    return run.time() >= end_at ? sw::Flow::stop : sw::Flow::go_on;
  }
  void evaluated(const sw::Running& run) override { seen.push_back(run[x][0]); }
  void row(const sw::Running&, std::size_t, std::span<const double> numbers) override {
    rows.push_back(numbers[1]);
  }

  sw::SignalId x;
  sw::InputId push;
  std::vector<double> seen{}, rows{};
  double end_at = 10.0;
};

void check_observers() {
  const sw::Model model = cart();
  Pusher view(model);
  const sw::Result result = sw::simulate(model, {.observers = {&view}});
  const auto recorded = result["cart.position"];
  CHECK(recorded.size() == 1001 && std::ranges::equal(view.seen, recorded) && view.rows == view.seen);
  sw::Simulation run(model);
  CHECK(path(run, view.x, view.push, 2000) == view.seen);
  Pusher short_view(model);
  short_view.end_at = 0.5;
  CHECK(sw::simulate(model, {.observers = {&short_view}})["time"].size() == 500);
  std::stop_source source;
  source.request_stop();
  CHECK(sw::simulate(model, {.stop = source.get_token()}).interrupted);
  CHECK(contains(refusal([&] { result["cart.positon"]; }), "did you mean 'cart.position'?"));
}

void check_sweep() {
  const sw::Model model = sw::load(CONSUMER_DIR "/fall.yaml");
  CHECK(model.runs() == 3);
  const sw::Result result = sw::simulate(model, {.threads = 2});
  const sw::Recording& rows = result.recordings.front();
  CHECK(rows.starts.size() == 3 && result["g"].size() == 303);
  for (std::size_t k = 0; k < result["way"].size(); ++k)
    CHECK(near(result["way"][k], 0.5 * result["g"][k] * result["time"][k] * result["time"][k]));
  const sw::Model one = sw::load(CONSUMER_DIR "/fall.yaml", {{"g", "6 m/s^2"}});
  CHECK(near(sw::simulate(one)["way"].back(), 3.0));
  const sw::Result kept = sw::simulate(sw::load(CONSUMER_DIR "/kept.yaml"));
  CHECK(kept.recordings.size() == 1 && kept["end"].size() == 3 && kept["g"].size() == 3);
  for (std::size_t run = 0; run < 3; ++run) CHECK(near(kept["end"][run], 0.5 * kept["g"][run]));
}

void check_compiled() {
  const sw::Model model = cart();
  sw::Simulation interpreted(model),
      compiled(model, {.engine = sw::ExecutionMode::compiled, .tuned = {"spring.gain"}});
  CHECK(compiled.compiled() && compiled.compile_problem().empty());
  const sw::InputId push = model.input("push");
  for (int k = 0; !interpreted.finished(); ++k) {
    for (sw::Simulation* run : {&interpreted, &compiled}) {
      if (k == 400) run->set("spring.gain", -250.0);
      run->set(push, std::cos(0.05 * k));
      run->step();
    }
    for (const sw::SignalInfo& signal : model.signals()) {
      const sw::SignalId id = model.signal(signal.name);
      CHECK(std::ranges::equal(interpreted[id], compiled[id]));
    }
  }
  CHECK(compiled.finished() && compiled.compiled());
  const sw::Result result = sw::simulate(model, {.engine = sw::ExecutionMode::compiled});
  CHECK(result.ticks == 1000 && result.compiled_ticks == result.ticks && result.compile_problem.empty());
}
