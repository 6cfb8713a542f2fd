#include <catch2/catch.hpp>
#include <cstring>

#include "tests/engine/app/studio/started_studio.hpp"

namespace stepwire::studio {

namespace {

using Catch::Contains;
using json::Json;

const std::string ramp_yaml = R"(stepwire: 1
title: A ramp
step: 1 ms
stop: 1 s
solver: rk4
parameters:
  slope: {value: 2 N/s, at_least: 0 N/s, at_most: 10 N/s, doc: of the ramp}
blocks:
  rate: {block: Constant, value: $slope}
  ramp: {block: Integrator, u: rate}
record: [ramp]
)";

/// One number of the body of a frame: column 0 is the time.
double value(const std::string& frame, std::size_t column, std::size_t row) {
  std::uint32_t rows = 0;
  std::memcpy(&rows, frame.data() + 12, sizeof rows);
  double value = 0.0;
  std::memcpy(&value, frame.data() + 32 + 8 * (column * rows + row), sizeof value);
  return value;
}

std::size_t rows(const std::string& frame) {
  std::uint32_t rows = 0;
  std::memcpy(&rows, frame.data() + 12, sizeof rows);
  return rows;
}

/// Returns the next frame with more than `least` rows; texts before it are dropped.
std::string frame(PageClient& page, std::size_t least) {
  while (const auto message = page.receive()) {
    if (!message->starts_with("SWD1")) continue;
    std::uint32_t sequence = 0;
    std::memcpy(&sequence, message->data() + 8, sizeof sequence);
    page.send(Json::object().set("ack", sequence).text(-1));
    if (rows(*message) > least) return *message;
  }
  return {};
}

int column_of(const Json& loaded, const std::string& name) {
  for (const Json& one : loaded.find("columns")->items())
    if (text(one, "name") == name) return static_cast<int>(*one.find("column")->as_number());
  return -1;
}

bool has_ended(PageClient& page) {
  while (const auto news = page.news("run"))
    if (text(*news, "state") == "ended") return true;
  return false;
}

Json window(int column) {
  const Json view = Json::object()
                        .set("view", 1)
                        .set("columns", Json::list({column}))
                        .set("from", 0)
                        .set("to", 2)
                        .set("follow", Json())
                        .set("pixels", 5000);
  return Json::object().set("views", Json::list({view}));
}

}  // namespace

TEST_CASE("a page runs the text as it is edited, and sees every sample") {
  const Started started(ramp_yaml);
  PageClient page(started.key);
  const std::size_t place = ramp_yaml.find("2 N/s");
  result(page.call("edit", edit(0, 0, place, place + 1, "4")));
  const Json answer = page.call("run.load", arguments(0));
  const Json& loaded = result(answer);
  CHECK(text(loaded, "title") == "A ramp");
  result(page.call("run.play", Json::object().set("rate", 0)));
  REQUIRE(has_ended(page));
  page.send(window(column_of(loaded, "ramp")).set("call", "data.want").text(-1));
  const std::string all = frame(page, 1000);
  REQUIRE(rows(all) == 1001);
  CHECK(value(all, 1, 500) == Approx(2.0));
  CHECK(value(all, 1, 1000) == Approx(4.0));
  CHECK(content_of(started.folder.path("home/gain.yaml")) == ramp_yaml);
}

TEST_CASE("what a page sets passes the ranges of the file, and all pages hear of it") {
  const Started started(ramp_yaml);
  PageClient page(started.key), other(started.key);
  result(page.call("run.load", arguments(0)));
  const auto set = [&](const Json& value) {
    return page.call("run.set", Json::object().set("name", "slope").set("value", value));
  };
  for (const Json& wrong :
       {Json("11 N/s"), Json(-1.0), Json("nan"), Json("5 kg"), Json("x"), Json(1e300), Json()}) {
    INFO(wrong.text());
    CHECK_FALSE(fault(set(wrong)).empty());
  }
  result(set("5 N/s"));
  const auto news = other.news("set");
  REQUIRE(news);
  CHECK(news->find("value")->as_number() == 5.0);
  CHECK_FALSE(fault(page.call("run.set", Json::object().set("name", "none").set("value", 1))).empty());
}

TEST_CASE("a run of a text with faults is refused with all of them, and the run before goes on") {
  const Started started(ramp_yaml);
  PageClient page(started.key);
  result(page.call("run.load", arguments(0)));
  const std::size_t place = ramp_yaml.find("u: rate");
  result(page.call("edit", edit(0, 0, place, place + 7, "u: rote")));
  const Json answer = page.call("run.load", arguments(0));
  CHECK_THAT(fault(answer), Contains("there is no block 'rote'"));
  CHECK(answer.find("fault")->find("faults")->items().size() == 1);
  CHECK(page.call("run.tick").find("result"));
}

TEST_CASE("the calls of the run withstand arguments of every kind") {
  const Started started(ramp_yaml);
  PageClient page(started.key);
  result(page.call("run.load", arguments(0)));
  const std::vector<Json> values{Json(),         Json(-1),         Json(1e308),
                                 Json("x"),      Json(true),       Json::list({Json::list()}),
                                 Json::object(), Json(4294967296), Json::list({-1, "x"})};
  for (const std::string& name : std::vector<std::string>{
           "run.load", "run.play", "run.seek", "run.set", "run.input", "clock", "scope.signal", "data.want",
           "data.statistics", "data.export", "fan", "scene.watch"})
    for (const Json& value : values)
      for (const char* key : {"file", "rate", "time", "name", "value", "samples", "views", "expression",
                              "columns", "page", "on"})
        page.call(name, Json::object().set(key, value));
  const Json wrong =
      Json::object().set("view", 1).set("columns", Json::list({99})).set("from", 0).set("to", 1);
  page.call("data.want", Json::object().set("views", Json::list({wrong})));
  CHECK(page.call("hello", Json::object().set("protocol", 1)).find("result"));
}

}  // namespace stepwire::studio
