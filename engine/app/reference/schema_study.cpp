#include "engine/app/reference/schema_study.hpp"

#include "engine/app/reference/schema_values.hpp"

namespace stepwire {

namespace {

Json string_of(const std::string& doc) {
  return explained(typed("string"), doc);
}

/// Which parameter takes what.
Json targets(const std::vector<std::string>& names, const std::string& doc) {
  Json keys = Json::object();
  for (const std::string& name : names) keys.set(name, string_of("name of a parameter"));
  return explained(closed_map(std::move(keys), names), doc);
}

Json subjects() {
  return any_of(
      {whole_schema(1, "how many people"),
       explained(list_of(whole_schema(1, "number of a person")).set("minItems", 1), "which people")});
}

Json conditions() {
  Json switches = Json::object().set("type", Json::list({"object", "null"}));
  switches.set("additionalProperties", Json::object().set("enum", Json::list({0, 1})));
  Json map = Json::object().set("type", "object").set("minProperties", 1);
  return explained(map.set("additionalProperties", std::move(switches)),
                   "what each condition switches on: haptic, visual, guiding_path");
}

Json circle() {
  Json keys = Json::object().set("of", string_of("the condition whose drawing the circle is fitted to"));
  keys.set("sets", targets({"x", "y", "radius"}, "which parameters of the other trials take it"));
  return explained(closed_map(std::move(keys), {"of"}), "task 1: the circle that is to be drawn");
}

Json way_back() {
  Json keys = Json::object().set("direction", string_of("recorded signal, zero inside"));
  keys.set("position", string_of("recorded signal that it follows from; that of the study without it"));
  return any_of({string_of("task 2: recorded signal, the direction of the way back, zero inside the region"),
                 closed_map(std::move(keys), {"direction"})});
}

}  // namespace

Json study_schema() {
  Json keys =
      Json::object().set("like", string_of("file whose section 'study' is taken for what is not given here"));
  keys.set("task", explained(Json::object().set("enum", Json::list({1, 2})),
                             "1: drawing a circle; 2: returning to the region"));
  keys.set("subjects", subjects());
  keys.set("seed", whole_schema(0, "who the people are, and all that is random"));
  keys.set("sets", targets({"subject", "seed"}, "which parameters take the person and the noise of a trial"));
  keys.set("conditions", conditions());
  keys.set("circle", circle());
  keys.set("position", string_of("recorded signal of two elements: where the end-effector is"));
  keys.set("way_back", way_back());
  keys.set("attempts",
           whole_schema(1, "runs of one trial at most, until one ends by stop_when before stop (10)"));
  keys.set("trials",
           string_of("CSV file of recorded trials in place of runs: subject, task, condition, time, x, y"));
  return explained(closed_map(std::move(keys)),
                   "runs the file once for each person and condition, and scores and analyses these trials; "
                   "beside a sweep, all "
                   "of that at each of its points");
}

}  // namespace stepwire
