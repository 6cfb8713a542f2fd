#include "engine/app/reference/diagram_schema.hpp"

#include <fmt/format.h>

#include "engine/app/reference/schema_blocks.hpp"
#include "engine/app/reference/schema_figure.hpp"
#include "engine/app/reference/schema_fit.hpp"
#include "engine/app/reference/schema_scene.hpp"
#include "engine/app/reference/schema_study.hpp"
#include "engine/app/reference/schema_values.hpp"
#include "engine/model/diagram/diagram.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire {

namespace {

constexpr const char* name_pattern = "^[A-Za-z_][A-Za-z0-9_]*$";
constexpr const char* dotted_pattern = "^[A-Za-z_][A-Za-z0-9_]*([.][A-Za-z_][A-Za-z0-9_]*)*$";

/// A map with any names as keys.
Json map_of(const Json& values, const std::string& doc, const char* pattern = name_pattern) {
  Json names = Json::object().set("pattern", pattern);
  return explained(typed("object").set("propertyNames", std::move(names)).set("additionalProperties", values),
                   doc);
}

Json text(const std::string& doc) {
  return explained(schema_ref("text"), doc);
}

Json solver_schema() {
  Json names = Json::list();
  for (const SolverKind& kind : solver_kinds()) names.push(constant(kind.name, kind.doc));
  return Json::object()
      .set("anyOf", std::move(names))
      .set("description", "how continuous states go from tick to tick; none where there are none");
}

Json thesis_schema() {
  Json keys = Json::object().set("figure", explained(typed("integer"), "number of the figure"));
  keys.set("table", explained(typed("integer"), "number of the table"))
      .set("section", text("section in which it stands"))
      .set("caption", text("caption of the figure, as the thesis prints it"))
      .set("says", text("what its text says of the figure, word for word"))
      .set("departures",
           explained(list_of(schema_ref("text")), "what is done otherwise here, a sentence each"));
  return explained(closed_map(std::move(keys)), "what of the thesis this file shows");
}

Json parameter_definition() {
  Json keys = Json::object().set(
      "value",
      Json::object().set("description", "the default: a number with unit, a list, a word, = expression"));
  keys.set("unit", text("unit of the value, where it stands apart: N/mm"));
  keys.set("doc", text("what it is"));
  keys.set("assumed", explained(typed("boolean"), "true: our guess, not from a source"));
  for (const char* bound : {"above", "below", "at_least", "at_most"})
    keys.set(bound, explained(schema_ref("number"), "a bound that --set and users of a part are held to"));
  const Json plain = Json::object().set("type", Json::list({"number", "string", "boolean", "array"}));
  return any_of({plain, closed_map(std::move(keys), {"value"})});
}

Json input_port() {
  Json keys = Json::object().set("unit", text("unit of what must be wired here"));
  keys.set("doc", text("what it is"))
      .set("default", explained(schema_ref("source"), "feeds the port where the user gives nothing"));
  return any_of({typed("null"), closed_map(std::move(keys))});
}

Json output_port() {
  Json keys =
      Json::object().set("signal", explained(schema_ref("text"), "a block or its output: carriage.position"));
  keys.set("unit", text("unit that it must have")).set("doc", text("what it is"));
  keys.set("safe",
           explained(schema_ref("source"), "what the output holds once a real-time loop has stopped: 0 A"));
  return any_of({schema_ref("text"), closed_map(std::move(keys), {"signal"})});
}

Json record_entry() {
  const Json signal = text("a signal (rig.x), a state of a block (lag.x), or all");
  Json keys =
      Json::object().set("every", explained(schema_ref("time"), "time between rows; every step without it"));
  const Json renamed = map_of(signal, "signals under names of your own: {position: rig.x}", dotted_pattern);
  keys.set("signals", explained(one_or_list_of(any_of({signal, renamed})), "what is recorded"));
  return any_of({signal, closed_map(std::move(keys), {"signals"})});
}

Json sweep_schema() {
  const Json values = list_of(schema_ref("text")).set("minItems", 1);
  Json range = Json::object().set("from", schema_ref("number")).set("to", schema_ref("number"));
  range.set("count", explained(typed("integer").set("minimum", 2), "how many values, both ends included"));
  Json axis = any_of({values, closed_map(Json::object().set("values", values), {"values"}),
                      closed_map(std::move(range), {"from", "to", "count"})});
  Json together = explained(typed("boolean"), "true: the parameters are paired, else they make a grid");
  Json sweep = typed("object").set("properties", Json::object().set("together", std::move(together)));
  return explained(
      sweep.set("additionalProperties", std::move(axis)),
      "runs the file, or its whole study, once per value: parameter: {from, to, count} or [values]");
}

void add_run_keys(Json& keys) {
  keys.set("step", explained(schema_ref("time"), "time between ticks: 1 ms"));
  keys.set("stop", explained(schema_ref("time"), "end of the run, a whole multiple of the step: 5 s"));
  keys.set("solver", solver_schema());
  keys.set("tolerance",
           explained(schema_ref("number"),
                     fmt::format("error of a step, in sizes of its state, beyond which rosenbrock and sdirk "
                                 "end the run: {:g} where it is left out",
                                 Diagram{}.tolerance)));
  keys.set("stop_when",
           explained(schema_ref("expression"),
                     "ends the run early where this is true: rig.x > 5 mm, rig.position.1 > 5 mm"));
  keys.set("record", explained(one_or_list_of(schema_ref("record")), "signals that figures and claims read"));
  keys.set("sweep", sweep_schema());
  keys.set("figure", explained(one_or_list_of(schema_ref("figure")), "pictures of what was recorded"));
  keys.set("scene", scene_schema());
  keys.set("claims", explained(list_of(schema_ref("claim")), "statements that the run is held to"));
  keys.set("invariants",
           explained(list_of(schema_ref("claim")),
                     "limits, energy and safety: what holds throughout any run; counted apart from claims"));
  keys.set("fit", fit_schema());
  keys.set("study", study_schema());
}

Json head() {
  Json keys = Json::object().set("stepwire",
                                 explained(Json::object().set("const", 1), "format of this file; always 1"));
  keys.set("title", text("one line on what is shown"));
  keys.set("caption", text("a few sentences for the gallery page"));
  keys.set("thesis", thesis_schema());
  keys.set("parameters", map_of(schema_ref("parameter"),
                                "numbers and words with a name, used as $name; --set changes them"));
  keys.set("inputs",
           map_of(schema_ref("input"),
                  "ports: what the file that uses this one as a part wires to it, or a program writes"));
  keys.set("outputs",
           map_of(schema_ref("output"),
                  "ports: signals that the file that uses this one as a part sees, or a program reads"));
  keys.set("units", explained(typed("object").set("additionalProperties", schema_ref("text")),
                              "units that signals have, where their blocks do not say: {pull: N}"));
  keys.set("blocks",
           map_of(schema_ref("block"), "the blocks by name; an input is a key of its block", dotted_pattern)
               .set("minProperties", 1));
  add_run_keys(keys);
  return keys;
}

/// A part need not say how it is run.
Json runnable_or_part() {
  const auto needs = [](Json keys) { return Json::object().set("required", std::move(keys)); };
  return Json::list(
      {needs(Json::list({"step", "stop"})), needs(Json::list({"inputs"})), needs(Json::list({"outputs"}))});
}

}  // namespace

Json diagram_schema(const Registry& registry) {
  Json definitions = Json::object();
  add_value_definitions(definitions);
  definitions.set("parameter", parameter_definition());
  definitions.set("input", input_port());
  definitions.set("output", output_port());
  definitions.set("record", record_entry());
  add_block_definitions(registry, definitions);
  add_figure_definitions(definitions);
  add_claim_definition(definitions);
  Json schema = Json::object().set("$schema", "https://json-schema.org/draft/2020-12/schema");
  schema.set("title", "Stepwire diagram").set("description", "A block diagram that stepwire runs.");
  schema.set("type", "object").set("properties", head()).set("required", Json::list({"stepwire", "blocks"}));
  schema.set("additionalProperties", false).set("anyOf", runnable_or_part());
  return schema.set("$defs", std::move(definitions));
}

}  // namespace stepwire
