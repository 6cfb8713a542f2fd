#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/app/language/completion.hpp"
#include "engine/app/language/diagnostics.hpp"
#include "engine/app/language/edits.hpp"
#include "engine/app/language/hover.hpp"
#include "engine/app/language/outline_tree.hpp"
#include "engine/app/language/renaming.hpp"

namespace stepwire::language {

/// A place in a file as an editor counts.
struct EditorPlace {
  std::string file;
  EditorRange range;
};

/// A change that an editor offers: what it does, and the text that it puts.
struct Mending {
  std::string title;
  TextDiagnostic diagnostic;
  EditorRange range;
  std::string text;
};

/// Changes of files as editors apply them.
using FileEdits = std::map<std::string, std::vector<std::pair<EditorRange, std::string>>>;

/// A piece of a file; its ends are units of UTF-16 from the start of the text, as browsers count.
struct Utf16Range {
  std::string file;
  std::size_t from = 0, to = 0;
};

/// What an edit of a diagram comes to.
struct EditChanges {
  struct Change {
    Utf16Range range;
    std::string text;  ///< in its place
  };
  std::vector<Change> changes;      ///< all of the same texts
  std::string name;                 ///< of a block that was inserted
  std::vector<yaml::Fault> faults;  ///< that come with it
};

/// What editors ask of diagram files that are open: what is wrong, what may be written, what names mean,
/// where they stand. Files are named by their absolute path. Nothing here knows how an editor is connected.
/// One thread at a time.
class LanguageService {
 public:
  /// The registry must outlive the service.
  explicit LanguageService(const Registry& registry, FileAccess access = {})
      : files_(registry, std::move(access)) {}

  void set_folders(std::vector<std::string> folders) { files_.set_folders(std::move(folders)); }
  void open(const std::string& file, std::string text);
  /// Replaces a piece of a file that is open.
  void edit(const std::string& file, const EditorRange& range, const std::string& text);
  void close(const std::string& file);
  /// Something on the disk is another now.
  void note_saved();

  /// Looks at one file that is another since it was looked at last; false where there is none.
  bool analyse_next();
  /// What is wrong in each file whose text or faults have changed since the last call; nothing as long as a
  /// file has not been looked at.
  std::map<std::string, std::vector<TextDiagnostic>> take_diagnostics();

  std::vector<std::pair<Completion, EditorRange>> completions(const std::string& file,
                                                              const EditorPosition& at);
  std::optional<std::pair<std::string, EditorRange>> hover(const std::string& file, const EditorPosition& at);
  std::optional<EditorPlace> definition(const std::string& file, const EditorPosition& at);
  std::vector<EditorPlace> references(const std::string& file, const EditorPosition& at,
                                      bool with_definition);
  /// The name that may be changed at a place. Throws EditRefused.
  EditorRange renamed(const std::string& file, const EditorPosition& at);
  FileEdits rename(const std::string& file, const EditorPosition& at, const std::string& name);
  std::vector<OutlineItem> outline(const std::string& file);
  /// Words that were probably meant, for what is wrong in a range.
  std::vector<Mending> mendings(const std::string& file, const EditorRange& range);

  /// The changes of texts that an edit of the diagram is; nothing is changed here. Throws EditRefused. The
  /// offset of SetValueAt counts UTF-16, too.
  EditChanges edited(const std::string& file, Edit edit);
  /// The inputs to which a signal may be connected. Throws EditRefused where there is no such signal.
  std::vector<InputName> inputs_for(const std::string& file, const std::string& from);
  /// Where the texts have each block and port of a drawing of the file: see shape_places().
  std::map<std::string, Utf16Range> shapes(const std::string& file);

 private:
  struct Known {
    Analysis analysis{};  ///< the last one with a draft
    std::vector<yaml::Fault> faults{};
    bool draft_is_old = true, faults_are_old = true;
  };

  void note_change(const std::string& file);
  const Analysis& with_draft(const std::string& file);
  void take(Known& known, Analysis now);
  std::vector<TextDiagnostic> diagnostics_of(const std::string& file);
  std::size_t offset(const std::string& file, const EditorPosition& at);
  EditorPlace shown(const FilePlace& place);

  DiagramFiles files_;
  std::map<std::string, Known> known_;  ///< of files that are open
  std::map<std::string, std::vector<TextDiagnostic>> shown_;
  std::set<std::string> changed_;  ///< files whose text is another since
};

}  // namespace stepwire::language
