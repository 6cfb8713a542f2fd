#include "engine/app/reference/schema_figure.hpp"

#include "engine/app/reference/schema_values.hpp"
#include "engine/view/plot/panel_reading.hpp"
#include "engine/view/plot/plot_kind.hpp"

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

Json row_schema(const FigureKey& key);

Json map_schema(const std::vector<FigureKey>& keys) {
  Json properties = Json::object();
  std::vector<std::string> required;
  for (const FigureKey& key : keys) {
    properties.set(key.name, row_schema(key));
    if (key.required) required.push_back(key.name);
  }
  return closed_map(std::move(properties), required);
}

/// Points of the plane by their names.
Json points_schema() {
  return map_of(pair_of(schema_ref("number")));
}

/// A value that has no definition of its own, without its explanation.
Json own_schema(const FigureKey& key) {
  if (key.type == ValueType::whole) return typed("integer").set("minimum", key.low).set("maximum", key.high);
  if (key.type == ValueType::truth) return typed("boolean");
  if (key.type == ValueType::word) return one_word_of(key.words);
  if (key.type == ValueType::number_pair) return pair_of(schema_ref("number"));
  if (key.type == ValueType::size_pair) return pair_of(typed("integer"));
  if (key.type == ValueType::points) return points_schema();
  if (key.type == ValueType::point_list)
    return any_of({points_schema(), list_of(pair_of(schema_ref("number")))});
  if (key.type == ValueType::text_map) return map_of(schema_ref("text"));
  if (key.type == ValueType::name_map) return map_of(one_or_list_of(schema_ref("text")));
  if (key.type == ValueType::map) return map_schema(key.keys);
  if (key.type == ValueType::panels) return list_of(schema_ref("panel")).set("minItems", 1);
  return Json::object();
}

Json value_schema(const FigureKey& key) {
  if (key.type == ValueType::text) return schema_ref("text");
  if (key.type == ValueType::expression) return schema_ref("expression");
  if (key.type == ValueType::series) return schema_ref("series");
  return key.type == ValueType::number ? schema_ref("number") : own_schema(key);
}

Json row_schema(const FigureKey& key) {
  Json value = key.list ? one_or_list_of(value_schema(key)) : value_schema(key);
  return key.doc.empty() ? value : explained(std::move(value), key.doc);
}

/// The keys of a whole picture; of one plot without `panels`.
void add_picture_keys(Json& properties, bool several) {
  for (const FigureKey& key : picture_keys())
    if (several || key.type != ValueType::panels) properties.set(key.name, row_schema(key));
}

/// Keys of one plot; alone in its picture it has the picture's keys too.
Json plot_schema(const PlotKind& kind, bool alone) {
  Json properties = Json::object().set("plot", Json::object().set("const", kind.name));
  std::vector<std::string> required{"plot"};
  if (kind.read) {  // a picture for itself
    for (const char* key : {"title", "caption"}) properties.set(key, schema_ref("text"));
    properties.set("own", typed("boolean"));
  } else {
    for (const auto& key : panel_keys())
      if (kind.takes(key.needs)) properties.set(key.name, row_schema(key));
    if (alone) add_picture_keys(properties, false);
  }
  for (const Channel& channel : kind.channels) {
    properties.set(channel.key, channel_schema(channel));
    if (channel.required) required.push_back(channel.key);
  }
  for (const FigureKey& option : kind.options) properties.set(option.name, row_schema(option));
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
  add_picture_keys(properties, true);
  definitions.set("panels", closed_map(std::move(properties), {"panels"}));
  Json figure = Json::object().set("if", Json::object().set("required", Json::list({"panels"})));
  definitions.set("figure", figure.set("then", schema_ref("panels")).set("else", schema_ref("plot")));
}

}  // namespace stepwire
