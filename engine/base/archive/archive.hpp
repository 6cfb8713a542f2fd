#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace stepwire::archive {

/// Thrown for an archive that cannot be read or made; the text is one sentence.
class ArchiveError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns a zip archive of these files, keyed by their paths in it. The same files give the same bytes.
/// Throws ArchiveError.
std::string archive_bytes(const std::map<std::string, std::string>& files);

/// A zip archive opened for reading. No entry may have a path outside of the folder of extraction.
class Archive {
 public:
  /// Throws ArchiveError for another format, for paths that lead out of the archive, and for too many bytes
  /// or entries. `kind` is the noun for the content in messages: "unit".
  Archive(const std::string& path, std::string kind);
  ~Archive();
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  const std::vector<std::string>& names() const { return names_; }
  bool contains(const std::string& name) const;
  /// Returns all bytes of an entry. Throws ArchiveError if it is missing or damaged.
  std::string read(const std::string& name) const;
  /// Extracts the entries that begin with `start` below a folder. Throws ArchiveError.
  void unpack(const std::string& start, const std::filesystem::path& folder) const;

 private:
  struct Handle;
  void read_entries();

  std::string path_, kind_;
  std::unique_ptr<Handle> handle_;
  std::vector<std::string> names_;
};

}  // namespace stepwire::archive
