#include "engine/app/reference/diagram_schema.hpp"

#include <fmt/format.h>

#include <functional>

#include "engine/app/reference/key_schema.hpp"
#include "engine/app/reference/schema_values.hpp"
#include "engine/app/reference/sections.hpp"
#include "engine/app/reference/words.hpp"
#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/guard_keys.hpp"
#include "engine/model/diagram/guard_types.hpp"
#include "engine/view/plot/figure.hpp"

namespace stepwire::reference {

using json::Json;

namespace {

std::string definition_of(const BlockType& type) {
  return "block." + type.name;
}

std::string definition_of(const yaml::Key& guard) {
  return "guard." + guard.name;
}

Json preset_schema(const BlockType& type) {
  Json words = Json::list();
  for (const PresetSpec& preset : type.presets) words.push(constant(preset.name, preset.doc));
  words.push(typed("string").set("pattern", "\\$"));
  return Json::object()
      .set("anyOf", std::move(words))
      .set("description", "a named set of parameter values; keys beside it come on top");
}

Json input_schema(const InputSpec& input) {
  std::string doc = input.doc;
  if (input.unit != "1" && input.unit != "*") doc += fmt::format(" [{}]", input.unit);
  if (input.optional) doc += "; optional";
  const Json source = schema_ref("source");
  return explained(input.list ? one_or_list_of(source) : source, doc);
}

Json initial_schema(const StateSpec& state) {
  ParameterSpec number;
  number.unit = state.unit;
  return explained(schema_ref("numbers"),
                   fmt::format("where the state {} starts ({}); default {}", state.name, state.doc,
                               value_text(number, {state.initial})));
}

/// Returns the schema of a key. If an input has the same name, a signal is allowed as well.
Json or_signal(const BlockType& type, const std::string& key, Json value) {
  if (type.input(key) < 0) return value;
  const Json* doc = value.find("description");
  Json either = Json::object().set("anyOf", Json::list({value, schema_ref("source")}));
  return doc ? either.set("description", *doc) : either;
}

/// Returns the schema of a parameter. If a guard key has the same name, as with `trigger` of a reset, a guard
/// map is allowed as well.
Json or_guard(const std::string& name, Json value) {
  for (const yaml::Key& key : diagram::guard_keys())
    if (key.name == name) {
      const Json* doc = value.find("description");
      Json either = any_of({value, schema_ref(definition_of(key))});
      return doc ? either.set("description", *doc) : either;
    }
  return value;
}

/// Adds the guard keys that a block or part has in addition to its own keys.
void set_guard_keys(const std::function<bool(const std::string&)>& is_own, Json& properties) {
  for (const yaml::Key& key : diagram::guard_keys())
    if (!is_own(key.name)) properties.set(key.name, explained(schema_ref(definition_of(key)), key.doc));
}

Json type_schema(const BlockType& type) {
  Json properties = Json::object().set("block", Json::object().set("const", type.name));
  std::vector<std::string> required{"block"};
  for (const InputSpec& input : type.inputs) {
    properties.set(input.name, input_schema(input));
    if (!input.optional) required.push_back(input.name);
  }
  for (const ParameterSpec& parameter : type.parameters) {
    properties.set(parameter.name, or_guard(parameter.name, or_signal(type, parameter.name,
                                                                      parameter_schema(type, parameter))));
    if (parameter.required) required.push_back(parameter.name);
  }
  for (const StateSpec& state : type.states)
    if (const std::string key = diagram::initial_key(type, state); state.settable)
      properties.set(key, or_signal(type, key, initial_schema(state)));
  if (!type.presets.empty()) properties.set("preset", preset_schema(type));
  if (!type.has_continuous_state())
    properties.set("every", key_schema(diagram::every_key("time between two runs of this block; " +
                                                          timing_text(type.timing))));
  set_guard_keys([&](const std::string& key) { return type.input(key) >= 0 || type.parameter(key); },
                 properties);
  return explained(closed_map(std::move(properties), required), type.doc);
}

/// Returns the schema of a part. Its keys are the inputs and parameters of its own file, so any key is
/// allowed.
Json part_schema() {
  Json properties = Json::object().set("diagram", schema_ref("file"));
  properties.set("every",
                 key_schema(diagram::every_key("time between two runs of its blocks that have no period")));
  set_guard_keys([](const std::string& key) { return key == "guard"; }, properties);
  return Json::object()
      .set("type", "object")
      .set("properties", std::move(properties))
      .set("required", Json::list({"diagram"}));
}

/// Returns the schema of a bus: named fields that are signals or other buses.
Json bus_schema() {
  Json fields = explained(Json::object().set("type", "object").set("minProperties", 1),
                          "signals under names, read as wrench.force: {force: f, torque: t}; a field may be "
                          "{signal: f, unit: N, shape: 3}, or another bus {fields: ..}");
  Json properties = Json::object().set("fields", std::move(fields));
  properties.set("doc", Json::object().set("type", "string").set("description", "what it is"));
  return closed_map(std::move(properties), {"fields"});
}

/// Returns the condition that selects a definition: {"properties": {"block": {"const": "Lag"}}, "required":
/// ["block"]}.
Json when_block_is(const std::string& name) {
  Json properties = Json::object().set("block", Json::object().set("const", name));
  return Json::object().set("properties", std::move(properties)).set("required", Json::list({"block"}));
}

/// Adds a definition for each block ("block.Lag"), one for a part, and "block", which selects among them by
/// the key `block`.
void add_block_definitions(const Registry& registry, Json& definitions) {
  Json names = Json::list(), choices = Json::list();
  std::vector<const BlockType*> types = registry.types();
  types.insert(types.end(), diagram::guard_types().begin(), diagram::guard_types().end());
  for (const BlockType* type : types) {
    definitions.set(definition_of(*type), type_schema(*type));
    names.push(constant(type->name, type->doc));
    choices.push(
        Json::object().set("if", when_block_is(type->name)).set("then", schema_ref(definition_of(*type))));
  }
  for (const yaml::Key& key : diagram::guard_keys()) definitions.set(definition_of(key), key_schema(key));
  definitions.set("part", part_schema());
  definitions.set("bus", bus_schema());
  const Json kind = Json::object()
                        .set("anyOf", std::move(names))
                        .set("description", "kind of block; `stepwire blocks` lists them");
  const Json file =
      explained(schema_ref("file"),
                "a part: the file of another diagram; its inputs and parameters are the keys beside it");
  Json block = Json::object().set("type", "object");
  block.set("properties", Json::object().set("block", kind).set("diagram", file));
  block.set("oneOf", Json::list({Json::object().set("required", Json::list({"block"})), schema_ref("part"),
                                 schema_ref("bus")}));
  definitions.set("block", block.set("allOf", std::move(choices)));
}

/// Selects the definition of a plot by the key `plot`.
Json plot_choice(const std::string& prefix, const std::vector<yaml::Key>& plots) {
  Json names = Json::list(), choices = Json::list();
  for (const yaml::Key& kind : plots) {
    names.push(constant(kind.name, kind.doc));
    Json properties = Json::object().set("plot", Json::object().set("const", kind.name));
    Json condition =
        Json::object().set("properties", std::move(properties)).set("required", Json::list({"plot"}));
    choices.push(Json::object().set("if", std::move(condition)).set("then", schema_ref(prefix + kind.name)));
  }
  Json plot = Json::object().set("anyOf", std::move(names)).set("description", "kind of plot");
  Json panel =
      Json::object().set("type", "object").set("properties", Json::object().set("plot", std::move(plot)));
  return panel.set("required", Json::list({"plot"})).set("allOf", std::move(choices));
}

Json series_schema() {
  return explained(any_of({schema_ref("expression"), key_schema(query::series_form())}),
                   "an expression over recorded columns, in the unit wanted: rig.x in mm");
}

/// Adds the definitions of figures: series, plot, panel, panels, figure and one for each kind of plot.
void add_figure_definitions(Json& definitions) {
  definitions.set("series", series_schema());
  for (const yaml::Key& plot : plot::plot_forms(true)) definitions.set("plot." + plot.name, key_schema(plot));
  for (const yaml::Key& plot : plot::plot_forms(false))
    definitions.set("panel." + plot.name, key_schema(plot));
  definitions.set("panel", plot_choice("panel.", plot::plot_forms(false)));
  definitions.set("plot", plot_choice("plot.", plot::plot_forms(true)));
  definitions.set("panels", key_schema(plot::picture_form()));
  Json figure = Json::object().set("if", Json::object().set("required", Json::list({"panels"})));
  definitions.set("figure", figure.set("then", schema_ref("panels")).set("else", schema_ref("plot")));
}

/// Returns the schema of required keys: a file that runs needs step and stop, a part has inputs or outputs
/// instead.
Json runnable_or_part() {
  const auto needs = [](Json keys) { return Json::object().set("required", std::move(keys)); };
  return Json::list(
      {needs(Json::list({"step", "stop"})), needs(Json::list({"inputs"})), needs(Json::list({"outputs"}))});
}

}  // namespace

Json diagram_schema(const Registry& registry) {
  Json definitions = Json::object();
  add_value_definitions(definitions);
  for (const Section& section : format_sections())
    if (!section.definition.empty()) definitions.set(section.definition, key_schema(section.form));
  add_block_definitions(registry, definitions);
  add_figure_definitions(definitions);
  Json schema = key_schema(find_section("head")->form);
  schema.set("$schema", "https://json-schema.org/draft/2020-12/schema");
  schema.set("title", "Stepwire diagram").set("description", "A block diagram that stepwire runs.");
  schema.set("anyOf", runnable_or_part());
  return schema.set("$defs", std::move(definitions));
}

}  // namespace stepwire::reference
