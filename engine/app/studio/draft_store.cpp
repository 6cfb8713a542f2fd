#include "engine/app/studio/draft_store.hpp"

#include <cstdlib>
#include <limits>

#include "engine/base/hash/hash.hpp"
#include "engine/base/json/json.hpp"

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

}  // namespace stepwire::studio
