#pragma once

#include "engine/app/language/edits.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::language {

/// An edit as a page sends it, by its `kind`:
///   {kind: number, name | at, text}, {kind: rename, name, to}, {kind: connect, from, to, input},
///   {kind: disconnect, to, input}, {kind: delete, name}, {kind: insert, type, name?}
/// Throws EditRefused for anything else.
Edit edit_of(const json::Json& edit);

}  // namespace stepwire::language
