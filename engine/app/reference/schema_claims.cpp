#include <utility>

#include "engine/app/reference/schema_figure.hpp"
#include "engine/app/reference/schema_values.hpp"

namespace stepwire {

namespace {

using Keys = std::vector<std::pair<std::string, Json>>;

Json map_of_two(const std::string& first, const std::string& second, const std::string& doc) {
  Json properties = Json::object().set(first, schema_ref("expression")).set(second, schema_ref("expression"));
  return explained(closed_map(std::move(properties), {first, second}), doc);
}

Keys reductions() {
  return {{"final",
           expression_schema("its last value; over a sweep that of every run, of which the worst is shown")},
          {"max", expression_schema("its largest value")},
          {"min", expression_schema("its smallest value")},
          {"mean", expression_schema("its mean over time")},
          {"rms", expression_schema("its root mean square over time")},
          {"spread", expression_schema("its largest value minus its smallest")},
          {"fraction", expression_schema("the share of rows where it is true, 0 to 1")},
          {"count", expression_schema("how often it becomes true")},
          {"at", map_of_two("time", "value", "its value at a time: {time: 2 s, value: x}")},
          {"rising",
           map_of_two("value", "over", "rank correlation, 1 where it rises strictly: {value: x, over: y}")},
          {"fit", explained(pair_of(schema_ref("expression")),
                            "agreement of [MODEL, MEASURED] in percent: 100 (1 - |e| / |y - mean y|)")}};
}

Keys comparisons() {
  return {{"equals", expression_schema("the reduced value is this; see within")},
          {"at_most", expression_schema("the reduced value is this or less")},
          {"at_least", expression_schema("the reduced value is this or more")},
          {"between", explained(pair_of(schema_ref("expression")),
                                "the reduced value lies in this interval: [3.1 N, 3.3 N]")}};
}

/// Adds the keys, and gives the condition that exactly one of them is there.
Json choice_among(const Keys& keys, Json& properties) {
  Json choices = Json::list();
  for (const auto& [key, schema] : keys) {
    properties.set(key, schema);
    choices.push(Json::object().set("required", Json::list({Json(key)})));
  }
  return Json::object().set("oneOf", std::move(choices));
}

}  // namespace

void add_claim_definition(Json& definitions) {
  Json properties = Json::object().set("that", explained(schema_ref("text"), "the statement, for people"));
  properties.set("where", expression_schema("only rows for which this is true count"));
  Json one_reduction = choice_among(reductions(), properties);
  Json one_comparison = choice_among(comparisons(), properties);
  properties.set("within", expression_schema("tolerance of `equals`: 0.1 N, or relative: 1 %"));
  properties.set(
      "each_run",
      explained(typed("boolean"),
                "true: judged for every run of a sweep, the worst is shown; always so for final and at"));
  properties.set("offset", explained(one_word_of({"free"}), "beside fit: the mean difference is no error"));
  properties.set("disagrees",
                 explained(schema_ref("text"), "why a statement of the thesis is known not to hold"));
  Json claim = closed_map(std::move(properties), {"that"});
  claim.set("allOf", Json::list({std::move(one_reduction), std::move(one_comparison)}));
  definitions.set(
      "claim",
      claim.set("dependentRequired",
                Json::object().set("within", Json::list({"equals"})).set("offset", Json::list({"fit"}))));
}

}  // namespace stepwire
