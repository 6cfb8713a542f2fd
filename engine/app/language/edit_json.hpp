#pragma once

#include "engine/app/language/edits.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::language {

/// Parses an edit from a page, by its `kind`.
/// Values: {kind: number, name | at, text}. Names: {kind: rename, name, to}.
/// Wires: {kind: connect, from, to, input}, {kind: disconnect, to, input}.
/// Blocks: {kind: delete, name}, {kind: insert, type, name?}.
/// Throws EditRefused for anything else.
Edit edit_of(const json::Json& edit);

}  // namespace stepwire::language
