#pragma once

#include "engine/base/sampling/design.hpp"

namespace stepwire::sampling {

/// Returns the points for Sobol indices (Saltelli and others: Variance based sensitivity analysis of model
/// output, Computer Physics Communications 181, 2010).
Points saltelli_points(const Design& design, std::size_t dimensions);

/// Returns the points for Morris screening (Factorial sampling plans for preliminary computational
/// experiments, Technometrics 33, 1991). Each dimension has the four levels 1/8, 3/8, 5/8 and 7/8.
Points morris_points(const Design& design, std::size_t dimensions);

}  // namespace stepwire::sampling
