#pragma once

#include <string>

#include "engine/simulate/codegen/groups.hpp"

namespace stepwire::codegen {

/// The header of a generated program: a struct with inputs, outputs, recorded signals and parameters as
/// members; with `between_ticks` also those for solvers of others.
std::string struct_text(const plan::Plan& plan, const Tuning& tuning, const Groups& groups,
                        const std::string& name, bool between_ticks = false);

/// Its member functions, on top of evaluate(), advance() and reset() of the GeneratedProgram.
std::string struct_definitions(const plan::Plan& plan, const Tuning& tuning, const Groups& groups,
                               const std::string& name, bool between_ticks = false);

}  // namespace stepwire::codegen
