// Files that are no units, or that this machine cannot run, are refused in one sentence.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "engine/base/fmi/package.hpp"
#include "engine/base/fmi/runner.hpp"
#include "engine/base/fmi/unit_error.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/units/units.hpp"

namespace stepwire::fmi {
using testing::Entries;
using testing::unit_of_3;
using testing::write_zip;

namespace {

std::string refusal(const std::string& path) {
  try {
    open_package(path);
  } catch (const UnitError& error) {
    return error.what();
  }
  return "";
}

std::string refusal_of(const Entries& entries) {
  const Scratch scratch;
  return refusal(write_zip(scratch.path("unit.fmu"), entries));
}

Entries replaced(const std::string& what, const std::string& by) {
  Entries entries = unit_of_3("dahlquist");
  std::string& xml = entries.at("modelDescription.xml");
  xml.replace(xml.find(what), what.size(), by);
  return entries;
}

bool holds(const std::string& text, const std::string& part) {
  INFO(text);
  CHECK(text.find(part) != text.npos);
  return text.find(part) != text.npos;
}

}  // namespace

TEST_CASE("a small unit is read: its version, its variables and their units") {
  const Scratch scratch;
  const auto package = open_package(write_zip(scratch.path("unit.fmu"), unit_of_3("dahlquist")));
  const Description& description = package->description();
  CHECK(description.version == 3);
  CHECK(description.state_count == 1);
  REQUIRE(description.find(3));
  CHECK(description.find(3)->name == "k");
  CHECK(description.find(3)->at_most == 100.0);
}

TEST_CASE("an archive whose paths lead out of it is refused, and nothing of it is written") {
  Entries entries = unit_of_3("dahlquist");
  for (const char* path :
       {"../evil.txt", "resources/../../evil.txt", "/evil.txt", "resources\\..\\evil.txt"}) {
    Entries with = entries;
    with[path] = "evil";
    holds(refusal_of(with), "leads out of the archive");
  }
}

TEST_CASE("what is no archive, or a broken one, is refused") {
  const Scratch scratch;
  holds(refusal(scratch.file("text.fmu", "no archive")), "a unit is a zip archive");
  holds(refusal(scratch.path("missing.fmu")), "there is no file");
  const std::string whole = write_zip(scratch.path("unit.fmu"), unit_of_3("dahlquist"));
  std::ifstream file(whole, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(file), {});
  holds(refusal(scratch.file("half.fmu", bytes.substr(0, bytes.size() / 2))), "a unit is a zip archive");
}

TEST_CASE("an archive that unpacks to too many bytes or files is refused, and nothing of it is unpacked",
          "[full]") {
  Entries large = unit_of_3("dahlquist"), many = large;
  for (int i = 0; i < 17; ++i)
    large[fmt::format("resources/{}", i)] = std::string(std::size_t{16} << 20, '\0');
  holds(refusal_of(large), "unpacks to 272 MiB or more, and a unit of its size may unpack to 256 MiB");
  for (int i = 0; i < 20'000; ++i) many[fmt::format("resources/{}", i)] = "";
  holds(refusal_of(many), fmt::format("has {} entries, and a unit may have 20000", many.size()));
}

TEST_CASE("a unit without a description, of another version, or without a binary is refused") {
  Entries entries = unit_of_3("dahlquist");
  Entries bare = entries;
  bare.erase("modelDescription.xml");
  holds(refusal_of(bare), "it has no modelDescription.xml");
  holds(refusal_of(replaced("fmiVersion=\"3.0\"", "fmiVersion=\"1.0\"")), "fmiVersion \"1.0\"");
  holds(refusal_of(replaced("<ModelVariables>", "<ModelVariables")), "is no XML");
  const Entries description{{"modelDescription.xml", entries.at("modelDescription.xml")}};
  holds(refusal_of(description), "no binaries at all");
  Entries other = description;
  other["binaries/x86_64-windows/unit.dll"] = "MZ";
  holds(refusal_of(other), "binaries for x86_64-windows, and none for this platform");
  holds(refusal_of(replaced("modelIdentifier=\"unit\"", "modelIdentifier=\"../unit\"")), "no name of C");
}

TEST_CASE("a token that is another one is refused with the unit's reason") {
  const Scratch scratch;
  const auto package =
      open_package(write_zip(scratch.path("unit.fmu"),
                             replaced("instantiationToken=\"dahlquist\"", "instantiationToken=\"other\"")));
  const auto runner = make_runner({package, Mode::co_simulation, "unit"}, false);
  CHECK_FALSE(runner->run(Operation::start));
  holds(runner->exchange().message, "the token is another one");
}

TEST_CASE("a state that is saved is restored, inside and in a process of its own") {
  for (const bool isolated : {false, true}) {
    const Scratch scratch;
    const auto package = open_package(write_zip(scratch.path("unit.fmu"), unit_of_3("dahlquist")));
    const auto runner = make_runner({package, Mode::co_simulation, "unit"}, isolated, 64);
    Exchange& exchange = runner->exchange();
    exchange.length = 0.1;
    REQUIRE(runner->run(Operation::start));
    REQUIRE(exchange.kept_numbers <= 64);
    REQUIRE(runner->run(Operation::step));
    const std::vector<double> saved(exchange.kept(), exchange.kept() + 64);
    const double after_one = exchange.outputs()[0];
    REQUIRE(runner->run(Operation::step));
    const double after_two = exchange.outputs()[0];
    std::ranges::copy(saved, exchange.kept());
    REQUIRE(runner->run(Operation::load));
    REQUIRE(runner->run(Operation::step));
    CHECK(exchange.outputs()[0] == after_two);
    CHECK(after_one == 0.9);
  }
}

}  // namespace stepwire::fmi
