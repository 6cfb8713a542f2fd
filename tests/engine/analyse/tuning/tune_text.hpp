#pragma once

#include <string>

#include "engine/analyse/tuning/tune.hpp"

namespace stepwire {

/// Runs the optimisation of a diagram given as text, compiled or not. Throws Error as the program does.
tuning::TuneResult tune_text(const std::string& yaml, plan::CodeSource* code = nullptr,
                             const tuning::TuneOptions& options = {},
                             const std::atomic<bool>* interrupt = nullptr);

/// The message with which the tuning is refused; empty if it is not.
std::string tune_error(const std::string& yaml);

/// The value that was found for a parameter; fails the test where there is none.
double tuned(const tuning::TuneResult& result, const std::string& name);

/// Returns the file of a cost, an expression of the parameters a (2 at first), b (1 at first) and c (0).
/// `tune` is the text below the section's key.
std::string cost_of(const std::string& expression, const std::string& tune);

/// The file of x'' + 2 zeta x' + x = 1 from rest, which keeps the integrals of e^2, t e^2 and t |e| for
/// e = 1 - x.
std::string second_order(const std::string& tune);

}  // namespace stepwire
