#include "engine/base/hdf5/matlab_read.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string_view>

#include "engine/base/hdf5/objects.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::hdf5 {
namespace {

using Kind = MatlabOther::Kind;

bool is_class_of_numbers(std::string_view name) {
  static constexpr std::array<std::string_view, 11> all{"double", "single", "logical", "int8",
                                                        "uint8",  "int16",  "uint16",  "int32",
                                                        "uint32", "int64",  "uint64"};
  return std::ranges::find(all, name) != all.end();
}

bool has_attribute(const Handle& object, const char* name) {
  return H5Aexists(object.id(), name) > 0;
}

/// Returns the size of an array in MATLAB's order of dimensions, at least two.
std::vector<std::size_t> size_of(const Handle& space) {
  std::array<hsize_t, H5S_MAX_RANK> counts{};
  const int rank = H5Sget_simple_extent_dims(space.id(), counts.data(), nullptr);
  if (rank < 0) Session::refuse("a size is damaged");
  std::vector<std::size_t> size(counts.rend() - rank, counts.rend());
  size.resize(std::max<std::size_t>(size.size(), 2), 1);
  return size;
}

/// Walk over the variables of one file and the fields of their structs.
class MatlabReading {
 public:
  MatlabReading(std::size_t file_size, const MatlabLimits& limits, const std::vector<std::string>& text_lists)
      : budget_(table::max_unpacked(file_size)), limits_(limits), text_lists_(text_lists) {}

  MatlabContent read(const Handle& file) {
    const Handle root(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose);
    for (const std::string& name : links_of(root))
      if (!name.starts_with('#')) take(opened(root, name), name, 0);  // MATLAB's own: #refs#, #subsystem#
    return std::move(content_);
  }

 private:
  static Handle opened(const Handle& group, const std::string& name) {
    Handle object(H5Oopen(group.id(), name.c_str(), H5P_DEFAULT), H5Oclose);
    if (!object) Session::refuse(fmt::format("'{}' is damaged", name));
    return object;
  }

  void note(const std::string& path, Kind kind, const std::string& class_name = "") {
    content_.others.push_back({path, kind, class_name});
  }

  void take(const Handle& object, const std::string& path, std::size_t depth) {
    if (depth > limits_.depth)
      throw table::TableError(
          fmt::format("'{}' has structs deeper than {} in each other", path, limits_.depth));
    const std::string class_name = text_attribute(object.id(), "MATLAB_class");
    if (has_attribute(object, "MATLAB_empty")) return;
    if (has_attribute(object, "MATLAB_sparse")) return note(path, Kind::sparse);
    if (H5Iget_type(object.id()) == H5I_GROUP) return take_group(object, class_name, path, depth);
    if (H5Iget_type(object.id()) != H5I_DATASET) return;
    if (class_name.empty()) return take_foreign(object, path, depth);
    if (has_attribute(object, "MATLAB_object_decode")) return note_object(path, class_name);
    if (class_name == "cell") return take_cell(object, path, depth);
    if (is_class_of_numbers(class_name)) return take_numbers(object, path);
    if (class_name != "char") note_object(path, class_name);
  }

  void note_object(const std::string& path, const std::string& class_name) {
    note(path, class_name == "function_handle" ? Kind::function : Kind::object, class_name);
  }

  /// Reads a struct, whose fields are the objects of a group. One group may have several names.
  void take_group(const Handle& group, const std::string& class_name, const std::string& path,
                  std::size_t depth) {
    if (class_name == "function_handle") return note(path, Kind::function);
    if (!class_name.empty() && class_name != "struct") return note(path, Kind::object, class_name);
    if (class_name.empty() && depth == 0) content_.has_foreign = true;
    if (class_name.empty() || !seen_.insert(place_of(group)).second) return;
    for (const std::string& name : links_of(group))
      take(opened(group, name), fmt::format("{}.{}", path, name), depth + 1);
  }

  /// Reads a dataset without MATLAB_class. In a struct array it is a field, a list of references to the
  /// values; elsewhere it was written by another program.
  void take_foreign(const Handle& set, const std::string& path, std::size_t depth) {
    const std::vector<Handle> values = depth > 0 ? referred(set) : std::vector<Handle>{};
    if (values.empty()) content_.has_foreign = content_.has_foreign || depth == 0;
    if (values.size() > limits_.structs) return note(path, Kind::struct_array);
    const std::size_t field = path.rfind('.');
    for (std::size_t i = 0; i < values.size(); ++i)
      take(values[i], fmt::format("{}({}){}", path.substr(0, field), i + 1, path.substr(field)), depth + 1);
  }

  /// Returns the objects that a dataset of references leads to; an empty list for any other dataset, and for
  /// one beyond the memory budget.
  std::vector<Handle> referred(const Handle& set) const {
    const Handle type(H5Dget_type(set.id()), H5Tclose), space(H5Dget_space(set.id()), H5Sclose);
    const hssize_t count = H5Sget_simple_extent_npoints(space.id());
    if (H5Tget_class(type.id()) != H5T_REFERENCE || count <= 0 ||
        static_cast<std::size_t>(count) > budget_ / sizeof(hobj_ref_t))
      return {};
    std::vector<hobj_ref_t> references(static_cast<std::size_t>(count));
    if (H5Dread(set.id(), H5T_STD_REF_OBJ, H5S_ALL, H5S_ALL, H5P_DEFAULT, references.data()) < 0)
      Session::refuse("a list of references cannot be read");
    std::vector<Handle> objects;
    for (const hobj_ref_t& reference : references) {
      objects.emplace_back(H5Rdereference2(set.id(), H5P_DEFAULT, H5R_OBJECT, &reference), H5Oclose);
      if (!objects.back()) Session::refuse("a reference leads nowhere");
    }
    return objects;
  }

  /// Reads the texts of a cell array that `text_lists_` names.
  void take_cell(const Handle& set, const std::string& path, std::size_t depth) {
    if (std::ranges::find(text_lists_, path) == text_lists_.end()) {
      if (depth == 0) note(path, Kind::cell);
      return;
    }
    MatlabTexts list{path, {}};
    for (const Handle& cell : referred(set)) {
      const bool text =
          text_attribute(cell.id(), "MATLAB_class") == "char" && !has_attribute(cell, "MATLAB_empty");
      list.texts.push_back(text ? numbers_of(cell, path) : std::vector<double>{});
    }
    content_.texts.push_back(std::move(list));
  }

  void take_numbers(const Handle& set, const std::string& path) {
    const Handle type(H5Dget_type(set.id()), H5Tclose), space(H5Dget_space(set.id()), H5Sclose);
    const Handle properties(H5Dget_create_plist(set.id()), H5Pclose);
    const H5T_class_t kind = H5Tget_class(type.id());
    if (kind == H5T_COMPOUND) return note(path, Kind::complex);
    if (H5Pget_external_count(properties.id()) > 0 || H5Pget_layout(properties.id()) == H5D_VIRTUAL)
      return note(path, Kind::outside);
    if (kind != H5T_INTEGER && kind != H5T_FLOAT && kind != H5T_ENUM)
      return note(path, Kind::object, "unknown");
    std::vector<double> values = numbers_of(set, path);
    if (!values.empty()) content_.arrays.push_back({path, size_of(space), std::move(values)});
  }

  std::vector<double> numbers_of(const Handle& set, const std::string& path) {
    const Handle space(H5Dget_space(set.id()), H5Sclose);
    const hssize_t points = H5Sget_simple_extent_npoints(space.id());
    const std::size_t count = points > 0 ? static_cast<std::size_t>(points) : 0;
    if (count > budget_ / sizeof(double))
      throw table::TableError(
          fmt::format("'{}' has {} numbers, more than a file of this size may unpack to", path, count));
    budget_ -= count * sizeof(double);
    std::vector<double> values(count);
    if (count > 0 && H5Dread(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
      Session::refuse(fmt::format("'{}' cannot be read; it is damaged or cut off", path));
    return values;
  }

  std::size_t budget_;
  MatlabLimits limits_;
  const std::vector<std::string>& text_lists_;
  std::set<std::uint64_t> seen_;
  MatlabContent content_;
};

}  // namespace

MatlabContent read_matlab(const std::string& path, std::size_t file_size, const MatlabLimits& limits,
                          const std::vector<std::string>& text_lists) {
  const Handle file = open_file(path);
  return MatlabReading(file_size, limits, text_lists).read(file);
}

}  // namespace stepwire::hdf5
