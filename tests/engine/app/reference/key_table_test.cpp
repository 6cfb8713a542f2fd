// Effects of a table of keys: the reader of its section, its schema and its page.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "engine/app/reference/format_page.hpp"
#include "engine/app/reference/key_schema.hpp"
#include "engine/base/yaml/section.hpp"

namespace stepwire::reference {
using Catch::Contains;

namespace {

// A table of the test's own, as one for a section is written.
struct Lamp {
  double power = 5.0;
  bool on = false;
  std::size_t count = 2;
  std::string name = "lamp";
  enum class Color { white, red } color = Color::white;
};

using LampTable = yaml::KeyTable<Lamp, yaml::SectionReading>;

LampTable lamp_table(std::vector<LampTable::Row> more) {
  std::vector<LampTable::Row> rows{
      {"power", "what it takes", yaml::form::above_zero(yaml::form::number()), &Lamp::power},
      {"on", "true: it shines", yaml::form::truth(), &Lamp::on},
      {"count", "how many there are", yaml::form::whole(1, 9), &Lamp::count}};
  rows.insert(rows.end(), more.begin(), more.end());
  return {"a lamp", "{power: 3}", std::move(rows)};
}

std::vector<std::string> read_lamp(const LampTable& table, const std::string& yaml, Lamp& lamp) {
  std::vector<std::string> faults;
  const yaml::SectionReading read(
      "lamp", [&](const yaml::Mark&, const std::string& subject, const yaml::Message& message) {
        faults.push_back(subject + ": " + message.text());
      });
  table.read(yaml::parse_document(yaml, "test.yaml").root, lamp, read);
  return faults;
}

const LampTable::Row name_row{"name", "text on it", yaml::form::text(), &Lamp::name};
const LampTable::Row color_row{"color", "in which it shines", yaml::form::word({"white", "red"}),
                               &Lamp::color};

}  // namespace

TEST_CASE("a row that is added to a table is read, described by the schema and shown on the page") {
  Lamp lamp;
  CHECK_THAT(read_lamp(lamp_table({}), "{name: desk}", lamp).at(0), Contains("a lamp has no 'name'"));
  const LampTable table = lamp_table({name_row, color_row});
  CHECK(read_lamp(table, "{name: desk, color: red, power: 3, on: true, count: 4}", lamp).empty());
  CHECK(lamp.name == "desk");
  CHECK(lamp.color == Lamp::Color::red);
  CHECK(lamp.power == 3.0);
  CHECK(lamp.on);
  CHECK(lamp.count == 4);
  const nlohmann::json written = nlohmann::json::parse(key_schema(table.form).text());
  CHECK(written.at("properties").at("color") == nlohmann::json{{"enum", {"white", "red"}},
                                                               {"description", "in which it shines"},
                                                               {"default", "white"}});
  CHECK(written.at("properties").at("count") == nlohmann::json{{"type", "integer"},
                                                               {"minimum", 1},
                                                               {"maximum", 9},
                                                               {"description", "how many there are"},
                                                               {"default", 2}});
  const std::string page = format_page({"lamp", "", "a light", table.form, "lamp: {power: 3}"});
  CHECK_THAT(page, Contains("white | red") && Contains("in which it shines") && Contains("text on it"));
  CHECK_THAT(page, Contains("1 to 9") && Contains("above 0"));
}

TEST_CASE("limits that are large are written with all their digits, small ones as they are meant") {
  Lamp lamp;
  const LampTable table = lamp_table({{"hours", "it lasts", yaml::form::whole(1, 1e6), &Lamp::count}});
  CHECK(read_lamp(table, "{hours: 0}", lamp) ==
        std::vector<std::string>{"lamp.hours: '0' is no whole number from 1 to 1000000"});
  const std::string page = format_page({"lamp", "", "a light", table.form, "lamp: {power: 3}"});
  CHECK_THAT(page, Contains("1 to 1000000") && !Contains("e+06"));
}

TEST_CASE("all faults of a map are found in one pass, each with what would be right") {
  Lamp lamp;
  const LampTable table = lamp_table({color_row, yaml::needed(name_row)});
  const auto faults = read_lamp(table, "{power: 0, on: maybe, count: 10, color: rde}", lamp);
  REQUIRE(faults.size() == 5);
  CHECK(faults[0] == "lamp: 'name' is missing (text on it): {power: 3}");
  CHECK(faults[1] == "lamp.power: 0 is not allowed; it must be above 0");
  CHECK(faults[2] == "lamp.on: 'maybe' is neither true nor false");
  CHECK(faults[3] == "lamp.count: '10' is no whole number from 1 to 9");
  CHECK(faults[4] == "lamp.color: 'rde' is not allowed; did you mean 'red'? It is one of: white, red");
  CHECK(lamp.count == 2);
  CHECK(read_lamp(table, "[1]", lamp) == std::vector<std::string>{"lamp: a lamp is a map: {power: 3}"});
  CHECK(read_lamp(table, "{pwoer: 3}", lamp).size() == 1);  // which may be what is missing
}

TEST_CASE("one key of a choice stands in a map, and what belongs to another stands beside it") {
  Lamp lamp;
  const LampTable table =
      lamp_table({yaml::one_of("look", color_row), yaml::one_of("look", name_row),
                  yaml::beside({"color"}, LampTable::Row{"shade", "of the colour", yaml::form::text()})});
  CHECK(read_lamp(table, "{on: true}", lamp) ==
        std::vector<std::string>{"lamp: a lamp needs one look: color, name"});
  CHECK(read_lamp(table, "{color: red, name: desk}", lamp) ==
        std::vector<std::string>{"lamp: both 'color' and 'name'; a lamp has one look"});
  CHECK(read_lamp(table, "{name: desk, shade: deep}", lamp) ==
        std::vector<std::string>{"lamp.shade: 'shade' goes with 'color' only"});
  CHECK(read_lamp(table, "{color: red, shade: deep}", lamp).empty());
}

}  // namespace stepwire::reference
