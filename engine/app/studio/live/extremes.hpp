#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

namespace stepwire::live {

/// Minimum and maximum of some numbers; NaN is ignored. `least` exceeds `most` if there are none.
struct Extremes {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  bool none() const { return least > most; }
  void take(const Extremes& other) {
    if (other.least < least) least = other.least;
    if (other.most > most) most = other.most;
  }
};

/// Returns the extremes of contiguous numbers. Eight independent lanes hide the latency of the comparisons.
inline Extremes extremes_of(std::span<const double> values) {
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> least, most;
  least.fill(Extremes{}.least);
  most.fill(Extremes{}.most);
  const std::size_t whole = values.size() / lanes * lanes;
  for (std::size_t i = 0; i < whole; i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) {
      const double value = values[i + k];
      least[k] = value < least[k] ? value : least[k];
      most[k] = value > most[k] ? value : most[k];
    }
  Extremes all;
  for (std::size_t k = 0; k < lanes; ++k) all.take({least[k], most[k]});
  for (std::size_t i = whole; i < values.size(); ++i) {
    if (values[i] < all.least) all.least = values[i];
    if (values[i] > all.most) all.most = values[i];
  }
  return all;
}

}  // namespace stepwire::live
