#include "engine/simulate/journal/journal.hpp"

#include <fmt/format.h>

#include "engine/base/io/environment_error.hpp"
#include "engine/simulate/journal/point_bytes.hpp"

namespace stepwire::journal {

void Journal::add(const run::PointResult& result) {
  add_bytes(result.point, bytes_of(result));
}

std::optional<run::PointResult> Journal::point(std::size_t point) {
  const auto bytes = this->bytes(point);
  if (!bytes) return std::nullopt;
  auto result = point_of(*bytes, job_, numbers_);
  if (!result || result->point != point)
    throw io::EnvironmentError(fmt::format(
        "{}: the record of point {} is not one of this diagram; remove the file, and run its points again",
        path(), point + 1));
  return result;
}

}  // namespace stepwire::journal
