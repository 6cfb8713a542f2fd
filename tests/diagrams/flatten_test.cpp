#include "engine/model/diagram/flatten.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "engine/app/reference/diagram_schema.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "tests/diagrams/diagram_files.hpp"
#include "tests/support/json_schema.hpp"
#include "tests/support/plan_text.hpp"

using namespace stepwire;

namespace {

plan::Plan plan_of(const std::string& flattened) {
  diagram::Loader loader(library());
  return plan::make_plan(loader.load_text(flattened, "flattened.yaml"));
}

/// Lists the interval of each table and each of its columns: "rig.x [m]" and the offset in the workspace.
std::vector<std::string> headers(const plan::Plan& plan) {
  std::vector<std::string> lines;
  for (const diagram::RecordRequest& request : plan.diagram.records) {
    lines.push_back("every " + std::to_string(request.every.value_or(0.0)));
    for (const record::RecordedColumn& column : record::recorded_columns(plan, request))
      lines.push_back(column.name +
                      (column.dimension ? " [" + unit::si_name(*column.dimension) + "] " : " ") +
                      std::to_string(column.offset));
  }
  return lines;
}

}  // namespace

TEST_CASE("every flattened diagram fits the schema") {
  const auto schema = nlohmann::json::parse(reference::diagram_schema(library()).text());
  for_every_diagram([&](const plan::Plan& plan) {
    const yaml::Document flat = yaml::parse_document(diagram::flattened_text(plan.diagram), "flattened.yaml");
    CHECK(schema_faults(json_of(flat.root), schema) == "");
  });
}

TEST_CASE("every diagram computes and records the same bits when it is flattened") {
  for_every_diagram([](const plan::Plan& plan) {
    const std::string text = diagram::flattened_text(plan.diagram);
    INFO(text);
    const plan::Plan flat = plan_of(text);
    CHECK(diagram::diagram_hash(flat.diagram) == diagram::diagram_hash(plan.diagram));
    CHECK(headers(flat) == headers(plan));
    CHECK(diagram::flattened_text(flat.diagram) == text);
    const std::int64_t last = std::min<std::int64_t>(plan.steps, 200);
    run::Executor one(plan), other(flat);
    CHECK(fingerprint(one, last) == fingerprint(other, last));
  });
}
