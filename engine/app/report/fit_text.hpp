#pragma once

#include <string>

#include "engine/analyse/estimation/fit.hpp"

namespace stepwire::report {

/// Returns the result of a fit as text for the terminal.
std::string fit_text(const estimation::FitResult& result);

}  // namespace stepwire::report
