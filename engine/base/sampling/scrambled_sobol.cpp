#include "engine/base/sampling/scrambled_sobol.hpp"

#include <array>
#include <bit>
#include <boost/random/sobol.hpp>

#include "engine/base/math/random.hpp"

namespace stepwire::sampling {

namespace {

constexpr int digits = 64;

/// Random lower triangular binary matrix, highest digit first, and a digital shift.
class Scramble {
 public:
  Scramble(std::int64_t seed, std::size_t dimension) {
    const std::uint64_t stream = random_bits(static_cast<std::uint64_t>(seed), dimension);
    for (int digit = 0; digit < digits; ++digit) {
      const std::uint64_t own = std::uint64_t{1} << (digits - 1 - digit);
      const std::uint64_t below = own - 1;
      columns_[static_cast<std::size_t>(digit)] =
          own | (random_bits(stream, static_cast<std::uint64_t>(digit)) & below);
    }
    shift_ = random_bits(stream, digits);
  }

  std::uint64_t operator()(std::uint64_t bits) const {
    std::uint64_t result = shift_;
    while (bits != 0) {
      const int digit = std::countl_zero(bits);
      result ^= columns_[static_cast<std::size_t>(digit)];
      bits ^= std::uint64_t{1} << (digits - 1 - digit);
    }
    return result;
  }

 private:
  std::array<std::uint64_t, digits> columns_;
  std::uint64_t shift_;
};

}  // namespace

std::size_t max_sobol_dimensions() {
  return boost::random::default_sobol_table::max_dimension;
}

void lay_out_sobol(Points& points, std::int64_t seed) {
  if (points.empty()) return;
  std::vector<Scramble> scrambles;
  for (std::size_t dimension = 0; dimension < points.size(); ++dimension)
    scrambles.emplace_back(seed, dimension);
  boost::random::sobol_engine<std::uint64_t, digits> sobol(points.size());
  for (std::size_t i = 0; i < points.front().size(); ++i)
    for (std::size_t dimension = 0; dimension < points.size(); ++dimension) {
      const std::uint64_t bits = i == 0 ? 0 : sobol();  // Boost's sequence omits the origin
      points[dimension][i] = to_unit_interval(scrambles[dimension](bits));
    }
}

}  // namespace stepwire::sampling
