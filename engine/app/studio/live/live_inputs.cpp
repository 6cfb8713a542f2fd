#include "engine/app/studio/live/live_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/text/count.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::live {

namespace {

constexpr std::size_t most_waiting = 4096;  // samples; a paused run takes none

}  // namespace

std::vector<std::vector<double>> defaults_of_inputs(const plan::Plan& plan) {
  std::vector<std::vector<double>> defaults;
  const run::Executor start(plan);
  for (const diagram::DiagramInput& input : plan.diagram.inputs) {
    const plan::SignalSlot slot = plan.slot({input.block, 0, -1});
    const double* first = start.values() + slot.offset;
    defaults.emplace_back(first, first + slot.size);
  }
  return defaults;
}

LiveInputs::LiveInputs(const plan::Plan& plan) : plan_(plan), defaults_(defaults_of_inputs(plan)) {}

std::size_t LiveInputs::find(const std::string& name) const {
  const auto& inputs = plan_.diagram.inputs;
  const auto found = std::ranges::find(inputs, name, &diagram::DiagramInput::name);
  if (found != inputs.end()) return static_cast<std::size_t>(found - inputs.begin());
  std::vector<std::string> names;
  for (const diagram::DiagramInput& input : inputs) names.push_back(input.name);
  throw yaml::Error(
      yaml::Fault{{plan_.diagram.file, {}},
                  name,
                  "there is no input of this name" + yaml::nearest_or_all(name, names, "there are"),
                  {}});
}

void LiveInputs::push(InputSample sample) {
  const std::size_t size = defaults_[find(sample.name)].size();
  if (size != sample.values.size())
    throw yaml::Error(
        yaml::Fault{{plan_.diagram.file, {}},
                    sample.name,
                    fmt::format("takes {}, not {}", text::counted(size, "number"), sample.values.size()),
                    {}});
  const std::lock_guard lock(mutex_);
  if (waiting_.size() >= most_waiting) waiting_.erase(waiting_.begin());
  writers_[sample.name] = sample.client;
  waiting_.push_back(std::move(sample));
  any_ = true;
}

void LiveInputs::release(int client) {
  const std::lock_guard lock(mutex_);
  std::erase_if(waiting_, [&](const InputSample& sample) { return sample.client == client; });
  for (const auto& [name, writer] : writers_)
    if (writer == client) waiting_.push_back({client, 0.0, name, defaults_[find(name)]});
  std::erase_if(writers_, [&](const auto& entry) { return entry.second == client; });
  any_ = !waiting_.empty();
}

std::vector<LiveEvent> LiveInputs::take(double time, std::int64_t tick) {
  std::vector<LiveEvent> events;
  if (!any_.load(std::memory_order_acquire)) return events;
  const std::lock_guard lock(mutex_);
  for (InputSample& sample : waiting_) {
    if (sample.time > time) continue;
    if (sample.page_time) taken_ = sample.page_time;
    events.push_back({tick, sample.name, "", std::move(sample.values), sample.time});
  }
  std::erase_if(waiting_, [&](const InputSample& sample) { return sample.time <= time; });
  any_ = !waiting_.empty();
  return events;
}

std::vector<int> LiveInputs::writers() {
  std::vector<int> writers;
  const std::lock_guard lock(mutex_);
  for (const diagram::DiagramInput& input : plan_.diagram.inputs) {
    const auto writer = writers_.find(input.name);
    writers.push_back(writer == writers_.end() ? 0 : writer->second);
  }
  return writers;
}

}  // namespace stepwire::live
