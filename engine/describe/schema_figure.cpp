#include "engine/describe/schema_figure.hpp"

#include <functional>

#include "engine/describe/schema_values.hpp"
#include "engine/figure/panel_reading.hpp"
#include "engine/figure/plot_kind.hpp"

namespace stepwire {

namespace {

Json series_schema() {
  Json properties = Json::object().set(
      "signal", explained(schema_ref("expression"), "expression, with `in UNIT` behind it"));
  properties.set("label", explained(schema_ref("text"), "text at the axis or in the legend, without unit"));
  return explained(any_of({schema_ref("expression"), closed_map(std::move(properties), {"signal"})}),
                   "an expression over recorded columns, in the unit wanted: rig.x in mm");
}

Json channel_schema(const Channel& channel) {
  const Json series = schema_ref("series");
  return explained(channel.several ? one_or_list_of(series) : series, channel.doc);
}

Json option_schema(const Option& option) {
  if (option.form == Option::Form::names) return explained(one_or_list_of(schema_ref("text")), option.doc);
  if (option.form == Option::Form::texts) return explained(map_of(schema_ref("text")), option.doc);
  if (option.form == Option::Form::lists)
    return explained(map_of(one_or_list_of(schema_ref("text"))), option.doc);
  if (option.form == Option::Form::tree) return Json::object().set("description", option.doc);
  if (option.words == std::vector<std::string>{"true", "false"})
    return explained(typed("boolean"), option.doc);
  if (!option.words.empty() && option.list)
    return explained(one_or_list_of(one_word_of(option.words)), option.doc);
  if (!option.words.empty()) return explained(one_word_of(option.words), option.doc);
  const Json number = schema_ref("number");
  return explained(option.list ? one_or_list_of(number) : number, option.doc);
}

/// Points of the plane by their names.
Json named_points_schema() {
  return map_of(pair_of(schema_ref("number")));
}

/// The same, or a list of points.
Json marks_schema() {
  return any_of({named_points_schema(), list_of(pair_of(schema_ref("number")))});
}

Json motion_schema() {
  Json keys = Json::object().set("x", schema_ref("expression")).set("y", schema_ref("expression"));
  keys.set("where", schema_ref("expression")).set("heads", schema_ref("number"));
  keys.set("color", one_word_of({"red", "blue", "green", "black"}));
  return one_or_list_of(closed_map(std::move(keys), {"x", "y"}));
}

Json rose_schema() {
  Json keys = Json::object();
  for (const char* key : {"x", "y", "angle", "where"}) keys.set(key, schema_ref("expression"));
  keys.set("value", schema_ref("series")).set("at", pair_of(schema_ref("number")));
  keys.set("radius", schema_ref("number")).set("name", schema_ref("text"));
  return one_or_list_of(closed_map(std::move(keys), {"x", "y", "angle", "value", "radius"}));
}

/// What a key of every panel or picture holds.
Json common_schema(const std::string& key) {
  if (key.ends_with("_range")) return pair_of(schema_ref("number"));
  if (key == "where") return schema_ref("expression");
  if (key == "rows") return one_word_of({"all", "final"});
  if (key == "equal") return typed("boolean");
  if (key == "log") return one_or_list_of(one_word_of({"x", "y", "color"}));
  if (key == "legend" || key == "boundary" || key == "region") return one_or_list_of(schema_ref("text"));
  if (key == "size") return pair_of(typed("integer"));
  if (key == "region_line") return one_word_of({"line", "dashes"});
  if (key == "marks") return marks_schema();
  if (key == "motion") return motion_schema();
  if (key == "rose") return rose_schema();
  if (key == "texts") return named_points_schema();
  if (key == "own") return typed("boolean");
  if (key == "note") return schema_ref("series");
  if (key == "columns") return typed("integer").set("minimum", 1).set("maximum", 6);
  if (key == "panels") return list_of(schema_ref("panel")).set("minItems", 1);
  return schema_ref("text");
}

void add_keys(Json& properties, const std::vector<FigureKey>& keys,
              const std::function<bool(const std::string&)>& takes) {
  for (const FigureKey& key : keys)
    if (takes(key.name)) properties.set(key.name, explained(common_schema(key.name), key.doc));
}

/// Keys of one plot; alone in its picture it has the picture's keys too.
Json plot_schema(const PlotKind& kind, bool alone) {
  Json properties = Json::object().set("plot", Json::object().set("const", kind.name));
  std::vector<std::string> required{"plot"};
  if (kind.read) {  // a picture for itself
    for (const char* key : {"title", "caption"}) properties.set(key, schema_ref("text"));
    properties.set("own", typed("boolean"));
  } else {
    add_keys(properties, panel_keys(), [&](const std::string& key) { return kind.takes(key); });
    if (alone) add_keys(properties, picture_keys(), [](const std::string& key) { return key != "panels"; });
  }
  for (const Channel& channel : kind.channels) {
    properties.set(channel.key, channel_schema(channel));
    if (channel.required) required.push_back(channel.key);
  }
  for (const Option& option : kind.options) properties.set(option.key, option_schema(option));
  return explained(closed_map(std::move(properties), required), kind.doc);
}

/// Picks the plot's own definition by the key `plot`.
Json plot_choice(const std::string& prefix, bool alone) {
  Json names = Json::list(), choices = Json::list();
  for (const PlotKind& kind : plot_kinds()) {
    if (kind.read && !alone) continue;
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

}  // namespace

void add_figure_definitions(Json& definitions) {
  definitions.set("series", series_schema());
  for (const PlotKind& kind : plot_kinds()) {
    definitions.set("plot." + kind.name, plot_schema(kind, true));
    if (!kind.read) definitions.set("panel." + kind.name, plot_schema(kind, false));
  }
  definitions.set("panel", plot_choice("panel.", false));
  definitions.set("plot", plot_choice("plot.", true));
  Json properties = Json::object();
  add_keys(properties, picture_keys(), [](const std::string&) { return true; });
  definitions.set("panels", closed_map(std::move(properties), {"panels"}));
  Json figure = Json::object().set("if", Json::object().set("required", Json::list({"panels"})));
  definitions.set("figure", figure.set("then", schema_ref("panels")).set("else", schema_ref("plot")));
}

}  // namespace stepwire
