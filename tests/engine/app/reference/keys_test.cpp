// The reader of each section, the schema and the reference page have the keys of its table, and no others.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "blocks/register.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/app/reference/diagram_schema.hpp"
#include "engine/app/reference/format_page.hpp"
#include "engine/app/reference/key_schema.hpp"
#include "engine/base/yaml/section.hpp"
#include "tests/support/json_schema.hpp"

using namespace stepwire;
using Catch::Contains;
using nlohmann::json;

namespace {

const Registry& registry() {
  static const Registry all = blocks();
  return all;
}

const json& schema() {
  static const json parsed = json::parse(diagram_schema(registry()).text());
  return parsed;
}

/// The map of keys in a form: itself, or what one of its choices, items or names is.
const Key* map_in(const Key& form) {
  if (form.form == Key::Form::keys) return &form;
  for (const Key& inner : form.of)
    if (const Key* map = map_in(inner)) return map;
  return nullptr;
}

/// The schema of a map, likewise.
const json* map_in(const json& schema) {
  if (schema.contains("properties")) return &schema;
  for (const char* inner : {"items", "additionalProperties"})
    if (schema.contains(inner) && schema.at(inner).is_object())
      if (const json* map = map_in(schema.at(inner))) return map;
  if (schema.contains("anyOf"))
    for (const json& choice : schema.at("anyOf"))
      if (const json* map = map_in(choice)) return map;
  return nullptr;
}

const json& schema_of(const Section& section) {
  const std::string& name = section.name;
  if (name == "head") return schema();
  if (name.starts_with("figure.")) return schema().at("$defs").at("plot." + name.substr(7));
  return schema().at("$defs").at(section.definition);
}

/// Checks all maps of keys in a form against the schema of the same place.
void compare(const Key& form, const json& written) {
  const Key* map = map_in(form);
  if (!map) return;
  const json* described = map_in(written);
  REQUIRE(described);
  std::set<std::string> keys, properties;
  for (const Key& key : map->of) keys.insert(key.name);
  for (const auto& [key, value] : described->at("properties").items()) properties.insert(key);
  CHECK(keys == properties);
  for (const Key& key : map->of) {
    INFO(key.name);
    CHECK_FALSE(key.doc.empty());
    CHECK(described->at("properties").at(key.name).at("description") == key.doc);
    compare(key, described->at("properties").at(key.name));
  }
}

/// The example of a section as a whole file: what it has stands in place of that of the head's example.
Document example_file(const Section& section) {
  Document added = parse_document(section.example, "example.yaml");
  if (added.root.find("stepwire")) return added;
  Document file = parse_document(find_section("head")->example, "example.yaml");
  std::erase_if(file.root.entries, [&](const Entry& entry) { return added.root.find(entry.key); });
  for (const Entry& entry : added.root.entries) file.root.entries.push_back(entry);
  return file;
}

LoadedModel loaded(Document document) {
  Loader loader(registry());
  loader.add(std::move(document));
  return load_model(loader, "example.yaml", {});
}

Entry named(const std::string& key) {
  Entry entry;
  entry.key = key;
  entry.value.kind = Node::Kind::scalar;
  entry.value.text = "1";
  return entry;
}

/// The first map in a value that has a key of `form`: where the keys of the section stand.
Node* map_with_keys(Node& node, const Key& form) {
  for (const Entry& entry : node.entries)
    if (form.find(entry.key)) return &node;
  for (Entry& entry : node.entries)
    if (Node* map = map_with_keys(entry.value, form)) return map;
  for (Node& item : node.items)
    if (Node* map = map_with_keys(item, form)) return map;
  return nullptr;
}

/// The value under which a section stands in a file.
Node& value_of(const Section& section, Document& file) {
  if (section.name == "head") return file.root;
  const std::string key = section.name.substr(0, section.name.find('.'));
  for (Entry& entry : file.root.entries)
    if (entry.key == key) return entry.value;
  FAIL("the example of " << section.name << " lacks it");
  return file.root;
}

// A table of the test's own, as one for a section is written.
struct Lamp {
  double power = 5.0;
  bool on = false;
  std::size_t count = 2;
  std::string name = "lamp";
  enum class Color { white, red } color = Color::white;
};

using LampTable = KeyTable<Lamp, SectionReading>;

LampTable lamp_table(std::vector<LampTable::Row> more) {
  std::vector<LampTable::Row> rows{{"power", "what it takes", form::above_zero(form::number()), &Lamp::power},
                                   {"on", "true: it shines", form::truth(), &Lamp::on},
                                   {"count", "how many there are", form::whole(1, 9), &Lamp::count}};
  rows.insert(rows.end(), more.begin(), more.end());
  return {"a lamp", "{power: 3}", std::move(rows)};
}

std::vector<std::string> read_lamp(const LampTable& table, const std::string& yaml, Lamp& lamp) {
  std::vector<std::string> faults;
  const SectionReading read("lamp", [&](const Mark&, const std::string& subject, const std::string& message) {
    faults.push_back(subject + ": " + message);
  });
  table.read(parse_document(yaml, "test.yaml").root, lamp, read);
  return faults;
}

const LampTable::Row name_row{"name", "text on it", form::text(), &Lamp::name};
const LampTable::Row color_row{"color", "in which it shines", form::word({"white", "red"}), &Lamp::color};

}  // namespace

TEST_CASE("the schema has the keys of each section's table, with their explanations") {
  for (const Section& section : format_sections()) {
    if (section.name == "figure") continue;  // each kind of plot has a schema of its own
    INFO(section.name);
    compare(section.form, schema_of(section));
  }
}

TEST_CASE("the example of each section can be run, and fits the schema") {
  for (const Section& section : format_sections()) {
    INFO(section.name << "\n" << section.example);
    REQUIRE_FALSE(section.example.empty());
    const Document file = example_file(section);
    CHECK(schema_faults(json_of(file.root), schema()) == "");
    CHECK_NOTHROW(loaded(file));
  }
}

TEST_CASE("the reader of each section refuses a key that its table has not") {
  for (const Section& section : format_sections()) {
    INFO(section.name);
    const Key* map = map_in(section.form);
    REQUIRE(map);
    Document file = example_file(section);
    Node* place = map_with_keys(value_of(section, file), *map);
    if (section.name == "sweep") place = nullptr;  // it takes any parameter
    if (!place) continue;
    place->entries.push_back(named("bogus_key"));
    CHECK_THROWS_WITH(loaded(file), Contains("'bogus_key'"));
  }
}

TEST_CASE("the reader of each section takes every key that its table has") {
  for (const Section& section : format_sections()) {
    const Key* map = map_in(section.form);
    for (const Key& key : map->of) {
      INFO(section.name << ": " << key.name);
      Document file = example_file(section);
      Node* place = map_with_keys(value_of(section, file), *map);
      if (!place || place->find(key.name)) continue;
      if (section.name == "figure") continue;  // it has panels here, and not all keys of plots
      place->entries.push_back(named(key.name));
      try {
        loaded(file);
      } catch (const std::exception& error) {
        CHECK_THAT(error.what(), !Contains(" has no '" + key.name + "'"));
      }
    }
  }
}

TEST_CASE("each page names all keys of its section, and the list all sections") {
  for (const Section& section : format_sections()) {
    INFO(section.name);
    for (const std::string& page : {format_page(section), format_markdown(section)})
      for (const Key& key : map_in(section.form)->of) CHECK_THAT(page, Contains(key.name));
    CHECK_THAT(format_list(),
               Contains("\n  " + section.name + " ") || Catch::StartsWith("  " + section.name));
    CHECK_THAT(formats_markdown(), Contains("\n## " + section.name + "\n"));
  }
}

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
  const json written = json::parse(key_schema(table.form).text());
  CHECK(written.at("properties").at("color") ==
        json{{"enum", {"white", "red"}}, {"description", "in which it shines"}, {"default", "white"}});
  CHECK(written.at("properties").at("count") == json{{"type", "integer"},
                                                     {"minimum", 1},
                                                     {"maximum", 9},
                                                     {"description", "how many there are"},
                                                     {"default", 2}});
  const std::string page = format_page({"lamp", "", "a light", table.form, "lamp: {power: 3}"});
  CHECK_THAT(page, Contains("white | red") && Contains("in which it shines") && Contains("text on it"));
  CHECK_THAT(page, Contains("1 to 9") && Contains("above 0"));
}

TEST_CASE("all faults of a map are found in one pass, each with what would be right") {
  Lamp lamp;
  const LampTable table = lamp_table({color_row, needed(name_row)});
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
      lamp_table({one_of("look", color_row), one_of("look", name_row),
                  beside({"color"}, LampTable::Row{"shade", "of the colour", form::text()})});
  CHECK(read_lamp(table, "{on: true}", lamp) ==
        std::vector<std::string>{"lamp: a lamp needs one look: color, name"});
  CHECK(read_lamp(table, "{color: red, name: desk}", lamp) ==
        std::vector<std::string>{"lamp: both 'color' and 'name'; a lamp has one look"});
  CHECK(read_lamp(table, "{name: desk, shade: deep}", lamp) ==
        std::vector<std::string>{"lamp.shade: 'shade' goes with 'color' only"});
  CHECK(read_lamp(table, "{color: red, shade: deep}", lamp).empty());
}
