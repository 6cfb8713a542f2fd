#pragma once

#include "engine/base/fmi/calls.hpp"

namespace stepwire::fmi {

/// Instances of units of FMI 2 and of FMI 3. Throw UnitError.
std::unique_ptr<Calls> instance_of_2(const Package& package, Mode mode, const std::string& name,
                                     CallNote& note);
std::unique_ptr<Calls> instance_of_3(const Package& package, Mode mode, const std::string& name,
                                     CallNote& note);

}  // namespace stepwire::fmi
