#include "engine/base/hdf5/matlab_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <hdf5.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <utility>

#include "engine/base/hdf5/handle.hpp"
#include "engine/base/io/atomic_file_writer.hpp"
#include "engine/base/io/descriptor.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/temporary.hpp"

namespace stepwire::hdf5 {

namespace {

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
