#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/studio/beneath.hpp"
#include "engine/app/studio/draft_store.hpp"
#include "engine/app/studio/text_changes.hpp"

namespace stepwire::studio {

/// A file as the pages see it. Ends of lines are "\n" in texts.
struct EditedText {
  std::string saved;                       ///< the text on the disk when it was read last
  std::string hash;                        ///< of the bytes on the disk with which `text` began
  std::string text;                        ///< with what was edited
  int version = 0;                         ///< counts the changes of `text`
  std::optional<std::string> base{};       ///< the text of the hash; nothing where it is not known
  std::string bytes;                       ///< on the disk, where not all lines end in "\n"; else empty
  bool is_kept = true;                     ///< is the draft on the disk as it is here?
  std::filesystem::file_time_type time{};  ///< of the file, when it was read last

  bool is_draft() const { return text != saved; }
};

/// A text that another program has written to the file.
struct WrittenElsewhere {
  EditedText now;                     ///< of the file, in the version of the edited text
  bool is_merged = false;             ///< true where the edited text has its lines
  std::vector<TextChange> changes{};  ///< of the edited text then
  std::string both{};                 ///< all lines of both texts otherwise
};

/// The texts that pages edit, by the paths of their files. One thread at a time.
class EditedTexts {
 public:
  EditedTexts(const Beneath& beneath, DraftStore store) : beneath_(beneath), store_(std::move(store)) {}

  /// Reads a file, and the draft that was left of it. Throws Fault.
  const EditedText& open(const std::string& path);
  /// Changes the version of which the places are. Throws Fault with the text and version there are where that
  /// is another one.
  const EditedText& edit(const std::string& path, int version, std::vector<TextChange> changes);
  const EditedText& discard(const std::string& path);
  /// Writes the file where its hash is still this one. Else it merges or returns what the file holds now.
  std::optional<WrittenElsewhere> save(const std::string& path, const std::string& hash);

  /// Throws Fault as edit() does.
  void require_version(const std::string& path, int version);
  /// All that were opened.
  const std::map<std::string, EditedText>& all() const { return texts_; }
  /// The text of a file as it is edited; nothing where it is not.
  const EditedText* find(const std::string& path) const;
  /// Puts drafts on the disk that are not there.
  void keep_drafts();
  /// Reads again what others have changed on the disk, and calls back for each. A text without draft follows;
  /// a draft takes the lines that it has not changed itself.
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
