#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"

namespace stepwire::mcp {

/// Faulty call of a tool, with its cure.
class CallFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Folder of a call, below which all its files are. Texts of the call are files in it during the call.
class ToolFolder {
 public:
  /// Takes the folder of a call, or makes a temporary one if `named` is nullptr. Throws CallFault for a path
  /// that is no folder or not below `root`.
  ToolFolder(const json::Json* named, const std::string& root);
  /// Removes the files of texts.
  ~ToolFolder();
  ToolFolder(const ToolFolder&) = delete;
  ToolFolder& operator=(const ToolFolder&) = delete;

  const std::string& path() const { return path_; }
  /// Folder for intermediate files, outside of path().
  const std::string& scratch() const { return scratch_.path(); }
  /// Checks a path of the call and returns it. Throws CallFault for an absolute path, one that leads out of
  /// the folder, also by links, and for "-".
  std::string checked(const std::string& path) const;
  /// Writes a text as a file and returns its name. Throws CallFault if the folder is not writable.
  std::string add_text(const std::string& text);
  /// Replaces the names of texts in an output by "text.yaml", or "text-1.yaml" and "text-2.yaml".
  std::string shown(std::string output) const;
  /// Returns the value of $STEPWIRE_INSIDE for the verb: the folder, and those of the program itself.
  std::string readable() const;

 private:
  subprocess::ScratchFolder scratch_;
  std::string path_;
  std::vector<std::string> texts_;  ///< names of files
};

}  // namespace stepwire::mcp
