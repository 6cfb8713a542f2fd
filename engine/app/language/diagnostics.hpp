#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/app/language/analysis.hpp"
#include "engine/app/language/splice.hpp"

namespace stepwire::language {

/// Fault in a file, as editors show it.
struct TextDiagnostic {
  struct Related {
    std::string file;
    EditorRange range;
    std::string message;
  };
  EditorRange range;
  std::string message;
  std::vector<Related> related;   ///< Uses of the faulty part, or the fault within the part.
  std::optional<Splice> mending;  ///< Replacement by the word that was probably meant.
  std::string meant{};            ///< That word.
  std::string text{};             ///< Message without names of blocks, which differ for each use of a part.

  bool operator==(const TextDiagnostic& other) const {
    return range.start == other.range.start && range.end == other.range.end && message == other.message;
  }
};

/// Converts a fault to a diagnostic of the file: the fault itself, or the fault of a part at the place that
/// uses it. Returns std::nullopt for faults of other files.
std::optional<TextDiagnostic> diagnostic_of(const yaml::Fault& fault, const std::string& file,
                                            OpenTexts& texts);

/// Adds a diagnostic. A fault that was found both in a part alone and in its users is merged into one.
void add_diagnostic(TextDiagnostic diagnostic, std::vector<TextDiagnostic>& all);

}  // namespace stepwire::language
