#pragma once

#include <vector>

#include "engine/app/studio/calls.hpp"

namespace stepwire::studio {

/// Returns faults as JSON, with the listed names of files in place of their paths.
json::Json faults_with_names(const DiagramFiles& files, const std::vector<yaml::Fault>& faults);

/// Returns the fault of a call for an error, with the listed names of files.
Fault named_faults(Desk& desk, const yaml::Error& error);

/// Runs an action; a yaml::Error becomes a Fault with the listed names of files.
template <class Action>
auto with_names(Desk& desk, const Action& action) -> decltype(action()) {
  try {
    return action();
  } catch (const yaml::Error& error) {
    throw named_faults(desk, error);
  }
}

}  // namespace stepwire::studio
