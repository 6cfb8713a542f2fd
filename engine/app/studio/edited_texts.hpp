#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/studio/beneath.hpp"
#include "engine/app/studio/text_merge.hpp"
#include "engine/base/io/cache.hpp"

namespace stepwire::studio {

/// Returns `text` with the line ends of `file`. A line that exists in the file keeps its own end, "\n" or
/// "\r\n"; a new line gets the most frequent end of the file. Lines of `text` end in "\n".
std::string with_line_ends_of(const std::string& file, const std::string& text);

/// Returns the folder for data of the user: $XDG_STATE_HOME/stepwire/studio, else
/// ~/.local/state/stepwire/studio; "" if neither variable is usable.
std::string state_folder();

/// Edited text that is not saved yet.
struct Draft {
  std::string hash;  ///< hash of the file from which the draft started
  std::string text;
};

/// Persistent store of drafts and page layouts between sessions. Its files are private to the user (0600) and
/// written atomically; they are synced to the disk before a call returns.
class DraftStore {
 public:
  explicit DraftStore(const std::string& folder = state_folder());

  std::optional<Draft> find(const std::string& path) const;
  void keep(const std::string& path, const Draft& draft) const;
  void drop(const std::string& path) const;

  /// Returns the layout of the page of a file as JSON; an empty path means all pages of the user. "" if none
  /// was stored.
  std::string layout(const std::string& path) const;
  void keep_layout(const std::string& path, const std::string& layout) const;

 private:
  io::Cache kept_;
};

/// File as the pages see it. All lines of its texts end in "\n".
struct EditedText {
  std::string saved;  ///< content of the file when it was last read
  std::string hash;   ///< hash of the file's bytes from which `text` started
  std::string text;
  int version = 0;                         ///< number of changes of `text`
  std::optional<std::string> base{};       ///< content with this hash; std::nullopt: unknown
  std::string bytes;                       ///< original bytes if some lines end in "\r\n", else empty
  bool is_kept = true;                     ///< true: the stored draft is current
  std::filesystem::file_time_type time{};  ///< write time of the file when read

  bool is_draft() const { return text != saved; }
};

/// Change of a file by another program.
struct WrittenElsewhere {
  EditedText now;                     ///< state of the file
  bool is_merged = false;             ///< true: the edited text contains the change
  std::vector<TextChange> changes{};  ///< changes of the edited text by the merge
  std::string both{};                 ///< otherwise the text with conflicts as comments
};

/// Texts that pages edit, by path. Not thread-safe.
class EditedTexts {
 public:
  EditedTexts(const Beneath& beneath, DraftStore store) : beneath_(beneath), store_(std::move(store)) {}

  /// Returns a text; the first call reads the file and its stored draft. Throws Fault.
  const EditedText& open(const std::string& path);
  /// Applies changes whose places refer to `version`. Throws Fault with the current text and version if that
  /// is another one.
  const EditedText& edit(const std::string& path, int version, std::vector<TextChange> changes);
  const EditedText& discard(const std::string& path);
  /// Writes the file if its hash is still `hash`; otherwise merges the file into the text and returns its
  /// change.
  std::optional<WrittenElsewhere> save(const std::string& path, const std::string& hash);

  /// Throws Fault as edit() does if `version` is not the current one.
  void require_version(const std::string& path, int version);
  /// Returns all open texts.
  const std::map<std::string, EditedText>& all() const { return texts_; }
  /// Returns the text of a file, or nullptr if it is not open.
  const EditedText* find(const std::string& path) const;
  /// Stores the drafts that have changed since the last call.
  void keep_drafts();
  /// Reads the files again that other programs have changed, and calls `changed` for each. A text without a
  /// draft is replaced; a draft is merged with the new content.
  void look_for_changes(const std::function<void(const std::string& path, const WrittenElsewhere&)>& changed);

 private:
  EditedText& known(const std::string& path);
  EditedText read(const std::string& path) const;
  static WrittenElsewhere take(EditedText& text, EditedText now);

  const Beneath& beneath_;
  DraftStore store_;
  std::map<std::string, EditedText> texts_;
};

}  // namespace stepwire::studio
