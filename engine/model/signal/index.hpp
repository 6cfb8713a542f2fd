#pragma once

#include <cstddef>

// Marks what is rarely needed in a function that is called all the time: it stays outside, so that the
// function needs few registers. In generated code sizes are constants, and nothing has to be kept apart.
#ifdef STEPWIRE_GENERATED
#define STEPWIRE_RARE
#else
#define STEPWIRE_RARE [[gnu::noinline]]
#endif

namespace stepwire {

/// Counts elements; the same type as Eigen's.
using Index = std::ptrdiff_t;

/// How many runs the numbers of a workspace belong to: number n of run l lies at n * lanes + l. More than one
/// only in generated code that steps several runs together.
#ifdef STEPWIRE_LANES
inline constexpr Index lanes = STEPWIRE_LANES;
#else
inline constexpr Index lanes = 1;
#endif

/// How many numbers a list holds in itself. A generated program defines its longest list, so that lists need
/// no heap there: none of them is longer. Elsewhere longer lists take memory of their own.
#ifdef STEPWIRE_LONGEST_LIST
inline constexpr bool lists_take_memory = false;
inline constexpr Index numbers_in_list = STEPWIRE_LONGEST_LIST;
#else
inline constexpr bool lists_take_memory = true;
inline constexpr Index numbers_in_list = 6;
#endif

/// A port or state whose size is known only when the diagram is planned.
inline constexpr int any_size = -1;

}  // namespace stepwire
