#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "blocks/register.hpp"
#include "engine/app/reference/diagram_schema.hpp"
#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/flatten.hpp"
#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/solve/solver.hpp"
#include "engine/view/plot/figure.hpp"
#include "tests/support/json_schema.hpp"

namespace stepwire::reference {

namespace {

const Registry& registry() {
  static const Registry all = blocks();
  return all;
}

const nlohmann::json& schema() {
  static const nlohmann::json parsed = nlohmann::json::parse(diagram_schema(registry()).text());
  return parsed;
}

std::string faults_of(const std::string& yaml) {
  return schema_faults(json_of(yaml::parse_document(yaml, "test.yaml").root), schema());
}

/// A diagram that fits but for what is added to it.
std::string diagram(const std::string& blocks, const std::string& more = "") {
  return "stepwire: 1\nstep: 1 ms\nstop: 1 s\nblocks:\n" + blocks + "\n" + more + "\n";
}

std::vector<std::filesystem::path> diagram_files() {
  std::vector<std::filesystem::path> files;
  const auto folder = std::filesystem::path(STEPWIRE_SOURCE_DIR) / "diagrams";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string in = entry.path().parent_path().filename().string();
    const bool is_diagram = in != "gallery" && in != "polar-rig";  // words of pages, and wires of a rig
    if (entry.path().extension() == ".yaml" && is_diagram) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("every diagram file of the repository fits the schema") {
  REQUIRE(diagram_files().size() > 5);
  for (const auto& file : diagram_files()) {
    INFO(file);
    CHECK(schema_faults(json_of(yaml::read_document(file.string()).root), schema()) == "");
  }
}

TEST_CASE("a flattened diagram fits the schema, guards and all") {
  for (const char* name : {"/102-two-drives.yaml", "/122-wrench.yaml"}) {
    const auto file = std::string(STEPWIRE_SOURCE_DIR "/diagrams/examples") + name;
    const diagram::Diagram flat = diagram::Loader(registry()).load(file);
    CHECK(faults_of(diagram::flattened_text(flat)) == "");
  }
}

TEST_CASE("every block is offered with its explanation and has all its keys") {
  const nlohmann::json& definitions = schema().at("$defs");
  const nlohmann::json& names = definitions.at("block").at("properties").at("block").at("anyOf");
  std::vector<const BlockType*> types = registry().types();
  types.insert(types.end(), diagram::guard_types().begin(), diagram::guard_types().end());
  CHECK(names.size() == types.size());
  for (const BlockType* type : types) {
    INFO(type->name);
    const nlohmann::json expected{{"const", type->name}, {"description", type->doc}};
    CHECK(std::find(names.begin(), names.end(), expected) != names.end());
    const nlohmann::json& properties = definitions.at("block." + type->name).at("properties");
    CHECK(properties.size() == diagram::keys_of(*type).size() + 2);  // block, and guard of flattened files
    for (const std::string& key : diagram::keys_of(*type)) {
      INFO(key);
      REQUIRE(properties.contains(key));
      CHECK(!properties.at(key).at("description").get<std::string>().empty());
    }
  }
}

TEST_CASE("every plot is offered and has all its keys") {
  for (const yaml::Key& plot : plot::plot_forms(true)) {
    INFO(plot.name);
    const nlohmann::json& properties = schema().at("$defs").at("plot." + plot.name).at("properties");
    for (const yaml::Key& key : plot.of) CHECK(properties.contains(key.name));
    CHECK(properties.contains("caption"));
    const std::set<std::string> pictures{"diagram", "rig", "scene", "table"};  // that are no panels of others
    const bool alone = pictures.contains(plot.name);
    const nlohmann::json& definitions = schema().at("$defs");
    REQUIRE(definitions.contains("panel." + plot.name) == !alone);
    if (!alone) CHECK_FALSE(definitions.at("panel." + plot.name).at("properties").contains("caption"));
  }
}

TEST_CASE("every solver is offered") {
  const nlohmann::json& forms = schema().at("properties").at("solver").at("anyOf");  // a name, or a map
  CHECK(forms.at(0).at("anyOf").size() == solve::solver_kinds().size());
  CHECK(forms.at(1).at("properties").contains("relative"));
}

TEST_CASE("an unknown key of a block, a missing input and an unknown block do not fit") {
  CHECK(faults_of(diagram("  a: {block: Lag, u: 1}")) == "");
  CHECK(faults_of(diagram("  a: {block: Lag, u: 1, tua: 1}")) == "/blocks/a/tua: is not allowed\n");
  CHECK(faults_of(diagram("  a: {block: Lag}")) == "/blocks/a: lacks \"u\"\n");
  CHECK(faults_of(diagram("  a: {block: Lagg, u: 1}")).starts_with("/blocks/a/block: "));
  CHECK(faults_of(diagram("  a: {u: 1}")) != "");
}

TEST_CASE(
    "a parameter takes numbers, units, parameters and expressions, but no truth and nothing out of range") {
  for (const char* good :
       {"0.5", "0.5 s", "$tau", "tau", "2*tau", "= 2*tau", "{value: 5, unit: ms}", "[1 s, 2 s]"}) {
    INFO(good);
    CHECK(faults_of(diagram(std::string("  a: {block: Lag, u: 1, tau: ") + good + "}")) == "");
  }
  for (const char* bad : {"\" \"", "-1", "0", "true", "{value: 5, unti: ms}"}) {
    INFO(bad);
    CHECK(faults_of(diagram(std::string("  a: {block: Lag, u: 1, tau: ") + bad + "}")) != "");
  }
}

TEST_CASE("a part takes any key, since its keys stand in its own file") {
  CHECK(faults_of(diagram("  a: {diagram: part.yaml, force: 1 N, mass: 2 kg}")) == "");
  CHECK(faults_of(diagram("  a: {diagram: part.yaml, block: Lag, u: 1}")) != "");
}

TEST_CASE("names of blocks and of recorded signals may have dots") {
  CHECK(faults_of(diagram("  rig.a: {block: Lag, u: 1}")) == "");
  CHECK(faults_of(diagram("  rig.1: {block: Lag, u: 1}")) != "");
  const std::string lag = "  a: {block: Lag, u: 1}";
  CHECK(faults_of(diagram(lag, "record: {signals: {rig.x: a}}\nunits: {a: N, a.y: 1}")) == "");
  CHECK(faults_of(diagram(lag, "record: {signals: [a, {rig.x: a}]}")) == "");
  CHECK(faults_of(diagram(lag, "record: {signals: [a, {1: a}]}")) != "");
}

TEST_CASE("a claim has one reduction and one comparison, and within goes with equals") {
  const std::string lag = "  a: {block: Lag, u: 1}";
  CHECK(faults_of(diagram(lag, "claims: [{that: x, final: a, equals: 2/3, within: 1e-3}]")) == "");
  CHECK(faults_of(diagram(
            lag, "claims: [{that: x, fit: [a, a], offset: free, each_run: true, at_least: 90}]")) == "");
  CHECK(faults_of(diagram(lag, "claims: [{that: x, final: a, offset: free, at_least: 90}]")) != "");
  CHECK(faults_of(diagram(lag, "claims: [{that: x, final: a, max: a, equals: 1}]")) != "");
  CHECK(faults_of(diagram(lag, "claims: [{that: x, final: a}]")) != "");
  CHECK(faults_of(diagram(lag, "claims: [{that: x, final: a, at_most: 1, within: 1}]")) != "");
  CHECK(faults_of(diagram(lag, "claims: [{final: a, at_most: 1}]")) != "");
}

TEST_CASE("a swept parameter has values, a range or one distribution, and a design how many samples") {
  const auto sweep = [](const std::string& keys) {
    return faults_of(diagram("  c: {block: Constant, value: 1}", "sweep: {" + keys + "}"));
  };
  CHECK(sweep("c.value: {uniform: [1, 2]}, design: {samples: 5, kind: sobol, seed: 3}, keep: final") == "");
  CHECK(sweep("c.value: {words: {1: 3, 2: 1}}, design: {samples: 5}, keep: {peak: max(c)}") == "");
  CHECK(sweep("c.value: {normal: [1, 2]}, correlation: {c.value: {d: 0.5}}, design: {samples: 5}") == "");
  CHECK(sweep("c.value: {uniform: [1, 2], normal: [1, 2]}, design: {samples: 5}") != "");
  CHECK(sweep("c.value: {uniform: [1, 2, 3]}, design: {samples: 5}") != "");
  CHECK(sweep("c.value: {uniform: [1, 2]}, design: {kind: sobol}") != "");
  CHECK(sweep("c.value: {uniform: [1, 2]}, design: {samples: 0}") != "");
  CHECK(sweep("c.value: {uniform: [1, 2]}, design: {samples: 5, kind: sobel}") != "");
  CHECK(sweep("c.value: [1, 2], keep: everything") != "");
}

TEST_CASE("a picture has one plot or several panels") {
  const std::string lag = "  a: {block: Lag, u: 1}";
  CHECK(faults_of(diagram(
            lag, "figure: {plot: lines, x: time, y: [a, {signal: a in 1, label: b}], size: [640, 420]}")) ==
        "");
  CHECK(faults_of(diagram(lag, "figure: [{panels: [{plot: lines, x: time, y: a}], columns: 1}]")) == "");
  CHECK(faults_of(diagram(lag, "figure: {plot: lines, x: time, y: a, wiht: 3}")) != "");
  CHECK(faults_of(diagram(lag, "figure: {plot: line, x: time, y: a}")) != "");
  CHECK(faults_of(diagram(lag, "figure: {panels: [{plot: lines, x: time, y: a, caption: b}]}")) != "");
}

TEST_CASE("a file that is run says for how long, a part need not") {
  const std::string blocks = "stepwire: 1\nblocks: {a: {block: Lag, u: 1}}\n";
  CHECK(faults_of(blocks) != "");
  CHECK(faults_of(blocks + "outputs: {y: a}\n") == "");
  CHECK(faults_of(diagram("  a: {block: Lag, u: 1}", "setp: 1 ms")) == "/setp: is not allowed\n");
}

}  // namespace stepwire::reference
