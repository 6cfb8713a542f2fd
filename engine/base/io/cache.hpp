#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace stepwire::io {

/// Returns the folder of cached results: $STEPWIRE_CACHE, else $XDG_CACHE_HOME/stepwire, else
/// ~/.cache/stepwire. It may be missing.
std::string cache_folder();

/// Cache on disk of expensive results, each named by the hash of its inputs. Folder and entries must be
/// accessible to the caller alone (0700, 0600); otherwise nothing is cached. Several processes may use it at
/// once: entries appear complete or not at all. A hash detects damaged entries. The least recently used ones
/// are evicted above `max_bytes`.
class Cache {
 public:
  explicit Cache(std::string folder = cache_folder(), std::uintmax_t max_bytes = 256u << 20u)
      : folder_(std::move(folder)), max_bytes_(max_bytes) {}

  /// Returns the content of an entry; std::nullopt if it is missing or not trustworthy.
  std::optional<std::string> find(const std::string& name) const;
  /// Stores a result, and replaces an earlier one of the same name.
  void keep(const std::string& name, const std::string& content) const;
  /// Removes an entry.
  void drop(const std::string& name) const;

 private:
  void write(int folder, const std::string& name, const std::string& content) const;
  void drop_old() const;

  std::string folder_;
  std::uintmax_t max_bytes_;
};

/// Returns and clears the first reason why a cache of this process did not work; empty without one.
std::string take_cache_problem();

}  // namespace stepwire::io
