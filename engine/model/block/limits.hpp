#pragma once

#include <algorithm>
#include <string>

#include "engine/model/block/configure.hpp"
#include "engine/model/signal/per_element.hpp"

namespace stepwire {

/// Returns the problem where an element of `lower` exceeds its counterpart in `upper`; empty if none does.
std::string order_problem(const PerElement& lower, const PerElement& upper, std::string_view upper_name);

/// Refuses, in configure(), a lower limit above the upper one.
template <auto lower, auto upper, class Block>
void require_order(const Block& block, const Configure& is) {
  const std::string problem = order_problem(block.*lower, block.*upper, member_name<upper>());
  if (!problem.empty()) is.refuse<lower>(problem);
}

/// True where every element equals this number.
inline bool all_are(const PerElement& numbers, double number) {
  return std::all_of(numbers.begin(), numbers.end(), [&](double one) { return one == number; });
}

/// True where any element has a finite limit.
inline bool limits(const PerElement& lower, const PerElement& upper) {
  return std::any_of(lower.begin(), lower.end(), [](double limit) { return limit > -unlimited; }) ||
         std::any_of(upper.begin(), upper.end(), [](double limit) { return limit < unlimited; });
}

}  // namespace stepwire
