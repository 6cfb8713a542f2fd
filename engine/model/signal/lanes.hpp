#pragma once

#include <cstdint>

#include "engine/model/signal/lane.hpp"

// Building blocks of the loops in generated code that steps a lane batch.

namespace stepwire {

/// Numbers that follow from the time alone, for a later time in each lane.
struct TimesAhead {
  double* first;
  std::int64_t tick;  ///< the first tick whose times are there
  int next;           ///< lane of the next time
};

/// Numbers of all lanes. A number common to all lanes is stored in lane 0.
struct Lanes {
  double* first;
  TimesAhead* ahead = nullptr;
  Lane lane(Index l) const { return {first + l}; }
  Lanes from(Index n) const { return {first + n * lanes}; }
  double& operator[](Index n) const { return first[n * lanes]; }
};

/// The variant for the tables of numbers; `+` returns a list, whose numbers are contiguous.
struct LaneNumbers {
  struct One {
    const double* first;
    double operator[](Index n) const { return first[n * lanes]; }
  };
  const double* first;
  One lane(Index l) const { return {first + l}; }
  const double* operator+(Index list) const { return first + list; }
};

/// Calls `call` for each lane in a form that the compiler vectorises. The call must construct its block
/// itself: for a block passed to it the loop would keep a copy for each lane in memory, which prevents
/// optimisation.
template <class Call>
[[gnu::always_inline]] inline void each_lane(const Call& call) {
#pragma omp simd
  for (int l = 0; l < static_cast<int>(lanes); ++l) call(l);
}

/// Numbers of all lanes in one or several vector registers.
typedef double LaneVector __attribute__((vector_size(lanes * sizeof(double)), may_alias));

/// Adds NaN in each lane with a non-finite number among `count`, else 0.
inline void add_unfinite(LaneVector& sum, const double* numbers, Index count) {
  for (Index i = 0; i < count; ++i) sum += *reinterpret_cast<const LaneVector*>(numbers + i * lanes) * 0.0;
}

/// The same where lane 0 holds the numbers of all lanes.
inline void add_unfinite_of_all(LaneVector& sum, const double* numbers, Index count) {
  for (Index i = 0; i < count; ++i) sum += numbers[i * lanes] * 0.0;
}

/// Returns a bit mask of the lanes in which a condition holds.
template <class Condition>
[[gnu::always_inline]] inline unsigned lanes_where(const Condition& holds) {
  unsigned bits = 0;
  for (unsigned l = 0; l < static_cast<unsigned>(lanes); ++l) bits |= holds(l) ? 1u << l : 0u;
  return bits;
}

}  // namespace stepwire
