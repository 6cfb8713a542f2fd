#include "engine/base/mcap/channel_rows.hpp"

#include <fmt/format.h>

#include <limits>

#include "engine/base/table/table_file.hpp"

namespace stepwire::mcap {

using json::Json;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::string inside(const std::string& name, const std::string& member) {
  return name.empty() ? member : name + "." + member;
}

void add_units(Units& units, const std::string& name, const Json& schema) {
  if (const Json* unit = schema.find("unit"); unit && unit->as_text()) units[name] = *unit->as_text();
  if (const Json* members = schema.find("properties"))
    for (const auto& [key, member] : members->members()) add_units(units, inside(name, key), member);
}

}  // namespace

Units units_of(std::string_view schema) {
  Units units;
  try {
    add_units(units, "", Json::parse(schema));
  } catch (const json::JsonError&) {  // without a readable schema units are unknown
  }
  return units;
}

ChannelRows::ChannelRows(std::string topic, std::shared_ptr<const Units> units)
    : topic_(std::move(topic)), units_(std::move(units)) {}

void ChannelRows::add(std::string_view message, std::uint64_t time) {
  times_.push_back(time);
  try {
    add("", Json::parse(message));
  } catch (const json::JsonError& error) {
    throw table::TableError(fmt::format("message {} of '{}' is no JSON: {}", rows(), topic_, error.what()));
  }
}

void ChannelRows::add(const std::string& name, const Json& value) {
  if (const auto number = value.as_number()) {
    column(name).back() = *number;
  } else if (const auto flag = value.as_flag()) {
    column(name).back() = *flag ? 1.0 : 0.0;
  } else if (value.as_text()) {
    problems_.try_emplace(name, fmt::format("'{}' holds text, not numbers", name));
    column(name);
  } else if (value.is_null()) {
    column(name);
  }
  for (const auto& [key, member] : value.members()) add(inside(name, key), member);
  std::size_t index = 0;
  for (const Json& item : value.items()) add(inside(name, std::to_string(++index)), item);
}

/// Returns the column of a name; a new one is NaN up to this message.
std::vector<double>& ChannelRows::column(const std::string& name) {
  const auto [place, is_new] = places_.try_emplace(name, columns_.size());
  if (is_new && columns() == max_columns)
    throw table::TableError(fmt::format("'{}' has more than {} columns", topic_, max_columns));
  if (is_new) columns_.push_back({name, "", {}});
  std::vector<double>& values = columns_[place->second].values;
  values.resize(rows(), nothing);
  return values;
}

void ChannelRows::give(table::RecordTable& table, const std::string& prefix, std::uint64_t begin) {
  if (!places_.contains("time")) {
    table.columns.push_back({prefix + "time", "s", {}});
    for (const std::uint64_t time : times_)
      table.columns.back().values.push_back(1e-9 * (static_cast<double>(time - begin)));
  }
  for (table::Column& column : columns_) {
    column.values.resize(rows(), nothing);
    if (units_ && units_->contains(column.name)) column.unit = units_->at(column.name);
    if (const auto problem = problems_.find(column.name); problem != problems_.end())
      table.problems[prefix + column.name] = problem->second;
    column.name = prefix + column.name;
    table.columns.push_back(std::move(column));
  }
}

}  // namespace stepwire::mcap
