#pragma once

#include <string>
#include <vector>

#include "engine/app/difference/facts.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::difference {

/// A value with two new values, or a thing that one side removed and the other one uses.
struct Conflict {
  std::string at;                  ///< "spring.gain"
  std::string base, ours, theirs;  ///< as written; "removed" or "absent" where a side has none
};

/// Result of a merge.
struct Merged {
  std::string text;
  std::vector<Conflict> conflicts;  ///< they are also in the section `conflicts` of the text
  std::vector<yaml::Fault> faults;  ///< new faults of the merged model
  bool is_clean() const { return conflicts.empty() && faults.empty(); }
};

/// Merges two versions of a diagram with their common ancestor. The differences from `base` to `theirs` are
/// applied to the text of `ours`, whose comments and layout stay. A renamed block is followed on both sides.
/// `path` is the path of the file, beside which its parts are. Throws yaml::Error if a text cannot be read,
/// or has unresolved conflicts already.
Merged merge(const Registry& registry, const std::string& path, const std::string& base,
             const std::string& ours, const std::string& theirs);

}  // namespace stepwire::difference
