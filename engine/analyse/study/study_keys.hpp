#pragma once

#include <vector>

#include "engine/analyse/study/study_request.hpp"
#include "engine/base/yaml/section.hpp"

namespace stepwire::study {

/// Context for reading a key of the section, which may be in the file that the key `like` names.
struct StudyReading : yaml::SectionReading {
  std::string file;
  const query::SymbolTable& names;
  const diagram::Diagram& diagram;
  bool runs;  ///< True: trials are runs of the file, not recorded ones.

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

/// Returns 1 to count.
std::vector<std::size_t> first_numbers(std::size_t count);

/// Returns the row of the key `subjects`.
StudyRow subjects_row();

/// Returns the rows on repetitions and on the sequence of a person's trials. They are read after the
/// conditions, the circle and the parameters that the study sets.
std::vector<StudyRow> sequence_rows();

}  // namespace stepwire::study
