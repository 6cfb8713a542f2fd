#pragma once

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/engine/app/cli/program.hpp"

/// The example of a study with people of one line: six draw under four conditions.
inline std::string small_study() {
  return content_of(STEPWIRE_SOURCE_DIR "/diagrams/examples/88-small-study.yaml");
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

inline nlohmann::json json_file(const Scratch& folder, const std::string& name) {
  return nlohmann::json::parse(content_of(folder.path(name)));
}
