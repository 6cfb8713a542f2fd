// Files that are no models, or that would do harm.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "engine/app/simulink/read_model.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/yaml/error.hpp"
#include "tests/engine/app/simulink/slx.hpp"

using Catch::Contains;

namespace stepwire::simulink {

namespace {

std::string refusal(const std::string& path) {
  try {
    read_model(path);
  } catch (const yaml::Error& error) {
    return error.what();
  }
  return "";
}

std::string refusal_of(const testing::Entries& entries) {
  const Scratch folder;
  return refusal(testing::write_zip(folder.path("a.slx"), entries));
}

testing::Entries changed(const std::string& file, const std::string& text) {
  testing::Entries entries = entries_of({number(1, "1")});
  entries[file] = text;
  return entries;
}

}  // namespace

TEST_CASE("what is no model is refused in one sentence") {
  const Scratch folder;
  CHECK_THAT(refusal(folder.path("none.slx")), Contains("there is no such file"));
  CHECK_THAT(refusal(folder.file("a.slx", "no archive")), Contains("a Simulink model is a zip archive"));
  CHECK_THAT(refusal(folder.file("a.mdl", "Model {\n  Name \"a\"\n}")),
             Contains("old text format; save it as .slx"));
  CHECK_THAT(refusal_of({{"a.txt", "x"}}), Contains("has no simulink/blockdiagram.xml"));
  CHECK_THAT(refusal_of({{"simulink/blockdiagram.xml", "<A/>"}}), Contains("has no <Model>"));
}

TEST_CASE("a library, a model without a system and a cut archive are refused with their cause") {
  const std::string main = "simulink/blockdiagram.xml";
  CHECK_THAT(refusal_of({{main, "<ModelInformation><Library><System/></Library></ModelInformation>"}}),
             Contains("is a library of blocks, and no model"));
  CHECK_THAT(refusal_of({{main, "<ModelInformation><Model/></ModelInformation>"}}),
             Contains("has no <System>"));
  CHECK_THAT(refusal_of({{main, "<ModelInformation><Model><Sys"}}),
             Contains("has a damaged simulink/blockdiagram.xml"));
  const Scratch folder;
  const std::string whole =
      io::read_file(testing::write_zip(folder.path("a.slx"), entries_of({number(1, "1")})));
  for (const std::size_t length : {std::size_t{0}, std::size_t{4}, whole.size() / 2, whole.size() - 10})
    CHECK_THAT(refusal(folder.file("cut.slx", whole.substr(0, length))), Contains("zip archive"));
}

TEST_CASE("damaged and hostile XML is refused") {
  CHECK_THAT(refusal_of(changed("simulink/systems/system_root.xml", "<System><Block")),
             Contains("has a damaged simulink/systems/system_root.xml"));
  const std::string laughs =
      "<!DOCTYPE a [<!ENTITY b \"bbbb\"><!ENTITY c \"&b;&b;&b;\">]><System>&c;</System>";
  CHECK_THAT(refusal_of(changed("simulink/systems/system_root.xml", laughs)),
             Contains("has a document type"));
  CHECK_THAT(refusal_of(changed("../evil.xml", "x")), Contains("leads out of the archive"));
}

TEST_CASE("systems that refer to each other or to nothing are refused") {
  const std::string loop =
      "<System><Block BlockType=\"SubSystem\" Name=\"A\" SID=\"1\"><System "
      "Ref=\"system_root\"/></Block></System>";
  CHECK_THAT(refusal_of(changed("simulink/systems/system_root.xml", loop)),
             Contains("twice; systems form a tree"));
  const std::string missing =
      "<System><Block BlockType=\"SubSystem\" Name=\"A\" SID=\"1\"><System "
      "Ref=\"system_9\"/></Block></System>";
  CHECK_THAT(refusal_of(changed("simulink/systems/system_root.xml", missing)),
             Contains("refers to the system 'system_9'"));
  std::string deep;
  for (int i = 0; i < 80; ++i) deep += "<System><Block BlockType=\"SubSystem\" Name=\"A\">";
  for (int i = 0; i < 80; ++i) deep += "</Block></System>";
  CHECK_THAT(refusal_of(changed("simulink/systems/system_root.xml", deep)), Contains("more than 60 deep"));
}

TEST_CASE("a zip bomb is refused before it is unpacked", "[full]") {
  testing::Entries entries = entries_of({number(1, "1")});
  for (int i = 0; i < 17; ++i) entries[fmt::format("media/{}", i)] = std::string(std::size_t{16} << 20, '\0');
  CHECK_THAT(refusal_of(entries), Contains("a Simulink model of its size may unpack to 256 MiB"));
}

TEST_CASE("lines from nowhere and loops of wires are faults with a place") {
  const Imported imported(ModelText{block("ToWorkspace", "W", 2, {{"VariableName", "y"}}) +
                                    block("Gain", "G", 3) + line("77#out:1", {"2#in:1", "3#in:1"})});
  CHECK_THAT(imported.notes(NoteKind::fault),
             Contains("has a line from a block '77' that is not in the file"));
  const std::string tags = block("From", "F", 1, {{"GotoTag", "a"}}) +
                           block("Goto", "G", 2, {{"GotoTag", "a"}}) + block("ToWorkspace", "W", 3) +
                           line("1#out:1", {"2#in:1", "3#in:1"});
  CHECK_THAT(Imported(ModelText{tags}).notes(NoteKind::fault),
             Contains("has a loop of wires without any block in it"));
}

TEST_CASE("ten thousand blocks are imported in seconds", "[full]") {
  std::string system = number(1, "1");
  for (int i = 2; i <= 10'000; ++i)
    system += block("Gain", "Gain", i, {{"Gain", "1"}}) +
              line(fmt::format("{}#out:1", i - 1), {fmt::format("{}#in:1", i)});
  system += block("ToWorkspace", "W", 10'001, {{"VariableName", "y"}}) + line("10000#out:1", {"10001#in:1"});
  ModelText model{system};
  model.solver["StopTime"] = "0.02";
  CHECK(Imported(model).last("y") == 1.0);
}

}  // namespace stepwire::simulink
