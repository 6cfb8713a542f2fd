#pragma once

#include <string>

#include "engine/model/plan/plan.hpp"

namespace stepwire::codegen {

/// Returns the main() of a generated program. It runs the diagram to its stop time and writes the signals
/// files as `stepwire run` does. The struct is in the header `header` and the namespace `space`.
std::string main_text(const plan::Plan& plan, const std::string& header, const std::string& space);

}  // namespace stepwire::codegen
