#include "engine/app/reference/schema_figure.hpp"

#include "engine/app/reference/key_schema.hpp"
#include "engine/app/reference/schema_values.hpp"
#include "engine/view/plot/figure.hpp"

namespace stepwire::reference {

using json::Json;

namespace {

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

}  // namespace

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

}  // namespace stepwire::reference
