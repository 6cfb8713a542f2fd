#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace stepwire::io {

/// Where results are kept that take long to make and follow from their input alone: $STEPWIRE_CACHE, else
/// $XDG_CACHE_HOME/stepwire, else ~/.cache/stepwire. It need not be there.
std::string cache_folder();

/// A folder of such results, each under the hash of what it follows from. Folder and entries belong to the
/// caller alone (0700, 0600); any other is refused, and nothing is kept. Several processes may use it at a
/// time: an entry appears whole or not at all, and one that has been damaged since is known by its hash. The
/// least recently used ones go when there are too many.
class Cache {
 public:
  explicit Cache(std::string folder = cache_folder(), std::uintmax_t max_bytes = 256u << 20u)
      : folder_(std::move(folder)), max_bytes_(max_bytes) {}

  /// What was kept under a name; nothing where there is none, or none that can be trusted.
  std::optional<std::string> find(const std::string& name) const;
  /// Keeps a result, in the place of what has the name.
  void keep(const std::string& name, const std::string& content) const;
  /// Forgets what has the name.
  void drop(const std::string& name) const;

 private:
  void write(int folder, const std::string& name, const std::string& content) const;
  void drop_old() const;

  std::string folder_;
  std::uintmax_t max_bytes_;
};

/// The first reason for which a cache of this process kept or gave nothing; empty once told.
std::string take_cache_problem();

}  // namespace stepwire::io
