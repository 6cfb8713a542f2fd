#pragma once

#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::session {

/// Converts faults to JSON for editors and other programs: a list of {file, call, line, column, end, subject,
/// block, port, text, cure, suggestions, used_by}.
/// Lines and columns count characters from 1. `end` is {line, column} after the faulty text; `text` is the
/// fault and `cure` the remedy.
/// `suggestions` has replacements {line, column, end, text} for probably misspelt words.
/// A setting of the call has no file but `call`, "--set mass=2 kg". Unknown fields are null, for example
/// `block` outside the section `blocks`.
/// Rereads the files to find the ends.
json::Json faults_json(const std::vector<yaml::Fault>& faults);

}  // namespace stepwire::session
