#include "engine/analyse/statistics/sobol_indices.hpp"

#include <cmath>

#include "engine/analyse/statistics/no_number.hpp"

namespace stepwire::statistics {

namespace {

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
