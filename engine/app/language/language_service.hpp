#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/app/language/analysis.hpp"
#include "engine/app/language/completion.hpp"
#include "engine/app/language/edits.hpp"
#include "engine/app/language/renaming.hpp"
#include "engine/app/language/text_places.hpp"

namespace stepwire::language {

/// Fault in a file, as editors show it.
struct TextDiagnostic {
  struct Related {
    std::string file;
    EditorRange range;
    std::string message;
  };
  EditorRange range;
  std::string message;
  std::vector<Related> related;   ///< Uses of the faulty part, or the fault within the part.
  std::optional<Splice> mending;  ///< Replacement by the word that was probably meant.
  std::string meant{};            ///< That word.
  std::string text{};             ///< Message without names of blocks, which differ for each use of a part.

  bool operator==(const TextDiagnostic& other) const {
    return range.start == other.range.start && range.end == other.range.end && message == other.message;
  }
};

/// Item in the outline of a file: a section, or a block, parameter, port or claim within one.
struct OutlineItem {
  enum class Kind { section, block, part, parameter, port, claim };
  std::string name;
  std::string detail;
  Kind kind;
  EditorRange range;  ///< range of the whole item
  EditorRange name_range;
  std::vector<OutlineItem> children;
};

/// Explanation of a place: Markdown, and the range that it explains.
struct Hover {
  std::string markdown;
  TextRange range;
};

/// Range in a file, in editor coordinates.
struct EditorPlace {
  std::string file;
  EditorRange range;
};

/// Quick fix: a title, and the replacement of a range.
struct Mending {
  std::string title;
  TextDiagnostic diagnostic;
  EditorRange range;
  std::string text;
};

/// Text changes by file, as editors apply them.
using FileEdits = std::map<std::string, std::vector<std::pair<EditorRange, std::string>>>;

/// Range in a file in UTF-16 units from the start of the text, as browsers count.
struct Utf16Range {
  std::string file;
  std::size_t from = 0, to = 0;
};

/// Result of an edit of a diagram.
struct EditChanges {
  struct Change {
    Utf16Range range;
    std::string text;  ///< replacement of the range
  };
  std::vector<Change> changes;      ///< all relative to the unchanged texts
  std::string name;                 ///< name of an inserted block
  std::vector<yaml::Fault> faults;  ///< new faults
};

/// Editor features for open diagram files: diagnostics, completion, meaning and places of names. Files are
/// identified by absolute path. The transport is not part of it. Not thread-safe.
class LanguageService {
 public:
  /// The registry must outlive the service.
  explicit LanguageService(const Registry& registry, FileAccess access = {})
      : files_(registry, std::move(access)) {}

  void set_folders(std::vector<std::string> folders) { files_.set_folders(std::move(folders)); }
  void open(const std::string& file, std::string text);
  /// Replaces a range of an open file.
  void edit(const std::string& file, const EditorRange& range, const std::string& text);
  void close(const std::string& file);
  /// Invalidates the analyses after a file on the disk has changed.
  void note_saved();

  /// Analyses one file that has changed since its last analysis; false if there is none.
  bool analyse_next();
  /// Returns the diagnostics of each file whose text or faults have changed since the last call. The map is
  /// empty until all analyses are finished.
  std::map<std::string, std::vector<TextDiagnostic>> take_diagnostics();

  std::vector<std::pair<Completion, EditorRange>> completions(const std::string& file,
                                                              const EditorPosition& at);
  std::optional<std::pair<std::string, EditorRange>> hover(const std::string& file, const EditorPosition& at);
  std::optional<EditorPlace> definition(const std::string& file, const EditorPosition& at);
  std::vector<EditorPlace> references(const std::string& file, const EditorPosition& at,
                                      bool with_definition);
  /// Returns the range of the name at a position that can be renamed. Throws EditRefused.
  EditorRange renamed(const std::string& file, const EditorPosition& at);
  FileEdits rename(const std::string& file, const EditorPosition& at, const std::string& name);
  std::vector<OutlineItem> outline(const std::string& file);
  /// Returns the quick fixes for faults in a range.
  std::vector<Mending> mendings(const std::string& file, const EditorRange& range);

  /// Computes the text changes of a diagram edit without applying them. The offset of SetValueAt counts
  /// UTF-16 units. Throws EditRefused.
  EditChanges edited(const std::string& file, Edit edit);
  /// Returns the inputs to which a signal may be connected. Throws EditRefused for an unknown signal.
  std::vector<InputName> inputs_for(const std::string& file, const std::string& from);
  /// Returns the text range of each block and port of the file's drawing: see shape_places().
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
  std::map<std::string, Known> known_;  ///< open files
  std::map<std::string, std::vector<TextDiagnostic>> shown_;
  std::set<std::string> changed_;  ///< files whose text has changed since the last diagnostics
};

}  // namespace stepwire::language
