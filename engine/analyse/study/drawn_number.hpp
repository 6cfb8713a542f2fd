#pragma once

#include <cstdint>
#include <initializer_list>

namespace stepwire::study {

/// Returns a pseudo-random whole number below 1e9, a hash of its arguments. It is used for the subject, the
/// noise of a trial and the order of the conditions.
std::uint64_t drawn_number(std::initializer_list<std::uint64_t> from);

}  // namespace stepwire::study
