#include "blocks/plants/linkage_core.hpp"

#include <fmt/format.h>

#include "blocks/plants/linkage_declare.hpp"
#include "engine/model/block/configure.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

void LinkageCore::configure(Configure& is) {
  const Index size = dimensions();
  if (size < 1 || size > 3)
    is.refuse<&LinkageCore::anchors>(
        fmt::format("has {} columns; it takes 1 (on a line), 2 (in the plane) or 3 (in space)", size));
  if (size != 2 && is.connected<&LinkageCore::torque>())
    is.refuse<&LinkageCore::anchors>(
        fmt::format("has {} columns, and a torque turns links in the plane only: leave 'torque' out, or give "
                    "each anchor 2 coordinates",
                    size));
  require_order<&LinkageCore::shortest, &LinkageCore::longest>(*this, is);
}

std::string strayed_link(const LinkageCore& linkage) {
  const auto k = static_cast<Index>(static_cast<double>(linkage.strayed)) - 1;
  const double length = linkage.strayed_length;
  if (!(length > 0.0)) return fmt::format("link {} has no length, its pin lies on its anchor", k + 1);
  const bool below = length < linkage.shortest[k];
  return fmt::format("link {} is {:.6g} m long, and {:.6g} m is its {}", k + 1, length,
                     below ? linkage.shortest[k] : linkage.longest[k], below ? "shortest" : "longest");
}

}  // namespace stepwire
