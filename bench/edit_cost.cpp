// Measures the latency of an editor: from a key to diagnostics, and to completions.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <future>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "bench/result.hpp"
#include "bench/workload.hpp"
#include "blocks/register.hpp"
#include "engine/app/language/language_server.hpp"

namespace stepwire {

namespace {

constexpr int blocks_of_file = 300;
constexpr int edits = 100;

/// Client of a running language server; it times the server's messages.
class Editor {
 public:
  explicit Editor(const Registry& registry)
      : server_(registry, [this](const std::string& message) { take(message); }),
        thread_([this] { server_.run(); }) {
    post(1, "initialize", json::Json::object());
  }
  ~Editor() {
    server_.close();
    thread_.join();
  }

  void post(int id, const std::string& method, json::Json params) {
    json::Json message =
        json::Json::object().set("jsonrpc", "2.0").set("method", method).set("params", std::move(params));
    if (id > 0) message.set("id", id);
    server_.post(message.text(-1));
  }

  /// Returns the milliseconds from a message to one that contains a word.
  double wait(int id, const std::string& method, json::Json params, const std::string& word) {
    std::future<void> came = expect(word);
    const auto start = std::chrono::steady_clock::now();
    post(id, method, std::move(params));
    came.wait();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }

 private:
  std::future<void> expect(const std::string& word) {
    const std::scoped_lock lock(mutex_);
    word_ = word;
    came_ = {};
    return came_.get_future();
  }
  void take(const std::string& message) {
    const std::scoped_lock lock(mutex_);
    if (word_.empty() || message.find(word_) == std::string::npos) return;
    word_.clear();
    came_.set_value();
  }

  std::mutex mutex_;
  std::string word_;
  std::promise<void> came_;
  language::LanguageServer server_;
  std::thread thread_;  // last member, since it uses the others
};

json::Json document() {
  return json::Json::object().set("uri", "file:///bench/w2.yaml");
}

json::Json position(int line, std::size_t character) {
  return json::Json::object().set("line", line).set("character", character);
}

/// Line and column of the first input of the last block, the place of the edits.
struct Spot {
  int line = 0;
  std::size_t from = 0, to = 0;
};

Spot spot_in(const std::string& text) {
  const std::size_t at = text.rfind("u: x") + 3;
  const std::size_t start = text.rfind('\n', at) + 1;
  return {static_cast<int>(std::ranges::count(text.substr(0, at), '\n')), at - start,
          text.find_first_of(",}[]\n", at) - start};
}

/// Changes a name to an unknown one and back, repeatedly.
std::vector<double> keys_to_diagnostics(Editor& editor, const std::string& text, const Spot& spot) {
  std::vector<double> times;
  const std::size_t line = text.rfind('\n', text.rfind("u: x")) + 1;
  std::string now = text.substr(line + spot.from, spot.to - spot.from);
  const std::string right = now;
  for (int i = 0; i < edits; ++i) {
    const std::string next = i % 2 == 0 ? fmt::format("no_block_{}", i) : right;
    json::Json range = json::Json::object()
                           .set("start", position(spot.line, spot.from))
                           .set("end", position(spot.line, spot.from + now.size()));
    json::Json change = json::Json::object().set("range", std::move(range)).set("text", next);
    json::Json params = json::Json::object()
                            .set("textDocument", document().set("version", i + 2))
                            .set("contentChanges", json::Json::list({std::move(change)}));
    const std::string answer = fmt::format("\"version\":{}}}", i + 2);
    times.push_back(editor.wait(0, "textDocument/didChange", std::move(params), answer));
    now = next;
  }
  return times;
}

std::vector<double> completions(Editor& editor, const Spot& spot) {
  std::vector<double> times;
  for (int i = 0; i < edits; ++i) {
    json::Json params =
        json::Json::object().set("textDocument", document()).set("position", position(spot.line, spot.from));
    times.push_back(editor.wait(100 + i, "textDocument/completion", std::move(params),
                                fmt::format("\"id\":{},", 100 + i)));
  }
  return times;
}

double p95(std::vector<double> times) {
  std::ranges::sort(times);
  return times[times.size() * 95 / 100];
}

std::vector<Result> measure_edits() {
  const Registry registry = blocks();
  const std::string text = w2_text(blocks_of_file, 5);
  Editor editor(registry);
  json::Json opened = document().set("languageId", "yaml").set("version", 1).set("text", text);
  editor.wait(0, "textDocument/didOpen", json::Json::object().set("textDocument", std::move(opened)),
              "publishDiagnostics");
  const Spot spot = spot_in(text);
  const auto result = [](const std::string& what, double value) {
    return Result{what, "interpreted", "ms", value, blocks_of_file + 2};
  };
  return {result("key to diagnostics of W2 300, p95", p95(keys_to_diagnostics(editor, text, spot))),
          result("completion in W2 300, p95", p95(completions(editor, spot)))};
}

}  // namespace

}  // namespace stepwire

int main(int argc, char** argv) {
  const std::string file = argc == 3 && std::strcmp(argv[1], "--json") == 0 ? argv[2] : "/dev/stdout";
  if (stepwire::write_json_lines(stepwire::measure_edits(), file)) return 0;
  fmt::print(stderr, "{} cannot be written\n", file);
  return 1;
}
