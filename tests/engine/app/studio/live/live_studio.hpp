#pragma once

#include <catch2/catch.hpp>
#include <cstring>
#include <mutex>
#include <optional>

#include "engine/app/studio/live/live_run.hpp"
#include "engine/app/studio/live/pointer.hpp"
#include "tests/engine/app/studio/live/waiting.hpp"

namespace stepwire::live {

using json::Json;

inline const std::string swing = R"(stepwire: 1
title: A swing
step: 1 ms
stop: 3 s
solver: rk4
parameters: {mass: {value: 2 kg, above: 0 kg, at_most: 9 kg, doc: of the slide}}
inputs: {push: {unit: N, default: 1 N}}
record: {every: 10 ms, signals: [slide.position, slide.velocity, both]}
blocks:
  spring: {block: Gain, u: slide.position, gain: -100 N/m}
  net: {block: Sum, u: [push, spring]}
  slide: {block: Mass, force: net, mass: $mass}
  both: {block: Mux, u: [slide.position, 2 m]}
figure:
  - {plot: lines, x: time in s, y: slide.position in mm, y_label: way}
  - {plot: path, x: slide.position in mm, y: slide.velocity in mm/s, color: time in s}
scene:
  view: {x: [-1 m, 1 m], y: [-1 m, 1 m]}
  objects:
    ball: {ball: [slide.position, 0 m], radius: 10 mm, color: {red: slide.position > 5 mm, else: blue}}
claims:
  - {that: it swings, spread: slide.position, at_least: 1 mm}
  - {that: it stays, max: slide.position, at_most: 0 mm}
  - {that: it is red at times, max: scene.ball.red, equals: 1, within: 0}
)";

/// Collector of the messages that are sent to pages.
struct Received {
  Sinks sinks() {
    return {[this](Json one) {
              const std::lock_guard lock(mutex);
              news.push_back(std::move(one));
            },
            [this](int page, std::string bytes) {
              const std::lock_guard lock(mutex);
              frames.emplace_back(page, std::move(bytes));
            }};
  }
  std::optional<Json> last(const std::string& kind) const {
    const std::lock_guard lock(mutex);
    for (auto one = news.rbegin(); one != news.rend(); ++one)
      if (*one->find("news")->as_text() == kind) return *one;
    return std::nullopt;
  }
  std::size_t frame_count() const {
    const std::lock_guard lock(mutex);
    return frames.size();
  }

  mutable std::mutex mutex;
  std::vector<Json> news;
  std::vector<std::pair<int, std::string>> frames;
};

struct Studio {
  explicit Studio(const std::string& text, std::optional<session::LoopSettings> loop = std::nullopt,
                  const std::string& out = "") {
    run.emplace(
        [text](int, bool hand) -> Loading {
          const auto loader = std::make_shared<diagram::Loader>(library());
          loader->add(yaml::parse_document(text, "swing.yaml"));
          return {
              hand ? load_for_page(*loader, "swing.yaml") : session::load_model(*loader, "swing.yaml", {}),
              [loader](const session::LoadOptions& options) {
                return session::load_model(*loader, "swing.yaml", options);
              },
              [loader](const std::string& file) -> const yaml::Document& { return loader->document(file); }};
        },
        received.sinks(), LiveOptions{std::move(loop), out});
  }
  Json call(const std::string& name, const std::string& arguments = "{}", int page = 1) {
    return run->call(page, name, Json::parse(arguments));
  }
  void run_to_end() {
    call("run.play", R"({"rate": 0})");
    wait_until([&] {
      const auto news = received.last("run");
      return news && *news->find("state")->as_text() == "ended";
    });
  }

  Received received;
  std::optional<LiveRun> run;
};

template <class Number>
Number number_at(const std::string& bytes, std::size_t place) {
  Number number;
  std::memcpy(&number, bytes.data() + place, sizeof(Number));
  return number;
}

inline const Json& at(const Json& list, std::size_t index) {
  return list.items()[index];
}

}  // namespace stepwire::live
