#pragma once

#include <Eigen/Core>
#include <atomic>
#include <functional>
#include <vector>

#include "engine/analyse/estimation/residuals.hpp"

namespace stepwire::estimation {

/// Points from which searches begin: the given start, then random ones within the bounds (evenly in the
/// logarithm where the bounds are more than tenfold apart; from half to twice the start where there are no
/// bounds), but none that the diagram refuses. The same for the same seed, on any machine.
std::vector<Eigen::VectorXd> make_starts(const Residuals& residuals, const FitRequest& request);

/// Told after each generation: its number and the best cost.
using GenerationWatcher = std::function<void(std::size_t generation, double cost)>;

/// Differential evolution (rand/1/bin, factor 0.7, crossover 0.9) within the bounds and what the
/// diagram takes; the given start is one of the first population. Returns the best point. R. Storn, K. Price
/// 1997.
Eigen::VectorXd evolve(const Residuals& residuals, const FitRequest& request,
                       const std::atomic<bool>* interrupt, const GenerationWatcher& watch);

}  // namespace stepwire::estimation
