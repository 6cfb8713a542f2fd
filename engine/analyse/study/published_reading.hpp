#pragma once

#include "engine/analyse/study/published.hpp"
#include "engine/analyse/study/study_keys.hpp"

namespace stepwire::study {

/// The keys of `published` in the section `study`.
const yaml::Key& published_form();

/// Reads them. Conditions that the study does not have are faults.
void read_published(PublishedStudy& published, const std::vector<std::string>& conditions,
                    const yaml::Node& node, const StudyReading& read);

}  // namespace stepwire::study
