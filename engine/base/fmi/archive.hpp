#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace stepwire::fmi {

/// A zip archive opened for reading. No entry may have a path outside of the folder of extraction.
class Archive {
 public:
  /// Throws UnitError for another format, for paths that lead out of the archive, and for too many bytes or
  /// entries.
  explicit Archive(const std::string& path);
  ~Archive();
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  const std::vector<std::string>& names() const { return names_; }
  bool contains(const std::string& name) const;
  /// Returns all bytes of an entry. Throws UnitError if it is missing or damaged.
  std::string read(const std::string& name) const;
  /// Extracts the entries that begin with `start` below a folder. Throws UnitError.
  void unpack(const std::string& start, const std::filesystem::path& folder) const;

 private:
  struct Handle;
  void read_entries();

  std::string path_;
  std::unique_ptr<Handle> handle_;
  std::vector<std::string> names_;
};

}  // namespace stepwire::fmi
