#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/base/result/record.hpp"

namespace stepwire::simulink {

/// Kinds of sentences in the report of an import.
enum class NoteKind {
  placeholder,  ///< a block without counterpart
  missing,      ///< a value that is not in the file
  deviates,     ///< the run differs from that of the model
  differs,      ///< another form or method, or what is not in the file
  renamed,      ///< a name that is no name here
  fault         ///< two meanings in the model, or a fault of the written diagram
};

const char* word_of(NoteKind kind);

/// A sentence in the report of an import.
struct Note {
  NoteKind kind = NoteKind::differs;
  std::string block;     ///< path in the model; empty: the model itself
  std::string sentence;  ///< without its end
};

/// Result of an import.
struct ImportResult {
  std::string model;               ///< the file of Simulink
  std::vector<std::string> files;  ///< that were written, the diagram first
  std::size_t blocks = 0;          ///< of the model
  std::size_t translated = 0;      ///< of these, with a counterpart
  std::vector<Note> notes;

  /// Returns the number of sentences of a kind.
  std::size_t count(NoteKind kind) const;
  /// True where the diagram still needs work: placeholders, missing values, deviations, faults.
  bool is_unfinished() const;
};

void declare(result::Record<ImportResult>& is);

}  // namespace stepwire::simulink
