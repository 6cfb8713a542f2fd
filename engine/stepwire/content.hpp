#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/model/diagram/named_signals.hpp"
#include "engine/simulate/run/run.hpp"
#include "engine/stepwire/model.hpp"

namespace stepwire {

struct Model::Content {
  /// What owns the job, the registry of its blocks and the loader of its plans lives as long as the content.
  explicit Content(std::shared_ptr<const run::Job> of);

  std::shared_ptr<const run::Job> job;
  std::shared_ptr<const run::RunNumbers> kept;  ///< what its sweep keeps of each run; null: rows
  std::vector<SignalInfo> signals;
  std::vector<InputInfo> inputs;
  std::vector<plan::SignalSlot> slots;  ///< of the signals, in the plan of the job

  /// Throw std::logic_error for what another model has made.
  std::size_t index(SignalId signal) const;
  std::size_t index(InputId input) const;
  /// Where the signals lie in the plan of another structure, which a sweep may have; of size 0 where it has
  /// none of the name.
  std::vector<plan::SignalSlot> slots_in(const plan::Plan& plan) const;
};

/// Sets a value of a run between two ticks. Throws Error where it is refused, or where it calls for another
/// plan.
void set_value(run::Executor& run, const std::string& name, yaml::Node value);

/// Throws Error for a wrong count of numbers, and for NaN.
void check_numbers(const InputInfo& input, std::span<const double> numbers);

}  // namespace stepwire
