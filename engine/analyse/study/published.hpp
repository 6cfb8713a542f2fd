#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/analysis.hpp"

namespace stepwire::study {

/// Numbers that a source prints together, such as the two columns of table 3 of the thesis.
struct PublishedValues {
  std::string source;  ///< "table 3, participant a"
  std::vector<NamedValue> values;
};

/// Published numbers of a study, for comparison with its own; all may be empty.
struct PublishedStudy {
  PublishedValues means;                        ///< Normalised errors by condition.
  PublishedValues probabilities;                ///< P of each factor.
  std::vector<PublishedValues> examples;        ///< Numbers of single participants.
  std::vector<std::vector<std::string>> order;  ///< Orders of conditions in the text, largest error first.
};

}  // namespace stepwire::study
