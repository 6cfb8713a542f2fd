#include "engine/analyse/statistics/bootstrap.hpp"

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/quartiles.hpp"
#include "engine/base/math/random.hpp"

namespace stepwire::statistics {

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

}  // namespace stepwire::statistics
