#pragma once

#include <cstdint>
#include <string>

#include "tests/random/bench.hpp"

namespace stepwire::random {

/// Smooth diagrams: all that jumps in them jumps at a tick of the file, or at an event that is located, so
/// that a solver has its order. Only such diagrams are made of one seed in seven.
bool is_smooth(std::uint64_t seed);
/// True for every second of them: nothing in it is sampled or works on condition.
bool is_continuous(std::uint64_t seed);
/// The number of seeds below this one whose diagrams are of all types.
std::uint64_t rank_among_others(std::uint64_t seed);

/// True for a type of which smooth diagrams are made; one that holds its outputs between ticks has `every`.
bool may_be_smooth(const std::string& type);
/// The same for a smooth diagram in which nothing is sampled.
bool may_be_continuous(const std::string& type);
/// True for a parameter that makes such a block bend, as a limit does.
bool bends(const std::string& parameter);
/// A number of steps in a smooth diagram, a whole one without `events: locate`.
double some_steps(Bench& bench, int least, int most);
/// A new signal that jumps at ticks, or where events are located.
Wire edges_on_ticks(Bench& bench);
/// The reason for which a diagram is not smooth; empty text for a smooth one.
std::string why_not_smooth(const Sketch& sketch);

}  // namespace stepwire::random
