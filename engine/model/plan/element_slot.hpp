#pragma once

#include <string>

#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// Where one element of a signal lies, which has it; the whole signal where no element is meant.
SignalSlot element_slot(const SignalSlot& whole, const diagram::ElementIndex& element);
/// The numbers that are meant of a constant on a wire, behind its first.
SignalSlot constant_slot(const diagram::Source& constant);
/// What is wrong with an element that a signal of this size has not; empty where it has it. `name` is that of
/// the element as it is written.
std::string missing_element(const diagram::ElementIndex& element, const SignalSlot& whole,
                            const std::string& name);
/// The name of number k of a signal: its own where it has but one, "v.2", or "R.2.3" of a matrix.
std::string element_name(const std::string& signal, const SignalSlot& whole, Eigen::Index k);
/// Element k of a signal.
diagram::SignalRef element_of(const diagram::SignalRef& signal, const SignalSlot& slot, Eigen::Index k);
/// "3" or "3 x 2"
std::string shape_text(Eigen::Index size, Eigen::Index columns);

}  // namespace stepwire::plan
