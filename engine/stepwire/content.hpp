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
  /// `of` also owns the registry of its blocks and the loader of its plans, which live as long as the
  /// content.
  explicit Content(std::shared_ptr<const run::Job> of);

  std::shared_ptr<const run::Job> job;
  std::shared_ptr<const run::RunNumbers> kept;  ///< numbers that its sweep keeps of each run; nullptr: rows
  std::vector<SignalInfo> signals;
  std::vector<InputInfo> inputs;
  std::vector<plan::SignalSlot> slots;  ///< slots of the signals, in the plan of the job

  /// Throw std::logic_error for an id of another model.
  std::size_t index(SignalId signal) const;
  std::size_t index(InputId input) const;
  /// Returns the slots of the signals in a plan of another structure, which a sweep may have. The slot of a
  /// missing signal has size 0.
  std::vector<plan::SignalSlot> slots_in(const plan::Plan& plan) const;
};

/// Sets a value of a run between two ticks. Throws Error if it is refused or requires another plan.
void set_value(run::Executor& run, const std::string& name, yaml::Node value);

/// Throws Error for a wrong count of numbers, and for NaN.
void check_numbers(const InputInfo& input, std::span<const double> numbers);

}  // namespace stepwire
