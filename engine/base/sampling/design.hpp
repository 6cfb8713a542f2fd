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
  sobol             ///< points of low discrepancy
};

/// What is laid out. The first n points of N are the points of a design of n, but for Latin hypercubes, whose
/// layers are as many as their points.
struct Design {
  Layout layout = Layout::random;
  std::size_t points = 0;
  std::int64_t seed = 1;
};

/// Dimensions for which there are Sobol numbers.
std::size_t max_sobol_dimensions();

/// The points of a design. The numbers of a dimension do not depend on how many dimensions there are. The
/// same bits on every machine. Those of Sobol (directions of Joe and Kuo, 2008) begin with that at the
/// origin, and are scrambled by the seed: the digits of each dimension are multiplied by a random lower
/// triangular matrix and shifted (Matousek: On the L2-discrepancy for anchored boxes, Journal of Complexity
/// 14, 1998), which keeps their balance: of 2^m points each of 2^m equal intervals of a dimension holds one.
Points points_of(const Design& design, std::size_t dimensions);

}  // namespace stepwire::sampling
