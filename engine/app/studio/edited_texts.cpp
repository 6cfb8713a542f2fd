#include "engine/app/studio/edited_texts.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <limits>
#include <utility>

#include "engine/app/studio/fault.hpp"
#include "engine/app/studio/line_ends.hpp"
#include "engine/app/studio/text_merge.hpp"
#include "engine/base/hash/hash.hpp"
#include "engine/base/json/json.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::studio {

using json::Json;

namespace {

/// Returns the absolute path in a variable, or "". The XDG Base Directory Specification ignores relative
/// paths.
std::string folder_of_variable(const char* name) {
  const char* value = std::getenv(name);
  return value && *value == '/' ? value : "";
}

std::string draft_name(const std::string& path) {
  return hash::hash_of(path) + ".draft";
}

std::string layout_name(const std::string& path) {
  return hash::hash_of(path) + ".layout";
}

constexpr std::size_t most_bytes = 8u << 20u;  // the limit for reading diagrams, too

std::filesystem::file_time_type time_of(const std::string& path) {
  std::error_code none;
  return std::filesystem::last_write_time(path, none);
}

}  // namespace

std::string state_folder() {
  if (const std::string state = folder_of_variable("XDG_STATE_HOME"); !state.empty())
    return state + "/stepwire/studio";
  const std::string home = folder_of_variable("HOME");
  return home.empty() ? "" : home + "/.local/state/stepwire/studio";
}

DraftStore::DraftStore(const std::string& folder)
    : kept_(folder, std::numeric_limits<std::uintmax_t>::max()) {}

std::optional<Draft> DraftStore::find(const std::string& path) const {
  const auto kept = kept_.find(draft_name(path));
  if (!kept) return std::nullopt;
  const Json draft = Json::parse(*kept);
  const Json *hash = draft.find("hash"), *text = draft.find("text");
  if (!hash || !hash->as_text() || !text || !text->as_text()) return std::nullopt;
  return Draft{*hash->as_text(), *text->as_text()};
}

void DraftStore::keep(const std::string& path, const Draft& draft) const {
  const Json kept = Json::object().set("file", path).set("hash", draft.hash).set("text", draft.text);
  kept_.keep(draft_name(path), kept.text(-1));
}

void DraftStore::drop(const std::string& path) const {
  kept_.drop(draft_name(path));
}

std::string DraftStore::layout(const std::string& path) const {
  return kept_.find(layout_name(path)).value_or("");
}

void DraftStore::keep_layout(const std::string& path, const std::string& layout) const {
  kept_.keep(layout_name(path), layout);
}

EditedText EditedTexts::read(const std::string& path) const {
  EditedText read;
  read.time = time_of(path);
  read.saved = beneath_.read(path).text;
  if (!is_utf8(read.saved)) throw Fault(fmt::format("{}: is no text in UTF-8", text::visible(path)));
  read.hash = hash::hash_of(read.saved);
  if (read.saved.find("\r\n") != std::string::npos) read.bytes = read.saved;
  text::replace_all(read.saved, "\r\n", "\n");
  read.text = read.saved;
  read.base = read.saved;
  return read;
}

const EditedText& EditedTexts::open(const std::string& path) {
  if (const auto found = texts_.find(path); found != texts_.end()) return found->second;
  EditedText opened = read(path);
  const auto draft = store_.find(path);
  if (draft && draft->text != opened.saved) {
    opened.text = draft->text;
    if (draft->hash != opened.hash) opened.base.reset();
    opened.hash = draft->hash;
  }
  return texts_[path] = std::move(opened);
}

EditedText& EditedTexts::known(const std::string& path) {
  open(path);
  return texts_.at(path);
}

const EditedText* EditedTexts::find(const std::string& path) const {
  const auto found = texts_.find(path);
  return found == texts_.end() ? nullptr : &found->second;
}

void EditedTexts::require_version(const std::string& path, int version) {
  const EditedText& text = known(path);
  if (version == text.version) return;
  const Json current = Json::object().set("text", text.text).set("version", text.version);
  throw Fault("the text was changed elsewhere meanwhile", Json::object().set("current", current));
}

const EditedText& EditedTexts::edit(const std::string& path, int version, std::vector<TextChange> changes) {
  require_version(path, version);
  EditedText& text = known(path);
  std::string next = changed(text.text, std::move(changes));
  if (next.size() > most_bytes) throw Fault("a diagram has 8 MB at most");
  text.text = std::move(next);
  ++text.version;
  text.is_kept = false;
  return text;
}

const EditedText& EditedTexts::discard(const std::string& path) {
  EditedText& text = known(path);
  const int version = text.version + 1;
  text = read(path);
  text.version = version;
  store_.drop(path);
  return text;
}

/// Merges the present content of a file into its edited text if they changed different lines; else only
/// reports both.
WrittenElsewhere EditedTexts::take(EditedText& text, EditedText now) {
  WrittenElsewhere written;
  const TextMerge merged = text.base ? merge(*text.base, text.text, now.saved) : merge(text.text, now.saved);
  const std::string both = changed(text.text, merged.changes);
  text.saved = now.saved;
  text.time = now.time;
  if (merged.is_clean) {
    if (!merged.changes.empty()) ++text.version;
    text.text = both;
    text.hash = now.hash;
    text.base = now.saved;
    text.bytes = now.bytes;
    text.is_kept = false;
    written.changes = merged.changes;
  } else {
    written.both = both;
  }
  written.is_merged = merged.is_clean;
  now.version = text.version;
  written.now = std::move(now);
  return written;
}

std::optional<WrittenElsewhere> EditedTexts::save(const std::string& path, const std::string& hash) {
  EditedText& text = known(path);
  EditedText now = read(path);
  if (now.hash != hash) return take(text, std::move(now));
  const std::string bytes = now.bytes.empty() ? text.text : with_line_ends_of(now.bytes, text.text);
  beneath_.replace(path, bytes);
  text.saved = text.text;
  text.base = text.text;
  text.hash = hash::hash_of(bytes);
  text.time = time_of(path);
  text.is_kept = true;
  store_.drop(path);
  return std::nullopt;
}

void EditedTexts::keep_drafts() {
  for (auto& [path, text] : texts_) {
    if (std::exchange(text.is_kept, true)) continue;
    if (text.is_draft())
      store_.keep(path, {text.hash, text.text});
    else
      store_.drop(path);
  }
}

void EditedTexts::look_for_changes(
    const std::function<void(const std::string& path, const WrittenElsewhere&)>& changed) {
  for (auto& [path, text] : texts_) {
    const auto time = time_of(path);
    if (time == text.time) continue;
    try {
      EditedText now = read(path);
      const bool is_other = now.saved != text.saved;
      text.time = now.time;
      if (!is_other) continue;
      if (text.is_draft()) {
        changed(path, take(text, std::move(now)));
        continue;
      }
      now.version = text.version + 1;
      text = now;
      changed(path, {now});
    } catch (const Fault&) {
      text.time = time;  // the file is gone or no text; save() reports that
    }
  }
}

}  // namespace stepwire::studio
