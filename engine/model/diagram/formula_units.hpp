#pragma once

#include <string>

#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

/// Checks the units in formulas of blocks, such as the guards of a StateMachine. A variable has the unit of
/// the input that it names: one of the block's list of words, or u1, u2, ...; `after` is a time. Reports sums
/// and comparisons of different units. Inputs without a unit are not checked. Diagram::output_dimensions must
/// be known.
void check_formulas(Report& report);

/// Returns a number with its unit for insertion into a formula: "(0.04 m)". Units of several symbols are
/// written as a quotient of numbers, "(0.04 kg / 1 s)": in "0.04 kg/s" the name s could be a variable.
std::string quantity_in_formula(double value, const unit::Dimension& dimension);

}  // namespace stepwire::diagram
