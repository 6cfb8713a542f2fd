// Hostile calls of a page, or of a program in its place, beyond the purpose of the calls.
#include <catch2/catch.hpp>
#include <fstream>
#include <optional>

#include "engine/app/studio/live/live_run.hpp"
#include "tests/engine/app/studio/started_studio.hpp"

namespace stepwire::studio {

namespace {

using Catch::Contains;
using json::Json;

const std::string reading_yaml = R"(stepwire: 1
title: "\"><img src=x onerror=alert(1)>"
step: 1 ms
stop: 1 h
solver: rk4
inputs: {push: {unit: N, default: 1 N}}
parameters: {mass: {value: 2 kg, above: 0 kg}}
blocks:
  table: {block: FromFile, file: table.csv, column: y}
  slide: {block: Mass, force: push, mass: $mass}
record: [table, slide.position]
)";

/// A studio on a diagram with a data file, an input and a parameter.
struct Target : Started {
  Target() {
    std::ofstream(folder.path("home/table.csv")) << "time,y\n0,1\n1,2\n";
    std::ofstream(folder.path("outside/secret.csv")) << "time,y\n0,7\n1,7\n";
    std::ofstream(folder.path("home/gain.yaml")) << reading_yaml;
    start();
  }
};

std::vector<std::string> all_calls() {
  std::vector<std::string> names = live::LiveRun::call_names();
  for (const char* name :
       {"hello", "files", "open", "edit", "discard", "save", "graph", "blocks", "splice", "fits", "gallery",
        "gallery.copy", "language", "state.get", "state.put", "user.get", "user.put"})
    names.emplace_back(name);
  return names;
}

/// Arguments of every kind for all names that calls have.
Json odd_arguments(const Json& value) {
  Json all = Json::object();
  for (const char* name :
       {"file",       "version", "hash",     "changes", "scope", "open",  "units",   "edit",
        "from",       "to",      "rate",     "time",    "name",  "value", "samples", "page",
        "expression", "views",   "columns",  "low",     "high",  "count", "on",      "message",
        "state",      "entry",   "protocol", "hand",    "text",  "at",    "kind"})
    all.set(name, value);
  return all;
}

/// Returns the newest value of `push` in the log of a run; std::nullopt before the first one.
std::optional<double> last_push(PageClient& page) {
  std::optional<double> last;
  const Json log = result(page.call("run.log"));
  for (const Json& event : log.find("events")->items())
    if (text(event, "name") == "push") last = event.find("values")->items()[0].as_number();
  return last;
}

/// Waits, five seconds at most, until the newest value of `push` is this one.
bool push_becomes(PageClient& page, double value) {
  for (int i = 0; i < 500; ++i) {
    if (last_push(page) == value) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

void flood(PageClient& page) {
  const Json sample = Json::object().set("time", 0).set("name", "push").set("values", Json::list({Json(9)}));
  for (int i = 0; i < 500; ++i)
    page.send(Json::object().set("call", "run.input").set("samples", Json::list({sample})).text(-1));
}

}  // namespace

TEST_CASE("no value of a run leads to a file: those that name one are not set") {
  Target target;
  PageClient page(target.key);
  REQUIRE(page.call("run.load", arguments(0)).find("result"));
  for (const std::string& path :
       {target.folder.path("outside/secret.csv"), std::string("../outside/secret.csv"),
        std::string("/etc/passwd"), std::string("table.csv")}) {
    const Json answer = page.call("run.set", Json::object().set("name", "table.file").set("value", path));
    CHECK_THAT(fault(answer), Contains("names a file"));
  }
  const Json fan = Json::object()
                       .set("name", "table.file")
                       .set("low", 0)
                       .set("high", 1)
                       .set("count", 3)
                       .set("columns", Json::list({Json(0)}));
  CHECK_FALSE(fault(page.call("fan", fan)).empty());
}

TEST_CASE("calls with arguments of every kind are answered, and the studio goes on") {
  Target target;
  PageClient page(target.key);
  Json deep = Json::list();
  for (int i = 0; i < 30; ++i) deep = Json::list({deep});
  for (const Json& odd :
       {Json(), Json(-1), Json(1e308), Json(4294967296.0), Json(0.5), Json(true), Json(""),
        Json("../../etc/passwd"), Json(std::string("a\0b", 3)), Json(std::string(5000, '(')),
        Json::list({Json(-1), Json("x"), Json()}), Json::object().set("id", "x"), deep})
    for (const std::string& name : all_calls()) {
      INFO(name << " " << odd.text(-1).substr(0, 60));
      const Json answer = page.call(name, odd_arguments(odd));
      REQUIRE((answer.find("result") || answer.find("fault")));
    }
  PageClient other(target.key);
  CHECK(other.call("hello", Json::object().set("protocol", 1)).find("result"));
}

TEST_CASE("names of copies stay in the folder, and are no option of a program") {
  Target target;
  PageClient page(target.key);
  for (const std::string& name :
       {std::string("../x"), std::string("/tmp/x"), std::string("a/b"), std::string(".."), std::string("."),
        std::string(""), std::string("x\0y", 3), std::string(300, 'x'), std::string("..\\x"),
        std::string(".hidden"), std::string("-o"), std::string("--out"), std::string(" x"),
        std::string(" ")}) {
    INFO(name);
    const Json answer = page.call("gallery.copy", Json::object().set("entry", 0).set("name", name));
    CHECK_FALSE(fault(answer).empty());
  }
  CHECK_FALSE(std::filesystem::exists(target.folder.path("x.yaml")));
}

TEST_CASE("what one page asks to see is bounded") {
  Target target;
  PageClient page(target.key);
  REQUIRE(page.call("run.load", arguments(0)).find("result"));
  const Json many = Json::list_of(std::vector<int>(2000, 0));
  const Json view = Json::object().set("view", 1).set("columns", many).set("pixels", 1e9);
  CHECK_THAT(fault(page.call("data.want", Json::object().set("views", Json::list({view})))),
             Contains("at most 1024"));
  const Json all = Json::object().set("columns", many).set("from", 0).set("to", 1);
  CHECK_THAT(fault(page.call("data.statistics", all)), Contains("at most 256"));
  page.call("run.seek", Json::object().set("time", 1));
  for (int i = 0; i < 500 && fault(page.call("data.export", all)).empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  CHECK_THAT(fault(page.call("data.export", all)), Contains("more than a page takes"));
}

TEST_CASE(
    "inputs of a page that floods and goes have their defaults again, and no late message brings them back") {
  Target target;
  {
    PageClient page(target.key);
    REQUIRE(page.call("run.load", arguments(0)).find("result"));
    page.call("run.play", Json::object().set("rate", 1));
    flood(page);
    REQUIRE(push_becomes(page, 9));
    flood(page);
  }
  PageClient other(target.key);
  REQUIRE(push_becomes(other, 1));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  CHECK(last_push(other) == 1.0);
}

TEST_CASE("a strange title is a text in every answer, and in none as markup of the page") {
  Target target;
  PageClient page(target.key);
  const Json loaded = result(page.call("run.load", arguments(0)));
  CHECK(text(loaded, "title") == "\"><img src=x onerror=alert(1)>");
  CHECK(answer_to(target.key, {"GET", "/", host_of(target.key), cookie_line(target.key)})
            .find("onerror=alert") == std::string::npos);
}

}  // namespace stepwire::studio
