#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>

#include "engine/app/studio/page_site.hpp"
#include "tests/engine/app/studio/started_studio.hpp"

namespace stepwire::studio {

namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using json::Json;

int file(PageClient& page, const std::string& name) {
  const Json answer = page.call("files");
  for (const Json& one : result(answer).find("files")->items())
    if (text(one, "name") == name) return static_cast<int>(*one.find("file")->as_number());
  return -1;
}

Json graph(const std::string& scope = "") {
  return arguments(0).set("scope", scope).set("open", Json::list()).set("units", true);
}

/// The change of the first place of a word.
Json replaced(const std::string& text, int version, const std::string& word, const std::string& put) {
  return edit(0, version, text.find(word), text.find(word) + word.size(), put);
}

}  // namespace

TEST_CASE("a page learns of the file, its parts and the diagrams beside it by numbers") {
  const Started started;
  PageClient page(started.key);
  CHECK(*result(page.call("hello", Json::object().set("protocol", 1))).find("file")->as_number() == 0);
  CHECK_THAT(fault(page.call("hello", Json::object().set("protocol", 2))), Contains("another version"));
  started.folder.file("home/beside.yaml", gain_yaml);
  started.folder.file("home/notes.txt", "no diagram");
  CHECK(file(page, "gain.yaml") == 0);
  CHECK(file(page, "parts/rig.yaml") == 1);
  CHECK(file(page, "beside.yaml") == 2);
  CHECK(file(page, "notes.txt") == -1);
  CHECK(text(result(page.call("open", arguments(1))), "text") == rig_yaml);
  for (const Json& wrong : {Json(99), Json(-1), Json("../outside/secret.yaml"), Json()}) {
    const Json answer = page.call("open", Json::object().set("file", wrong));
    CHECK_FALSE(fault(answer).empty());
  }
}

TEST_CASE("drawings show the text as it is edited, and that of parts") {
  const Started started;
  PageClient page(started.key);
  CHECK_THAT(result(page.call("graph", graph())).text(-1), Contains("\"two\""));
  CHECK_THAT(result(page.call("graph", graph("rig"))).text(-1), Contains("\"half\""));
  CHECK_THAT(fault(page.call("graph", graph("two"))), Contains("no part 'two'"));
  result(page.call("edit", replaced(gain_yaml, 0, "u: one", "u: uno")));
  const Json broken = page.call("graph", graph());
  CHECK_THAT(fault(broken), Contains("there is no block 'uno'"));
  REQUIRE(broken.find("fault")->find("faults")->items().size() == 1);
  CHECK(text(broken.find("fault")->find("faults")->items()[0], "file") == "gain.yaml");
  CHECK(broken.text(-1).find(started.folder.path("")) == std::string::npos);  // names, never paths
  const std::size_t place = gain_yaml.find("u: one");
  result(page.call("edit", edit(0, 1, place, place + 6, "u: one")));
  const std::string part = rig_yaml;
  REQUIRE(file(page, "parts/rig.yaml") == 1);
  result(page.call("edit", edit(1, 0, part.find("half:"), part.find("half:") + 4, "third")));
  CHECK_THAT(fault(page.call("graph", graph())), Contains("half"));
}

TEST_CASE("a part outside of the folders that there were at the start is not read for a page") {
  const Started started;
  PageClient page(started.key);
  fs::create_symlink(started.folder.path("outside/secret.yaml"), started.folder.path("home/link.yaml"));
  std::string now = "parts/rig.yaml";
  int version = 0;
  for (const std::string& path :
       std::vector<std::string>{"../outside/secret.yaml", started.folder.path("outside/secret.yaml"),
                                "link.yaml", "parts/../../outside/secret.yaml", "/etc/passwd"}) {
    const std::string all = std::regex_replace(gain_yaml, std::regex("parts/rig.yaml"), now);
    result(page.call("edit", replaced(all, version++, now, path)));
    now = path;
    INFO(path);
    CHECK_THAT(fault(page.call("graph", graph())), Contains("does not lie beneath the folders"));
  }
}

TEST_CASE("two pages on one file: each sees the edits of the other") {
  const Started started;
  PageClient one(started.key), other(started.key);
  result(other.call("open", arguments(0)));
  result(one.call("edit", replaced(gain_yaml, 0, "A gain", "Two")));
  const auto edited = other.news("edited");
  REQUIRE(edited);
  CHECK(edited->find("version")->as_number() == 1);
  CHECK(text(edited->find("changes")->items()[0], "text") == "Two");
  const Json stale = other.call("edit", replaced(gain_yaml, 0, "A gain", "Three"));
  CHECK_THAT(stale.find("fault")->text(-1), Contains("title: Two"));
  CHECK(one.call("hello", Json::object().set("protocol", 1)).find("id"));
  result(one.call("save", arguments(0).set("hash", text(result(one.call("open", arguments(0))), "hash"))));
  CHECK(other.news("saved"));
}

TEST_CASE("a file that is changed elsewhere is told to its pages") {
  const Started started;
  PageClient page(started.key);
  result(page.call("open", arguments(0)));
  started.folder.file("home/gain.yaml", gain_yaml + "# more\n");
  const auto changed = page.news("changed");
  REQUIRE(changed);
  CHECK(text(*changed, "text") == gain_yaml + "# more\n");
}

TEST_CASE("a draft outlives the studio, and the state of its page with it") {
  Started started;
  {
    PageClient page(started.key);
    result(page.call("edit", replaced(gain_yaml, 0, "A gain", "A draft")));
    result(page.call("state.put", Json::object().set("state", Json::object().set("pane", 3))));
    CHECK_THAT(fault(page.call("state.put", Json::object().set("state", std::string(300'000, 'x')))),
               Contains("256 kB"));
  }
  started.start();
  PageClient page(started.key);
  const Json opened = page.call("open", arguments(0));
  CHECK(text(result(opened), "text") == gain_yaml);
  CHECK_THAT(text(result(opened), "draft"), Contains("A draft"));
  CHECK(result(page.call("state.get")).find("state")->find("pane")->as_number() == 3);
  CHECK(content_of(started.folder.path("home/gain.yaml")) == gain_yaml);
}

TEST_CASE("texts of a diagram are data: no answer to a request for the page holds them") {
  const std::string evil = "\"><img src=x onerror=alert(1)>";
  const Started started(std::regex_replace(gain_yaml, std::regex("A gain"), "'" + evil + "'"));
  for (const std::string& target : std::vector<std::string>{"/", "/index.html", "/gain.yaml", "/socket"}) {
    const std::string answer =
        answer_to(started.key, {"GET", target, host_of(started.key), cookie_line(started.key)});
    CHECK(answer.find("onerror") == std::string::npos);
  }
  PageClient page(started.key);
  CHECK_THAT(text(*result(page.call("graph", graph())).find("graph"), "title"),
             Contains(evil));  // in JSON, whole
}

TEST_CASE("the page comes from a table: a path is one of it or there is nothing") {
  const std::vector<PageFile> table{{"/index.html", "<html><p nonce=\"STUDIO_NONCE\">", ""},
                                    {"/a.js", "plain text", "packed"}};
  const auto answer = [&](const std::string& path, const std::string& takes = {}) {
    return page_answer(table, {"GET", path, {{"Accept-Encoding", takes}}}, path);
  };
  CHECK(answer("/a.js").fixed == "plain text");
  CHECK(answer("/a.js", "deflate, gzip").fixed == "packed");
  for (const std::string& path :
       std::vector<std::string>{"/a.js/", "//a.js", "/./a.js", "/x/../a.js", "/%61.js", "/A.js", "/a",
                                "/a.js%00", "/etc/passwd", "/../../etc/passwd", "/STUDIO_NONCE"})
    CHECK(answer(path).status == 404);
}

TEST_CASE("each answer has its own nonce, in the page and in what the page may do") {
  const std::vector<PageFile> table{{"/index.html", "STUDIO_NONCE", ""}};
  std::set<std::string> nonces;
  for (int i = 0; i < 10; ++i) {
    const http::Answer answer = page_answer(table, {"GET", "/", {}}, "/");
    std::map<std::string, std::string> headers;
    for (const http::Header& one : answer.headers) headers[one.name] = one.value;
    nonces.insert(answer.body);
    CHECK(headers["Content-Security-Policy"] ==
          "default-src 'none'; script-src 'self'; worker-src 'self'; connect-src 'self'; img-src 'self' "
          "data: blob:; "
          "style-src 'self' 'nonce-" +
              answer.body + "'; base-uri 'none'; form-action 'self'; frame-ancestors 'none'");
    CHECK(headers["X-Content-Type-Options"] == "nosniff");
    CHECK(headers["Referrer-Policy"] == "no-referrer");
    CHECK(headers["Cache-Control"] == "no-store");
  }
  CHECK(nonces.size() == 10);
}

TEST_CASE("GET changes nothing: not the file, not its draft, whatever the address says") {
  const Started started;
  for (const std::string& target :
       std::vector<std::string>{"/save?file=0&hash=0", "/?call=save", "/socket", "/edit", "/discard?file=0"})
    answer_to(started.key, {"GET", target, host_of(started.key), cookie_line(started.key)});
  CHECK(content_of(started.folder.path("home/gain.yaml")) == gain_yaml);
  CHECK_FALSE(fs::exists(started.folder.path("state")));
}

}  // namespace stepwire::studio
