#pragma once

#include <memory>
#include <string>
#include <vector>

namespace stepwire::subprocess {
class ScratchFolder;
}

namespace stepwire::difference {

/// All files of a revision of git, in a temporary folder for the lifetime of the object.
class Revision {
 public:
  /// Takes the repository that contains the file. Throws yaml::Error for an unknown revision, for one without
  /// the file, and for a file outside of a repository.
  Revision(const std::string& file, const std::string& revision);
  ~Revision();
  Revision(const Revision&) = delete;
  Revision& operator=(const Revision&) = delete;

  /// Returns the path of the file in the temporary folder.
  const std::string& file() const { return file_; }
  /// Returns a path of the temporary folder as git writes it, "HEAD~1:rig.yaml"; others unchanged.
  std::string shown(const std::string& path) const;

 private:
  std::string revision_, file_;
  std::unique_ptr<subprocess::ScratchFolder> folder_;
};

/// Returns the difference of two texts in lines, as git writes it.
std::string line_difference(const std::string& path, const std::string& before, const std::string& after);

/// True for the text of a diagram file: a map with the key `stepwire`. Text that is no YAML counts if it has
/// a line that begins so.
bool is_diagram(const std::string& path, const std::string& text);

/// Text that is merged by lines, with the marks of git where both sides differ.
struct MergedLines {
  std::string text;
  bool is_clean = true;
};
MergedLines merged_lines(const std::string& base, const std::string& ours, const std::string& theirs);

/// Runs git in a folder. Returns its output without the last line end. Throws yaml::Error with git's message.
std::string git_output(const std::string& folder, const std::vector<std::string>& arguments);

}  // namespace stepwire::difference
