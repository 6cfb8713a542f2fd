#pragma once

#include "engine/analyse/study/published.hpp"
#include "engine/analyse/study/study_keys.hpp"

namespace stepwire::study {

/// Returns the schema of `published` in the section `study`.
const yaml::Key& published_form();

/// Reads these keys. Unknown conditions are faults.
void read_published(PublishedStudy& published, const std::vector<std::string>& conditions,
                    const yaml::Node& node, const StudyReading& read);

}  // namespace stepwire::study
