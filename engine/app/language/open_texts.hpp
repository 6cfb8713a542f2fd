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

/// How files are reached that an editor names but has not open.
struct FileAccess {
  /// The text of a file; throws yaml::Error. Empty: any file of the machine.
  std::function<std::string(const std::string& path)> read{};
  /// Throws yaml::Error where a document names a file that is not to be read. Empty: it may name any.
  std::function<void(const yaml::Document& document)> check{};
};

/// Texts of files: those that an editor has open, and all others as they are on the disk. What was read once
/// is kept until the file changes.
class OpenTexts {
 public:
  explicit OpenTexts(FileAccess access = {}) : access_(std::move(access)) {}

  void open(const std::string& path, std::string text);
  /// A file of which the tree is known before its text.
  void open_tree(const std::string& path, std::shared_ptr<const yaml::Document> document);
  void close(const std::string& path);
  bool is_open(const std::string& path) const { return open_.contains(path); }
  std::vector<std::string> open_paths() const;

  /// Empty for a file that cannot be read.
  std::shared_ptr<const std::string> text(const std::string& path);
  /// Throws Error for a text that is no YAML, a file that is not there, and so on.
  std::shared_ptr<const yaml::Document> document(const std::string& path);
  /// The last one that could be read since the file was opened; null where there was none.
  std::shared_ptr<const yaml::Document> last_document(const std::string& path);
  /// Hands these documents to a Loader.
  diagram::DocumentReader reader();
  /// Grows with every text that is opened, changed or closed.
  std::uint64_t changes() const { return changes_; }

 private:
  struct OnDisk {
    std::int64_t time = 0;  ///< of the last change
    std::uintmax_t size = 0;
    bool operator==(const OnDisk&) const = default;
  };
  struct File {
    std::optional<OnDisk> stamp;  ///< none for a text that is open
    std::shared_ptr<const std::string> text{};
    std::shared_ptr<const yaml::Document> document{};  ///< null where it has not been read, or could not be
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
