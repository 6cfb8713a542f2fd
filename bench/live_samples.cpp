// Measures the cost of samples of a live run: when they are stored, and when they are viewed.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "engine/app/studio/live/frame_views.hpp"

namespace {

using namespace stepwire::live;

/// Returns the processor time of this thread [s].
double processor_time() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const std::function<void()>& action) {
  const double start = processor_time();
  action();
  return processor_time() - start;
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

void row(const char* what, double value, const char* unit) {
  fmt::print("{:<64} {:>12.4g} {}\n", what, value, unit);
}

/// Measures the storage of rows of `signals` signals in batches, as a run passes them.
void measure_store(std::size_t signals) {
  constexpr std::size_t rows_at_once = 256, parts = 2000;
  std::vector<double> rows(rows_at_once * signals);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = std::sin(0.1 * static_cast<double>(i));
  std::vector<double> rates;
  for (int round = 0; round < 5; ++round) {
    SampleStore store(1e-3);
    for (std::size_t i = 0; i < signals; ++i) store.add(0);
    const std::size_t count = parts * 100 / std::max<std::size_t>(signals, 100);
    const double seconds = seconds_of([&] {
      for (std::size_t i = 0; i < count; ++i) store.append(rows);
    });
    rates.push_back(static_cast<double>(count * rows.size()) / seconds);
  }
  row(fmt::format("samples of {} signals into store, extremes and disk", signals).c_str(), median(rates),
      "per s");
}

void measure_views() {
  constexpr std::int64_t samples = 10'000'000;
  SampleStore store(1e-4);
  store.add(0);
  std::vector<double> part(1000);
  for (std::int64_t tick = 0; tick < samples; tick += std::ssize(part)) {
    for (std::size_t i = 0; i < part.size(); ++i)
      part[i] = std::sin(1e-5 * static_cast<double>(tick + static_cast<std::int64_t>(i)));
    store.append(part);
  }
  for (const std::int64_t width : {samples, samples / 3, std::int64_t{2'000'000}, std::int64_t{500'000},
                                   std::int64_t{100'000}, std::int64_t{3000}}) {
    std::vector<double> times;
    for (int i = 0; i < 21; ++i) {
      const std::int64_t from = (samples - width) * i / 21;
      times.push_back(seconds_of([&] { frame({}, store.look({{0}, from, from + width, 1500}), store); }));
    }
    row(fmt::format("a frame of 1500 pixels over {} of 10,000,000 samples, median", width).c_str(),
        1e3 * median(times), "ms");
    row("  and the slowest of 21", 1e3 * std::ranges::max(times), "ms");
  }
}

}  // namespace

int main() {
  for (const std::size_t signals : {1u, 20u, 100u, 1000u}) measure_store(signals);
  measure_views();
}
