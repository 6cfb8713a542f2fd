#include "engine/base/hdf5/hdf5_writer.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/hdf5/handle.hpp"
#include "engine/base/io/atomic_file_writer.hpp"
#include "engine/base/io/environment_error.hpp"

namespace stepwire::hdf5 {

namespace {

constexpr hsize_t rows_of_chunk = 8192;

/// Whether rows can be appended later.
enum class Length { fixed, growing };

Handle simple_space(hsize_t count, Length length = Length::fixed) {
  const hsize_t most = length == Length::growing ? H5S_UNLIMITED : count;
  return {H5Screate_simple(1, &count, &most), H5Sclose};
}

/// Type of UTF-8 text: of variable length, which h5py returns as str in attributes, or of fixed length, which
/// Octave reads in datasets.
Handle text_type(std::size_t length = H5T_VARIABLE) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), length);
  if (length != H5T_VARIABLE) H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

/// Properties of groups that track the creation order of links, and store no times.
Handle group_properties(hid_t of) {
  Handle properties(H5Pcreate(of), H5Pclose);
  H5Pset_link_creation_order(properties.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  H5Pset_obj_track_times(properties.id(), false);
  return properties;
}

/// Properties of datasets with a checksum for every number: that of its chunk, or for a scalar that of the
/// object header.
Handle dataset_properties(hsize_t rows, Length length, bool is_scalar) {
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties.id(), false);
  if (is_scalar) {
    H5Pset_layout(properties.id(), H5D_COMPACT);
    return properties;
  }
  const double filled = 0.0;  // sets the unused rest of the last chunk, which would otherwise be undefined
  const hsize_t chunk =
      length == Length::growing ? rows_of_chunk : std::clamp<hsize_t>(rows, 1, rows_of_chunk);
  H5Pset_chunk(properties.id(), 1, &chunk);
  H5Pset_fill_value(properties.id(), H5T_NATIVE_DOUBLE, &filled);
  H5Pset_fletcher32(properties.id());
  return properties;
}

}  // namespace

/// Implementation. The library writes the temporary file of the AtomicFileWriter, which renames it.
struct Hdf5Writer::File {
  io::AtomicFileWriter writer;
  std::string path;
  Handle file, root;
  bool named = false;
  std::vector<Handle> growing;  ///< datasets of the run under way, see begin()
  hsize_t rows = 0;             ///< length of each of them

  explicit File(const std::string& of) : writer(of), path(of) {
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_file_locking(access.id(), false, true);  // others may read during writing
    H5Pset_libver_bounds(access.id(), H5F_LIBVER_V18, H5F_LIBVER_V110);
    const Handle creation = group_properties(H5P_FILE_CREATE);
    file = {H5Fcreate(writer.temporary().c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose};
    // From here on the format of HDF5 1.10 (2016), in which every header and index has a checksum. If the
    // whole file had that format, it could not be read while it is written.
    require(H5Fset_libver_bounds(require(file).id(), H5F_LIBVER_V110, H5F_LIBVER_V110) >= 0);
    root = {H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose};
    require(root);
  }

  /// Throws EnvironmentError unless done. Each library call clears the error stack, so no call may come in
  /// between.
  void require(bool done) const {
    if (done) return;
    const std::string complaint = Session::complaint();
    throw io::EnvironmentError(
        fmt::format("{}: {}", path, complaint.empty() ? "cannot be written" : complaint));
  }
  const Handle& require(const Handle& handle) const {
    require(static_cast<bool>(handle));
    return handle;
  }

  void put_texts(hid_t object, const char* name, const Handle& space, const std::vector<const char*>& texts) {
    const Handle type = text_type();
    Handle attribute(H5Acreate2(object, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    require(H5Awrite(require(attribute).id(), type.id(), texts.data()) >= 0 && attribute.close());
  }

  void put_text(hid_t object, const char* name, const std::string& text) {
    if (!text.empty()) put_texts(object, name, {H5Screate(H5S_SCALAR), H5Sclose}, {text.c_str()});
  }

  Handle put(hid_t group, const std::string& name, const Handle& type, const Handle& space, hsize_t rows,
             const void* content, Length length = Length::fixed) {
    const bool is_scalar = H5Sget_simple_extent_type(space.id()) == H5S_SCALAR;
    const Handle creation = dataset_properties(rows, length, is_scalar);
    Handle set(
        H5Dcreate2(group, name.c_str(), type.id(), space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
        H5Dclose);
    require(set);
    require(rows == 0 || H5Dwrite(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, content) >= 0);
    return set;
  }

  Handle put(hid_t group, const table::SeriesView& series, Length length) {
    const hsize_t count = series.values.size();
    Handle set = put(group, series.name, {H5Tcopy(H5T_IEEE_F64LE), H5Tclose}, simple_space(count, length),
                     count, series.values.data(), length);
    put_text(set.id(), "units", series.unit);
    if (series.words.empty()) return set;
    std::vector<const char*> words;
    for (const std::string& word : series.words) words.push_back(word.c_str());
    put_texts(set.id(), "words", simple_space(words.size()), words);
    return set;
  }

  void put(hid_t group, const table::SweptValue& value) {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    Handle set = value.word.empty()
                     ? put(group, value.name, {H5Tcopy(H5T_IEEE_F64LE), H5Tclose}, space, 1, &value.number)
                     : put(group, value.name, text_type(value.word.size()), space, 1, value.word.data());
    put_text(set.id(), "units", value.unit);
    require(set.close());
  }

  void put(const table::RunView& run, Length length) {
    Handle group;
    const Handle creation = group_properties(H5P_GROUP_CREATE);
    if (!run.name.empty())
      group = {H5Gcreate2(root.id(), run.name.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Gclose};
    const hid_t place = run.name.empty() ? root.id() : require(group).id();
    close_growing();
    for (const table::SweptValue& value : run.swept) put(place, value);
    for (const table::SeriesView& series : run.series) {
      Handle set = put(place, series, length);
      length == Length::growing ? growing.push_back(std::move(set)) : require(set.close());
    }
    rows = run.series.empty() ? 0 : run.series.front().values.size();
    require(group.close());
  }

  /// Closes the datasets of the current run, which writes their buffered rows.
  void close_growing() {
    for (Handle& set : growing) require(set.close());
    growing.clear();
  }

  void append(const Handle& set, std::span<const double> values) const {
    const hsize_t count = values.size(), total = rows + count;
    require(H5Dset_extent(set.id(), &total) >= 0);
    const Handle piece = simple_space(count), whole(H5Dget_space(set.id()), H5Sclose);
    require(H5Sselect_hyperslab(whole.id(), H5S_SELECT_SET, &rows, nullptr, &count, nullptr) >= 0);
    require(H5Dwrite(set.id(), H5T_NATIVE_DOUBLE, piece.id(), whole.id(), H5P_DEFAULT, values.data()) >= 0);
  }

  void flush() const { require(H5Fflush(file.id(), H5F_SCOPE_LOCAL) >= 0); }

  void name() {
    if (!std::exchange(named, true)) writer.finish();
  }

  void close() {
    close_growing();
    require(root.close() && H5Fflush(file.id(), H5F_SCOPE_LOCAL) >= 0 && file.close());
  }
};

Hdf5Writer::Hdf5Writer(const std::string& path, const std::string& title) {
  const Session session;
  file_ = std::make_unique<File>(path);
  file_->put_text(file_->root.id(), "title", title);
}

Hdf5Writer::~Hdf5Writer() {
  const Session session;
  file_.reset();
}

void Hdf5Writer::add(const table::RunView& run) {
  const Session session;
  file_->put(run, Length::fixed);
}

void Hdf5Writer::begin(const table::RunView& run) {
  const Session session;
  file_->put(run, Length::growing);
}

void Hdf5Writer::append(std::span<const std::span<const double>> columns) {
  if (columns.empty() || columns.front().empty()) return;
  const Session session;
  for (std::size_t i = 0; i < columns.size(); ++i) file_->append(file_->growing[i], columns[i]);
  file_->rows += columns.front().size();
}

void Hdf5Writer::flush() {
  const Session session;
  file_->flush();
}

void Hdf5Writer::publish() {
  flush();
  file_->name();
}

void Hdf5Writer::finish() {
  const Session session;
  file_->close();
  file_->name();
}

}  // namespace stepwire::hdf5
