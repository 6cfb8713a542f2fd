#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/analysis.hpp"

namespace stepwire::study {

/// Numbers that a source prints side by side, such as the two columns of table 3 of the thesis.
struct PublishedValues {
  std::string source;  ///< "table 3, participant a"
  std::vector<NamedValue> values;
};

/// What a source prints of a study, which a file gives beside the study's own; all of it may be empty.
struct PublishedStudy {
  PublishedValues means;                        ///< normalised errors, by condition
  PublishedValues probabilities;                ///< P of each factor
  std::vector<PublishedValues> examples;        ///< of single participants
  std::vector<std::vector<std::string>> order;  ///< conditions that the text orders, the largest error first
};

}  // namespace stepwire::study
