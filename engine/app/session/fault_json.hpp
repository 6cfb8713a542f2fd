#pragma once

#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::session {

/// Faults as data, for editors and other programs: a list of {file, call, line, column, end, subject, block,
/// port, text, cure, suggestions, used_by}. Lines and columns count characters from 1, `end` is {line,
/// column} behind what is wrong; `text` is what is wrong and `cure` what would be right. `suggestions` has
/// the word that was probably meant, {line, column, end, text}: `text` belongs between these places. A
/// setting of the call has no file but `call`, "--set mass=2 kg". What is not known is null, as blocks of
/// what stands outside of `blocks`. Reads the files again to find the ends.
json::Json faults_json(const std::vector<yaml::Fault>& faults);

}  // namespace stepwire::session
