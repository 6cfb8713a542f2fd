#include "engine/analyse/statistics/sensitivity_indices.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/analyse/statistics/no_number.hpp"
#include "engine/base/math/random.hpp"

namespace stepwire::statistics {
namespace {

/// Returns the ranks of each column, centred and of length 1; nan for a constant column.
Eigen::MatrixXd unit_ranks(const Samples& samples, const Choice& choice) {
  Eigen::MatrixXd columns(choice.size(), samples.width);
  std::vector<double> values(choice.size());
  for (std::size_t c = 0; c < samples.width; ++c) {
    for (std::size_t i = 0; i < choice.size(); ++i) values[i] = samples[choice[i]][c];
    const std::vector<double> ranked = ranks(values);
    auto column = columns.col(static_cast<Eigen::Index>(c));
    column = Eigen::Map<const Eigen::VectorXd>(ranked.data(), static_cast<Eigen::Index>(ranked.size()));
    column.array() -= column.mean();
    const double length = column.norm();
    column /= length > 0.0 ? length : no_number;
  }
  return columns;
}

/// Returns the partial correlation of each parameter with the outcome (the last column), given the others.
Eigen::VectorXd partial_correlations(const Eigen::MatrixXd& correlations) {
  constexpr double singular = 1e-10;
  const Eigen::Index last = correlations.rows() - 1;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlations.topLeftCorner(last, last));
  if (!(solver.eigenvalues()[0] > singular)) return Eigen::VectorXd::Constant(last, no_number);
  const Eigen::VectorXd together = correlations.col(last).head(last);
  const Eigen::MatrixXd inverse = correlations.topLeftCorner(last, last).inverse();
  const Eigen::VectorXd weights = inverse * together;
  const double unexplained = std::max(0.0, 1.0 - together.dot(weights));
  // From the block inverse P of the whole correlation matrix: -P_iy / sqrt(P_ii P_yy).
  return weights.array() / (inverse.diagonal().array() * unexplained + weights.array().square()).sqrt();
}

/// Returns the rank correlations of all parameters, then the partial ones.
std::vector<double> correlations_of(const Samples& samples, const Choice& choice) {
  const auto parameters = static_cast<Eigen::Index>(samples.width) - 1;
  if (choice.size() < fewest_rows(0)) return std::vector<double>(2 * (samples.width - 1), no_number);
  const bool enough = choice.size() >= fewest_rows(samples.width - 2);
  const Eigen::MatrixXd columns = unit_ranks(samples, choice);
  const Eigen::MatrixXd correlations = columns.transpose() * columns;
  Eigen::VectorXd all(2 * parameters);
  all << correlations.col(parameters).head(parameters),
      enough && correlations.allFinite() ? partial_correlations(correlations)
                                         : Eigen::VectorXd::Constant(parameters, no_number);
  return {all.data(), all.data() + all.size()};
}

/// Returns the first indices of all parameters, then the total ones.
std::vector<double> indices_of(const Samples& samples, const Choice& choice, std::size_t parameters) {
  if (choice.size() < fewest_samples) return std::vector<double>(2 * parameters, no_number);
  std::vector<double> sums(2 * parameters);
  double sum = 0.0, squares = 0.0;
  for (const std::size_t sample : choice) sum += samples[sample][0] + samples[sample][1];
  const double count = static_cast<double>(choice.size()), mean = sum / (2.0 * count);
  for (const std::size_t sample : choice) {
    const double* const outcome = samples[sample];
    const double a = outcome[0] - mean, b = outcome[1] - mean;
    squares += a * a + b * b;
    for (std::size_t i = 0; i < parameters; ++i) {
      const double changed = outcome[2 + i] - mean;
      sums[i] += b * (changed - a);
      sums[parameters + i] += 0.5 * (a - changed) * (a - changed);
    }
  }
  const double variance = squares / (2.0 * count);
  for (double& index : sums) index = variance > 0.0 ? index / count / variance : no_number;
  return sums;
}

/// Returns the means of absolute effects, the means of effects, and their deviations.
std::vector<double> effects_of(const Samples& effects, const Choice& choice) {
  const std::size_t parameters = effects.width;
  std::vector<double> numbers(3 * parameters);
  const auto count = static_cast<double>(choice.size());
  for (std::size_t i = 0; i < parameters; ++i) {
    double size = 0.0, sum = 0.0, squares = 0.0;
    for (const std::size_t sample : choice) {
      size += std::abs(effects[sample][i]);
      sum += effects[sample][i];
    }
    const double mean = sum / count;
    for (const std::size_t sample : choice)
      squares += (effects[sample][i] - mean) * (effects[sample][i] - mean);
    numbers[i] = choice.empty() ? no_number : size / count;
    numbers[parameters + i] = choice.empty() ? no_number : mean;
    numbers[2 * parameters + i] = count > 1.0 ? std::sqrt(squares / (count - 1.0)) : no_number;
  }
  return numbers;
}

}  // namespace

Samples::Samples(std::span<const double> all, std::size_t of_sample) : width(of_sample) {
  for (std::size_t first = 0; first + width <= all.size(); first += width) {
    const auto sample = all.subspan(first, width);
    if (!std::ranges::all_of(sample, [](double value) { return std::isfinite(value); })) continue;
    numbers.insert(numbers.end(), sample.begin(), sample.end());
    ++count;
  }
}

std::vector<Estimate> estimate(const Samples& samples, const Bootstrap& bootstrap,
                               const std::function<std::vector<double>(const Choice&)>& numbers_of) {
  Choice choice(samples.count);
  for (std::size_t i = 0; i < choice.size(); ++i) choice[i] = i;
  std::vector<Estimate> estimates;
  for (const double value : numbers_of(choice)) estimates.push_back({value, {no_number, no_number}});
  if (samples.count < 2) return estimates;
  std::vector<std::vector<double>> replicates(estimates.size());
  for (std::size_t r = 0; r < bootstrap.replicates; ++r) {
    const std::uint64_t stream = random_bits(static_cast<std::uint64_t>(bootstrap.seed), r);
    for (std::size_t i = 0; i < choice.size(); ++i)
      choice[i] = static_cast<std::size_t>(to_unit_interval(random_bits(stream, i)) *
                                           static_cast<double>(samples.count));
    const std::vector<double> numbers = numbers_of(choice);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      if (!std::isnan(numbers[k])) replicates[k].push_back(numbers[k]);
  }
  const double tail = 0.5 * (1.0 - bootstrap.confidence);
  for (std::size_t k = 0; k < estimates.size(); ++k) {
    if (replicates[k].empty()) continue;
    std::ranges::sort(replicates[k]);
    estimates[k].interval = {hazen_quantile(replicates[k], tail), hazen_quantile(replicates[k], 1.0 - tail)};
  }
  return estimates;
}

std::vector<Estimate> part_of(const std::vector<Estimate>& all, std::size_t part, std::size_t size) {
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(part * size);
  return {begin, begin + static_cast<std::ptrdiff_t>(size)};
}

RankSensitivity rank_sensitivity(std::span<const double> rows, std::size_t parameters,
                                 const Bootstrap& bootstrap) {
  const Samples samples(rows, parameters + 1);
  const auto all =
      estimate(samples, bootstrap, [&](const Choice& choice) { return correlations_of(samples, choice); });
  return {part_of(all, 0, parameters), part_of(all, 1, parameters), samples.count};
}

SobolIndices sobol_indices(std::span<const double> outcomes, std::size_t parameters,
                           const Bootstrap& bootstrap) {
  const Samples samples(outcomes, parameters + 2);
  const auto all = estimate(samples, bootstrap,
                            [&](const Choice& choice) { return indices_of(samples, choice, parameters); });
  return {part_of(all, 0, parameters), part_of(all, 1, parameters), samples.count};
}

MorrisEffects morris_effects(std::span<const double> outcomes, const std::vector<MorrisStep>& steps,
                             std::size_t parameters, const Bootstrap& bootstrap) {
  std::vector<double> effects;
  for (std::size_t way = 0; (way + 1) * (parameters + 1) <= outcomes.size(); ++way) {
    std::vector<double> of_way(parameters);
    for (std::size_t k = 0; k < parameters; ++k) {
      const MorrisStep& step = steps[way * parameters + k];
      const std::size_t before = way * (parameters + 1) + k;
      of_way[step.parameter] = (outcomes[before + 1] - outcomes[before]) / step.size;
    }
    effects.insert(effects.end(), of_way.begin(), of_way.end());
  }
  const Samples samples(effects, parameters);
  const auto all =
      estimate(samples, bootstrap, [&](const Choice& choice) { return effects_of(samples, choice); });
  return {part_of(all, 0, parameters), part_of(all, 1, parameters), part_of(all, 2, parameters),
          samples.count};
}

}  // namespace stepwire::statistics
