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

Plan plan_of(const std::string& flattened) {
  Loader loader(library());
  return make_plan(loader.load_text(flattened, "flattened.yaml"));
}

/// "rig.x [m]" for each column of each table, where it lies in the workspace, and how often it is kept.
std::vector<std::string> headers(const Plan& plan) {
  std::vector<std::string> lines;
  for (const RecordRequest& request : plan.diagram.records) {
    lines.push_back("every " + std::to_string(request.every.value_or(0.0)));
    for (const RecordedColumn& column : recorded_columns(plan, request))
      lines.push_back(column.name + (column.dimension ? " [" + si_name(*column.dimension) + "] " : " ") +
                      std::to_string(column.offset));
  }
  return lines;
}

}  // namespace

TEST_CASE("every flattened diagram fits the schema") {
  const auto schema = nlohmann::json::parse(diagram_schema(library()).text());
  for_every_diagram([&](const Plan& plan) {
    const Document flat = parse_document(flattened_text(plan.diagram), "flattened.yaml");
    CHECK(schema_faults(json_of(flat.root), schema) == "");
  });
}

TEST_CASE("every diagram computes and records the same bits when it is flattened") {
  for_every_diagram([](const Plan& plan) {
    const std::string text = flattened_text(plan.diagram);
    INFO(text);
    const Plan flat = plan_of(text);
    CHECK(diagram_hash(flat.diagram) == diagram_hash(plan.diagram));
    CHECK(headers(flat) == headers(plan));
    CHECK(flattened_text(flat.diagram) == text);
    const std::int64_t last = std::min<std::int64_t>(plan.steps, 200);
    Executor one(plan), other(flat);
    CHECK(fingerprint(one, last) == fingerprint(other, last));
  });
}
