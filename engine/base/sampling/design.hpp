#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stepwire::sampling {

/// Points in a cube: [dimension][point], each number in (0, 1).
using Points = std::vector<std::vector<double>>;

/// Kinds of designs of points in a cube.
enum class Layout {
  random,           ///< Independent points.
  latin_hypercube,  ///< Each dimension has one point in each of as many layers as there are points.
  sobol,            ///< Low-discrepancy sequence.
  saltelli,         ///< Two Sobol points A and B, then for each dimension A with that coordinate of B.
  morris            ///< Trajectories that change each dimension once by half the cube, in random order.
};

/// Step of a Morris trajectory along a dimension; each dimension has four levels.
inline constexpr double morris_step = 0.5;

/// Description of a design. The first n of N samples equal a design of n samples, except for Latin
/// hypercubes, whose layers depend on N.
struct Design {
  Layout layout = Layout::random;
  std::size_t samples = 0;  ///< of saltelli and morris each makes several points
  std::int64_t seed = 1;

  /// Returns the number of points that one sample makes.
  std::size_t points_of_sample(std::size_t dimensions) const;
};

/// Returns the number of dimensions with Sobol direction numbers.
std::size_t max_sobol_dimensions();

/// Returns the points of a design, with the same bits on every machine. For random, latin_hypercube and sobol
/// a dimension has the same numbers for any number of dimensions. The Sobol sequence (directions of Joe and
/// Kuo, 2008) begins at the origin and is scrambled by the seed. Scrambling multiplies the digits of each
/// dimension by a random lower triangular matrix and shifts them (Matousek: On the L2-discrepancy for
/// anchored boxes, Journal of Complexity 14, 1998). It keeps the balance: of 2^m points each of 2^m equal
/// intervals of a dimension holds one.
Points points_of(const Design& design, std::size_t dimensions);

}  // namespace stepwire::sampling
