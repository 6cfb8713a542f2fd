#include "engine/app/cluster/served_points.hpp"

#include "engine/simulate/journal/point_bytes.hpp"

namespace stepwire::cluster {

std::optional<std::size_t> ServedPoints::next() {
  const auto item = client_.next();
  return item ? std::optional(item->number) : std::nullopt;
}

void ServedPoints::take(run::PointResult result) {
  if (result.end.interrupted) return;
  client_.put(result.point, journal::Journal::record_of(journal::bytes_of(result)));
}

}  // namespace stepwire::cluster
