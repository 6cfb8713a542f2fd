#include "engine/app/session/fault_json.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "engine/base/io/file.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::session {

using json::Json;

namespace {

bool lies_behind(const yaml::Mark& a, const yaml::Mark& b) {
  return std::pair(a.line, a.column) > std::pair(b.line, b.column);
}

/// What stands at a mark of a tree: the keys that lead there, and the innermost key or value that begins
/// there.
struct FoundPlace {
  std::vector<std::string> keys;
  const yaml::Entry* key = nullptr;   ///< that begins at the mark
  const yaml::Node* value = nullptr;  ///< that begins at the mark
};

void find(const yaml::Node& node, const yaml::Mark& mark, FoundPlace& found) {
  if (node.mark.line == mark.line && node.mark.column == mark.column) found.value = &node;
  const yaml::Entry* inside = nullptr;
  for (const yaml::Entry& entry : node.entries)
    if (!lies_behind(entry.mark, mark)) inside = &entry;
  const yaml::Node* item = nullptr;
  for (const yaml::Node& one : node.items)
    if (!lies_behind(one.mark, mark)) item = &one;
  if (inside) {
    found.keys.push_back(inside->key);
    if (inside->mark.line == mark.line && inside->mark.column == mark.column) found.key = inside;
    find(inside->value, mark, found);
  } else if (item) {
    find(*item, mark, found);
  }
}

/// A file that faults name, as it is now.
class FaultyFile {
 public:
  explicit FaultyFile(const std::string& path) {
    try {
      std::istringstream text(io::read_file(path));
      for (std::string line; std::getline(text, line);) lines_.push_back(line);
      document_ = yaml::read_document(path);
    } catch (
        const std::exception&) {  // there is no such file, or it is no YAML: its lines tell what they can
    }
  }

  FoundPlace at(const yaml::Mark& mark) const {
    FoundPlace found;
    if (document_) find(document_->root, mark, found);
    return found;
  }

  /// Just behind what begins at the mark; none where that is not known.
  std::optional<yaml::Mark> end(const yaml::Mark& mark) const {
    const auto line = static_cast<std::size_t>(mark.line);
    if (line < 1 || line > lines_.size() || mark.column < 1) return std::nullopt;
    const std::string_view rest = behind(lines_[line - 1], mark.column - 1);
    if (rest.empty()) return std::nullopt;
    const FoundPlace found = at(mark);
    const std::size_t bytes = length(rest, found);
    return yaml::Mark{mark.line, mark.column + characters(rest.substr(0, bytes))};
  }

 private:
  static std::string_view behind(std::string_view text, int count) {
    for (; count > 0 && !text.empty(); --count)
      text.remove_prefix(std::max<std::size_t>(1, text::utf8_length(text)));
    return text;
  }
  static int characters(std::string_view text) {
    int count = 0;
    for (; !text.empty(); ++count) text.remove_prefix(std::max<std::size_t>(1, text::utf8_length(text)));
    return count;
  }
  /// Bytes of a key, a scalar in or without quotes, or what the line holds up to its comment.
  static std::size_t length(std::string_view rest, const FoundPlace& found) {
    const std::string* text = found.key                                 ? &found.key->key
                              : found.value && found.value->is_scalar() ? &found.value->text
                                                                        : nullptr;
    if (text && !text->empty() && rest.starts_with(*text)) return text->size();
    if (rest.front() == '"' || rest.front() == '\'')
      if (const std::size_t close = rest.find(rest.front(), 1); close != std::string_view::npos)
        return close + 1;
    const std::size_t end = std::min(rest.find(" #"), rest.size());
    return rest.substr(0, end).find_last_not_of(" \t\r") + 1;
  }

  std::vector<std::string> lines_;
  std::optional<yaml::Document> document_;
};

/// The block of a subject such as "rig.mount.stiffness", and what of it. The tree has the last name of the
/// block below `blocks`, and behind that the key.
std::pair<std::string, std::string> block_and_port(const std::string& subject, const FoundPlace& found) {
  const auto section = std::ranges::find(found.keys, "blocks");
  if (found.keys.end() - section < 2) return {};
  const std::string& name = section[1];
  if (subject.empty()) return {name, ""};
  const auto key = found.keys.end() - section > 2 ? "." + section[2] : std::string();
  const std::string whole = "." + subject;
  if (!key.empty() && whole.ends_with("." + name + key))
    return {subject.substr(0, subject.size() - key.size()), key.substr(1)};
  if (!key.empty() && found.key && whole.ends_with("." + name)) return {subject, key.substr(1)};
  const std::size_t at = (whole + ".").rfind("." + name + ".");
  if (at == std::string::npos || at + name.size() == subject.size()) return {subject, ""};
  return {subject.substr(0, at + name.size()), subject.substr(at + name.size() + 1)};
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

Json number_or_null(int number) {
  return number > 0 ? Json(number) : Json();
}

/// A setting stands in the call: "--set mass=2 kg".
bool is_call(const yaml::Place& place) {
  return place.mark.line == 0 && place.file.starts_with("--");
}

Json place_json(const yaml::Place& place) {
  return Json::object()
      .set("file", text_or_null(is_call(place) ? "" : place.file))
      .set("call", text_or_null(is_call(place) ? place.file : ""))
      .set("line", number_or_null(place.mark.line))
      .set("column", number_or_null(place.mark.column));
}

Json end_json(const FaultyFile& file, const yaml::Mark& mark) {
  const auto end = file.end(mark);
  return end ? Json::object().set("line", end->line).set("column", end->column) : Json();
}

}  // namespace

Json faults_json(const std::vector<yaml::Fault>& faults) {
  std::map<std::string, FaultyFile> files;
  Json list = Json::list();
  for (const yaml::Fault& fault : faults) {
    const FaultyFile& file = files.try_emplace(fault.place.file, fault.place.file).first->second;
    const auto [block, port] = block_and_port(fault.subject, file.at(fault.place.mark));
    Json users = Json::list();
    for (const yaml::Place& user : fault.used_by) users.push(place_json(user));
    list.push(place_json(fault.place)
                  .set("end", end_json(file, fault.place.mark))
                  .set("subject", text_or_null(fault.subject))
                  .set("block", text_or_null(block))
                  .set("port", text_or_null(port))
                  .set("text", fault.wrong())
                  .set("cure", text_or_null(fault.cure()))
                  .set("used_by", std::move(users)));
  }
  return list;
}

}  // namespace stepwire::session
