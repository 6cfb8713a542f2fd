#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/analyse/statistics/bootstrap.hpp"

namespace stepwire::statistics {

/// What part of the variance of an outcome goes with each parameter.
struct SobolIndices {
  std::vector<Estimate> first;  ///< what is gone if the parameter were known
  std::vector<Estimate> total;  ///< what is left if all others were known
  std::size_t samples = 0;      ///< that count
};

/// Indices from the outcomes of a design of Saltelli (sampling::saltelli_points): first ones as Saltelli and
/// others 2010, total ones as Jansen (Analysis of variance designs for model output, 1999). A sample with an
/// outcome that is no number does not count; nan with fewer than two, or where all outcomes are equal.
SobolIndices sobol_indices(std::span<const double> outcomes, std::size_t parameters,
                           const Bootstrap& bootstrap);

/// What a step of each parameter does to an outcome, as a slope over its share of all samples.
struct MorrisEffects {
  std::vector<Estimate> size;       ///< mean of the absolute values: how much it matters
  std::vector<Estimate> mean;       ///< with their signs
  std::vector<Estimate> deviation;  ///< how much it hangs on the others, or is not linear
  std::size_t samples = 0;          ///< ways that count
};

/// Effects from the outcomes of a design of Morris. `steps` has for each point but the first of its way which
/// parameter was changed, and how far.
struct MorrisStep {
  std::size_t parameter = 0;
  double size = 0.0;
};
MorrisEffects morris_effects(std::span<const double> outcomes, const std::vector<MorrisStep>& steps,
                             std::size_t parameters, const Bootstrap& bootstrap);

}  // namespace stepwire::statistics
