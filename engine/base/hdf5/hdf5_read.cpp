#include "engine/base/hdf5/hdf5_read.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <set>
#include <vector>

#include "engine/base/hdf5/handle.hpp"
#include "engine/base/hdf5/objects.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/temporary.hpp"
#include "engine/base/table/isolated_table.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::hdf5 {
namespace {

constexpr std::size_t max_words = 1'000'000;  // in one column

/// Returns the texts of an attribute that is a list of variable-length strings; an empty list otherwise.
std::vector<std::string> texts_attribute(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return {};
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Handle type(H5Aget_type(attribute.id()), H5Tclose), space(H5Aget_space(attribute.id()), H5Sclose);
  if (!attribute || H5Tis_variable_str(type.id()) <= 0) return {};
  const hssize_t count = H5Sget_simple_extent_npoints(space.id());
  if (count <= 0 || static_cast<std::size_t>(count) > max_words) return {};
  std::vector<char*> texts(static_cast<std::size_t>(count));
  if (H5Aread(attribute.id(), type.id(), texts.data()) < 0) return {};
  std::vector<std::string> words;
  for (char* const text : texts) {
    words.emplace_back(text ? text : "");
    H5free_memory(text);
  }
  return words;
}

/// Size of a dataset of one or two dimensions.
struct Size {
  std::size_t rows = 1, columns = 1;
};

/// Reader of one dataset.
class Dataset {
 public:
  Dataset(hid_t set, const std::string& name, table::RecordTable& table, std::size_t& budget)
      : set_(set),
        name_(name),
        table_(table),
        budget_(budget),
        type_(H5Dget_type(set), H5Tclose),
        space_(H5Dget_space(set), H5Sclose),
        unit_(text_attribute(set, "units")) {
    if (!type_ || !space_) Session::refuse(fmt::format("'{}' is damaged", name));
    if (unit_.empty()) unit_ = text_attribute(set, "unit");
  }

  void read() {
    if (H5Tget_class(type_.id()) == H5T_COMPOUND) return read_members();
    const std::string problem = problem_of(type_);
    if (!problem.empty()) return note(name_, problem);
    read_numbers(name_, {H5Tcopy(H5T_NATIVE_DOUBLE), H5Tclose});
    if (auto words = texts_attribute(set_, "words"); !words.empty()) table_.words[name_] = std::move(words);
  }

 private:
  void note(const std::string& name, const std::string& problem) {
    table_.columns.push_back({name, "", {}});
    table_.problems[name] = fmt::format("'{}' {}", name, problem);
  }

  /// Returns the reason why a type cannot be a column of numbers; empty if it can.
  std::string problem_of(const Handle& type) const {
    const H5T_class_t kind = H5Tget_class(type.id());
    if (kind == H5T_STRING) return "holds text, not numbers";
    if (kind != H5T_INTEGER && kind != H5T_FLOAT && kind != H5T_ENUM) return "holds no real numbers";
    const Handle properties(H5Dget_create_plist(set_), H5Pclose);
    if (H5Pget_external_count(properties.id()) > 0 || H5Pget_layout(properties.id()) == H5D_VIRTUAL)
      return "lies in other files, which are not read";
    if (H5Sget_simple_extent_ndims(space_.id()) > 2) return "has more than two dimensions";
    return H5Sget_simple_extent_npoints(space_.id()) == 0 ? "has no rows" : "";
  }

  Size size() const {
    hsize_t counts[2] = {1, 1};
    H5Sget_simple_extent_dims(space_.id(), counts, nullptr);
    return {counts[0], counts[1]};
  }

  void spend(const std::string& name, Size size) {
    constexpr std::size_t most = std::numeric_limits<std::size_t>::max() / sizeof(double);
    if (size.columns > max_columns)
      throw table::TableError(
          fmt::format("'{}' has {} columns; at most {} are read", name, size.columns, max_columns));
    if (size.rows > most / size.columns || size.rows * size.columns * sizeof(double) > budget_)
      throw table::TableError(
          fmt::format("'{}' has {} x {} numbers, more than a file of this size may unpack to", name,
                      size.rows, size.columns));
    budget_ -= size.rows * size.columns * sizeof(double);
  }

  /// Reads the whole dataset at once, with `numbers` doubles for each element.
  std::vector<double> numbers_of_elements(const Handle& as, std::size_t numbers) const {
    const Size count = size();
    std::vector<double> all(count.rows * count.columns * numbers);
    if (H5Dread(set_, as.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) < 0)
      Session::refuse(fmt::format(
          "'{}' cannot be read; it is damaged, cut off, or packed by a filter that is not installed", name_));
    return all;
  }

  /// Returns every `step`-th number from `first` on.
  static std::vector<double> picked(const std::vector<double>& all, std::size_t first, std::size_t step) {
    std::vector<double> values;
    values.reserve(all.size() / step + 1);
    for (std::size_t i = first; i < all.size(); i += step) values.push_back(all[i]);
    return values;
  }

  /// Adds the columns of a row-major matrix; a vector is one column.
  void add_columns(const std::string& name, std::vector<double> all) {
    const Size count = size();
    if (count.columns == 1 || count.rows == 1) return table_.columns.push_back({name, unit_, std::move(all)});
    for (std::size_t column = 0; column < count.columns; ++column)
      table_.columns.push_back(
          {fmt::format("{}({})", name, column + 1), unit_, picked(all, column, count.columns)});
  }

  void read_numbers(const std::string& name, const Handle& as) {
    spend(name, size());
    add_columns(name, numbers_of_elements(as, 1));
  }

  /// A member of a compound type, and the reason why it is unreadable; empty if it is readable.
  struct Member {
    std::string name, problem;
  };

  std::vector<Member> members_of_type() const {
    std::vector<Member> members;
    const int count = H5Tget_nmembers(type_.id());
    for (int i = 0; i < count; ++i) {
      const auto index = static_cast<unsigned>(i);
      char* const text = H5Tget_member_name(type_.id(), index);
      members.push_back({text ? text : "", problem_of({H5Tget_member_type(type_.id(), index), H5Tclose})});
      H5free_memory(text);
    }
    return members;
  }

  /// Reads all members in one pass over the dataset.
  void read_members() {
    const std::vector<Member> members = members_of_type();
    const auto readable =
        static_cast<std::size_t>(std::ranges::count_if(members, &std::string::empty, &Member::problem));
    const Handle record(H5Tcreate(H5T_COMPOUND, std::max<std::size_t>(readable, 1) * sizeof(double)),
                        H5Tclose);
    std::size_t place = 0;
    for (const Member& member : members) {
      if (!member.problem.empty()) continue;
      spend(name_ + "." + member.name, size());
      H5Tinsert(record.id(), member.name.c_str(), place++ * sizeof(double), H5T_NATIVE_DOUBLE);
    }
    const std::vector<double> all =
        readable > 0 ? numbers_of_elements(record, readable) : std::vector<double>();
    place = 0;
    for (const Member& member : members) {
      const std::string name = name_ + "." + member.name;
      member.problem.empty() ? add_columns(name, picked(all, place++, readable)) : note(name, member.problem);
    }
  }

  hid_t set_;
  const std::string& name_;
  table::RecordTable& table_;
  std::size_t& budget_;
  Handle type_, space_;
  std::string unit_;
};

/// Appends the columns of a dataset to the table, and subtracts their bytes from the budget. Non-numeric or
/// unreadable data become a problem of a column without rows. Throws TableError, without the name of the
/// file, for a damaged dataset or an exhausted budget.
void read_dataset(std::int64_t set, const std::string& name, table::RecordTable& table, std::size_t& budget) {
  Dataset(set, name, table, budget).read();
}

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
