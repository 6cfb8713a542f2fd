#include "engine/app/session/version.hpp"
#include "engine/app/studio/calls.hpp"

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

}  // namespace

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

}  // namespace stepwire::studio
