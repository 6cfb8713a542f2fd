#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/math/random.hpp"

namespace stepwire::random {

/// Random choices that follow from a seed alone: the same on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(mix_bits(seed + 0x5eed)) {}

  /// A whole number from 0 to `count` - 1; `count` is above 0.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
  /// A whole number from `first` to `last`.
  int whole(int first, int last) {
    return first + static_cast<int>(below(static_cast<std::size_t>(last - first + 1)));
  }
  /// A number from `lower` to `upper`.
  double between(double lower, double upper) { return lower + (upper - lower) * to_unit_interval(next()); }
  /// True with this probability.
  bool chance(double probability) { return to_unit_interval(next()) < probability; }
  /// An element of a list that is not empty.
  template <class T>
  const T& of(const std::vector<T>& list) {
    return list[below(list.size())];
  }
  /// Puts a list into a random order.
  template <class T>
  void shuffle(std::vector<T>& list) {
    for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[below(i)]);
  }

 private:
  std::uint64_t next() { return random_bits(seed_, count_++); }

  std::uint64_t seed_, count_ = 0;
};

}  // namespace stepwire::random
