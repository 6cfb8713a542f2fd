#pragma once

#include <string>

#include "engine/simulate/codegen/groups.hpp"

namespace stepwire::codegen {

/// Returns the header of a generated program: a struct with inputs, outputs, recorded signals and parameters
/// as members. With `between_ticks` it has the members for external solvers too.
std::string struct_text(const plan::Plan& plan, const Tuning& tuning, const Groups& groups,
                        const std::string& name, bool between_ticks = false);

/// Returns its member functions, which use evaluate(), advance() and reset() of the GeneratedProgram.
std::string struct_definitions(const plan::Plan& plan, const Tuning& tuning, const Groups& groups,
                               const std::string& name, bool between_ticks = false);

}  // namespace stepwire::codegen
