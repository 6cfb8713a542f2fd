#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/simulate/run/point_exchange.hpp"

namespace stepwire::journal {

/// Returns the result of a point as bytes for another process. Numbers are in their memory format
/// (little-endian, 8 bytes), texts follow their length. Names of recorded columns are omitted, since the job
/// has them.
std::string bytes_of(const run::PointResult& result);

/// Reads these bytes for a job whose sweep keeps these numbers (nullptr: rows). Returns std::nullopt for
/// bytes that bytes_of() has not written for this job.
std::optional<run::PointResult> point_of(std::string_view bytes, const run::Job& job,
                                         const run::RunNumbers* numbers);

}  // namespace stepwire::journal
