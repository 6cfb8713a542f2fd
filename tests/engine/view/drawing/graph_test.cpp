#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "blocks/register.hpp"
#include "engine/view/drawing/graph_faults.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::drawing {

namespace {

/// A spring-mass loop around a part, a constant and a part that nothing opens by itself.
void write_rig(const Scratch& folder) {
  folder.file(
      "spring.yaml",
      "stepwire: 1\ntitle: a spring\nparameters: {k: 2 N/m}\n"
      "inputs:\n  x: {unit: m}\n  rest: {unit: m, default: 1 mm}\noutputs: {force: gain, stretch: net}\n"
      "blocks:\n  net: {block: Sum, signs: \"-+\", u: [rest, x]}\n  gain: {block: Gain, gain: $k, u: net}\n");
  folder.file("rig.yaml",
              "stepwire: 1\ntitle: a rig\nstep: 1 ms\nstop: 0.1 s\nsolver: rk4\n"
              "blocks:\n  mount: {diagram: spring.yaml, x: body.position}\n"
              "  net: {block: Sum, signs: \"+--\", u: [2 N, mount.force, drag]}\n"
              "  body: {block: Mass, force: net}\n"
              "  drag: {block: Gain, gain: 0.5 N s/m, u: body.velocity}\n"
              "record: [body.position, mount.stretch]\n");
}

nlohmann::json graph(const std::string& file, const GraphOptions& options = {}) {
  const Registry registry = blocks();
  diagram::Loader loader(registry);
  return nlohmann::json::parse(DrawnFile(loader, file).view().graph(options).text());
}

std::vector<std::string> ids(const nlohmann::json& graph) {
  std::vector<std::string> found;
  for (const nlohmann::json& node : graph["nodes"]) found.push_back(node["id"]);
  return found;
}

std::string text(const nlohmann::json& end) {
  if (end.contains("constant")) return "'" + end["constant"].get<std::string>() + "'";
  const std::string node = end["node"], port = end["port"];
  return node + "." + port;
}

std::vector<std::string> wires(const nlohmann::json& graph) {
  std::vector<std::string> found;
  for (const nlohmann::json& wire : graph["wires"])
    found.push_back(text(wire["from"]) + " > " + text(wire["to"]));
  return found;
}

std::vector<std::string> ports(const nlohmann::json& list, const std::string& key = "port") {
  std::vector<std::string> found;
  for (const nlohmann::json& port : list) found.push_back(port.value(key, ""));
  return found;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a graph has every block and every wire of a file once, with ports in their order") {
  const Scratch folder;
  write_rig(folder);
  const nlohmann::json rig = graph(folder.path("rig.yaml"));
  CHECK(rig["title"] == "a rig");
  CHECK(ids(rig) == Names{"mount", "net", "body", "drag"});
  CHECK(wires(rig) == Names{"body.position > mount.x", "'2 N' > net.u.1", "mount.force > net.u.2",
                            "drag.y > net.u.3", "net.y > body.force", "body.velocity > drag.u"});
  CHECK(ports(rig["nodes"][0]["inputs"]) == Names{"x"});
  CHECK(ports(rig["nodes"][0]["outputs"]) == Names{"force", "stretch"});
  CHECK(ports(rig["nodes"][1]["inputs"], "sign") == Names{"+", "-", "-"});
  CHECK(ports(rig["nodes"][2]["outputs"]) == Names{"position", "velocity"});
  CHECK(rig["nodes"][2]["outputs"][0]["recorded"] == true);
  CHECK_FALSE(rig["nodes"][2]["outputs"][1].contains("recorded"));
  CHECK(rig["nodes"][0]["outputs"][1]["recorded"] == true);
}

TEST_CASE("an opened part has a graph of its own, with its default where nothing feeds it") {
  const Scratch folder;
  write_rig(folder);
  const nlohmann::json closed = graph(folder.path("rig.yaml"));
  CHECK_FALSE(closed["nodes"][0].contains("graph"));
  GraphOptions by_name, by_depth;
  by_name.open = {"mount"};
  by_depth.depth = 1;
  const nlohmann::json inside = graph(folder.path("rig.yaml"), by_name)["nodes"][0]["graph"];
  CHECK(ids(inside) == Names{"mount.net", "mount.gain"});
  CHECK(ports(inside["inputs"]) == Names{"x"});
  CHECK(ports(inside["outputs"]) == Names{"force", "stretch"});
  CHECK(wires(inside) == Names{"'1 mm' > mount.net.u.1", ".x > mount.net.u.2", "mount.net.y > mount.gain.u",
                               "mount.gain.y > .force", "mount.net.y > .stretch"});
  CHECK(graph(folder.path("rig.yaml"), by_depth)["nodes"][0]["graph"] == inside);
}

TEST_CASE("what decides whether a part runs is an input of it, with a wire from each signal of its formula") {
  const Scratch folder;
  write_rig(folder);
  folder.file("on.yaml",
              "stepwire: 1\ntitle: on and off\nstep: 1 ms\nstop: 0.1 s\nblocks:\n"
              "  a: {block: Clock}\n  b: {block: Clock}\n"
              "  mount: {diagram: spring.yaml, x: 1 m, enable: a > 20 ms && b < 1 s}\n"
              "  seen: {block: Gain, u: mount.active, trigger: a}\nrecord: [mount.force, seen]\n");
  const nlohmann::json drawn = graph(folder.path("on.yaml"));
  CHECK(ids(drawn) == Names{"a", "b", "mount", "seen"});
  CHECK(wires(drawn) == Names{"'1 m' > mount.x", "a.y > mount.enable.1", "b.y > mount.enable.2",
                              "mount.active > seen.u", "a.y > seen.trigger"});
  CHECK(drawn["nodes"][2]["inputs"][1]["condition"] == true);
  CHECK(drawn["nodes"][2]["inputs"][1]["label"] == "enable");
  CHECK_FALSE(drawn["nodes"][2]["inputs"][0].contains("condition"));
}

TEST_CASE("a part is drawn by itself with all of its ports, though it cannot run") {
  const Scratch folder;
  write_rig(folder);
  const nlohmann::json part = graph(folder.path("spring.yaml"));
  CHECK(part["title"] == "a spring");
  CHECK(ids(part) == Names{"net", "gain"});
  CHECK(ports(part["inputs"]) == Names{"x", "rest"});
  CHECK(ports(part["outputs"]) == Names{"force", "stretch"});
  CHECK(wires(part)[0] == ".rest > net.u.1");
}

TEST_CASE("wires carry units where they are wanted") {
  const Scratch folder;
  write_rig(folder);
  GraphOptions options;
  options.units = true;
  const nlohmann::json rig = graph(folder.path("rig.yaml"), options);
  CHECK(rig["wires"][0]["unit"] == "m");
  CHECK(rig["wires"][2]["unit"] == "N");
  CHECK_FALSE(graph(folder.path("rig.yaml"))["wires"][0].contains("unit"));
}

TEST_CASE("a file's parts are known by their names") {
  const Scratch folder;
  write_rig(folder);
  const Registry registry = blocks();
  diagram::Loader loader(registry);
  CHECK(DrawnFile(loader, folder.path("rig.yaml")).view().parts() == Names{"mount"});
  CHECK(DrawnFile(loader, folder.path("spring.yaml")).view().parts().empty());
}

namespace {

/// The graph with options, from the rig of write_rig().
nlohmann::json rig_with(const GraphOptions& options) {
  const Scratch folder;
  write_rig(folder);
  return graph(folder.path("rig.yaml"), options);
}

std::vector<GraphFault> faults_with(const GraphOptions& options) {
  const Scratch folder;
  write_rig(folder);
  const Registry registry = blocks();
  diagram::Loader loader(registry);
  return faults_of(DrawnFile(loader, folder.path("rig.yaml")).view(), options);
}

}  // namespace

TEST_CASE("a star in a pattern stands for any letters, also for none") {
  CHECK(follows_pattern("rig.energy", "rig.*"));
  CHECK(follows_pattern("rig.energy", "*energy"));
  CHECK(follows_pattern("rig.energy", "*g*e*y*"));
  CHECK(follows_pattern("work", "work*"));
  CHECK(follows_pattern("aab", "a*ab"));
  CHECK_FALSE(follows_pattern("rig.energy", "rig"));
  CHECK_FALSE(follows_pattern("rig", "rig.*"));
  CHECK_FALSE(follows_pattern("ab", "*a"));
}

TEST_CASE("what is hidden is left out with its wires and the ports at their ends") {
  const nlohmann::json without = rig_with({.hide = {"drag"}});
  CHECK(ids(without) == Names{"mount", "net", "body"});
  CHECK(wires(without) ==
        Names{"body.position > mount.x", "'2 N' > net.u.1", "mount.force > net.u.2", "net.y > body.force"});
  CHECK(ports(without["nodes"][1]["inputs"]) == Names{"u.1", "u.2"});
  CHECK(ports(without["nodes"][2]["outputs"]) == Names{"position"});
}

TEST_CASE("a hidden signal of a part has neither port nor wire, inside nor outside") {
  const nlohmann::json closed = rig_with({.hide = {"mount.stretch"}});
  CHECK(ports(closed["nodes"][0]["outputs"]) == Names{"force"});
  const nlohmann::json opened =
      rig_with({.open = {"mount"}, .hide = {"*.stretch", "mount.gain"}})["nodes"][0];
  CHECK(ids(opened["graph"]) == Names{"mount.net"});
  CHECK(opened["graph"]["outputs"].empty());
  CHECK(opened["outputs"].empty());
}

TEST_CASE("an input of an opened part that feeds hidden blocks only is left out") {
  const nlohmann::json rig = rig_with({.open = {"mount"}, .hide = {"mount.net"}});
  CHECK(ids(rig["nodes"][0]["graph"]) == Names{"mount.gain"});
  CHECK(rig["nodes"][0]["inputs"].empty());
  CHECK(wires(rig["nodes"][0]["graph"]) == Names{"mount.gain.y > .force"});
  CHECK(wires(rig).front() == "'2 N' > net.u.1");
}

TEST_CASE("labels, names and groups are handed on to what draws") {
  GraphOptions options{.open = {"mount"},
                       .labels = {{"net", "F"}, {"mount.force", "F_d"}, {"mount.net", "s"}}};
  options.names = {{"body", "mass"}, {"mount.gain", "spring"}};
  options.groups = {{"plant", {"body", "mount"}}};
  const nlohmann::json rig = rig_with(options);
  CHECK(ports(rig["nodes"][0]["outputs"], "mark") == Names{"F_d", ""});
  CHECK(ports(rig["nodes"][1]["outputs"], "mark") == Names{"F"});
  CHECK(ports(rig["nodes"][0]["graph"]["nodes"][0]["outputs"], "mark") == Names{"s"});
  CHECK(rig["nodes"][2]["id"] == "body");
  CHECK(rig["nodes"][2]["name"] == "mass");
  CHECK(rig["nodes"][0]["graph"]["nodes"][1]["name"] == "spring");
  CHECK(rig["groups"] == nlohmann::json::parse(R"([{"name": "plant", "members": ["body", "mount"]}])"));
  CHECK(faults_with(options).empty());
}

TEST_CASE("names that a drawing does not have are faults, each with what is near") {
  GraphOptions options{.open = {"moutn"}, .hide = {"darg", "x*"}, .names = {{"bdoy", "mass"}}};
  options.groups = {{"a", {"net", "nte"}}, {"b", {"net"}}};
  const auto faults = faults_with(options);
  REQUIRE(faults.size() == 6);
  CHECK(faults[0].message.text() == "there is no part 'moutn'; did you mean 'mount'? It has: mount");
  CHECK(
      faults[1].message.text().starts_with("there is no block, part or signal 'darg'; did you mean 'drag'?"));
  CHECK(faults[2].message.text().starts_with(
      "there is no block, part or signal 'x*'. It has: mount, mount.force"));
  CHECK(faults[3].message.text().starts_with("there is no block or part 'bdoy'; did you mean 'body'?"));
  CHECK(faults[4].message.text().starts_with(
      "there is no block or part of the file itself 'nte'; did you mean 'net'?"));
  CHECK(faults[5].message.text() == "'net' is in two groups; one can hold it");
}

TEST_CASE("a label on a signal that is not drawn, or on a block with several, is a fault") {
  const auto unknown = faults_with({.labels = {{"mount.forc", "F"}}});
  REQUIRE(unknown.size() == 1);
  CHECK(
      unknown[0].message.text().starts_with("there is no signal 'mount.forc'; did you mean 'mount.force'?"));
  const auto closed = faults_with({.labels = {{"mount.net", "s"}}});
  REQUIRE(closed.size() == 1);
  CHECK(closed[0].message.text().starts_with("no wire is drawn that is 'mount.net' alone"));
  CHECK(faults_with({.labels = {{"body", "x"}}}).size() == 1);
}

TEST_CASE("a block with a sample time of its own carries it as the file writes it") {
  const Scratch folder;
  folder.file(
      "rig.yaml",
      "stepwire: 1\ntitle: a rig\nstep: 1 ms\nstop: 0.1 s\nparameters: {turn: 2 ms}\nblocks:\n"
      "  a: {block: Gain, gain: 1, u: 1, every: 50 ms}\n"
      "  b: {block: Gain, gain: 1, u: a, every: {period: 4 ms, offset: 1 ms}}\n"
      "  c: {block: Gain, gain: 1, u: b, every: $turn}\n  d: {block: Gain, gain: 1, u: c}\nrecord: d\n");
  std::map<std::string, std::string> times;
  const nlohmann::json drawn = graph(folder.path("rig.yaml"));
  for (const nlohmann::json& node : drawn["nodes"])
    if (node.contains("every")) times[node["id"]] = node["every"];
  CHECK(times == std::map<std::string, std::string>{{"a", "50 ms"}, {"b", "4 ms + 1 ms"}, {"c", "2 ms"}});
}

}  // namespace stepwire::drawing
