#include "engine/app/session/fault_json.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "engine/base/io/file.hpp"
#include "engine/base/yaml/fault_place.hpp"
#include "engine/base/yaml/text_position.hpp"

namespace stepwire::session {

using json::Json;

namespace {

Json mark_json(const yaml::Mark& mark) {
  return Json::object().set("line", mark.line).set("column", mark.column);
}

/// File named by faults, in its present state.
class FaultyFile {
 public:
  explicit FaultyFile(const std::string& path) {
    try {
      document_ = yaml::read_document(path);  // checks kind and size of the file first
      text_ = io::read_file(path);
    } catch (const std::exception&) {  // missing file, or no YAML
    }
  }

  yaml::FoundPlace at(const yaml::Mark& mark) const {
    return document_ ? yaml::find_place(document_->root, mark) : yaml::FoundPlace{};
  }
  std::optional<yaml::Mark> end(const yaml::Fault& fault) const {
    return document_ ? yaml::end_of_fault(document_->root, fault) : std::nullopt;
  }

  /// Returns the replacement of a probably misspelt word; a list of at most one.
  Json suggestions(const yaml::Fault& fault) const {
    Json list = Json::list();
    const auto& suggestion = fault.message.suggestion;
    const auto behind = suggestion ? end(fault) : std::nullopt;
    if (!behind) return list;
    yaml::LineIndex lines(text_);
    const auto at = yaml::find_word(text_, lines.position(fault.place.mark), lines.position(*behind),
                                    suggestion->written);
    if (!at) return list;
    const yaml::Mark from = lines.mark(*at), to = lines.mark(*at + suggestion->written.size());
    return list.push(mark_json(from).set("end", mark_json(to)).set("text", suggestion->meant));
  }

 private:
  std::string text_;
  std::optional<yaml::Document> document_;
};

/// Splits a subject such as "rig.mount.stiffness" into block and port or key. In the YAML path the entry
/// below `blocks` is the last piece of the block's name, and the key follows it.
std::pair<std::string, std::string> block_and_port(const std::string& subject,
                                                   const yaml::FoundPlace& found) {
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

/// True if the place is a setting of the call, such as "--set mass=2 kg".
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

Json end_json(const FaultyFile& file, const yaml::Fault& fault) {
  const auto end = file.end(fault);
  return end ? mark_json(*end) : Json();
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
                  .set("end", end_json(file, fault))
                  .set("subject", text_or_null(fault.subject))
                  .set("block", text_or_null(block))
                  .set("port", text_or_null(port))
                  .set("text", fault.message.wrong)
                  .set("cure", text_or_null(fault.message.cure))
                  .set("suggestions", file.suggestions(fault))
                  .set("used_by", std::move(users)));
  }
  return list;
}

}  // namespace stepwire::session
