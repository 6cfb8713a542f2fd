#include <nlohmann/json.hpp>

#include "engine/base/json/json.hpp"

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
    throw JsonError(error.what());
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
