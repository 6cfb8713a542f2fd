#pragma once

#include <string>

#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::codegen {

/// Returns the number of parameters that depend on others until they are written themselves.
std::size_t dependent_count(const plan::Plan& plan, const Tuning& tuning);

/// Returns the function of a generated program that computes the numbers that depend on its parameters:
///
///     const char* follow_parameters(Diagram::Parameters& p, const Diagram::Parameters& before, bool* own,
///                                   double* numbers)
///
/// Here `p` holds the written parameters and `before` the previous ones; `own` marks parameters that no
/// longer depend on others. The function returns a message and changes nothing if a value is refused. With a
/// null `numbers` it only checks the parameters.
std::string tuning_text(const plan::Plan& plan, const Tuning& tuning);

}  // namespace stepwire::codegen
