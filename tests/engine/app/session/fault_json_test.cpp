#include "engine/app/session/fault_json.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "blocks/register.hpp"
#include "engine/app/session/session.hpp"
#include "tests/engine/app/cli/program.hpp"

namespace stepwire::session {

namespace {

/// Returns the faults of a file as JSON.
nlohmann::json faults_of(const Scratch& folder, const std::string& file) {
  static const Registry registry = blocks();
  try {
    Session(registry).load(folder.path(file));
  } catch (const yaml::Error& error) {
    return nlohmann::json::parse(faults_json(error.faults()).text());
  }
  return nlohmann::json::array();
}

const std::string head = "stepwire: 1\ntitle: t\nstep: 1 ms\nstop: 1 s\nsolver: rk4\nrecord: all\n";

}  // namespace

TEST_CASE("a fault as data has the place and the end of what is wrong, the block, the port, and the cure") {
  const Scratch folder;
  folder.file("a.yaml", head +
                            "blocks:\n  one: {block: Constant, value: 1}\n  gain:\n    block: Gain\n    "
                            "gain: \"two\"\n    u: on\n");
  const nlohmann::json faults = faults_of(folder, "a.yaml");
  REQUIRE(faults.size() == 2);
  const nlohmann::json& gain = faults[0];
  CHECK(gain["file"] == folder.path("a.yaml"));
  CHECK(gain["line"] == 11);
  CHECK(gain["column"] == 11);
  CHECK(gain["end"] == nlohmann::json{{"line", 11}, {"column", 16}});  // behind the closing quote
  CHECK(gain["block"] == "gain");
  CHECK(gain["port"] == "gain");
  CHECK(gain["subject"] == "gain.gain");
  const nlohmann::json& wire = faults[1];
  CHECK(wire["text"] == "there is no block 'on'");
  CHECK(wire["cure"] == "did you mean 'one'?");
  CHECK(wire["end"] == nlohmann::json{{"line", 12}, {"column", 10}});
  CHECK(wire["port"] == "u");
}

TEST_CASE("a fault in a part names the block by its whole name, and who uses the part") {
  const Scratch folder;
  folder.file(
      "spring.yaml",
      "stepwire: 1\ntitle: a spring\ninputs: {x: {unit: m}}\noutputs: {force: k}\nblocks:\n  k: {block: "
      "Gain, gain: -, u: x}\n");
  folder.file("a.yaml",
              head + "blocks:\n  x: {block: Constant, value: 1 m}\n  rig: {diagram: spring.yaml, x: x}\n");
  const nlohmann::json faults = faults_of(folder, "a.yaml");
  REQUIRE(faults.size() == 1);
  CHECK(faults[0]["file"] == folder.path("spring.yaml"));
  CHECK(faults[0]["block"] == "rig.k");
  CHECK(faults[0]["port"] == "gain");
  CHECK(faults[0]["used_by"][0]["line"] == 9);
}

TEST_CASE("characters, not bytes, are counted up to the end of what is wrong") {
  const Scratch folder;
  folder.file("a.yaml", head + "blocks:\n  a: {block: Constant, value: '1 \xC2\xB5\xC2\xB5'}\n");
  const nlohmann::json faults = faults_of(folder, "a.yaml");
  REQUIRE(faults.size() == 1);
  CHECK(faults[0]["end"]["column"].get<int>() - faults[0]["column"].get<int>() == 6);
}

TEST_CASE("a word that was probably meant has the place in which it belongs") {
  const Scratch folder;
  folder.file("a.yaml", head +
                            "blocks:\n  one: {block: Constant, value: 1}\n  gain: {block: Gain, gain: 2, "
                            "u: oen}\n");
  const nlohmann::json faults = faults_of(folder, "a.yaml");
  REQUIRE(faults.size() == 1);
  REQUIRE(faults[0]["suggestions"].size() == 1);
  const nlohmann::json& suggestion = faults[0]["suggestions"][0];
  CHECK(suggestion["text"] == "one");
  CHECK(suggestion["line"] == 9);
  CHECK(suggestion["column"] == 35);
  CHECK(suggestion["end"] == nlohmann::json({{"line", 9}, {"column", 38}}));
}

TEST_CASE("what stands outside of the blocks has no block, and a setting of a call no line") {
  const Scratch folder;
  folder.file("a.yaml",
              "stepwire: 1\ntitle: t\nstep: 0 s\nstop: 1 s\nblocks:\n  a: {block: Constant, value: 1}\n");
  const nlohmann::json faults = faults_of(folder, "a.yaml");
  REQUIRE_FALSE(faults.empty());
  CHECK(faults[0]["block"].is_null());
  CHECK(faults[0]["line"] == 3);
  const nlohmann::json call =
      nlohmann::json::parse(faults_json({yaml::Fault{{"--set tau=x", {}}, "tau", "what; that", {}}}).text());
  CHECK(call[0]["line"].is_null());
  CHECK(call[0]["end"].is_null());
  CHECK(call[0]["cure"] == "that");
}

TEST_CASE("a fault of the call has that for its place") {
  const Scratch folder;
  folder.file("a.yaml", head + "parameters: {m: 1 kg}\nblocks:\n  a: {block: Constant, value: $m}\n");
  const Done done = run_program(folder, {"check", "a.yaml", "--set", "m=2*3kg", "--json"});
  CHECK(done.code == 2);
  const nlohmann::json fault = nlohmann::json::parse(done.out)[0]["faults"][0];
  CHECK(fault["call"] == "--set m=2*3kg");
  CHECK(fault["file"].is_null());
  CHECK(fault["text"] == "'2*3kg' is no number");
  CHECK(fault["cure"] == "write one, as 2 kg, and '=' before what is computed");
  const Done empty = run_program(folder, {"check", "a.yaml", "--set", "m=", "--json"});
  CHECK(empty.code == 2);
  CHECK(nlohmann::json::parse(empty.out)[0]["faults"][0]["call"] == "--set m=");
}

}  // namespace stepwire::session
