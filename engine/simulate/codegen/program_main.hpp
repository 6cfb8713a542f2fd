#pragma once

#include <string>

#include "engine/model/plan/plan.hpp"

namespace stepwire::codegen {

/// The main() of a generated program: runs the diagram to its stop and writes signals.csv (signals-2.csv,
/// ...) as `stepwire run` does. The struct stands in a header and a namespace.
std::string main_text(const plan::Plan& plan, const std::string& header, const std::string& space);

}  // namespace stepwire::codegen
