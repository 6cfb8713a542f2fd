#pragma once

#include <fmt/core.h>

#include "engine/base/text/count.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

/// Refuses a list of precisions whose length differs from that of the directions or channels.
template <auto Measured, auto Precision, class Configuring>
void require_precision_of_each(Configuring& is, const char* what) {
  const auto measured = is.template count<Measured>(), precisions = is.template count<Precision>();
  if (measured != precisions)
    is.template refuse<Precision>(fmt::format("it has {} for {}; each {} has its own",
                                              text::counted(precisions, "number"),
                                              text::counted(measured, what), what));
}

}  // namespace stepwire
