#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace stepwire::io {

/// A folder for what one run writes. As long as it is there no other run may write into the folder. Which
/// files runs have written stands in its file ".stepwire": what the run before left is removed at the
/// beginning, with pieces of files that were never finished, and nothing else ever is.
class OwnedFolder {
 public:
  using Files = std::set<std::string>;

  /// Files that stay although a run wrote them: their paths as this run knows them.
  using Spared = std::function<Files()>;

  /// Makes the folder, and those above it. Throws EnvironmentError where another run has it, or the system
  /// refuses.
  explicit OwnedFolder(const std::string& path, const Spared& spared = {});
  /// Leaves no list behind of a run that wrote nothing.
  ~OwnedFolder();
  OwnedFolder(const OwnedFolder&) = delete;
  OwnedFolder& operator=(const OwnedFolder&) = delete;

  /// Notes files that the run will write at its end. Throws EnvironmentError, and notes none of them, where a
  /// file that no run wrote is in the place of one.
  void reserve(const std::vector<std::string>& names);

 private:
  friend void note_written(const std::string& path);
  void lock();
  Files listed() const;
  void clear(const Files& listed, const Spared& spared);
  void note(const std::string& name);
  void refuse_foreign(const std::string& name, const std::string& shown) const;

  std::string path_;   ///< from the root
  std::string shown_;  ///< as the call names it
  int list_ = -1;      ///< the file ".stepwire", locked
  Files names_;        ///< in it
};

/// Notes a file that is about to be written, where it lies in a folder that a run owns. Throws
/// EnvironmentError where a file that no run wrote is in its place there, or a link leads out of the folder.
void note_written(const std::string& path);

}  // namespace stepwire::io
