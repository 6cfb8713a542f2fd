#pragma once

#include <vector>

#include "engine/app/studio/calls.hpp"

namespace stepwire::studio {

/// Faults as data, with the names that files have in lists in the place of their paths.
json::Json faults_with_names(const DiagramFiles& files, const std::vector<yaml::Fault>& faults);

/// The same of an error, as the fault of a call.
Fault named_faults(Desk& desk, const yaml::Error& error);

/// Does something whose faults are for a page.
template <class Action>
auto with_names(Desk& desk, const Action& action) -> decltype(action()) {
  try {
    return action();
  } catch (const yaml::Error& error) {
    throw named_faults(desk, error);
  }
}

}  // namespace stepwire::studio
