#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace stepwire::io {

/// Exclusive output folder of one run. No other run may write into the folder during its lifetime. The file
/// ".stepwire" in it lists the files that runs have written. The constructor removes those of the previous
/// run, and unfinished temporary files; no other file is ever removed.
class OwnedFolder {
 public:
  using Files = std::set<std::string>;

  /// Returns the files to keep although an earlier run wrote them, by the paths of this run.
  using Spared = std::function<Files()>;

  /// Creates the folder and its parents. Throws EnvironmentError if another run owns it or the system
  /// refuses.
  explicit OwnedFolder(const std::string& path, const Spared& spared = {});
  /// Removes the list of a run that wrote no file.
  ~OwnedFolder();
  OwnedFolder(const OwnedFolder&) = delete;
  OwnedFolder& operator=(const OwnedFolder&) = delete;

  /// Reserves names for files written at the end of the run. Throws EnvironmentError, and reserves none, if a
  /// foreign file has one of the names.
  void reserve(const std::vector<std::string>& names);

 private:
  friend void note_written(const std::string& path);
  void lock();
  Files listed() const;
  void clear(const Files& listed, const Spared& spared);
  void note(const std::string& name);
  void refuse_foreign(const std::string& name, const std::string& shown) const;

  std::string path_;   ///< absolute
  std::string shown_;  ///< as given by the user
  int list_ = -1;      ///< descriptor of the locked file ".stepwire"
  Files names_;        ///< listed in it
};

/// Registers a file about to be written if it is in an owned folder. Throws EnvironmentError for a foreign
/// file of that name, and for a link that leads out of the folder.
void note_written(const std::string& path);

}  // namespace stepwire::io
