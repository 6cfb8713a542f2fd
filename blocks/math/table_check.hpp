#pragma once

#include <fmt/format.h>

#include "engine/base/text/count.hpp"
#include "engine/model/block/configure.hpp"

namespace stepwire {

/// Refuses points of a table that do not increase, or are fewer than two.
template <auto parameter>
void require_increasing(const Configure& is, const Numbers& points) {
  if (points.size() < 2)
    is.refuse<parameter>(
        fmt::format("has {}; a table needs two or more", text::counted(points.size(), "point")));
  for (Index i = 1; i < points.size(); ++i)
    if (!(points[i] > points[i - 1]))
      is.refuse<parameter>(
          fmt::format("element {}, {}, does not lie above the one before, {}; points must increase", i + 1,
                      points[i], points[i - 1]));
}

}  // namespace stepwire
