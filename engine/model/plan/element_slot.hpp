#pragma once

#include <string>

#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// Returns the slot of one element of a signal that has it; the whole signal for a reference without an
/// element.
SignalSlot element_slot(const SignalSlot& whole, const diagram::ElementIndex& element);
/// Returns the numbers of a constant on a wire that its reference selects, relative to its first number.
SignalSlot constant_slot(const diagram::Source& constant);
/// Returns the fault of an element that a signal of this size does not have; empty if it exists. `name` is
/// that of the element in the file.
std::string missing_element(const diagram::ElementIndex& element, const SignalSlot& whole,
                            const std::string& name);
/// Returns the name of number k of a signal: the signal's own for a scalar, else "v.2", or "R.2.3" for a
/// matrix.
std::string element_name(const std::string& signal, const SignalSlot& whole, Eigen::Index k);
/// Returns a reference to element k of a signal.
diagram::SignalRef element_of(const diagram::SignalRef& signal, const SignalSlot& slot, Eigen::Index k);
/// Returns a shape as text: "3" or "3 x 2".
std::string shape_text(Eigen::Index size, Eigen::Index columns);

}  // namespace stepwire::plan
