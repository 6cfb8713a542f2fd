#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <unordered_map>

#include "engine/base/hdf5/handle.hpp"
#include "engine/base/hdf5/hdf5_read.hpp"
#include "engine/base/io/inside.hpp"
#include "engine/base/mat/mat_content.hpp"
#include "engine/base/mat/mat_file.hpp"
#include "engine/base/mat/mat_names.hpp"
#include "engine/base/table/isolated_table.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::mat {
namespace {

constexpr std::size_t max_columns = 20'000;

/// Version and byte order in the header of levels 5 and 7.3; version 0 without such a header.
struct Header {
  unsigned version = 0;
  bool swap = false;
};

Header header_of(std::string_view file) {
  if (file.size() < 128) return {};
  std::array<std::uint16_t, 2> mark{};
  std::memcpy(mark.data(), file.data() + 124, 4);
  if (mark[1] == 0x4D49) return {mark[0], false};
  if (mark[1] == 0x494D) return {static_cast<unsigned>(mark[0] >> 8 | (mark[0] & 0xFF) << 8), true};
  return {};
}

/// Runs a reader and prefixes its errors and problems with the file name.
template <class Read>
table::RecordTable named(const std::string& path, const Read& read) {
  try {
    table::RecordTable table = read();
    for (auto& [column, problem] : table.problems) problem = fmt::format("{}: {}", path, problem);
    return table;
  } catch (const table::TableError& error) {
    throw table::TableError(fmt::format("{}: {}", path, error.what()));
  }
}

/// Appends a vector as one column, and each column of a larger array as one.
void append_columns(table::Table& table, MatVariable& variable) {
  const std::size_t longest = *std::max_element(variable.size.begin(), variable.size.end());
  const std::vector<double>& all = variable.values;
  if (longest == all.size()) return table.columns.push_back({variable.name, "", std::move(variable.values)});
  const std::size_t rows = variable.size.front();
  if (all.size() / rows + table.columns.size() > max_columns)
    throw table::TableError(fmt::format("'{}' has {} columns; at most {} are read", variable.name,
                                        all.size() / rows, max_columns));
  for (std::size_t first = 0; first < all.size(); first += rows) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
    table.columns.push_back({fmt::format("{}({})", variable.name, first / rows + 1),
                             "",
                             {begin, begin + static_cast<std::ptrdiff_t>(rows)}});
  }
}

/// Restores the original names and units of a file of ours, in the order of the stored names: level 7.3 lists
/// its variables in another order.
void restore_names(table::Table& table, const MatContent& content) {
  if (content.names.size() != table.columns.size() || content.units.size() != table.columns.size()) return;
  const std::vector<std::string> variables = matlab_names(content.names);
  std::unordered_map<std::string_view, std::size_t> places;
  for (std::size_t i = 0; i < variables.size(); ++i) places.emplace(table.columns[i].name, i);
  if (!std::ranges::all_of(variables, [&](const std::string& name) { return places.contains(name); })) return;
  table::Table ordered;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    std::vector<double>& values = table.columns[places.at(variables[i])].values;
    ordered.columns.push_back({content.names[i], content.units[i], std::move(values)});
  }
  table = std::move(ordered);
}

void require_names(const table::Table& table) {
  std::set<std::string_view> seen;
  for (const table::Column& column : table.columns)
    if (!seen.insert(column.name).second)
      throw table::TableError(fmt::format("two columns are named '{}'", column.name));
}

/// Appends unreadable variables as columns without rows.
void append_problems(table::RecordTable& table, const MatContent& content) {
  for (const MatProblem& problem : content.problems) {
    table.columns.push_back({problem.name, "", {}});
    table.problems.emplace(problem.name, problem.text);
  }
}

table::RecordTable table_of(MatContent content) {
  table::RecordTable table;
  for (MatVariable& variable : content.variables) append_columns(table, variable);
  if (table.columns.empty() && !content.problems.empty())
    throw table::TableError(content.problems.front().text);
  if (table.columns.empty()) throw table::TableError("there is no real vector in the file");
  restore_names(table, content);
  append_problems(table, content);
  require_names(table);
  return table;
}

/// Reads levels 4 and 5 with the readers of this room.
table::RecordTable read_own(const std::string& path) {
  const std::string file = io::read_file(path);
  const Header header = header_of(file);
  return table_of(header.version == 0x0100 ? read_mat_level_5(file, header.swap) : read_mat_level_4(file));
}

/// Reads level 7.3 by the HDF5 library. A file without MATLAB variables is read as a plain HDF5 file.
table::RecordTable read_by_library(const std::string& path) {
  std::error_code none;
  const std::size_t size = std::filesystem::file_size(path, none);
  table::RecordTable table;
  {
    const hdf5::Session session;  // held during the fork, so that no other thread is inside the library
    table = table::read_isolated(path, size, [&] {
      return named(path, [&] {
        MatContent content = read_mat_level_7(path, size);
        const bool foreign = content.has_foreign && content.variables.empty() && content.problems.empty();
        return foreign ? table::RecordTable{} : table_of(std::move(content));
      });
    });
  }
  return table.columns.empty() ? hdf5::read_hdf5(path) : table;
}

enum class Level { own, by_library, hdf5 };

Level level_of(const std::string& path) {
  io::require_inside(path);
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return Level::own;
  std::array<char, 128> start{};
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), start.size());
  const std::string_view bytes(start.data(), static_cast<std::size_t>(file.gcount()));
  if (bytes.starts_with("\x89HDF\r\n")) return Level::hdf5;
  return header_of(bytes).version == 0x0200 ? Level::by_library : Level::own;
}

}  // namespace

table::RecordTable read_mat(const std::string& path) {
  switch (level_of(path)) {
    case Level::hdf5:
      return hdf5::read_hdf5(path);
    case Level::by_library:
      return read_by_library(path);
    case Level::own:
      break;
  }
  return named(path, [&] { return read_own(path); });
}

}  // namespace stepwire::mat
