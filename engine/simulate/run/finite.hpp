#pragma once

#include <cstddef>

namespace stepwire::run {

/// True if all `count` numbers are finite.
bool all_finite(const double* numbers, std::size_t count);

}  // namespace stepwire::run
