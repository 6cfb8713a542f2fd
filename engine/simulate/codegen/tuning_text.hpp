#pragma once

#include <string>

#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::codegen {

/// How many parameters follow from others until they are written themselves.
std::size_t dependent_count(const plan::Plan& plan, const Tuning& tuning);

/// The function of a generated program that computes what follows from its parameters:
///
///     const char* follow_parameters(Diagram::Parameters& p, const Diagram::Parameters& before, bool* own,
///                                   double* numbers)
///
/// `p` is what was written, `before` what held until now; `own` says which parameters follow from no other
/// any more. It returns what is refused, and changes nothing then. Without `numbers` it checks the parameters
/// only.
std::string tuning_text(const plan::Plan& plan, const Tuning& tuning);

}  // namespace stepwire::codegen
