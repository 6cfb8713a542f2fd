#pragma once

#include <cstdint>
#include <initializer_list>

namespace stepwire::study {

/// Whole numbers below 1e9 that follow from others, each as if drawn: who the subject is, the noise of a
/// trial, the order of the conditions.
std::uint64_t drawn_number(std::initializer_list<std::uint64_t> from);

}  // namespace stepwire::study
