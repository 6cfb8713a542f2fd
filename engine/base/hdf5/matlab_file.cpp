#include "engine/base/hdf5/matlab_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <limits>
#include <set>
#include <string_view>
#include <utility>

#include "engine/base/hdf5/handle.hpp"
#include "engine/base/hdf5/objects.hpp"
#include "engine/base/io/atomic_file_writer.hpp"
#include "engine/base/io/descriptor.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/temporary.hpp"
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

constexpr hsize_t size_of_header = 512;
constexpr const char* group_of_cells = "#refs#";

/// Returns the space of a MATLAB matrix; HDF5 counts dimensions in reverse order.
Handle matrix_space(hsize_t rows, hsize_t columns) {
  const std::array<hsize_t, 2> counts{columns, rows};
  return {H5Screate_simple(2, counts.data(), nullptr), H5Sclose};
}

Handle without_times(hid_t of) {
  Handle properties(H5Pcreate(of), H5Pclose);
  H5Pset_obj_track_times(properties.id(), false);
  return properties;
}

Handle copy_of(hid_t type) {
  return {H5Tcopy(type), H5Tclose};
}

}  // namespace

MatlabContent read_matlab(const std::string& path, std::size_t file_size, const MatlabLimits& limits,
                          const std::vector<std::string>& text_lists) {
  const Handle file = open_file(path);
  return MatlabReading(file_size, limits, text_lists).read(file);
}

struct MatlabFile::File {
  io::AtomicFileWriter writer;
  std::string path, header;
  Handle file, cells;
  std::size_t texts = 0;

  File(const std::string& of, std::string begins) : writer(of), path(of), header(std::move(begins)) {
    const Handle properties(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    H5Pset_userblock(properties.id(), size_of_header);
    file = {H5Fcreate(writer.temporary().c_str(), H5F_ACC_TRUNC, properties.id(), H5P_DEFAULT), H5Fclose};
    require(static_cast<bool>(file));
  }

  void require(bool done) const {
    if (done) return;
    const std::string complaint = Session::complaint();
    throw io::EnvironmentError(
        fmt::format("{}: {}", path, complaint.empty() ? "cannot be written" : complaint));
  }

  void put_attribute(const Handle& object, const char* name, const Handle& type, const void* value) const {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    Handle attribute(H5Acreate2(object.id(), name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
                     H5Aclose);
    require(attribute && H5Awrite(attribute.id(), type.id(), value) >= 0 && attribute.close());
  }

  void put_class(const Handle& object, std::string_view name) const {
    const Handle type = copy_of(H5T_C_S1);
    H5Tset_size(type.id(), name.size());
    put_attribute(object, "MATLAB_class", type, name.data());
  }

  Handle put(const Handle& place, const std::string& name, const Handle& type, const Handle& space,
             const void* content) const {
    const Handle creation = without_times(H5P_DATASET_CREATE);
    Handle set(
        H5Dcreate2(place.id(), name.c_str(), type.id(), space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
        H5Dclose);
    require(set && H5Dwrite(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, content) >= 0);
    return set;
  }

  /// Writes an empty array, which MATLAB stores as its size.
  Handle put_empty(const Handle& place, const std::string& name, std::size_t rows,
                   std::size_t columns) const {
    const std::array<std::uint64_t, 2> size{rows, columns};
    const hsize_t count = size.size();
    Handle set = put(place, name, copy_of(H5T_STD_U64LE), {H5Screate_simple(1, &count, nullptr), H5Sclose},
                     size.data());
    const std::uint8_t yes = 1;
    put_attribute(set, "MATLAB_empty", copy_of(H5T_STD_U8LE), &yes);
    return set;
  }

  void put_text(const std::string& name, const std::u16string& text) const {
    Handle set = text.empty()
                     ? put_empty(cells, name, 0, 0)
                     : put(cells, name, copy_of(H5T_STD_U16LE), matrix_space(1, text.size()), text.data());
    put_class(set, "char");
    const std::int32_t bytes = 2;
    put_attribute(set, "MATLAB_int_decode", copy_of(H5T_STD_I32LE), &bytes);
    require(set.close());
  }

  /// Stores the text of a cell in the group of cells and returns the reference to it.
  hobj_ref_t put_cell(const std::u16string& text) {
    const Handle creation = without_times(H5P_GROUP_CREATE);
    if (!cells)
      cells = {H5Gcreate2(file.id(), group_of_cells, H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Gclose};
    require(static_cast<bool>(cells));
    const std::string name = fmt::format("t{}", texts++);
    put_text(name, text);
    hobj_ref_t reference{};
    require(H5Rcreate(&reference, cells.id(), name.c_str(), H5R_OBJECT, -1) >= 0);
    return reference;
  }

  void put_header() const {
    const io::Descriptor start(::open(writer.temporary().c_str(), O_WRONLY | O_CLOEXEC));
    const ssize_t written = start.open() ? ::pwrite(start.number(), header.data(), header.size(), 0) : -1;
    if (written != static_cast<ssize_t>(header.size())) io::refuse_file(path, errno);
  }
};

MatlabFile::MatlabFile(const std::string& path, std::string header) {
  const Session session;
  file_ = std::make_unique<File>(path, std::move(header));
}

MatlabFile::~MatlabFile() {
  const Session session;
  file_.reset();
}

void MatlabFile::add(const std::string& name, std::size_t rows, std::size_t columns,
                     std::span<const double> values) {
  const Session session;
  Handle set = values.empty() ? file_->put_empty(file_->file, name, rows, columns)
                              : file_->put(file_->file, name, copy_of(H5T_IEEE_F64LE),
                                           matrix_space(rows, columns), values.data());
  file_->put_class(set, "double");
  file_->require(set.close());
}

void MatlabFile::add(const std::string& name, const std::vector<std::u16string>& texts) {
  const Session session;
  std::vector<hobj_ref_t> references;
  for (const std::u16string& text : texts) references.push_back(file_->put_cell(text));
  Handle set = texts.empty() ? file_->put_empty(file_->file, name, 0, 0)
                             : file_->put(file_->file, name, copy_of(H5T_STD_REF_OBJ),
                                          matrix_space(texts.size(), 1), references.data());
  file_->put_class(set, "cell");
  file_->require(set.close());
}

void MatlabFile::finish() {
  const Session session;
  file_->require(file_->cells.close() && H5Fflush(file_->file.id(), H5F_SCOPE_LOCAL) >= 0 &&
                 file_->file.close());
  file_->put_header();
  file_->writer.finish();
}

}  // namespace stepwire::hdf5
