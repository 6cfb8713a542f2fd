#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <concepts>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/base/result/result_type.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::result {

/// Values by name, in their order.
template <class Value>
using Map = std::vector<std::pair<std::string, Value>>;

template <class Struct>
const RecordType& record_type();

/// Type and JSON of a C++ type: here of a struct with a function `declare(Record<Struct>&)` in its namespace.
template <class Struct>
struct ValueOf {
  static ValueType type() { return {ValueType::Kind::record, false, record_type<Struct>}; }
  static json::Json json(const Struct& value) { return record_type<Struct>().json_of(&value); }
};

template <class Value>
json::Json json_of(const Value& value) {
  return ValueOf<Value>::json(value);
}

template <ValueType::Kind kind_>
struct PlainValue {
  static ValueType type() { return {kind_}; }
  static json::Json json(const auto& value) { return value; }
};

template <>
struct ValueOf<bool> : PlainValue<ValueType::Kind::flag> {};
template <std::integral Integer>
struct ValueOf<Integer> : PlainValue<ValueType::Kind::count> {};
template <>
struct ValueOf<double> : PlainValue<ValueType::Kind::number> {};
/// Number that is never missing.
struct Finite {
  double value;
};
template <>
struct ValueOf<Finite> {
  static ValueType type() { return {ValueType::Kind::finite}; }
  static json::Json json(Finite number) { return number.value; }
};
template <>
struct ValueOf<std::string> : PlainValue<ValueType::Kind::text> {};
template <>
struct ValueOf<const char*> : PlainValue<ValueType::Kind::text> {};
template <>
struct ValueOf<json::Json> : PlainValue<ValueType::Kind::any> {};

/// A dimension is the text of its SI unit.
template <>
struct ValueOf<unit::Dimension> {
  static ValueType type() { return {ValueType::Kind::text}; }
  static json::Json json(const unit::Dimension& dimension) { return unit::si_name(dimension); }
};

template <>
struct ValueOf<std::complex<double>> {
  static ValueType type() { return {ValueType::Kind::complex}; }
  static json::Json json(const std::complex<double>& number) {
    return json::Json::list({number.real(), number.imag()});
  }
};

template <>
struct ValueOf<std::array<double, 2>> {
  static ValueType type() { return {ValueType::Kind::pair}; }
  static json::Json json(const std::array<double, 2>& pair) { return json::Json::list_of(pair); }
};

template <>
struct ValueOf<Eigen::MatrixXd> {
  static ValueType type() { return {ValueType::Kind::matrix}; }
  static json::Json json(const Eigen::MatrixXd& matrix) {
    json::Json rows = json::Json::list();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) rows.push(json::Json::list_of(matrix.row(i)));
    return rows;
  }
};

template <class Value>
struct ValueOf<std::optional<Value>> {
  static ValueType type() {
    ValueType type = ValueOf<Value>::type();
    type.optional = true;
    return type;
  }
  static json::Json json(const std::optional<Value>& value) { return value ? json_of(*value) : json::Json(); }
};

template <class Value>
struct ValueOf<std::vector<Value>> {
  static ValueType type() { return {ValueType::Kind::list, false, nullptr, {ValueOf<Value>::type()}}; }
  static json::Json json(const std::vector<Value>& values) {
    json::Json list = json::Json::list();
    for (const auto& value : values) list.push(json_of<Value>(value));
    return list;
  }
};

template <class Value>
struct ValueOf<Map<Value>> {
  static ValueType type() { return {ValueType::Kind::map, false, nullptr, {ValueOf<Value>::type()}}; }
  static json::Json json(const Map<Value>& values) {
    json::Json object = json::Json::object();
    for (const auto& [name, value] : values) object.set(name, json_of(value));
    return object;
  }
};

/// Returns a text, or std::nullopt for an empty one.
inline std::optional<std::string> text_if_any(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

/// Returns a function of a struct that follows members, or functions, one after the other, as in
/// `path(&TunedClaim::verdict, &Verdict::that)`. Pointers and inner structs are followed alike.
template <class First, class... Rest>
auto path(First first, Rest... rest) {
  if constexpr (sizeof...(rest) == 0)
    return [first](const auto& object) { return std::invoke(first, object); };
  else
    return [first, next = path(rest...)](const auto& object) { return next(std::invoke(first, object)); };
}

/// Returns structs that are declared in the place of those of a room without JSON, from which they derive.
template <class Declared, class Struct>
std::vector<Declared> as(const std::vector<Struct>& structs) {
  std::vector<Declared> all;
  for (const Struct& one : structs) all.push_back({one});
  return all;
}

/// Declaration of the fields of a struct. The value of a field is a member, or a function of the struct:
///   void declare(result::Record<Crossing>& is) {
///     is.named("Crossing", "margin at a frequency");
///     is.field("frequency", &Crossing::frequency, "frequency of the crossing", "rad/s");
///   }
template <class Struct>
class Record {
 public:
  void named(std::string name, std::string doc) {
    type_.name = std::move(name);
    type_.doc = std::move(doc);
  }
  template <class Get>
  FieldType& field(std::string name, Get get, std::string doc, std::string unit = "") {
    using Value = std::remove_cvref_t<std::invoke_result_t<Get, const Struct&>>;
    FieldType field{std::move(name), std::move(doc), std::move(unit), ValueOf<Value>::type()};
    field.value = [get](const void* object) {
      return json_of<Value>(std::invoke(get, *static_cast<const Struct*>(object)));
    };
    return type_.fields.emplace_back(std::move(field));
  }
  /// Declares a field that the JSON object does not have without a value.
  template <class Get>
  FieldType& omitted(std::string name, Get get, std::string doc, std::string unit = "") {
    FieldType& added = field(std::move(name), get, std::move(doc), std::move(unit));
    added.omitted = true;
    return added;
  }

  /// Declares a field for programs, which no file has.
  template <class Get>
  FieldType& hidden(std::string name, Get get, std::string doc, std::string unit = "") {
    FieldType& added = field(std::move(name), get, std::move(doc), std::move(unit));
    added.hidden = true;
    return added;
  }

  RecordType type_;
};

/// Returns the declared type of a struct.
template <class Struct>
const RecordType& record_type() {
  static const RecordType type = [] {
    Record<Struct> record;
    declare(record);
    return std::move(record.type_);
  }();
  return type;
}

}  // namespace stepwire::result
