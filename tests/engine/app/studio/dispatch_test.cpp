#include "engine/app/studio/dispatch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <condition_variable>
#include <random>

namespace stepwire::studio {

namespace {

using json::Json;

/// Collector of the texts that a dispatch sends; after() waits until there are enough.
class Sent {
 public:
  void take(std::string text) {
    const std::lock_guard lock(mutex_);
    texts_.push_back(std::move(text));
    changed_.notify_all();
  }
  std::vector<std::string> after(std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::seconds(5), [&] { return texts_.size() >= count; });
    return texts_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> texts_;
};

Calls some_calls() {
  Calls calls;
  calls["double"] = {[](int, const Arguments& it) { return Json::object().set("twice", 2 * it.whole("n")); }};
  calls["page"] = {[](int page, const Arguments&) { return Json::object().set("page", page); },
                   CallRow::Where::run};
  calls["fail"] = {[](int, const Arguments&) -> Json {
    throw Fault("it is wrong; be right", Json::object().set("more", 1));
  }};
  calls["text"] = {[](int, const Arguments& it) { return Json(it.text("text")); }, CallRow::Where::slow};
  calls["deep"] = {[](int, const Arguments& it) { return Json(it.items("list").size()); }};
  return calls;
}

std::string answer(const std::string& message) {
  const Calls calls = some_calls();
  Sent sent;
  Dispatch dispatch(
      calls, [&](int, std::string text) { sent.take(std::move(text)); }, [](int, std::uint32_t) {});
  dispatch.take(7, message, nullptr);
  const auto texts = sent.after(1);
  return texts.empty() ? "" : texts.front();
}

}  // namespace

TEST_CASE("a call is answered with its number") {
  CHECK(answer(R"({"id": 3, "call": "double", "n": 21})") == R"({"id":3,"result":{"twice":42}})");
  CHECK(answer(R"({"id": 4, "call": "page"})") == R"({"id":4,"result":{"page":7}})");
  CHECK(answer(R"({"call": "fail"})") == R"({"fault":{"more":1,"text":"it is wrong","cure":"be right"}})");
}

TEST_CASE("a call that there is not, or with other arguments, is a fault") {
  CHECK(answer(R"({"id": 1, "call": "dance\u0007"})") ==
        R"({"id":1,"fault":{"text":"there is no call 'dance\\x07'"}})");
  for (const std::string& message : std::vector<std::string>{
           R"({"id": 1, "call": "double"})", R"({"id": 1, "call": "double", "n": -1})",
           R"({"id": 1, "call": "double", "n": 0.5})", R"({"id": 1, "call": "double", "n": "2"})",
           R"({"id": 1, "call": "double", "n": 1e300})", R"({"id": 1, "call": "double", "n": null})",
           R"({"id": 1, "call": 5})", R"({"id": 1})", R"({"id": 1, "call": "text"})"}) {
    INFO(message);
    CHECK(answer(message).starts_with(R"({"id":1,"fault":{"text":)"));
  }
}

TEST_CASE("what is no JSON, or no object, is a fault and nothing more") {
  for (const std::string& message : std::vector<std::string>{"", "{", "[]", "5", "null", "\"text\"",
                                                             "{\"id\":}", "\xff", "{\"id\": 1} x"}) {
    INFO(message);
    CHECK(answer(message).find("\"fault\"") != std::string::npos);
  }
  CHECK(answer(std::string(100'000, '[')).find("\"fault\"") != std::string::npos);
  CHECK(answer(R"({"id": {"a": [1]}, "call": "page"})") == R"({"result":{"page":7}})");
}

TEST_CASE("calls of one lane are done in order, a slow one holds up no other lane") {
  std::mutex gate;
  std::unique_lock closed(gate);
  Calls calls;
  calls["wait"] = {[&](int, const Arguments&) {
                     const std::lock_guard lock(gate);
                     return Json("waited");
                   },
                   CallRow::Where::slow};
  calls["now"] = {[](int, const Arguments&) { return Json("now"); }, CallRow::Where::run};
  Sent sent;
  Dispatch dispatch(
      calls, [&](int, std::string text) { sent.take(std::move(text)); }, [](int, std::uint32_t) {});
  dispatch.take(1, R"({"id": 1, "call": "wait"})", nullptr);
  dispatch.take(1, R"({"id": 2, "call": "wait"})", nullptr);
  dispatch.take(1, R"({"id": 3, "call": "now"})", nullptr);
  CHECK(sent.after(1).front() == R"({"id":3,"result":"now"})");
  closed.unlock();
  CHECK(sent.after(3) == std::vector<std::string>{R"({"id":3,"result":"now"})",
                                                  R"({"id":1,"result":"waited"})",
                                                  R"({"id":2,"result":"waited"})"});
}

TEST_CASE("a page with many calls waits for its own: another page has its answer after one of them") {
  std::mutex gate;
  std::unique_lock closed(gate);
  Calls calls;
  calls["wait"] = {[&](int page, const Arguments&) {
    const std::lock_guard lock(gate);
    return Json(page);
  }};
  Sent sent;
  Dispatch dispatch(
      calls, [&](int, std::string text) { sent.take(std::move(text)); }, [](int, std::uint32_t) {});
  const auto call = [&](int page, int id) {
    dispatch.take(page, Json::object().set("id", id).set("call", "wait").text(-1), nullptr);
  };
  for (int id = 0; id < 1000; ++id) call(1, id);
  for (int id = 0; id < 2; ++id) call(2, id);
  closed.unlock();
  const std::vector<std::string> answers = sent.after(1002);
  REQUIRE(answers.size() == 1002);
  const auto place = [&](const std::string& answer) {
    return std::ranges::find(answers, answer) - answers.begin();
  };
  CHECK(place(R"({"id":0,"result":2})") <= 2);  // the thread may have begun with one or two of the other page
  CHECK(place(R"({"id":1,"result":2})") <= 4);
  for (int id = 1; id < 1000; ++id)
    CHECK(place(fmt::format(R"({{"id":{},"result":1}})", id)) >
          place(fmt::format(R"({{"id":{},"result":1}})", id - 1)));
}

TEST_CASE("an acknowledgement has no answer, and neither has a call without a number") {
  std::vector<std::pair<int, std::uint32_t>> acknowledged;
  const Calls calls = some_calls();
  Sent sent;
  Dispatch dispatch(
      calls, [&](int, std::string text) { sent.take(std::move(text)); },
      [&](int page, std::uint32_t sequence) { acknowledged.emplace_back(page, sequence); });
  dispatch.take(2, R"({"ack": 12})", nullptr);
  dispatch.take(2, R"({"call": "double", "n": 1})", nullptr);
  dispatch.take(2, R"({"id": 1, "call": "double", "n": 2})", nullptr);
  CHECK(sent.after(1) == std::vector<std::string>{R"({"id":1,"result":{"twice":4}})"});
  CHECK(acknowledged == std::vector<std::pair<int, std::uint32_t>>{{2, 12}});
}

TEST_CASE("whatever a page sends, each message has at most one answer, which is JSON") {
  const std::vector<std::string> seeds{R"({"id": 1, "call": "double", "n": 21})",
                                       R"({"id":2,"call":"text","text":"a\u00e9\n"})", R"({"ack": 3})",
                                       R"({"id": 4, "call": "deep", "list": [[1, {"a": null}], "x"]})"};
  const Calls calls = some_calls();
  std::mt19937 random(7);
  const auto any = [&](std::size_t size) {
    return std::uniform_int_distribution<std::size_t>(0, size - 1)(random);
  };
  const std::string bytes = "{}[]\",:0-e.\\u\xff\0n t";
  std::vector<std::string> answers;
  {
    Sent sent;
    Dispatch dispatch(
        calls, [&](int, std::string text) { sent.take(std::move(text)); }, [](int, std::uint32_t) {});
    for (int i = 0; i < 5000; ++i) {
      std::string message = seeds[any(seeds.size())];
      for (std::size_t edits = any(4) + 1; edits > 0; --edits) {
        const std::size_t at = any(message.size());
        if (any(3) == 0)
          message.erase(at, any(8));
        else
          message.insert(at, 1, bytes[any(bytes.size())]);
        if (message.empty()) message = "{";
      }
      dispatch.take(1, message, nullptr);
    }
    // The last one of each lane.
    dispatch.take(1, R"({"id": 98, "call": "double", "n": 1})", nullptr);
    dispatch.take(1, R"({"id": 99, "call": "text", "text": "end"})", nullptr);
    const auto has = [&](const std::string& one) { return std::ranges::count(answers, one) > 0; };
    while (!has(R"({"id":98,"result":{"twice":2}})") || !has(R"({"id":99,"result":"end"})")) {
      const std::size_t before = answers.size();
      answers = sent.after(before + 1);
      REQUIRE(answers.size() > before);
    }
  }
  CHECK(answers.size() <= 5002);
  for (const std::string& one : answers) CHECK_NOTHROW(Json::parse(one));
}

}  // namespace stepwire::studio
