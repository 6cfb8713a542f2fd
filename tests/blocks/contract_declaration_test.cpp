// Rules for the declaration of every block: it is complete and consistent. Checked from the declarations
// alone.
#include <catch2/catch.hpp>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "engine/app/reference/block_json.hpp"
#include "engine/app/reference/words.hpp"
#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/unit_expression.hpp"
#include "tests/blocks/contract_rig.hpp"

using namespace stepwire;

namespace {

using Words = std::set<std::string>;

/// Declared properties of a parameter, port or state.
struct Member {
  std::string name, unit, shape, doc;
};

template <class Specs>
void add(const Specs& specs, std::vector<Member>& members) {
  for (const auto& spec : specs) members.push_back({spec.name, spec.unit, spec.shape, spec.doc});
}

std::vector<Member> members_of(const BlockType& type) {
  std::vector<Member> members;
  add(type.parameters, members);
  add(type.inputs, members);
  add(type.outputs, members);
  add(type.states, members);
  return members;
}

bool is_clean(const std::string& doc) {
  const auto blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  return !doc.empty() && !blank(doc.front()) && !blank(doc.back()) && doc.find("  ") == std::string::npos;
}

Words unit_variables(const std::string& unit) {
  Words names;
  if (const auto expression = diagram::parse_unit_expression(unit))
    for (const auto& [name, exponent] : expression->variables) names.insert(name);
  return names;
}

/// "n x m" has the letters n and m, "+n" has n, "3" has none.
Words size_letters(const std::string& shape) {
  Words letters;
  std::istringstream words(shape);
  for (std::string word; words >> word;) {
    if (word.front() == '+') word.erase(0, 1);
    if (word != "x" && !word.empty() && std::isalpha(static_cast<unsigned char>(word.front())))
      letters.insert(word);
  }
  return letters;
}

std::vector<double> numbers_in(const Value& value) {
  if (const double* number = std::get_if<double>(&value.content)) return {*number};
  if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content))
    return {vector->begin(), vector->end()};
  if (const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content))
    return {matrix->data(), matrix->data() + matrix->size()};
  return {};
}

/// A bound that is absent is infinite and need not be in range.
bool is_allowed(const Range& range, double value) {
  return !std::isfinite(value) ||
         ((!range.above || value > *range.above) && (!range.below || value < *range.below) &&
          (!range.at_least || value >= *range.at_least) && (!range.at_most || value <= *range.at_most));
}

}  // namespace

TEST_CASE("a block's name is in Pascal case and its file is named alike") {
  for (const BlockType* type : library().types()) {
    INFO(type->name);
    CHECK(std::regex_match(type->name, std::regex("[A-Z][A-Za-z0-9]*")));
    const auto file =
        std::filesystem::path("blocks") / type->folder / (reference::snake_case(type->name) + ".hpp");
    CHECK(std::filesystem::exists(STEPWIRE_SOURCE_DIR / file));
  }
}

TEST_CASE("a block and each of its members are explained, without stray blanks") {
  for (const BlockType* type : library().types()) {
    INFO(type->name);
    CHECK(is_clean(type->doc));
    CHECK(type->doc.back() == '.');
    for (const Member& member : members_of(*type)) {
      INFO(member.name << ": '" << member.doc << "'");
      CHECK(is_clean(member.doc));
    }
    for (const DiagnosticSpec& diagnostic : type->diagnostics) CHECK(is_clean(diagnostic.doc));
    for (const PresetSpec& preset : type->presets) CHECK(is_clean(preset.doc));
  }
}

TEST_CASE(
    "units can be read, and what an output's unit is made of is known from inputs, parameters or states") {
  for (const BlockType* type : library().types()) {
    Words bound;
    for (const Member& member : members_of(*type)) {
      INFO(type->name << "." << member.name << " [" << member.unit << "]");
      CHECK(diagram::parse_unit_expression(member.unit).has_value());
    }
    for (const auto& spec : type->inputs) bound.merge(unit_variables(spec.unit));
    for (const auto& spec : type->parameters) bound.merge(unit_variables(spec.unit));
    for (const auto& spec : type->states) bound.merge(unit_variables(spec.unit));
    for (const OutputSpec& output : type->outputs)
      for (const std::string& name : unit_variables(output.unit)) {
        INFO(type->name << "." << output.name << ": '" << name);
        // A block that reads files takes the unit from there in configure().
        CHECK((bound.contains(name) || type->configure != nullptr));
      }
  }
}

TEST_CASE("sizes of outputs and states are numbers, or letters that inputs or parameters have") {
  for (const BlockType* type : library().types()) {
    Words known;
    for (const auto& spec : type->inputs) known.merge(size_letters(spec.shape));
    for (const auto& spec : type->parameters) known.merge(size_letters(spec.shape));
    std::vector<Member> made;
    add(type->outputs, made);
    add(type->states, made);
    for (const Member& member : made) {
      INFO(type->name << "." << member.name << " of size " << member.shape);
      CHECK(!member.shape.empty());
      // Sizes that no wire and no parameter defines can be set by configure().
      for (const std::string& letter : size_letters(member.shape))
        CHECK((known.contains(letter) || type->configure != nullptr));
    }
  }
}

TEST_CASE("an exact delay has a time, and an output that is like its input") {
  for (const BlockType* type : library().types()) {
    if (type->delayed_by.empty()) continue;
    INFO(type->name);
    REQUIRE(type->input(type->delayed_by) > 0);
    CHECK(type->inputs[static_cast<std::size_t>(type->input(type->delayed_by))].unit == "s");
    CHECK_FALSE(type->inputs[0].feedthrough);
    REQUIRE(type->outputs.size() == 1);
    CHECK(type->outputs[0].unit == type->inputs[0].unit);
    CHECK(type->outputs[0].shape == type->inputs[0].shape);
  }
}

TEST_CASE("no two keys of a block are the same, and none is one that every block has") {
  for (const BlockType* type : library().types()) {
    Words keys{"block", "diagram"};
    for (const std::string& key : diagram::keys_of(*type)) {
      INFO(type->name << "." << key);
      CHECK(std::regex_match(key, std::regex("[A-Za-z][A-Za-z0-9_]*")));
      CHECK(keys.insert(key).second);
    }
    Words signals;
    for (const OutputSpec& output : type->outputs)
      if (output.state != output.name) CHECK(signals.insert(output.name).second);
    for (const StateSpec& state : type->states) {
      INFO(type->name << "." << state.name);
      CHECK(signals.insert(state.name).second);
    }
  }
}

TEST_CASE("no parameter or input takes a name that the file format needs for itself") {
  for (const BlockType* type : library().types())
    for (const char* key : {"every", "preset", "block", "diagram"}) {
      INFO(type->name << "." << key);
      CHECK(type->parameter(key) == nullptr);
      CHECK(type->input(key) == -1);
    }
}

TEST_CASE("the default of a parameter is in its range and survives being set") {
  for (const BlockType* type : library().types())
    for (const ParameterSpec& spec : type->parameters) {
      INFO(type->name << "." << spec.name);
      AnyBlock block(*type);
      const Value value = spec.get(block.get());
      if (!spec.required)
        for (double number : numbers_in(value)) CHECK(is_allowed(spec.range, number));
      spec.set(block.get(), value);
      CHECK(reference::value_json(spec, spec.get(block.get())).text() ==
            reference::value_json(spec, value).text());
    }
}

TEST_CASE("a parameter with words has one for each value, and no other parameter has words") {
  for (const BlockType* type : library().types())
    for (const ParameterSpec& spec : type->parameters) {
      INFO(type->name << "." << spec.name);
      CHECK((spec.kind == ParameterKind::word) == !spec.words.empty());
      CHECK(Words(spec.words.begin(), spec.words.end()).size() == spec.words.size());
      if (spec.kind != ParameterKind::word) continue;
      AnyBlock block(*type);
      CHECK(std::get<double>(spec.get(block.get()).content) < static_cast<double>(spec.words.size()));
      for (std::size_t i = 0; i < spec.words.size(); ++i) {
        spec.set(block.get(), {static_cast<double>(i)});
        CHECK(std::get<double>(spec.get(block.get()).content) == static_cast<double>(i));
      }
    }
}

TEST_CASE("outputs are computed or are continuous states, and states have what moves them") {
  for (const BlockType* type : library().types()) {
    INFO(type->name);
    for (const OutputSpec& output : type->outputs) {
      INFO(output.name);
      const int state = type->state(output.state);
      if (output.state.empty()) CHECK(type->run_outputs);
      if (output.state.empty()) continue;
      REQUIRE(state >= 0);
      CHECK(type->states[static_cast<std::size_t>(state)].continuous);
    }
    for (const StateSpec& state : type->states) {
      INFO(state.name);
      CHECK((state.continuous ? bool(type->run_derivatives)
                              : type->run_update || type->run_outputs_at_instant));
    }
    if (!type->diagnostics.empty()) CHECK((type->run_update || type->run_outputs));
  }
}

TEST_CASE("a block can be made, copied, moved and destroyed") {
  for (const BlockType* type : library().types()) {
    INFO(type->name);
    AnyBlock block(*type);
    AnyBlock copy = block;
    AnyBlock moved = std::move(block);
    copy = moved;
    for (const ParameterSpec& spec : type->parameters)
      CHECK(reference::value_json(spec, spec.get(copy.get())).text() ==
            reference::value_json(spec, spec.get(moved.get())).text());
    for (const PresetSpec& preset : type->presets) preset.apply(copy.get());
  }
}

TEST_CASE("a block with diagnostics is judged at the last row, too") {
  // The update of a KalmanFilter judges the next tick, that of a unit makes the next step, and an Inverse and
  // a unit judge in their outputs.
  const Words others{"KalmanFilter", "Fmu", "Inverse"};
  for (const BlockType* type : library().types()) {
    INFO(type->name);
    if (!type->diagnostics.empty()) CHECK((type->at_end || others.contains(type->name)));
  }
}
