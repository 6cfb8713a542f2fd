#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/analysis.hpp"

namespace stepwire {

/// Numbers that the thesis prints side by side, such as the two columns of table 3.
struct PublishedValues {
  std::string source;  ///< "table 3, participant a"
  std::vector<NamedValue> values;
};

/// What the thesis prints of one task.
struct PublishedTask {
  std::string task;
  PublishedValues means;                        ///< normalised errors, by condition
  PublishedValues probabilities;                ///< P of each factor
  std::vector<PublishedValues> examples;        ///< of single participants
  std::vector<std::vector<std::string>> order;  ///< conditions that the text orders, the largest error first
};

/// Task 1: section 4.3.1 with tables 3 and 4.
const PublishedTask& published_task_1();

/// Task 2: section 4.3.2 with tables 5 and 6. Table 5 prints the error of V_gp in a line named H_gp.
const PublishedTask& published_task_2();

/// The task with this number: "1", and the other one for any other text.
const PublishedTask& published_task(const std::string& task);

}  // namespace stepwire
