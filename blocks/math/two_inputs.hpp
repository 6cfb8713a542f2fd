#pragma once

#include <string>

#include "engine/model/block/configure.hpp"

namespace stepwire {

/// Refuses a list of inputs that does not have two elements.
template <auto list>
void require_two(const Configure& is) {
  if (is.count<list>() != 2)
    is.refuse<list>("has " + std::to_string(is.count<list>()) + " elements; it takes two, [first, second]");
}

}  // namespace stepwire
