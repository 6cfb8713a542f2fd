#pragma once

#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire {

/// Faults as data, for editors and other programs: a list of {file, line, column, end, subject, block, port,
/// text, cure, used_by}. Lines and columns count characters from 1, `end` is {line, column} behind what is
/// wrong; `text` is what is wrong and `cure` what would be right. What is not known is null: places of
/// settings of a call, blocks of what stands outside of `blocks`. Reads the files again to find the ends.
Json faults_json(const std::vector<Fault>& faults);

}  // namespace stepwire
