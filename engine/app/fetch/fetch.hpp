#pragma once

#include <string>
#include <vector>

#include "engine/model/diagram/uses.hpp"

namespace stepwire::fetch {

/// Entry of `uses` whose files are in the cache.
struct FetchedUse {
  diagram::Use use;
  std::string file{};                   ///< the file with the entry
  bool was_there = false;               ///< the cache had the right files already
  std::size_t files = 0;                ///< number of its files
  std::vector<std::string> left_out{};  ///< sentences on what is not fetched
};

/// Result of a call of `fetch`.
struct Fetched {
  std::vector<FetchedUse> uses;
  std::vector<yaml::Fault> faults;
};

/// Fetches the repositories that diagrams use, their parts, and the parts of these in turn. Each is written
/// under a temporary name in the cache and renamed once its hash is known. A missing or wrong sha256 is a
/// fault with the right one; the files are kept under the right one. A tag or branch in the place of a commit
/// is a fault with its commit. Throws yaml::Error for a file that is not YAML, EnvironmentError if the cache
/// cannot be written.
Fetched fetch_parts(const std::vector<std::string>& files);

}  // namespace stepwire::fetch
