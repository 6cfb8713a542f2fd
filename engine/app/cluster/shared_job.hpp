#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/app/session/loaded_model.hpp"

namespace stepwire::cluster {

/// What several processes do together with one file.
struct SharedJob {
  enum class Kind : std::uint8_t { points, study, fit, tune };

  Kind kind = Kind::points;
  std::vector<diagram::Setting> settings{};  ///< by which the file is loaded, also what a fit has found
  run::PointSettings of_points{};
};

/// The job of a model.
SharedJob job_of(SharedJob::Kind kind, const session::LoadedModel& model);
/// "sweep", "study", "fit" or "tune".
const char* name_of(SharedJob::Kind kind);

std::string bytes_of(const SharedJob& job);
/// Nothing where the bytes are others than bytes_of() makes.
std::optional<SharedJob> job_of(std::string_view bytes);

}  // namespace stepwire::cluster
