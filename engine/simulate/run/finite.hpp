#pragma once

#include <cstddef>

namespace stepwire::run {

/// Are all of these numbers finite?
bool all_finite(const double* numbers, std::size_t count);

}  // namespace stepwire::run
