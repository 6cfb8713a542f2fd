#pragma once

#include "engine/analyse/study/study_request.hpp"
#include "engine/base/yaml/section.hpp"

namespace stepwire {

/// What a key of the section is read with: it may stand in another file, which the section is like.
struct StudyReading : SectionReading {
  std::string file;
  const SymbolTable& names;
  const Diagram& diagram;
  bool runs;  ///< trials are runs of the file, not recorded ones

  StudyReading(std::string file, const SymbolTable& names, const Diagram& diagram, bool runs, Faults& faults)
      : SectionReading(
            "study",
            [file, &faults](const Mark& mark, const std::string& subject, const std::string& message) {
              faults.add({{file, mark}, subject, message, {}});
            }),
        file(file),
        names(names),
        diagram(diagram),
        runs(runs) {}
};

}  // namespace stepwire
