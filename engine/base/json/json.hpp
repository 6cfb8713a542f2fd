#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace stepwire::json {

/// Thrown for a text that is not JSON or is nested too deeply.
class JsonError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A JSON value: null, true or false, a number, text, a list, or an object that keeps its
/// order.
///   Json::object().set("that", "the lag settles").set("holds", true).set("value", 0.667)
class Json {
 public:
  Json() = default;
  Json(std::nullptr_t) {}
  Json(std::same_as<bool> auto value) : value_(value) {}
  Json(std::floating_point auto value) : value_(static_cast<double>(value)) {}
  Json(std::signed_integral auto value) : value_(static_cast<std::int64_t>(value)) {}
  template <std::unsigned_integral T>
  requires(!std::same_as<T, bool>) Json(T value) : value_(static_cast<std::uint64_t>(value)) {}
  Json(std::string value) : value_(std::move(value)) {}
  Json(std::string_view value) : value_(std::string(value)) {}
  Json(const char* value) : value_(std::string(value)) {}

  static Json list(std::vector<Json> items = {});
  static Json object();
  /// Makes a list of a range whose items convert to Json, such as names or numbers.
  template <class Range>
  static Json list_of(const Range& range) {
    Json result = list();
    for (const auto& item : range) result.push(Json(item));
    return result;
  }

  /// Appends to a list; null becomes a list. Throws std::logic_error for any other value.
  Json& push(Json item);
  /// Appends a member to an object, or replaces the value of the key; null becomes an object. Throws
  /// std::logic_error for any other value.
  Json& set(std::string key, Json value);

  /// Parses one value. Throws JsonError.
  static Json parse(std::string_view text);

  bool is_null() const { return std::holds_alternative<std::nullptr_t>(value_); }
  bool is_list() const { return std::holds_alternative<std::vector<Json>>(value_); }
  bool is_object() const { return std::holds_alternative<Members>(value_); }
  /// Returns the items of a list; an empty span for any other value.
  std::span<const Json> items() const;
  /// Returns the members of an object in their order; an empty span for any other value.
  std::span<const std::pair<std::string, Json>> members() const;
  /// Returns the value of a key; nullptr if the key is missing or this is not an object.
  const Json* find(std::string_view key) const;
  /// Returns the string; nullptr for any other value.
  const std::string* as_text() const { return std::get_if<std::string>(&value_); }
  /// Returns the number; std::nullopt for any other value.
  std::optional<double> as_number() const;
  std::optional<bool> as_flag() const;

  /// Writes JSON. Doubles have the digits that read back to the same bits; NaN and infinity become null.
  /// `indent` is the number of blanks a level; a negative one writes a single line. Invalid UTF-8 is
  /// replaced.
  std::string text(int indent = 2) const;

 private:
  /// Ordered keys and values. Objects with many keys have an index for look-ups.
  class Members {
   public:
    const std::vector<std::pair<std::string, Json>>& all() const { return pairs_; }
    Json* find(std::string_view key);
    const Json* find(std::string_view key) const { return const_cast<Members*>(this)->find(key); }
    /// Adds a key that is not present yet.
    void add(std::string key, Json value);

   private:
    struct Hash {
      using is_transparent = void;
      std::size_t operator()(std::string_view key) const { return std::hash<std::string_view>()(key); }
    };

    std::vector<std::pair<std::string, Json>> pairs_;
    std::unordered_map<std::string, std::size_t, Hash, std::equal_to<>> places_;  ///< empty for up to 32 keys
  };
  using Value = std::variant<std::nullptr_t, bool, double, std::int64_t, std::uint64_t, std::string,
                             std::vector<Json>, Members>;
  friend struct JsonText;
  Value value_ = nullptr;
};

}  // namespace stepwire::json
