// The reader of each section, the schema and the reference page have the keys of its table, and no others.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "blocks/register.hpp"
#include "engine/app/reference/diagram_schema.hpp"
#include "engine/app/reference/format_page.hpp"
#include "engine/app/reference/key_schema.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/base/yaml/section.hpp"
#include "tests/support/json_schema.hpp"

namespace stepwire::reference {
using Catch::Contains;

namespace {

const Registry& registry() {
  static const Registry all = blocks();
  return all;
}

const nlohmann::json& schema() {
  static const nlohmann::json parsed = nlohmann::json::parse(diagram_schema(registry()).text());
  return parsed;
}

/// The map of keys in a form: itself, or what one of its choices, items or names is.
const yaml::Key* map_in(const yaml::Key& form) {
  if (form.form == yaml::Key::Form::keys) return &form;
  for (const yaml::Key& inner : form.of)
    if (const yaml::Key* map = map_in(inner)) return map;
  return nullptr;
}

/// The schema of a map, likewise.
const nlohmann::json* map_in(const nlohmann::json& schema) {
  if (schema.contains("properties")) return &schema;
  for (const char* inner : {"items", "additionalProperties"})
    if (schema.contains(inner) && schema.at(inner).is_object())
      if (const nlohmann::json* map = map_in(schema.at(inner))) return map;
  if (schema.contains("anyOf"))
    for (const nlohmann::json& choice : schema.at("anyOf"))
      if (const nlohmann::json* map = map_in(choice)) return map;
  return nullptr;
}

const nlohmann::json& schema_of(const Section& section) {
  const std::string& name = section.name;
  if (name == "head") return schema();
  if (name.starts_with("figure.")) return schema().at("$defs").at("plot." + name.substr(7));
  return schema().at("$defs").at(section.definition);
}

/// Checks all maps of keys in a form against the schema of the same place.
void compare(const yaml::Key& form, const nlohmann::json& written) {
  const yaml::Key* map = map_in(form);
  if (!map) return;
  const nlohmann::json* described = map_in(written);
  REQUIRE(described);
  std::set<std::string> keys, properties;
  for (const yaml::Key& key : map->of) keys.insert(key.name);
  for (const auto& [key, value] : described->at("properties").items()) properties.insert(key);
  CHECK(keys == properties);
  for (const yaml::Key& key : map->of) {
    INFO(key.name);
    CHECK_FALSE(key.doc.empty());
    CHECK(described->at("properties").at(key.name).at("description") == key.doc);
    compare(key, described->at("properties").at(key.name));
  }
}

/// Returns the example of a section as a whole file: its entries replace those of the head's example.
yaml::Document example_file(const Section& section) {
  yaml::Document added = yaml::parse_document(section.example, "example.yaml");
  if (added.root.find("stepwire")) return added;
  yaml::Document file = yaml::parse_document(find_section("head")->example, "example.yaml");
  std::erase_if(file.root.entries, [&](const yaml::Entry& entry) { return added.root.find(entry.key); });
  for (const yaml::Entry& entry : added.root.entries) file.root.entries.push_back(entry);
  return file;
}

session::LoadedModel loaded(yaml::Document document) {
  diagram::Loader loader(registry());
  loader.add(std::move(document));
  return session::load_model(loader, "example.yaml", {});
}

yaml::Entry named(const std::string& key) {
  yaml::Entry entry;
  entry.key = key;
  entry.value.kind = yaml::Node::Kind::scalar;
  entry.value.text = "1";
  return entry;
}

/// Returns the first map in a value that has a key of `form`, the map of the section's keys; nullptr if there
/// is none.
yaml::Node* map_with_keys(yaml::Node& node, const yaml::Key& form) {
  for (const yaml::Entry& entry : node.entries)
    if (form.find(entry.key)) return &node;
  for (yaml::Entry& entry : node.entries)
    if (yaml::Node* map = map_with_keys(entry.value, form)) return map;
  for (yaml::Node& item : node.items)
    if (yaml::Node* map = map_with_keys(item, form)) return map;
  return nullptr;
}

/// Returns the value of the key of a section in a file.
yaml::Node& value_of(const Section& section, yaml::Document& file) {
  if (section.name == "head") return file.root;
  const std::string key = section.name.substr(0, section.name.find('.'));
  for (yaml::Entry& entry : file.root.entries)
    if (entry.key == key) return entry.value;
  FAIL("the example of " << section.name << " lacks it");
  return file.root;
}

bool has_only(const yaml::Node& map, const yaml::Key& keys) {
  return std::ranges::all_of(map.entries, [&](const yaml::Entry& entry) { return keys.find(entry.key); });
}

/// The maps of keys of a form that a value has, with those inside of them.
void find_maps(yaml::Node& node, const yaml::Key& form, std::vector<yaml::Node*>& maps) {
  using enum yaml::Key::Form;
  if (form.form == keys && node.is_map() && form.rest.empty() && has_only(node, form)) {
    maps.push_back(&node);
    for (const yaml::Key& key : form.of)
      for (yaml::Entry& entry : node.entries)
        if (entry.key == key.name) find_maps(entry.value, key, maps);
  }
  if (form.form == list && node.is_list())
    for (yaml::Node& item : node.items) find_maps(item, form.of.front(), maps);
  if (form.form == names && node.is_map())
    for (yaml::Entry& entry : node.entries) find_maps(entry.value, form.of.front(), maps);
  if (form.form == either)
    for (const yaml::Key& choice : form.of) find_maps(node, choice, maps);
}

std::vector<yaml::Node*> maps_of(const Section& section, yaml::Document& file) {
  std::vector<yaml::Node*> maps;
  yaml::Node& value = value_of(section, file);
  find_maps(value, section.form, maps);
  for (yaml::Node& item : value.items) find_maps(item, section.form, maps);
  for (yaml::Entry& entry : value.entries)
    if (maps.empty() && section.form.form == yaml::Key::Form::either)
      find_maps(entry.value, section.form, maps);
  return maps;
}

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
    const yaml::Document file = example_file(section);
    CHECK(schema_faults(json_of(file.root), schema()) == "");
    CHECK_NOTHROW(loaded(file));
  }
}

TEST_CASE("the reader of each section refuses a key that its table has not") {
  for (const Section& section : format_sections()) {
    INFO(section.name);
    const yaml::Key* map = map_in(section.form);
    REQUIRE(map);
    yaml::Document file = example_file(section);
    yaml::Node* place = map_with_keys(value_of(section, file), *map);
    if (section.name == "sweep") place = nullptr;  // it takes any parameter
    if (!place) continue;
    place->entries.push_back(named("bogus_key"));
    CHECK_THROWS_WITH(loaded(file), Contains("'bogus_key'"));
  }
}

TEST_CASE("the reader of each section refuses a key that no map inside of it has") {
  std::size_t inner = 0;
  for (const Section& section : format_sections()) {
    yaml::Document counted = example_file(section);
    const std::size_t count = maps_of(section, counted).size();
    for (std::size_t i = 0; i < count; ++i) {
      yaml::Document file = example_file(section);
      yaml::Node& map = *maps_of(section, file)[i];
      INFO(section.name << ": map " << i << " with '" << map.entries.front().key << "'");
      map.entries.push_back(named("bogus_key"));
      CHECK_THROWS_WITH(loaded(file), Contains("'bogus_key'"));
      inner += i > 0;
    }
  }
  CHECK(inner >= 12);  // of fits, scenes, rigs and claims
}

TEST_CASE("the reader of each section takes every key that its table has") {
  for (const Section& section : format_sections()) {
    const yaml::Key* map = map_in(section.form);
    for (const yaml::Key& key : map->of) {
      INFO(section.name << ": " << key.name);
      yaml::Document file = example_file(section);
      yaml::Node* place = map_with_keys(value_of(section, file), *map);
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
      for (const yaml::Key& key : map_in(section.form)->of) CHECK_THAT(page, Contains(key.name));
    CHECK_THAT(format_list(),
               Contains("\n  " + section.name + " ") || Catch::StartsWith("  " + section.name));
    CHECK_THAT(formats_markdown(), Contains("\n## " + section.name + "\n"));
  }
}

}  // namespace stepwire::reference
