#include "engine/base/sampling/sensitivity_points.hpp"

#include <numeric>
#include <utility>

#include "engine/base/math/random.hpp"
#include "engine/base/sampling/scrambled_sobol.hpp"

namespace stepwire::sampling {

Points saltelli_points(const Design& design, std::size_t dimensions) {
  Points base(2 * dimensions, std::vector<double>(design.samples));
  lay_out_sobol(base, design.seed);
  const std::size_t each = design.points_of_sample(dimensions);
  Points points(dimensions, std::vector<double>(design.samples * each));
  for (std::size_t d = 0; d < dimensions; ++d)
    for (std::size_t sample = 0; sample < design.samples; ++sample) {
      const double a = base[d][sample], b = base[dimensions + d][sample];
      for (std::size_t k = 0; k < each; ++k) points[d][sample * each + k] = k == 1 || k == 2 + d ? b : a;
    }
  return points;
}

namespace {

/// Generator of the random choices of one trajectory.
class Way {
 public:
  Way(std::int64_t seed, std::size_t sample) : seed_(random_bits(static_cast<std::uint64_t>(seed), sample)) {}

  std::size_t draw(std::size_t count) {
    const double share = to_unit_interval(random_bits(seed_, drawn_++));
    return static_cast<std::size_t>(share * static_cast<double>(count));
  }

  std::vector<std::size_t> order(std::size_t count) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[draw(i)]);
    return order;
  }

 private:
  std::uint64_t seed_, drawn_ = 0;
};

}  // namespace

Points morris_points(const Design& design, std::size_t dimensions) {
  const std::size_t each = design.points_of_sample(dimensions);
  Points points(dimensions, std::vector<double>(design.samples * each));
  for (std::size_t sample = 0; sample < design.samples; ++sample) {
    Way way(design.seed, sample);
    const std::vector<std::size_t> order = way.order(dimensions);
    for (std::size_t step = 0; step < dimensions; ++step) {
      const double low = way.draw(2) == 0 ? 0.125 : 0.375, high = low + morris_step;
      const bool rises = way.draw(2) == 0;
      for (std::size_t k = 0; k < each; ++k)
        points[order[step]][sample * each + k] = (k <= step) == rises ? low : high;
    }
  }
  return points;
}

}  // namespace stepwire::sampling
