#pragma once

#include <cstddef>

// Marks rarely executed code of a hot function: it is kept out of line, so that the function needs few
// registers. In generated code sizes are constants, and the marker is empty.
#ifdef STEPWIRE_GENERATED
#define STEPWIRE_RARE
#else
#define STEPWIRE_RARE [[gnu::noinline]]
#endif

// Marks a short loop, over the inputs of a list for example. In generated code its count is a constant,
// and it is written out: a loop over lanes is not vectorised around other loops.
#if defined(STEPWIRE_GENERATED) && !defined(__clang__)
#define STEPWIRE_UNROLLED _Pragma("GCC unroll 64")
#else
#define STEPWIRE_UNROLLED
#endif

namespace stepwire {

/// Type of element indices and counts; the same as Eigen's.
using Index = std::ptrdiff_t;

/// Number of runs that share a workspace: number n of run l has index n * lanes + l. It exceeds 1 only in
/// generated code that steps a lane batch.
#ifdef STEPWIRE_LANES
inline constexpr Index lanes = STEPWIRE_LANES;
#else
inline constexpr Index lanes = 1;
#endif

/// Capacity of a list without heap memory. A generated program sets it to its longest list and never
/// allocates; elsewhere longer lists use the heap.
#ifdef STEPWIRE_LONGEST_LIST
inline constexpr bool lists_take_memory = false;
inline constexpr Index numbers_in_list = STEPWIRE_LONGEST_LIST;
#else
inline constexpr bool lists_take_memory = true;
inline constexpr Index numbers_in_list = 6;
#endif

/// Size of a port or state that is known only when the diagram is planned.
inline constexpr int any_size = -1;

}  // namespace stepwire
