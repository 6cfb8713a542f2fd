#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/app/session/loaded_model.hpp"

namespace stepwire::cluster {

/// Job that several processes run together on one file.
struct SharedJob {
  enum class Kind : std::uint8_t { points, study, fit, tune };

  Kind kind = Kind::points;
  std::vector<diagram::Setting> settings{};  ///< settings of the load, with fitted values
  run::PointSettings of_points{};
};

/// Returns the job of this kind for a loaded model.
SharedJob job_of(SharedJob::Kind kind, const session::LoadedModel& model);
/// Returns "sweep", "study", "fit" or "tune".
const char* name_of(SharedJob::Kind kind);

std::string bytes_of(const SharedJob& job);
/// Parses the bytes of bytes_of(); std::nullopt if they are malformed.
std::optional<SharedJob> job_of(std::string_view bytes);

}  // namespace stepwire::cluster
