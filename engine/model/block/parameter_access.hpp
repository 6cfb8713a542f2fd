#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/model/block/spec.hpp"
#include "engine/model/block/tree.hpp"
#include "engine/model/signal/file_path.hpp"
#include "engine/model/signal/per_element.hpp"
#include "engine/model/signal/text.hpp"

namespace stepwire {

/// Form of a parameter of C++ type T in a file, and its conversion from and to a Value.
template <class T>
struct ParameterAccess {
  static_assert(std::is_enum_v<T>,
                "a parameter is a double, int64, bool, enum, Text, FilePath, Numbers, ...");
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

/// A list of numbers, stored as a vector in a Value.
template <class List, ParameterKind parameter_kind>
struct StoredAsVector {
  static constexpr ParameterKind kind = parameter_kind;
  static void set(List& member, const Value& value) {
    const auto& vector = std::get<Eigen::VectorXd>(value.content);
    member = List(Numbers(vector.data(), vector.size()));
  }
  static Value get(const List& member) {
    return {Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(member.data(), member.size()))};
  }
};

template <>
struct ParameterAccess<Numbers> : StoredAsVector<Numbers, ParameterKind::vector> {};
template <>
struct ParameterAccess<PerElement> : StoredAsVector<PerElement, ParameterKind::per_element> {};

template <>
struct ParameterAccess<Text> {
  static constexpr ParameterKind kind = ParameterKind::text;
  static void set(Text& member, const Value& value) { member = Text(*value.text()); }
  static Value get(const Text& member) { return {std::string(member)}; }
};

template <>
struct ParameterAccess<Matrix> {
  static constexpr ParameterKind kind = ParameterKind::matrix;
  static void set(Matrix& member, const Value& value) {
    const auto& matrix = std::get<Eigen::MatrixXd>(value.content);
    member = Matrix(matrix.rows(), matrix.cols(), Numbers(matrix.data(), matrix.size()));
  }
  static Value get(const Matrix& member) {
    return {Eigen::MatrixXd(
        Eigen::Map<const Eigen::MatrixXd>(member.elements().data(), member.rows(), member.columns()))};
  }
};

template <>
struct ParameterAccess<FilePath> {
  static constexpr ParameterKind kind = ParameterKind::file;
  static void set(FilePath& member, const Value& value) { member = FilePath(*value.text()); }
  static Value get(const FilePath& member) { return {member.string()}; }
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
struct ParameterAccess<Tree> {
  static constexpr ParameterKind kind = ParameterKind::tree;
  static void set(Tree& member, const Value& value) { member = Tree(value); }
  static Value get(const Tree& member) { return member.value(); }
};

}  // namespace stepwire
