#include "engine/app/studio/live/page_device.hpp"

#include <algorithm>

#include "engine/app/studio/live/live_inputs.hpp"

namespace stepwire::live {

namespace {

std::size_t numbers_of(const std::vector<std::vector<double>>& defaults) {
  std::size_t count = 0;
  for (const std::vector<double>& values : defaults) count += 1 + values.size();
  return count;
}

}  // namespace

PageDevice::PageDevice(const plan::Plan& plan, realtime::LoopClock& clock)
    : clock_(clock), row_(numbers_of(defaults_of_inputs(plan)), 0.0), latest_(row_) {
  std::size_t first = 0;
  for (std::vector<double>& defaults : defaults_of_inputs(plan)) {
    const std::size_t size = defaults.size();
    inputs_.push_back({first, std::move(defaults)});
    first += 1 + size;
  }
}

void PageDevice::read(double* inputs) noexcept {
  const std::span<const double> row = latest_.take();
  const auto now = static_cast<double>(clock_.now());
  for (const Input& input : inputs_) {
    const bool holds = now <= row[input.first];
    const double* from = holds ? row.data() + input.first + 1 : input.defaults.data();
    inputs = std::copy_n(from, input.defaults.size(), inputs);
  }
}

void PageDevice::put(std::size_t input, const std::vector<double>& values, std::int64_t until) {
  extend(input, until);
  std::ranges::copy(values, row_.begin() + static_cast<std::ptrdiff_t>(inputs_[input].first) + 1);
}

}  // namespace stepwire::live
