#pragma once

#include <limits>
#include <string>

#include "engine/block/configure.hpp"
#include "engine/signal/per_element.hpp"

namespace stepwire {

/// Default of a limit that a file may leave out.
inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// What is wrong where an element of `lower` lies above its partner in `upper`; empty where none does.
std::string order_problem(const PerElement& lower, const PerElement& upper, std::string_view upper_name);

/// Refuses, in configure(), a lower limit that lies above the upper one.
template <auto lower, auto upper, class Block>
void require_order(const Block& block, const Configure& is) {
  const std::string problem = order_problem(block.*lower, block.*upper, member_name<upper>());
  if (!problem.empty()) is.refuse<lower>(problem);
}

/// Does any element have a limit?
inline bool limits(const PerElement& lower, const PerElement& upper) {
  return (lower > -unlimited).any() || (upper < unlimited).any();
}

}  // namespace stepwire
