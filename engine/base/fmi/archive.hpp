#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace stepwire::fmi {

/// A zip archive that is read; none of its entries may lead out of the folder that it is unpacked into.
class Archive {
 public:
  /// Throws UnitError for what is no zip archive, for paths that lead out of it, and for one that unpacks to
  /// too many bytes or has too many entries.
  explicit Archive(const std::string& path);
  ~Archive();
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  const std::vector<std::string>& names() const { return names_; }
  bool contains(const std::string& name) const;
  /// All bytes of an entry. Throws UnitError where it is missing or damaged.
  std::string read(const std::string& name) const;
  /// Writes the entries that begin with `start` under a folder. Throws UnitError.
  void unpack(const std::string& start, const std::filesystem::path& folder) const;

 private:
  struct Handle;
  void read_entries();

  std::string path_;
  std::unique_ptr<Handle> handle_;
  std::vector<std::string> names_;
};

}  // namespace stepwire::fmi
