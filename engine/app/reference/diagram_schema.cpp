#include "engine/app/reference/diagram_schema.hpp"

#include "engine/app/reference/key_schema.hpp"
#include "engine/app/reference/schema_blocks.hpp"
#include "engine/app/reference/schema_figure.hpp"
#include "engine/app/reference/schema_values.hpp"
#include "engine/app/reference/sections.hpp"

namespace stepwire::reference {

using json::Json;

namespace {

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
