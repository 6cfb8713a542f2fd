#pragma once

#include <string>

#include "engine/analyse/estimation/fit.hpp"

namespace stepwire::report {

/// What a fit found, for people.
std::string fit_text(const estimation::FitResult& result);

}  // namespace stepwire::report
