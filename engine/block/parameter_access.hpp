#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/block/spec.hpp"
#include "engine/signal/per_element.hpp"

namespace stepwire {

/// How a parameter of C++ type T is written in a file, and moved between it and a Value.
template <class T>
struct ParameterAccess {
  static_assert(std::is_enum_v<T>,
                "a parameter is a double, int64, bool, enum, string, path, Eigen array, ...");
  static constexpr ParameterKind kind = ParameterKind::word;
  static void set(T& member, const Value& value) { member = static_cast<T>(std::get<double>(value.content)); }
  static Value get(const T& member) { return {static_cast<double>(member)}; }
};

template <class T, ParameterKind parameter_kind, class Stored = T>
struct StoredAs {
  static constexpr ParameterKind kind = parameter_kind;
  static void set(T& member, const Value& value) { member = static_cast<T>(std::get<Stored>(value.content)); }
  static Value get(const T& member) { return {static_cast<Stored>(member)}; }
};

template <>
struct ParameterAccess<double> : StoredAs<double, ParameterKind::number> {};
template <>
struct ParameterAccess<std::int64_t> : StoredAs<std::int64_t, ParameterKind::integer, double> {};
template <>
struct ParameterAccess<bool> : StoredAs<bool, ParameterKind::flag> {};
template <>
struct ParameterAccess<std::string> : StoredAs<std::string, ParameterKind::text> {};
template <>
struct ParameterAccess<Eigen::VectorXd> : StoredAs<Eigen::VectorXd, ParameterKind::vector> {};
template <>
struct ParameterAccess<Eigen::MatrixXd> : StoredAs<Eigen::MatrixXd, ParameterKind::matrix> {};

template <>
struct ParameterAccess<PerElement> {
  static constexpr ParameterKind kind = ParameterKind::per_element;
  static void set(PerElement& member, const Value& value) {
    member = PerElement(std::get<Eigen::VectorXd>(value.content).array());
  }
  static Value get(const PerElement& member) { return {Eigen::VectorXd(member.matrix())}; }
};

template <>
struct ParameterAccess<std::filesystem::path> {
  static constexpr ParameterKind kind = ParameterKind::file;
  static void set(std::filesystem::path& member, const Value& value) { member = *value.text(); }
  static Value get(const std::filesystem::path& member) { return {member.string()}; }
};

template <>
struct ParameterAccess<std::vector<std::string>> {
  static constexpr ParameterKind kind = ParameterKind::texts;
  static void set(std::vector<std::string>& member, const Value& value) {
    member.clear();
    for (const Value& item : *value.list()) member.push_back(*item.text());
  }
  static Value get(const std::vector<std::string>& member) {
    Value::List list;
    for (const std::string& text : member) list.push_back({text});
    return {list};
  }
};

template <>
struct ParameterAccess<Value> {
  static constexpr ParameterKind kind = ParameterKind::tree;
  static void set(Value& member, const Value& value) { member = value; }
  static Value get(const Value& member) { return member; }
};

}  // namespace stepwire
