#pragma once

#include <optional>
#include <string>

#include "engine/app/difference/facts.hpp"

namespace stepwire::difference {

/// Returns the text of a file with new names; comments and layout stay. Returns std::nullopt where the text
/// would mean something else than the facts with these names.
std::optional<std::string> with_new_names(const Registry& registry, Texts& texts, const std::string& file,
                                          const NewNames& names);

/// Returns the canonical text of facts without marks around names.
std::string meaning_of(const Fact& root);

}  // namespace stepwire::difference
