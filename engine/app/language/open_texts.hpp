#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/model/diagram/load.hpp"

namespace stepwire::language {

/// Access to files that are not open in the editor.
struct FileAccess {
  /// Returns the text of a file; throws yaml::Error. Empty: any file of the machine.
  std::function<std::string(const std::string& path)> read{};
  /// Checks the file names in a document; throws yaml::Error for a forbidden one. Empty: all are allowed.
  std::function<void(const yaml::Document& document)> check{};
};

/// Texts of the open files, and a cache of files on the disk, which is valid until they change.
class OpenTexts {
 public:
  explicit OpenTexts(FileAccess access = {}) : access_(std::move(access)) {}

  void open(const std::string& path, std::string text);
  /// Opens a file with a given tree; its text is set later.
  void open_tree(const std::string& path, std::shared_ptr<const yaml::Document> document);
  void close(const std::string& path);
  bool is_open(const std::string& path) const { return open_.contains(path); }
  std::vector<std::string> open_paths() const;

  /// Returns the text; empty for an unreadable file.
  std::shared_ptr<const std::string> text(const std::string& path);
  /// Parses the text. Throws Error for invalid YAML, a missing file, and so on.
  std::shared_ptr<const yaml::Document> document(const std::string& path);
  /// Returns the last valid document since the file was opened; nullptr if there is none.
  std::shared_ptr<const yaml::Document> last_document(const std::string& path);
  /// Returns a reader of these documents for a Loader.
  diagram::DocumentReader reader();
  /// Returns a counter of opened, changed and closed texts.
  std::uint64_t changes() const { return changes_; }

 private:
  struct OnDisk {
    std::int64_t time = 0;  ///< last modification
    std::uintmax_t size = 0;
    bool operator==(const OnDisk&) const = default;
  };
  struct File {
    std::optional<OnDisk> stamp;  ///< std::nullopt for an open text
    std::shared_ptr<const std::string> text{};
    std::shared_ptr<const yaml::Document> document{};  ///< nullptr if not parsed, or invalid
    std::shared_ptr<const yaml::Error> error{};
  };

  static OnDisk stamp_of(const std::string& path);
  File& file(const std::string& path);
  std::string read(const std::string& path) const;
  yaml::Document parsed(const std::string& path, const File& file) const;

  FileAccess access_;

  std::map<std::string, File> open_, on_disk_;
  std::map<std::string, std::shared_ptr<const yaml::Document>> last_;
  std::uint64_t changes_ = 0;
};

}  // namespace stepwire::language
