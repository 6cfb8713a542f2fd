// Measures the latency of a live run: from an input sample, or from a set value, to the frame with its tick.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "blocks/register.hpp"
#include "engine/app/studio/live/command_queue.hpp"
#include "engine/app/studio/live/live_run.hpp"

namespace {

using namespace stepwire;
using json::Json;

/// Returns a diagram of `signals` signals: lags of one input that the page writes.
std::string diagram_of(std::size_t signals) {
  std::string text =
      "stepwire: 1\ntitle: t\nstep: 1 ms\nstop: 1 h\nsolver: rk4\ninputs: {hand: {default: 0}}\nblocks:\n";
  std::string names = "hand";
  for (std::size_t i = 0; i + 1 < signals; ++i) {
    text += fmt::format("  lag{}: {{block: Lag, u: hand, tau: {} ms}}\n", i, 5 + i);
    names += fmt::format(", lag{}", i);
  }
  return text + "record: [" + names + "]\n";
}

double processor_seconds() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

double newest_value(const std::string& bytes) {
  std::uint32_t rows = 0;
  std::memcpy(&rows, bytes.data() + 12, sizeof(rows));
  double value = 0.0;  // last value of the first column after the time
  if (rows > 0) std::memcpy(&value, bytes.data() + 32 + (2 * rows - 1) * sizeof(double), sizeof(value));
  return value;
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void row(const char* what, const std::vector<double>& seconds) {
  fmt::print("{:<56} p50 {:6.2f} ms, p99 {:6.2f} ms\n", what, 1e3 * quantile(seconds, 0.5),
             1e3 * quantile(seconds, 0.99));
}

std::string views() {
  std::string list = R"({"view": 1, "columns": [0], "follow": 0.05, "pixels": 400})";
  for (int view = 2; view <= 6; ++view)
    list += fmt::format(R"(, {{"view": {}, "columns": [{}, {}, {}, {}], "follow": 60, "pixels": 1000}})", view,
                        4 * view, 4 * view + 1, 4 * view + 2, 4 * view + 3);
  return R"({"views": [)" + list + "]}";
}

}  // namespace

int main() {
  const Registry registry = blocks();
  std::atomic<double> seen = 0.0;
  live::LiveRun* to_acknowledge = nullptr;
  std::atomic<std::int64_t> frames = 0;
  live::LiveRun run(
      [&](int, bool) {
        diagram::Loader loader(registry);
        loader.add(yaml::parse_document(diagram_of(100), "hundred.yaml"));
        return session::load_model(loader, "hundred.yaml", {});
      },
      {[](const Json&) {},
       [&](int page, const std::string& bytes) {
         std::uint16_t view = 0;
         std::uint32_t sequence = 0;
         std::memcpy(&view, bytes.data() + 6, sizeof(view));
         std::memcpy(&sequence, bytes.data() + 8, sizeof(sequence));
         if (view == 1) seen = newest_value(bytes);
         ++frames;
         to_acknowledge->acknowledge(page, sequence);
       }});
  to_acknowledge = &run;
  const auto call = [&](const char* name, const std::string& arguments) {
    return run.call(1, name, Json::parse(arguments));
  };
  call("run.load", R"({"file": 1})");
  call("run.play", R"({"rate": 1})");
  call("data.want", views());
  std::this_thread::sleep_for(std::chrono::seconds(3));
  const double processor = processor_seconds(), start = live::seconds_now();
  std::vector<double> drawn, set;
  for (int i = 1; i <= 1000; ++i) {
    const double sent = live::seconds_now();
    call("run.input", fmt::format(R"({{"samples": [{{"time": {}, "name": "hand", "values": [{}]}}]}})", sent, i));
    while (seen < i && live::seconds_now() - sent < 1.0) std::this_thread::sleep_for(std::chrono::microseconds(200));
    drawn.push_back(live::seconds_now() - sent);
    if (i % 10 == 0) {
      const double begin = live::seconds_now();
      call("run.set", fmt::format(R"({{"name": "lag0.tau", "value": {}}})", 0.005 + 1e-6 * i));
      set.push_back(live::seconds_now() - begin);
    }
  }
  const double share = (processor_seconds() - processor) / (live::seconds_now() - start);
  fmt::print("100 signals at 1 kHz in real time, 21 of them in 6 views, 5 of 60 s\n");
  row("a sample of an input to the frame with its tick", drawn);
  row("a value that is set to its echo", set);
  fmt::print("{:<56} {:.1f} % of a core, {} frames in {:.1f} s\n", "run, store and frames together", 100.0 * share,
             frames.load(), live::seconds_now() - start);
}
