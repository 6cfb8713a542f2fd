#include "engine/app/reference/schema_fit.hpp"

#include "engine/app/reference/schema_values.hpp"

namespace stepwire {

namespace {

Json parameter() {
  Json keys =
      Json::object().set("start", expression_schema("where the search begins; the file's value without it"));
  keys.set("bounds",
           explained(pair_of(schema_ref("expression")), "it is sought between these: [1 kg, 5 kg]"));
  keys.set("scale", expression_schema("a change that counts; the size of the start without it"));
  keys.set("each_record",
           explained(typed("boolean"), "true: each record has its own value, else they share one"));
  return closed_map(std::move(keys));
}

Json comparison() {
  Json keys = Json::object().set("model", explained(schema_ref("series"), "what the diagram computes"));
  keys.set("measured", expression_schema("what it is held against"));
  keys.set("weight", expression_schema("factor of the difference, 1 over what is expected of it: 1/(3 N)"));
  keys.set("where", expression_schema("only rows for which this is true are compared"));
  keys.set("offset", explained(one_word_of({"free"}), "the mean difference of each record is no error"));
  keys.set("against", one_or_list_of(schema_ref("series")));
  return closed_map(std::move(keys), {"model", "measured"});
}

Json curve() {
  Json keys = Json::object().set(
      "y", explained(schema_ref("series"), "expression of fitted parameters and of the variable"));
  Json over = typed("object").set("minProperties", 1).set("maxProperties", 1);
  keys.set("over", explained(over.set("additionalProperties", pair_of(schema_ref("expression"))),
                             "the variable and its range in bare numbers: {i: [0, 1]}"));
  keys.set("data", expression_schema("where the records have the variable; this range is shaded"));
  keys.set("x_label", explained(typed("string"), "text at the axis of the variable"));
  return closed_map(std::move(keys), {"y", "over"});
}

Json global() {
  Json keys = Json::object().set("population", whole_schema(4, "how many points there are at a time"));
  keys.set("generations", whole_schema(1, "how often they are replaced"));
  return explained(closed_map(std::move(keys)), "differential evolution within the bounds ahead of the rest");
}

}  // namespace

Json fit_schema() {
  Json parameters = typed("object").set("additionalProperties", parameter());
  Json keys = Json::object();
  keys.set("parameters", explained(parameters.set("minProperties", 1),
                                   "what is to be found, by the names that --set takes"));
  keys.set("compare",
           explained(list_of(comparison()).set("minItems", 1), "model and measurement, side by side"));
  keys.set("hold_out", expression_schema("of swept parameters: records that are predicted, not fitted"));
  keys.set("loss", explained(one_word_of({"none", "huber", "cauchy"}),
                             "what large differences count: all, or less beyond the width"));
  keys.set("width", expression_schema("of the loss, in weighted differences"));
  keys.set("starts",
           whole_schema(1, "searches; the first begins at the given start, the others within the bounds"));
  keys.set("follow",
           whole_schema(1, "how many of the searches go on after the first steps; a quarter without it"));
  keys.set("seed", whole_schema(0, "of what is random"));
  keys.set("iterations", whole_schema(1, "steps of one search, at most"));
  keys.set("global", global());
  keys.set("curves", explained(list_of(curve()),
                               "what follows from the fitted parameters, drawn with its 95 % interval"));
  keys.set("records",
           explained(schema_ref("text"), "what pictures call the records: measured, simulated (record)"));
  return explained(
      closed_map(std::move(keys), {"parameters", "compare"}),
      "finds parameters so that the model agrees with records: the runs of the sweep, or the one run");
}

}  // namespace stepwire
