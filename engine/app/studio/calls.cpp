#include "engine/app/studio/calls.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <set>

#include "engine/app/session/version.hpp"
#include "engine/app/studio/live/live_run.hpp"
#include "engine/app/studio/live/pointer.hpp"
#include "engine/app/studio/named_faults.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::studio {

using json::Json;

namespace {

Json hello(const Desk& desk, const Arguments& arguments) {
  constexpr int protocol = 1;
  if (arguments.whole("protocol") != protocol)
    throw Fault("this page is of another version than the program; load it again");
  return Json::object().set("version", session::program_version()).set("file", 0).set("loop", desk.loop);
}

Json files(Desk& desk) {
  const std::lock_guard lock(desk.mutex);
  Json list = Json::list();
  for (const ListedFile& file : desk.files.list())
    list.push(Json::object()
                  .set("file", file.number)
                  .set("name", file.name)
                  .set("writable", file.writable)
                  .set("part", file.is_part));
  return Json::object().set("files", std::move(list));
}

const std::string& path(Desk& desk, const Arguments& arguments) {
  return desk.files.path(arguments.whole("file"));
}

Json open(Desk& desk, const Arguments& arguments) {
  const std::lock_guard lock(desk.mutex);
  const std::string& file = path(desk, arguments);
  const EditedText& text = desk.files.texts().open(file);
  return Json::object()
      .set("name", std::filesystem::path(file).filename().string())
      .set("text", text.saved)
      .set("hash", text.hash)
      .set("draft", text.is_draft() ? Json(text.text) : Json())
      .set("version", text.version);
}

std::vector<TextChange> changes_of(const Arguments& arguments) {
  std::vector<TextChange> changes;
  for (const Json& one : arguments.items("changes")) {
    const Arguments change(one);
    changes.push_back({static_cast<std::size_t>(change.whole("from")),
                       static_cast<std::size_t>(change.whole("to")), change.text("text")});
  }
  return changes;
}

Json edit_news(int file, int version, const Json& changes) {
  return Json::object()
      .set("news", "edited")
      .set("file", file)
      .set("version", version)
      .set("changes", changes);
}

Json edit(Desk& desk, int page, const Arguments& arguments) {
  const std::lock_guard lock(desk.mutex);
  const EditedText& text =
      desk.files.texts().edit(path(desk, arguments), arguments.whole("version"), changes_of(arguments));
  desk.tell(edit_news(arguments.whole("file"), text.version, arguments.any("changes")), page);
  return Json::object().set("version", text.version);
}

Json discard(Desk& desk, int page, const Arguments& arguments) {
  const std::lock_guard lock(desk.mutex);
  const std::size_t length = utf16_length(desk.files.texts().open(path(desk, arguments)).text);
  const EditedText& text = desk.files.texts().discard(path(desk, arguments));
  const Json all = Json::object().set("from", 0).set("to", length).set("text", text.text);
  desk.tell(edit_news(arguments.whole("file"), text.version, Json::list({all})), page);
  return Json::object().set("text", text.text).set("hash", text.hash).set("version", text.version);
}

Json save(Desk& desk, int page, const Arguments& arguments) {
  const std::lock_guard lock(desk.mutex);
  const std::string& file = path(desk, arguments);
  if (const auto other = desk.files.texts().save(file, arguments.text("hash"))) {
    if (other->is_merged) {
      for (const Json& news : change_news(arguments.whole("file"), *other)) desk.tell(news, 0);
      return Json::object().set("merged", true);
    }
    const EditedText& now = other->now;
    const Json conflict =
        Json::object().set("text", now.saved).set("hash", now.hash).set("both", other->both);
    return Json::object().set("conflict", conflict);
  }
  const std::string hash = desk.files.texts().find(file)->hash;
  desk.tell(Json::object().set("news", "saved").set("file", arguments.whole("file")).set("hash", hash), page);
  return Json::object().set("hash", hash);
}

Json get(Desk& desk, const std::string& path) {
  const std::lock_guard lock(desk.mutex);
  const std::string layout = desk.store.layout(path);
  return Json::object().set("state", layout.empty() ? Json() : Json::parse(layout));
}

Json put(Desk& desk, const std::string& path, std::size_t most, const Arguments& arguments) {
  const std::string layout = arguments.any("state").text(-1);
  if (layout.size() > most) throw Fault(fmt::format("what is kept here has {} kB at most", most >> 10u));
  const std::lock_guard lock(desk.mutex);
  desk.store.keep_layout(path, layout);
  return Json::object();
}

/// Returns the names of calls that take long; all others act on the run without delay.
const std::set<std::string>& slow_calls() {
  static const std::set<std::string> names{"run.load", "figures",     "claims",  "fan",
                                           "profile",  "data.export", "run.keep"};
  return names;
}

}  // namespace

void Arguments::refuse(const std::string& name, const std::string& kind) {
  throw Fault(fmt::format("'{}' of this call is missing or is no {}", name, kind));
}

const Json& Arguments::any(const std::string& name) const {
  const Json* found = message_.find(name);
  if (!found) refuse(name, "value");
  return *found;
}

int Arguments::whole(const std::string& name) const {
  const Json* found = message_.find(name);
  const auto number = found ? found->as_number() : std::nullopt;
  const bool fits = number && *number >= 0 && *number <= std::numeric_limits<int>::max();
  if (!fits || std::floor(*number) != *number) refuse(name, "whole number");
  return static_cast<int>(*number);
}

std::string Arguments::text(const std::string& name) const {
  const Json* found = message_.find(name);
  if (!found || !found->as_text()) refuse(name, "text");
  return *found->as_text();
}

bool Arguments::flag(const std::string& name) const {
  const Json* found = message_.find(name);
  if (!found || !found->as_flag()) refuse(name, "true or false");
  return *found->as_flag();
}

std::span<const Json> Arguments::items(const std::string& name) const {
  const Json* found = message_.find(name);
  if (!found || !found->is_list()) refuse(name, "list");
  return found->items();
}

std::vector<std::string> Arguments::texts(const std::string& name) const {
  std::vector<std::string> words;
  for (const Json& item : items(name)) {
    if (!item.as_text()) refuse(name, "list of texts");
    words.push_back(*item.as_text());
  }
  return words;
}

std::vector<Json> change_news(int file, const WrittenElsewhere& written) {
  const EditedText& text = written.now;
  std::vector<Json> all;
  if (!written.changes.empty()) {
    Json changes = Json::list();
    for (const TextChange& one : written.changes)
      changes.push(Json::object().set("from", one.from).set("to", one.to).set("text", one.text));
    all.push_back(edit_news(file, text.version, changes));
  }
  Json changed = Json::object()
                     .set("news", "changed")
                     .set("file", file)
                     .set("text", text.saved)
                     .set("hash", text.hash)
                     .set("version", text.version)
                     .set("merged", written.is_merged);
  all.push_back(written.both.empty() ? changed : changed.set("both", written.both));
  return all;
}

void add_file_calls(Calls& calls, Desk& desk) {
  calls["hello"] = {[&desk](int, const Arguments& arguments) { return hello(desk, arguments); }};
  calls["files"] = {[&desk](int, const Arguments&) { return files(desk); }};
  calls["open"] = {[&desk](int, const Arguments& arguments) { return open(desk, arguments); }};
  calls["edit"] = {[&desk](int page, const Arguments& arguments) { return edit(desk, page, arguments); }};
  calls["discard"] = {
      [&desk](int page, const Arguments& arguments) { return discard(desk, page, arguments); }};
  calls["save"] = {[&desk](int page, const Arguments& arguments) { return save(desk, page, arguments); }};
}

void add_state_calls(Calls& calls, Desk& desk) {
  constexpr std::size_t most_of_file = 256u << 10u, most_of_user = 16u << 10u;
  const std::string file = desk.files.path(0), user;
  calls["state.get"] = {[&desk, file](int, const Arguments&) { return get(desk, file); }};
  calls["user.get"] = {[&desk, user](int, const Arguments&) { return get(desk, user); }};
  calls["state.put"] = {
      [&desk, file](int, const Arguments& it) { return put(desk, file, most_of_file, it); }};
  calls["user.put"] = {[&desk, user](int, const Arguments& it) { return put(desk, user, most_of_user, it); }};
}

void add_live_calls(Calls& calls, live::LiveRun& run) {
  for (const std::string& name : live::LiveRun::call_names())
    calls[name] = {
        [&run, name](int page, const Arguments& arguments) { return run.call(page, name, arguments.all()); },
        slow_calls().contains(name) ? CallRow::Where::slow : CallRow::Where::run};
}

live::Loading edited_model(Desk& desk, int file, bool hand) {
  return with_names(desk, [&] {
    const auto loader = std::make_shared<diagram::Loader>(desk.registry);
    const std::string path = add_documents(desk, file, *loader);
    session::LoadedModel model =
        hand ? live::load_for_page(*loader, path) : session::load_model(*loader, path, {});
    const auto again = [loader, path](const session::LoadOptions& options) {
      return session::load_model(*loader, path, options);  // with the texts of the page
    };
    const auto document = [loader](const std::string& file) -> const yaml::Document& {
      return loader->document(file);
    };
    return live::Loading(std::move(model), again, document);
  });
}

}  // namespace stepwire::studio
