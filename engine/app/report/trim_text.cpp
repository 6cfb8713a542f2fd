#include <fmt/format.h>

#include "engine/analyse/query/number.hpp"
#include "engine/app/report/linear_text.hpp"
#include "engine/base/text/text_table.hpp"

namespace stepwire::report {

namespace {

void add_rows(const char* kind, const std::vector<linear::TrimmedValue>& values, text::TextTable& table) {
  for (const linear::TrimmedValue& value : values) {
    const std::string unit = value.channel.unit.empty() ? "" : " " + value.channel.unit;
    const char* how = value.at_bound ? "at its bound" : value.free ? "found" : "given";
    table.rows.push_back({kind, value.channel.name, query::short_number(value.value, 8) + unit, how,
                          value.setting.empty() ? "-" : value.setting});
  }
}

}  // namespace

std::string trim_text(const std::string& file, const linear::TrimResult& result) {
  text::TextTable table;
  table.columns = {"", "name", "value", "", "set by"};
  add_rows("state", result.states, table);
  add_rows("input", result.inputs, table);
  add_rows("output", result.outputs, table);
  std::string text = fmt::format("{}: {} after {} steps, largest residual {}\n\n{}", file,
                                 result.converged ? "found" : "NOT found", result.iterations,
                                 query::short_number(result.largest, 3), text::text(table));
  if (result.converged) return text;
  for (const auto& [channel, value] : result.residuals)
    text += fmt::format("  {} is off by {}\n", channel.name, query::short_number(value, 4));
  return text;
}

}  // namespace stepwire::report
