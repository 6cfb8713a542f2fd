#include "tests/engine/app/difference/comparing.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <sstream>

#include "blocks/register.hpp"
#include "engine/app/difference/difference_text.hpp"

namespace stepwire::difference {

const std::string loop_yaml = R"yaml(stepwire: 1
title: A mass on a spring
step: 1 ms
stop: 1 s
solver: rk4
parameters:
  stiffness: {value: 400 N/m, doc: of the spring}
  weight: 2 kg
blocks:
  push:   {block: Sine, amplitude: 3 N, frequency: 2 Hz}
  spring: {block: Gain, u: body.position, gain: = -stiffness}
  sum:    {block: Sum, u: [push, spring]}
  body:   {block: Mass, force: sum, mass: $weight}
record: [body.position, spring]
figure: {plot: lines, x: time in s, y: body.position in mm}
claims:
  - {that: it moves, max: body.position, at_least: 1 mm}
  - {that: it stays near, max: abs(body.position), at_most: 0.5 m}
)yaml";

const Registry& every_block() {
  static const Registry registry = blocks();
  return registry;
}

Difference compared(const std::string& before, const std::string& after, const GivenFiles& old_parts,
                    const GivenFiles& new_parts) {
  Texts old_texts, new_texts;
  for (const auto& [path, text] : old_parts) old_texts.give(path, text);
  for (const auto& [path, text] : new_parts) new_texts.give(path, text);
  old_texts.give("model.yaml", before);
  new_texts.give("model.yaml", after);
  Comparer comparer(every_block(), old_texts, new_texts);
  comparer.compare("model.yaml", "model.yaml");
  return comparer.result();
}

std::vector<std::string> lines(const Difference& difference) {
  std::vector<std::string> found;
  std::istringstream text(text_of(difference));
  for (std::string line; std::getline(text, line);)
    if (line.starts_with("    ")) found.push_back(line.substr(4, line.rfind("  [") - 4));
  return found;
}

std::vector<std::string> lines(const std::string& before, const std::string& after) {
  return lines(compared(before, after));
}

std::vector<std::string> all_diagrams() {
  std::vector<std::string> files;
  const std::string folder = std::string(STEPWIRE_SOURCE_DIR) + "/diagrams";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  std::ranges::sort(files);
  return files;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace stepwire::difference
