#pragma once

#include <cstddef>
#include <string>

#include "engine/analyse/study/repetition.hpp"
#include "engine/app/session/studies.hpp"

namespace stepwire {

/// Performs experiments with `count` seeds from the file's one on, as far as the folder does not have them
/// yet in experiments.csv; writes their distribution to experiments.txt and .svg once all are there. What is
/// done is kept when it is interrupted. Throws Error, EnvironmentError.
Repetition repeat_study(const Registry& registry, const LoadedModel& model, const StudyCall& call,
                        std::size_t count, const std::string& folder, const Monitor& monitor);

}  // namespace stepwire
