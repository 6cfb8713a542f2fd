#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/simulate/run/point_exchange.hpp"

namespace stepwire::journal {

/// What a point gave, as bytes that another process reads: numbers as they lie in memory (little-endian,
/// 8 bytes), texts behind their length. Names of recorded columns are left out, which the job has.
std::string bytes_of(const run::PointResult& result);

/// The same back, for a job whose sweep keeps these numbers (null: rows); nothing where the bytes are others
/// than bytes_of() has made for it.
std::optional<run::PointResult> point_of(std::string_view bytes, const run::Job& job,
                                         const run::RunNumbers* numbers);

}  // namespace stepwire::journal
