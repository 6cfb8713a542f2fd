#include "engine/base/json/json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/base/text/characters.hpp"

namespace stepwire::json {

namespace {

using In = nlohmann::json;

constexpr std::size_t deepest = 64;

/// Builds a Json from the events of the nlohmann parser. Its own values would search all keys of an object
/// for each member.
class Builder {
 public:
  bool null() { return put(nullptr); }
  bool boolean(bool value) { return put(value); }
  bool number_integer(std::int64_t value) { return put(value); }
  bool number_unsigned(std::uint64_t value) { return put(value); }
  bool number_float(double value, const std::string&) { return put(value); }
  bool string(std::string& value) { return put(std::move(value)); }
  bool binary(In::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Json::object()); }
  bool start_array(std::size_t) { return open(Json::list()); }
  bool key(std::string& name) {
    open_.back().key = std::move(name);
    return true;
  }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t, const std::string&, const In::exception& error) {
    const std::string_view text = error.what();  // "[json.exception.parse_error.101] parse error at ..."
    throw JsonError(std::string(text.substr(text.find("] ") + 2)));
  }

  Json done() { return std::move(whole_); }

 private:
  /// An object or list under construction, and the key of its next value.
  struct Open {
    Json value;
    std::string key;
  };

  bool put(Json value) {
    if (open_.empty()) {
      whole_ = std::move(value);
    } else if (Open& in = open_.back(); in.value.is_list()) {
      in.value.push(std::move(value));
    } else {
      in.value.set(std::move(in.key), std::move(value));
    }
    return true;
  }
  bool open(Json value) {
    if (open_.size() == deepest) throw JsonError("nested deeper than 64 levels");
    open_.push_back({std::move(value), ""});
    return true;
  }
  bool close() {
    Json value = std::move(open_.back().value);
    open_.pop_back();
    return put(std::move(value));
  }

  std::vector<Open> open_;
  Json whole_;
};

}  // namespace

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

Json Json::parse(std::string_view text) {
  Builder builder;
  In::sax_parse(text, &builder);
  return builder.done();
}

std::span<const Json> Json::items() const {
  const auto* items = std::get_if<std::vector<Json>>(&value_);
  return items ? std::span<const Json>(*items) : std::span<const Json>();
}

std::span<const std::pair<std::string, Json>> Json::members() const {
  if (const auto* members = std::get_if<Members>(&value_)) return members->all();
  return {};
}

const Json* Json::find(std::string_view key) const {
  const auto* members = std::get_if<Members>(&value_);
  return members ? members->find(key) : nullptr;
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
