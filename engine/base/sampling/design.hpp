#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stepwire::sampling {

/// Points in a cube: [dimension][point], each number in (0, 1).
using Points = std::vector<std::vector<double>>;

/// How points are laid out in a cube.
enum class Layout {
  random,           ///< each point alone
  latin_hypercube,  ///< along each dimension one point in each of as many layers as there are points
  sobol,            ///< points of low discrepancy
  saltelli,  ///< of two Sobol points A and B one after the other, and for each dimension A with that of B
  morris     ///< ways that go half of the cube along each dimension once, in random order
};

/// Half of what a way of Morris goes over, of which each dimension has four places.
inline constexpr double morris_step = 0.5;

/// What is laid out. The first n samples of N are those of a design of n, but for Latin hypercubes, whose
/// layers are as many as their points.
struct Design {
  Layout layout = Layout::random;
  std::size_t samples = 0;  ///< points; of saltelli and morris each makes several points
  std::int64_t seed = 1;

  /// Points that one sample makes.
  std::size_t points_of_sample(std::size_t dimensions) const;
};

/// Dimensions for which there are Sobol numbers.
std::size_t max_sobol_dimensions();

/// The points of a design. Those of random, latin_hypercube and sobol are in each dimension the same ones
/// however many dimensions there are. The same bits on every machine. Those of Sobol (directions of Joe and
/// Kuo, 2008) begin with that at the origin, and are scrambled by the seed: the digits of each dimension are
/// multiplied by a random lower triangular matrix and shifted (Matousek: On the L2-discrepancy for anchored
/// boxes, Journal of Complexity 14, 1998), which keeps their balance: of 2^m points each of 2^m equal
/// intervals of a dimension holds one.
Points points_of(const Design& design, std::size_t dimensions);

}  // namespace stepwire::sampling
