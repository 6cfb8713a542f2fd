#include "engine/simulate/run/sweep_ends.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/simulate/run/pooling.hpp"

namespace stepwire::run {

std::string which_run(const std::vector<diagram::Setting>& settings) {
  return fmt::format(" (in the run with {})", settings_text(settings));
}

void SweepEnds::add(std::size_t point, RunEnd end) {
  const std::lock_guard lock(mutex_);
  for (RunFault& fault : end.faults) {
    fault.fault.message += which_run(job_.settings_of(point));
    faults_.emplace(point, std::move(fault));
  }
  std::size_t order = 0;
  for (RaisedDiagnostic& diagnostic : end.diagnostics) {
    const std::pair place{point, order++};
    const auto [known, is_new] =
        diagnostics_.try_emplace({diagnostic.block, diagnostic.text}, place, diagnostic);
    if (!is_new && place < known->second.first) known->second = {place, std::move(diagnostic)};
  }
  all_.interrupted = all_.interrupted || end.interrupted;
  all_.stopped = all_.stopped || end.stopped;
  all_.ticks += end.ticks;
  all_.compiled_ticks += end.compiled_ticks;
  all_.lane_ticks += end.lane_ticks;
  add_loops(all_.loops, end.loops);
  all_.events += end.events;
  all_.steps += end.steps;
}

RunEnd SweepEnds::take() {
  for (auto& [point, fault] : faults_) all_.faults.push_back(std::move(fault));
  std::vector<std::pair<Place, RaisedDiagnostic>> diagnostics;
  for (auto& [key, diagnostic] : diagnostics_) diagnostics.push_back(std::move(diagnostic));
  std::ranges::stable_sort(diagnostics, {}, [](const auto& diagnostic) { return diagnostic.first; });
  for (auto& [point, diagnostic] : diagnostics) all_.diagnostics.push_back(std::move(diagnostic));
  return std::move(all_);
}

}  // namespace stepwire::run
