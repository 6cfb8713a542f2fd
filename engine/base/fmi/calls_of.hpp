#pragma once

#include "engine/base/fmi/calls.hpp"

namespace stepwire::fmi {

/// Create instances of FMI 2 and FMI 3. Throw UnitError.
std::unique_ptr<Calls> instance_of_2(const Package& package, Mode mode, const std::string& name,
                                     CallNote& note);
std::unique_ptr<Calls> instance_of_3(const Package& package, Mode mode, const std::string& name,
                                     CallNote& note);

}  // namespace stepwire::fmi
