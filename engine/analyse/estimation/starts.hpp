#pragma once

#include <Eigen/Core>
#include <atomic>
#include <functional>
#include <vector>

#include "engine/analyse/estimation/residuals.hpp"

namespace stepwire::estimation {

/// Returns the starts of a fit: the given one, then random ones within the bounds. They are uniform in the
/// logarithm if the bounds differ by more than a factor of ten. Without bounds they are from half to twice
/// the start. Points that the diagram refuses are drawn again. The result depends on the seed only, on any
/// machine.
std::vector<Eigen::VectorXd> make_starts(const Residuals& residuals, const FitRequest& request);

/// Callback after each generation, with its number and the best cost.
using GenerationWatcher = std::function<void(std::size_t generation, double cost)>;

/// Minimises the cost by differential evolution (rand/1/bin, factor 0.7, crossover 0.9) within the bounds and
/// the accepted values. The given start is in the first population. Returns the best point. R. Storn, K.
/// Price 1997.
Eigen::VectorXd evolve(const Residuals& residuals, const FitRequest& request,
                       const std::atomic<bool>* interrupt, const GenerationWatcher& watch);

}  // namespace stepwire::estimation
