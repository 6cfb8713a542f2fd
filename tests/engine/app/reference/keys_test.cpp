// The schema names keys that the readers of the file know by themselves; the readers' own messages tell
// whether both agree.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "blocks/register.hpp"
#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/app/reference/diagram_schema.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/view/scene/scene.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;
using nlohmann::json;

namespace {

using Words = std::set<std::string>;

Words keys_of_map(const json& schema) {
  Words keys;
  for (const auto& [key, value] : schema.at("properties").items()) keys.insert(key);
  return keys;
}

/// "...; Known are: a, b, c" as a set.
Words listed_in(const std::string& message, const std::string& mark) {
  const auto at = message.find(mark);
  INFO(message);
  REQUIRE(at != std::string::npos);
  std::istringstream list(message.substr(at + mark.size(), message.find('\n', at) - at - mark.size()));
  Words words;
  for (std::string word; std::getline(list, word, ',');)
    words.insert(word.substr(word.find_first_not_of(' ')));
  return words;
}

json schema() {
  static const Registry registry = blocks();
  return json::parse(diagram_schema(registry).text());
}

/// The keys that the loader knows where it refuses one, from its message.
Words known_to_loader(const std::string& yaml) {
  return listed_in(error_of(yaml), "Known are: ");
}

const std::string head = "step: 1 ms\nstop: 1 s\nblocks: {a: {block: Constant}}\n";

}  // namespace

TEST_CASE("the schema has the keys of the head that the loader has") {
  CHECK(known_to_loader(head + "bogus_key: 1\n") == keys_of_map(schema()));
}

TEST_CASE("the schema has the keys of parameters, ports, thesis and record that the loader has") {
  const json definitions = schema().at("$defs");
  CHECK(known_to_loader(head + "parameters: {p: {value: 1, bogus_key: 1}}\n") ==
        keys_of_map(definitions.at("parameter").at("anyOf").at(1)));
  CHECK(known_to_loader(head + "inputs: {p: {default: 1, bogus_key: 1}}\n") ==
        keys_of_map(definitions.at("input").at("anyOf").at(1)));
  CHECK(known_to_loader(head + "outputs: {p: {signal: a, bogus_key: 1}}\n") ==
        keys_of_map(definitions.at("output").at("anyOf").at(1)));
  CHECK(known_to_loader(head + "record: {signals: a, bogus_key: 1}\n") ==
        keys_of_map(definitions.at("record").at("anyOf").at(1)));
  CHECK(known_to_loader(head + "thesis: {figure: 1, bogus_key: 1}\n") ==
        keys_of_map(schema().at("properties").at("thesis")));
}

TEST_CASE("the schema has the keys of claims that their reader has") {
  Faults faults;
  const Document claims = parse_document("[{that: x, final: time, equals: 1, bogus_key: 1}]", "test.yaml");
  read_claims(claims.root, Claim::Kind::statement, {"test.yaml", {{"time", {}, {}}}}, faults);
  REQUIRE(faults.size() == 1);
  CHECK(listed_in(faults.list().front().message, "it has: ") ==
        keys_of_map(schema().at("$defs").at("claim")));
}

TEST_CASE("the schema has the keys of fits that their reader has") {
  const json fit = schema().at("properties").at("fit"), properties = fit.at("properties");
  const auto known = [](const std::string& yaml, const std::string& mark) {
    Faults faults;
    const Document document = parse_document(yaml, "test.yaml");
    Diagram diagram;
    diagram.parameters.push_back({"p", "1", {1.0}, {}, {}});
    read_fit(document.root, {"test.yaml", {{"time", {}, {}}}}, diagram, faults);
    for (const Fault& fault : faults.list())
      if (fault.message.find("bogus_key") != std::string::npos) return listed_in(fault.message, mark);
    return std::set<std::string>{};
  };
  CHECK(known("{bogus_key: 1}", "it has: ") == keys_of_map(fit));
  CHECK(known("{parameters: {p: {bogus_key: 1}}}", "it has: ") ==
        keys_of_map(properties.at("parameters").at("additionalProperties")));
  CHECK(known("{compare: [{bogus_key: 1}]}", "it has: ") ==
        keys_of_map(properties.at("compare").at("items")));
  CHECK(known("{global: {bogus_key: 1}}", "it has: ") == keys_of_map(properties.at("global")));
}

TEST_CASE("the schema has the keys of scenes that their reader has") {
  const json scene = schema().at("properties").at("scene"), properties = scene.at("properties");
  const auto known = [](const std::string& yaml) {
    Faults faults;
    const Document document = parse_document(yaml, "test.yaml");
    read_scene(document.root, {"test.yaml", {{"time", {}, {}}}}, faults);
    for (const Fault& fault : faults.list())
      if (fault.message.find("bogus_key") != std::string::npos) return listed_in(fault.message, "it has: ");
    return std::set<std::string>{};
  };
  CHECK(known("{bogus_key: 1}") == keys_of_map(scene));
  CHECK(known("{view: {bogus_key: 1}}") == keys_of_map(properties.at("view")));
  CHECK(known("{animation: {bogus_key: 1}}") == keys_of_map(properties.at("animation")));
  std::set<std::string> of_objects;
  for (const SceneKind& kind : scene_kinds())
    of_objects.merge(known("{objects: {a: {" + kind.name + ": x, bogus_key: 1}}}"));
  CHECK(of_objects == keys_of_map(properties.at("objects").at("additionalProperties")));
}
