#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/base/json/json.hpp"

namespace stepwire::json {

namespace {

using In = nlohmann::ordered_json;

constexpr int deepest = 64;

Json read(const In& in) {
  if (in.is_boolean()) return in.get<bool>();
  if (in.is_number_unsigned()) return in.get<std::uint64_t>();
  if (in.is_number_integer()) return in.get<std::int64_t>();
  if (in.is_number()) return in.get<double>();
  if (in.is_string()) return in.get<std::string>();
  if (in.is_null()) return nullptr;
  Json result = in.is_array() ? Json::list() : Json::object();
  for (const auto& [key, value] : in.items())
    if (in.is_array())
      result.push(read(value));
    else
      result.set(key, read(value));
  return result;
}

}  // namespace

Json Json::parse(std::string_view text) {
  try {
    return read(In::parse(text, [](int depth, In::parse_event_t, In&) {
      if (depth > deepest) throw JsonError("nested deeper than 64 levels");
      return true;
    }));
  } catch (const In::exception& error) {
    throw JsonError(error.what());
  }
}

std::span<const Json> Json::items() const {
  const auto* items = std::get_if<std::vector<Json>>(&value_);
  return items ? std::span<const Json>(*items) : std::span<const Json>();
}

std::span<const std::pair<std::string, Json>> Json::members() const {
  if (const auto* members = std::get_if<Members>(&value_)) return *members;
  return {};
}

const Json* Json::find(std::string_view key) const {
  const auto* members = std::get_if<Members>(&value_);
  if (!members) return nullptr;
  const auto found = std::ranges::find(*members, key, &Members::value_type::first);
  return found == members->end() ? nullptr : &found->second;
}

std::optional<double> Json::as_number() const {
  if (const auto* number = std::get_if<double>(&value_)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&value_)) return static_cast<double>(*whole);
  if (const auto* whole = std::get_if<std::uint64_t>(&value_)) return static_cast<double>(*whole);
  return std::nullopt;
}

std::optional<bool> Json::as_flag() const {
  const auto* flag = std::get_if<bool>(&value_);
  return flag ? std::optional(*flag) : std::nullopt;
}

}  // namespace stepwire::json
