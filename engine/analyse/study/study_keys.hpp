#pragma once

#include <vector>

#include "engine/analyse/study/study_request.hpp"
#include "engine/base/yaml/section.hpp"

namespace stepwire::study {

/// What a key of the section is read with: it may stand in another file, which the section is like.
struct StudyReading : yaml::SectionReading {
  std::string file;
  const query::SymbolTable& names;
  const diagram::Diagram& diagram;
  bool runs;  ///< trials are runs of the file, not recorded ones

  StudyReading(std::string file, const query::SymbolTable& names, const diagram::Diagram& diagram, bool runs,
               yaml::Faults& faults)
      : yaml::SectionReading("study",
                             [file, &faults](const yaml::Mark& mark, const std::string& subject,
                                             const yaml::Message& message) {
                               faults.add({{file, mark}, subject, message, {}});
                             }),
        file(file),
        names(names),
        diagram(diagram),
        runs(runs) {}
};

using StudyRow = yaml::KeyRow<StudyRequest, StudyReading>;

/// 1 to count.
std::vector<std::size_t> first_numbers(std::size_t count);

/// The key that says who takes part.
StudyRow subjects_row();

/// The keys about how often trials are made, and how those of a person follow each other. They are read
/// behind the conditions, the circle and the parameters that the study sets.
std::vector<StudyRow> sequence_rows();

}  // namespace stepwire::study
