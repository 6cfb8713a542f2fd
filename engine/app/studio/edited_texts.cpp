#include "engine/app/studio/edited_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <utility>

#include "engine/app/studio/fault.hpp"
#include "engine/base/hash/hash.hpp"
#include "engine/base/json/json.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::studio {

using json::Json;

namespace {

constexpr std::ptrdiff_t most_edits = 1000;  // limit of removed and added lines; beyond it all lines between
                                             // head and tail are new

struct Line {
  std::string_view text;
  std::string_view end;  ///< empty for a last line without end
};

std::vector<Line> lines_with_ends(std::string_view text) {
  std::vector<Line> lines;
  while (!text.empty()) {
    const std::size_t at = text.find('\n');
    if (at == std::string_view::npos) {
      lines.push_back({text, {}});
      break;
    }
    const std::size_t end = at > 0 && text[at - 1] == '\r' ? at - 1 : at;
    lines.push_back({text.substr(0, end), text.substr(end, at + 1 - end)});
    text.remove_prefix(at + 1);
  }
  return lines;
}

std::string_view usual_end(const std::vector<Line>& lines) {
  const auto long_ends = std::ranges::count(lines, "\r\n", &Line::end);
  return long_ends > std::ranges::count(lines, "\n", &Line::end) ? "\r\n" : "\n";
}

/// Alignment of the lines of `now` with those of `before`, with the fewest removed and added lines. Source:
/// E. W. Myers, "An O(ND) Difference Algorithm and Its Variations", Algorithmica 1, 1986. The common head and
/// tail are cut off first. Then forward() extends paths on the diagonals k = x - y, with one more edit in
/// each round, until one reaches the end. Afterwards back() retraces that path through the stored frontiers.
/// Cost with N lines and D edits: O(ND) time, O(D^2) memory. D is at most most_edits.
class Pairs {
 public:
  Pairs(const std::vector<Line>& before, const std::vector<Line>& now) : before_(before), now_(now) {
    of_now.resize(now.size());
    const std::ptrdiff_t head = common_head(), tail = common_tail(head);
    for (std::ptrdiff_t i = 0; i < head; ++i) of_now[index(i)] = i;
    for (std::ptrdiff_t i = 1; i <= tail; ++i) of_now[now.size() - index(i)] = std::ssize(before) - i;
    first_ = head;
    n_ = std::ssize(before) - head - tail;
    m_ = std::ssize(now) - head - tail;
    if (forward()) back();
  }

  std::vector<std::optional<std::ptrdiff_t>> of_now;

 private:
  static std::size_t index(std::ptrdiff_t i) { return static_cast<std::size_t>(i); }
  bool same(std::ptrdiff_t b, std::ptrdiff_t n) const {
    return before_[index(b)].text == now_[index(n)].text;
  }

  std::ptrdiff_t common_head() const {
    const std::ptrdiff_t most = std::min(std::ssize(before_), std::ssize(now_));
    std::ptrdiff_t head = 0;
    while (head < most && same(head, head)) ++head;
    return head;
  }
  std::ptrdiff_t common_tail(std::ptrdiff_t head) const {
    const std::ptrdiff_t most = std::min(std::ssize(before_), std::ssize(now_)) - head;
    std::ptrdiff_t tail = 0;
    while (tail < most && same(std::ssize(before_) - tail - 1, std::ssize(now_) - tail - 1)) ++tail;
    return tail;
  }

  /// Returns the x at which the path of d edits enters diagonal k = x - y, from the frontier `last` of d - 1
  /// edits.
  std::ptrdiff_t reach(const std::vector<std::ptrdiff_t>& last, std::ptrdiff_t d, std::ptrdiff_t k) const {
    const auto at = [&](std::ptrdiff_t diagonal) { return last[index(diagonal + d)]; };
    if (d == 0) return 0;
    const bool added = k == -d || (k != d && at(k - 1) < at(k + 1));
    return added ? at(k + 1) : at(k - 1) + 1;
  }

  /// Stores the frontier of each number of edits; false if more than most_edits are needed.
  bool forward() {
    for (std::ptrdiff_t d = 0; d <= std::min(n_ + m_, most_edits); ++d) {
      static const std::vector<std::ptrdiff_t> none;
      std::vector<std::ptrdiff_t> reached(index(2 * d + 3), -1);  // diagonals -d-1 to d+1
      const std::vector<std::ptrdiff_t>& last = ways_.empty() ? none : ways_.back();
      for (std::ptrdiff_t k = -d; k <= d; k += 2) {
        std::ptrdiff_t x = reach(last, d, k);
        while (x < n_ && x - k < m_ && x >= k && same(first_ + x, first_ + x - k)) ++x;
        reached[index(k + d + 1)] = x;
        if (x >= n_ && x - k >= m_) {
          end_ = d;
          return true;
        }
      }
      ways_.push_back(std::move(reached));
    }
    return false;
  }

  void back() {
    std::ptrdiff_t x = n_, y = m_;
    for (std::ptrdiff_t d = end_; d >= 0; --d) {
      const std::ptrdiff_t k = x - y;
      const std::ptrdiff_t begin = d == 0 ? 0 : reach(ways_[index(d - 1)], d, k);
      for (; x > begin; --x, --y) of_now[index(first_ + y - 1)] = first_ + x - 1;
      if (d == 0) return;
      const auto& last = ways_[index(d - 1)];
      const bool added = k == -d || (k != d && last[index(k - 1 + d)] < last[index(k + 1 + d)]);
      added ? --y : --x;
    }
  }

  const std::vector<Line>&before_, &now_;
  std::ptrdiff_t first_ = 0, n_ = 0, m_ = 0, end_ = 0;
  std::vector<std::vector<std::ptrdiff_t>> ways_;
};

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

std::string with_line_ends_of(const std::string& file, const std::string& text) {
  const std::vector<Line> before = lines_with_ends(file), now = lines_with_ends(text);
  const std::string_view usual = usual_end(before);
  if (std::ranges::all_of(before, [&](const Line& line) { return line.end.empty() || line.end == usual; }) &&
      usual == "\n")
    return text;
  const Pairs pairs(before, now);
  std::string result;
  for (std::size_t i = 0; i < now.size(); ++i) {
    result += now[i].text;
    if (now[i].end.empty()) continue;
    const auto& pair = pairs.of_now[i];
    const std::string_view own = pair ? before[static_cast<std::size_t>(*pair)].end : "";
    result += own.empty() ? usual : own;
  }
  return result;
}

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
