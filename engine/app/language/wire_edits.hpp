#pragma once

#include <optional>
#include <string>

#include "engine/app/language/edits.hpp"
#include "engine/app/language/tree_edits.hpp"

namespace stepwire::language {

/// "u", or of a list "u.2".
struct InputPlace {
  std::string key;
  std::optional<std::size_t> item{};  ///< from 0
};

InputPlace input_place(const std::string& input);

/// How a file writes a signal: "lag" for "lag.y", where a block has one output; "x" for ".x", an input of the
/// file. Throws EditRefused where the file has no such block or input.
std::string source_text(DiagramFiles& files, const std::string& file, const yaml::Document& document,
                        const std::string& from);

/// Puts the signal where the input has one, or adds it. Both throw EditRefused.
void connect(TreeEdits& edits, DiagramFiles& files, const std::string& file, const yaml::Document& document,
             const Connect& edit);
void disconnect(TreeEdits& edits, const yaml::Document& document, const Disconnect& edit);

}  // namespace stepwire::language
