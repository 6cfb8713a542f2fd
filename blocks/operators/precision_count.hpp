#pragma once

#include <fmt/core.h>

#include "engine/model/block/declare.hpp"

namespace stepwire {

/// Refuses a list of precisions whose length differs from that of the directions or channels.
template <auto Measured, auto Precision, class Configuring>
void require_precision_of_each(Configuring& is, const char* what) {
  const auto measured = is.template count<Measured>(), precisions = is.template count<Precision>();
  if (measured != precisions)
    is.template refuse<Precision>(
        fmt::format("it has {} numbers for {} {}s; each {} has its own", precisions, measured, what, what));
}

}  // namespace stepwire
