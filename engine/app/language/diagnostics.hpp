#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/app/language/analysis.hpp"
#include "engine/app/language/splice.hpp"

namespace stepwire::language {

/// Something wrong in a file, as an editor shows it.
struct TextDiagnostic {
  struct Related {
    std::string file;
    EditorRange range;
    std::string message;
  };
  EditorRange range;
  std::string message;
  std::vector<Related> related;   ///< who uses the part in which it is; where it is in a part
  std::optional<Splice> mending;  ///< that puts the word that was probably meant
  std::string meant{};            ///< that word
  std::string text{};  ///< the message without the names of blocks, which each user of a part has its own of

  bool operator==(const TextDiagnostic& other) const {
    return range.start == other.range.start && range.end == other.range.end && message == other.message;
  }
};

/// What of a fault is in a file: the fault itself, or that a part has one which the file uses. Nothing where
/// it is about other files.
std::optional<TextDiagnostic> diagnostic_of(const yaml::Fault& fault, const std::string& file,
                                            OpenTexts& texts);

/// Adds one to those of a file; what is found in a part alone and again for each of its users is one.
void add_diagnostic(TextDiagnostic diagnostic, std::vector<TextDiagnostic>& all);

}  // namespace stepwire::language
