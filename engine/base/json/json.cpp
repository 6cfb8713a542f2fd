#include "engine/base/json/json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/base/text/characters.hpp"

namespace stepwire::json {

/// Converts our Json to the values of nlohmann::json, which writes the text.
struct JsonText {
  using Out = nlohmann::ordered_json;

  static Out of(const Json& json) { return std::visit(JsonText{}, json.value_); }

  Out operator()(const Json::Members& members) const {
    Out result = Out::object();
    // Appends directly: the insertion of the library walks all keys, and ours are already distinct.
    auto& pairs = result.get_ref<Out::object_t&>();
    for (const auto& [key, value] : members.all()) pairs.push_back({key, of(value)});
    return result;
  }
  Out operator()(const std::vector<Json>& items) const {
    Out result = Out::array();
    for (const Json& item : items) result.push_back(of(item));
    return result;
  }
  template <class T>
  Out operator()(const T& value) const {
    return Out(value);
  }
};

Json Json::list(std::vector<Json> items) {
  Json result;
  result.value_ = std::move(items);
  return result;
}

Json Json::object() {
  Json result;
  result.value_ = Members{};
  return result;
}

Json& Json::push(Json item) {
  if (std::holds_alternative<std::nullptr_t>(value_)) value_ = std::vector<Json>{};
  auto* const items = std::get_if<std::vector<Json>>(&value_);
  if (!items) throw std::logic_error("only a list takes items");
  items->push_back(std::move(item));
  return *this;
}

Json& Json::set(std::string key, Json value) {
  if (std::holds_alternative<std::nullptr_t>(value_)) value_ = Members{};
  auto* const members = std::get_if<Members>(&value_);
  if (!members) throw std::logic_error("only an object takes keys");
  if (Json* const same = members->find(key)) {
    *same = std::move(value);
  } else {
    members->add(std::move(key), std::move(value));
  }
  return *this;
}

Json* Json::Members::find(std::string_view key) {
  if (places_.empty()) {
    const auto found = std::ranges::find(pairs_, key, &std::pair<std::string, Json>::first);
    return found == pairs_.end() ? nullptr : &found->second;
  }
  const auto place = places_.find(key);
  return place == places_.end() ? nullptr : &pairs_[place->second].second;
}

void Json::Members::add(std::string key, Json value) {
  constexpr std::size_t few = 32;
  pairs_.emplace_back(std::move(key), std::move(value));
  if (pairs_.size() <= few) return;
  for (std::size_t i = places_.size(); i < pairs_.size(); ++i) places_.emplace(pairs_[i].first, i);
}

std::string Json::text(int indent) const {
  return text::json_escaped(
      JsonText::of(*this).dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}  // namespace stepwire::json
