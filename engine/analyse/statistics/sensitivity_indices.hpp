#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

/// An estimate with its confidence interval (percentiles of a bootstrap).
struct Estimate {
  double value = 0.0;
  ConfidenceInterval interval;
};

/// Parameters of a bootstrap.
struct Bootstrap {
  double confidence = 0.95;
  std::size_t replicates = 500;
  std::int64_t seed = 1;
};

/// Samples of `width` numbers each. Samples with a non-finite number are left out.
struct Samples {
  std::vector<double> numbers;
  std::size_t width, count = 0;

  Samples(std::span<const double> all, std::size_t of_sample);
  const double* operator[](std::size_t sample) const { return numbers.data() + sample * width; }
};

/// Indices of drawn samples, with repetitions.
using Choice = std::vector<std::size_t>;

/// Computes numbers from samples, with their bootstrap intervals. Intervals are nan for fewer than two
/// samples.
std::vector<Estimate> estimate(const Samples& samples, const Bootstrap& bootstrap,
                               const std::function<std::vector<double>(const Choice&)>& numbers_of);

/// Returns the part-th group of `size` consecutive estimates.
std::vector<Estimate> part_of(const std::vector<Estimate>& all, std::size_t part, std::size_t size);

/// Monotonic dependence of an outcome on each parameter: -1 to 1, 0 for none.
struct RankSensitivity {
  std::vector<Estimate> rank;     ///< Spearman's rank correlation.
  std::vector<Estimate> partial;  ///< Rank correlation with the other parameters regressed out.
  std::size_t samples = 0;        ///< Number of complete samples.
};

/// Returns the least number of samples of a correlation from which the effect of `others` is removed. It
/// leaves two degrees of freedom: without one, each correlation is 1 or -1.
constexpr std::size_t fewest_rows(std::size_t others) {
  return others + 4;
}

/// Computes rank correlations (Spearman 1904) and partial ones (Iman and Conover 1979) for samples of any
/// design. A row of `rows` is one sample: the parameters, then the outcome. Samples with a non-finite number
/// are left out. The result is nan for a constant column, and for too few samples: see fewest_rows(). Partial
/// correlations are also nan if a parameter is a function of others.
RankSensitivity rank_sensitivity(std::span<const double> rows, std::size_t parameters,
                                 const Bootstrap& bootstrap);

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
