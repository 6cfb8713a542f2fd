#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/engine/app/studio/started_studio.hpp"

namespace stepwire::studio {

namespace {

using Catch::Contains;
using json::Json;

Json message(const std::string& method, Json params, int id = 0) {
  Json message = Json::object().set("jsonrpc", "2.0").set("method", method).set("params", std::move(params));
  if (id > 0) message.set("id", id);
  return Json::object().set("message", std::move(message));
}

Json document(const std::string& uri, const std::string& text = {}) {
  Json document = Json::object().set("uri", uri);
  if (!text.empty()) document.set("text", text).set("version", 0).set("languageId", "yaml");
  return Json::object().set("textDocument", std::move(document));
}

/// A page with its language server begun.
void begin(PageClient& page) {
  result(page.call("language", message("initialize", Json::object().set("rootUri", "studio:/"), 1)));
  REQUIRE(page.news("language"));
  result(page.call("language", message("initialized", Json::object())));
}

Json splice(const std::string& kind, int version, Json edit) {
  return arguments(0).set("version", version).set("edit", edit.set("kind", kind));
}

/// The text of FILE with the changes that a splice gave.
std::string spliced(std::string text, const Json& changes) {
  const auto items = changes.find("changes")->items();
  for (auto one = items.rbegin(); one != items.rend(); ++one) {
    const auto from = static_cast<std::size_t>(*one->find("from")->as_number());
    const auto to = static_cast<std::size_t>(*one->find("to")->as_number());
    text.replace(from, to - from, *one->find("text")->as_text());
  }
  return text;
}

}  // namespace

TEST_CASE("a page has a language server, which knows files by their numbers alone") {
  const Started started;
  PageClient page(started.key), other(started.key);
  begin(page);
  std::string broken = gain_yaml;
  broken.replace(broken.find("u: one"), 6, "u: uno");
  result(page.call("language", message("textDocument/didOpen", document("studio:/0", broken))));
  const auto news = page.news("language");
  REQUIRE(news);
  CHECK_THAT(news->text(-1),
             Contains("publishDiagnostics") && Contains("studio:/0") && Contains("there is no block 'uno'"));
  CHECK(news->text(-1).find(started.folder.path("")) == std::string::npos);
  CHECK(other.call("hello", Json::object().set("protocol", 1)).find("result"));  // the other page is answered
}

TEST_CASE("the language server of a page reads nothing outside of the folders") {
  const Started started;
  PageClient page(started.key);
  begin(page);
  for (const std::string& uri : std::vector<std::string>{"file:///etc/passwd", "studio:/99", "studio:/-1",
                                                         "studio:/../x", "/etc/passwd", ""}) {
    page.call("language", message("textDocument/didOpen", document(uri, gain_yaml)));
    page.call("language", message("textDocument/documentSymbol", document(uri), 5));
  }
  std::string outside = gain_yaml;
  outside.replace(outside.find("parts/rig.yaml"), 14, "../outside/secret.yaml");
  page.call("language", message("textDocument/didOpen", document("studio:/0", outside)));
  std::string heard;
  for (int i = 0; i < 40 && heard.find("does not lie beneath") == std::string::npos; ++i)
    if (const auto news = page.news("language")) heard += news->text(-1);
  CHECK_THAT(heard, Contains("does not lie beneath the folders"));
  CHECK(heard.find("half") == std::string::npos);  // a block of that file
}

TEST_CASE("messages that are none of a language server leave the studio as it is") {
  const Started started;
  PageClient page(started.key);
  begin(page);
  for (const Json& wrong :
       {Json(), Json(5), Json("x"), Json::list(), Json::object(), Json::object().set("method", 7),
        Json::object().set("jsonrpc", "2.0").set("id", 1).set("method", "nothing")})
    page.call("language", Json::object().set("message", wrong));
  CHECK_FALSE(fault(page.call("language")).empty());
  CHECK(page.call("hello", Json::object().set("protocol", 1)).find("result"));
}

TEST_CASE("a drawing has the place of every shape in the text, in units of UTF-16") {
  std::string yaml = gain_yaml;
  yaml.replace(yaml.find("A gain"), 6, "\xf0\x9f\x98\x80 \xce\xa9 gain");  // 4 and 2 bytes, 2 units and 1
  const Started started(yaml);
  PageClient page(started.key);
  const Json answer =
      page.call("graph", arguments(0).set("scope", "").set("open", Json::list()).set("units", true));
  const Json& ranges = *result(answer).find("ranges");
  const Json* two = ranges.find("two");
  REQUIRE(two);
  const auto from = static_cast<std::size_t>(*two->find("from")->as_number());
  CHECK(two->find("file")->as_number() == 0);
  CHECK(yaml.substr(from + 3, 4) == "two:");  // three more bytes than UTF-16 units precede it
  CHECK(ranges.find("two.u"));
  const Json part =
      page.call("graph", arguments(0).set("scope", "rig").set("open", Json::list()).set("units", true));
  CHECK(result(part).find("ranges")->find("half")->find("file")->as_number() == 1);
}

TEST_CASE("an edit of the drawing is changes of the text that the page has") {
  const Started started;
  PageClient page(started.key);
  const Json number =
      page.call("splice", splice("number", 0, Json::object().set("name", "two.gain").set("text", "3")));
  CHECK_THAT(spliced(gain_yaml, result(number)), Contains("two: {block: Gain, u: one, gain: 3}"));
  const Json rename =
      page.call("splice", splice("rename", 0, Json::object().set("name", "two").set("to", "twice")));
  CHECK_THAT(spliced(gain_yaml, result(rename)), Contains("twice: {block") && Contains("u: twice"));
  result(page.call("edit", edit(0, 0, 0, 0, "# one more line\n")));
  const Json stale = page.call("splice", splice("delete", 0, Json::object().set("name", "two")));
  CHECK(stale.find("fault")->find("current")->find("version")->as_number() == 1);
  CHECK_FALSE(fault(page.call("splice", splice("delete", 1, Json::object().set("name", "none")))).empty());
  CHECK_FALSE(fault(page.call("splice", splice("dance", 1, Json::object()))).empty());
  const Json later =
      page.call("splice", splice("number", 1, Json::object().set("name", "two.gain").set("text", "3")));
  CHECK_THAT(spliced("# one more line\n" + gain_yaml, result(later)), Contains("gain: 3}"));
}

TEST_CASE("a page hears where a wire may lead") {
  const Started started;
  PageClient page(started.key);
  const Json answer = page.call("fits", arguments(0).set("version", 0).set("from", "one"));
  CHECK_THAT(result(answer).text(-1), Contains(R"("node":"two","input":"u")"));
  CHECK_FALSE(fault(page.call("fits", arguments(0).set("version", 0).set("from", "none"))).empty());
}

}  // namespace stepwire::studio
