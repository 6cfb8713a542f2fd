#pragma once

#include <string>

#include "engine/analyse/estimation/fit.hpp"

namespace stepwire {

/// What a fit found, for people.
std::string fit_text(const FitResult& result);

}  // namespace stepwire
