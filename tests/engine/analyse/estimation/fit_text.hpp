#pragma once

#include <string>

#include "engine/analyse/estimation/fit.hpp"

namespace stepwire {

/// Runs the fit of a diagram given as text, compiled or not. Throws Error as the program does.
estimation::FitResult fit_text(const std::string& yaml, plan::CodeSource* code = nullptr,
                               const estimation::FitOptions& options = {});

/// The message with which the fit is refused; empty if it is not.
std::string fit_error(const std::string& yaml);

/// The number that was found for a parameter; fails the test where there is none.
const estimation::FittedNumber& found(const estimation::FitResult& result, const std::string& name);

/// Returns the file of a fit of y = slope u + bias to the points (t, y), for t from 0 to 7 s. `fit` is the
/// text below the section's key.
std::string straight_line(const std::string& fit);

}  // namespace stepwire
