#include "engine/base/sampling/design.hpp"

#include <numeric>
#include <utility>

#include "engine/base/math/random.hpp"
#include "engine/base/sampling/scrambled_sobol.hpp"
#include "engine/base/sampling/sensitivity_points.hpp"

namespace stepwire::sampling {

namespace {

void lay_out_randomly(std::vector<double>& numbers, std::int64_t seed, std::size_t dimension) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = even_sample(seed, static_cast<std::ptrdiff_t>(dimension), static_cast<double>(i));
}

/// Fills `numbers` with one random point in each layer, in random order (Fisher-Yates).
void lay_out_in_layers(std::vector<double>& numbers, std::int64_t seed, std::size_t dimension) {
  std::vector<std::size_t> layers(numbers.size());
  std::iota(layers.begin(), layers.end(), std::size_t{0});
  const auto stream = static_cast<std::ptrdiff_t>(2 * dimension);
  for (std::size_t i = layers.size(); i > 1; --i) {
    const double share = even_sample(seed, stream, static_cast<double>(i));
    std::swap(layers[i - 1], layers[static_cast<std::size_t>(share * static_cast<double>(i))]);
  }
  const auto count = static_cast<double>(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] =
        (static_cast<double>(layers[i]) + even_sample(seed, stream + 1, static_cast<double>(i))) / count;
}

}  // namespace

std::size_t Design::points_of_sample(std::size_t dimensions) const {
  return layout == Layout::saltelli ? dimensions + 2 : layout == Layout::morris ? dimensions + 1 : 1;
}

Points points_of(const Design& design, std::size_t dimensions) {
  if (design.layout == Layout::saltelli) return saltelli_points(design, dimensions);
  if (design.layout == Layout::morris) return morris_points(design, dimensions);
  Points points(dimensions, std::vector<double>(design.samples));
  if (design.layout == Layout::sobol) {
    lay_out_sobol(points, design.seed);
    return points;
  }
  const auto lay_out = design.layout == Layout::random ? lay_out_randomly : lay_out_in_layers;
  for (std::size_t dimension = 0; dimension < dimensions; ++dimension)
    lay_out(points[dimension], design.seed, dimension);
  return points;
}

}  // namespace stepwire::sampling
