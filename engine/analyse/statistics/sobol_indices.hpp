#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/analyse/statistics/bootstrap.hpp"

namespace stepwire::statistics {

/// Shares of the variance of an outcome by parameter.
struct SobolIndices {
  std::vector<Estimate> first;  ///< Share that vanishes if the parameter is fixed.
  std::vector<Estimate> total;  ///< Share that remains if all other parameters are fixed.
  std::size_t samples = 0;      ///< Number of complete samples.
};

/// Least number of samples of an index: its error is about 1/sqrt(samples), and its range is 1.
inline constexpr std::size_t fewest_samples = 4;

/// Computes Sobol indices from the outcomes of a Saltelli design (sampling::saltelli_points). First indices
/// are those of Saltelli and others 2010, total ones those of Jansen (Analysis of variance designs for model
/// output, 1999). A sample with a non-finite outcome is left out. Nan for fewer samples than
/// `fewest_samples`, or if all outcomes are equal.
SobolIndices sobol_indices(std::span<const double> outcomes, std::size_t parameters,
                           const Bootstrap& bootstrap);

/// Elementary effects of each parameter: the change of the outcome over the change of the parameter's
/// quantile.
struct MorrisEffects {
  std::vector<Estimate> size;       ///< Mean of the absolute effects: importance.
  std::vector<Estimate> mean;       ///< Mean of the signed effects.
  std::vector<Estimate> deviation;  ///< Standard deviation of the effects: interaction or nonlinearity.
  std::size_t samples = 0;          ///< Number of complete trajectories.
};

/// Computes the effects from the outcomes of a Morris design. `steps` has one entry per point of a trajectory
/// but the first: the changed parameter and the size of the change.
struct MorrisStep {
  std::size_t parameter = 0;
  double size = 0.0;
};
MorrisEffects morris_effects(std::span<const double> outcomes, const std::vector<MorrisStep>& steps,
                             std::size_t parameters, const Bootstrap& bootstrap);

}  // namespace stepwire::statistics
