#include "engine/base/hdf5/hdf5_read.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <set>
#include <vector>

#include "engine/base/hdf5/dataset.hpp"
#include "engine/base/hdf5/handle.hpp"
#include "engine/base/hdf5/objects.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/temporary.hpp"
#include "engine/base/table/isolated_table.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::hdf5 {

namespace {

constexpr int max_depth = 16;  // of nested groups

/// Walk over the groups of one file.
class Reading {
 public:
  explicit Reading(std::size_t file_size) : budget_(table::max_unpacked(file_size)) {}

  void read(const Handle& group, const std::string& path, int depth = 0) {
    if (depth > max_depth)
      throw table::TableError(fmt::format("its groups lie deeper than {} in each other", max_depth));
    for (const std::string& name : links_of(group)) read_object(group, path, name, depth);
  }

  void read_named(const Handle& root, const std::string& name) {
    H5L_info_t link{};
    if (H5Lexists(root.id(), name.c_str(), H5P_DEFAULT) <= 0) return;
    if (H5Lget_info(root.id(), name.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD) return;
    read_object(root, "", name, 0);
  }

  table::RecordTable done() { return std::move(table_); }

 private:
  void read_object(const Handle& group, const std::string& path, const std::string& name, int depth) {
    const Handle object(H5Oopen(group.id(), name.c_str(), H5P_DEFAULT), H5Oclose);
    if (!object) Session::refuse(fmt::format("'{}' is damaged", path + name));
    take(object, path + name, depth);
  }

  void take(const Handle& object, const std::string& name, int depth) {
    const H5I_type_t kind = H5Iget_type(object.id());
    if (kind == H5I_GROUP && seen_.insert(place_of(object)).second) read(object, name + "/", depth + 1);
    if (kind == H5I_DATASET) read_dataset(object.id(), name, table_, budget_);
    if (table_.columns.size() > max_columns)
      throw table::TableError(fmt::format("it has more than {} columns", max_columns));
  }

  std::size_t budget_;
  std::set<std::uint64_t> seen_;
  table::RecordTable table_;
};

/// Returns the size of a readable file.
std::size_t size_of(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) io::refuse_file(path, error.value());
  if (::access(path.c_str(), R_OK) != 0) io::refuse_file(path, errno);
  return size;
}

table::RecordTable read_all(const Handle& root, Reading& reading) {
  reading.read(root, "");
  table::RecordTable table = reading.done();
  if (table.columns.empty()) throw table::TableError("there is no dataset in the file");
  return table;
}

/// Reads a file from its root. Errors and problems begin with the file name.
template <class Read>
table::RecordTable read_file(const std::string& path, std::size_t file_size, const Read& read) {
  try {
    const Handle file = open_file(path);
    Reading reading(file_size);
    table::RecordTable table = read({H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose}, reading);
    for (auto& [column, problem] : table.problems) problem = fmt::format("{}: {}", path, problem);
    return table;
  } catch (const table::TableError& error) {
    throw table::TableError(fmt::format("{}: {}", path, error.what()));
  }
}

template <class Read>
table::RecordTable read_isolated(const std::string& path, const Read& read) {
  const std::size_t size = size_of(path);
  const Session session;  // held during the fork, so that no other thread is inside the library
  return table::read_isolated(path, size, [&] { return read_file(path, size, read); });
}

}  // namespace

table::RecordTable read_hdf5(const std::string& path) {
  return read_isolated(path, read_all);
}

table::RecordTable read_hdf5_groups(const std::string& path, const std::vector<std::string>& groups) {
  return read_isolated(path, [&](const Handle& root, Reading& reading) {
    for (const std::string& name : groups) reading.read_named(root, name);
    return reading.done();
  });
}

}  // namespace stepwire::hdf5
