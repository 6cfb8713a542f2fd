#pragma once

#include "engine/model/signal/lane.hpp"

// What generated code that steps several runs together writes its loops with.

namespace stepwire {

/// Numbers of all lanes. What is the same in all of them lies in lane 0.
struct Lanes {
  double* first;
  Lane lane(Index l) const { return {first + l}; }
  Lanes from(Index n) const { return {first + n * lanes}; }
  double& operator[](Index n) const { return first[n * lanes]; }
};

/// The same of the tables of numbers; `+` leads to a list, whose numbers lie one behind the other.
struct LaneNumbers {
  struct One {
    const double* first;
    double operator[](Index n) const { return first[n * lanes]; }
  };
  const double* first;
  One lane(Index l) const { return {first + l}; }
  const double* operator+(Index list) const { return first + list; }
};

/// Calls the same for each lane; the compiler puts the lanes side by side into registers where it can. The
/// call makes its block itself: of one that it is given the loop keeps a copy for each lane in memory, which
/// the compiler does not see through.
template <class Call>
[[gnu::always_inline]] inline void each_lane(const Call& call) {
#pragma omp simd
  for (int l = 0; l < static_cast<int>(lanes); ++l) call(l);
}

/// Numbers of all lanes in a register, or several.
typedef double LaneVector __attribute__((vector_size(lanes * sizeof(double)), may_alias));

/// Adds numbers that are nan in each lane in which one of `count` is not finite, else 0.
inline void add_unfinite(LaneVector& sum, const double* numbers, Index count) {
  for (Index i = 0; i < count; ++i) sum += *reinterpret_cast<const LaneVector*>(numbers + i * lanes) * 0.0;
}

/// The same where lane 0 stands for all.
inline void add_unfinite_of_all(LaneVector& sum, const double* numbers, Index count) {
  for (Index i = 0; i < count; ++i) sum += numbers[i * lanes] * 0.0;
}

/// Bits of the lanes in which a condition holds.
template <class Condition>
[[gnu::always_inline]] inline unsigned lanes_where(const Condition& holds) {
  unsigned bits = 0;
  for (unsigned l = 0; l < static_cast<unsigned>(lanes); ++l) bits |= holds(l) ? 1u << l : 0u;
  return bits;
}

}  // namespace stepwire
