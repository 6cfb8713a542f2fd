#pragma once

#include <optional>
#include <string>

#include "engine/app/language/edits.hpp"
#include "engine/app/language/tree_edits.hpp"

namespace stepwire::language {

/// Input of a block: "u", or an item of a list input "u.2".
struct InputPlace {
  std::string key;
  std::optional<std::size_t> item{};  ///< from 0
};

InputPlace input_place(const std::string& input);

/// Returns the text of a signal in a file: "lag" for "lag.y" if the block has a single output, "x" for ".x",
/// an input of the file. Throws EditRefused for an unknown block or input.
std::string source_text(DiagramFiles& files, const std::string& file, const yaml::Document& document,
                        const std::string& from);

/// Sets the source of an input, or adds it. Both functions throw EditRefused.
void connect(TreeEdits& edits, DiagramFiles& files, const std::string& file, const yaml::Document& document,
             const Connect& edit);
void disconnect(TreeEdits& edits, const yaml::Document& document, const Disconnect& edit);

}  // namespace stepwire::language
