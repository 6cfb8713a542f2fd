#pragma once

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "blocks/register.hpp"
#include "engine/app/studio/studio.hpp"
#include "tests/engine/app/cli/program.hpp"
#include "tests/engine/app/studio/raw_client.hpp"

namespace stepwire::studio {

inline const std::string gain_yaml = R"(stepwire: 1
title: A gain
step: 1 ms
stop: 1 s
blocks:
  one: {block: Constant, value: 1 N}
  two: {block: Gain, u: one, gain: 2}
  rig: {diagram: parts/rig.yaml, u: two}
record: [rig.y]
)";
inline const std::string rig_yaml = R"(stepwire: 1
inputs: {u: {}}
outputs: {y: half}
blocks:
  half: {block: Gain, u: u, gain: 0.5}
)";

/// A studio with two files, whose drafts are the test's own.
class Started {
 public:
  explicit Started(const std::string& text = gain_yaml) {
    std::filesystem::create_directories(folder.path("home/parts"));
    std::filesystem::create_directories(folder.path("outside"));
    folder.file("home/gain.yaml", text);
    folder.file("home/parts/rig.yaml", rig_yaml);
    folder.file("outside/secret.yaml", rig_yaml);
    ::setenv("XDG_STATE_HOME", folder.path("state").c_str(), 1);
    start();
  }
  ~Started() { ::unsetenv("XDG_STATE_HOME"); }
  void start() {
    studio.reset();
    studio = std::make_unique<Studio>(StudioCall{folder.path("home/gain.yaml")}, registry);
    const std::string address = studio->address();
    key = {static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))),
           address.substr(address.find('=') + 1)};
  }

  Scratch folder;
  Registry registry = blocks();
  std::unique_ptr<Studio> studio;
  http::Key key;
};

inline const json::Json& result(const json::Json& answer) {
  INFO(answer.text(-1));
  REQUIRE(answer.find("result"));
  return *answer.find("result");
}

inline std::string text(const json::Json& object, const std::string& name) {
  const json::Json* found = object.find(name);
  return found && found->as_text() ? *found->as_text() : "";
}

inline std::string fault(const json::Json& answer) {
  return answer.find("fault") ? text(*answer.find("fault"), "text") : "";
}

inline json::Json arguments(int file) {
  return json::Json::object().set("file", file);
}

inline json::Json edit(int file, int version, std::size_t from, std::size_t to, const std::string& put) {
  const json::Json change = json::Json::object().set("from", from).set("to", to).set("text", put);
  return arguments(file).set("version", version).set("changes", json::Json::list({change}));
}

}  // namespace stepwire::studio
