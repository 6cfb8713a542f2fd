#pragma once

#include <string>
#include <vector>

#include "engine/base/table/record_table.hpp"

namespace stepwire::mat {

/// Every real vector of a MATLAB file (level 4, 5 or 7.3), one column each; a matrix gives columns "name(1)",
/// "name(2)", ..., and a field of a struct "out.signals.values", as Simulink's structure with time has it.
/// Columns may differ in length here. A variable that is no real array, as a complex one or an object, is a
/// problem that names the cure in MATLAB. Errors as read_csv; an HDF5 file under this name is read as one. A
/// damaged file is an error, except that inside a file of level 7.3 only the HDF5 library can tell; it reads
/// in a process of its own.
table::RecordTable read_mat(const std::string& path);

inline constexpr std::size_t max_bytes_of_level_5 = 0x7FFF'FFFF;  ///< of a variable

/// Variables are named as the columns with what MATLAB does not allow replaced by '_' (made unique), doubles,
/// one column vector each; beside them the cell arrays "names" and "units" in the same order. The file is of
/// level 5, or of level 7.3 where a column would take more than `max_bytes` there.
void write_mat(const std::string& path, const table::Table& table,
               std::size_t max_bytes = max_bytes_of_level_5);

/// A matrix, column by column as Eigen has it, or a list of texts.
struct NamedMatrix {
  std::string name;
  std::size_t rows = 0, columns = 0;
  std::vector<double> values;
};
struct NamedTextList {
  std::string name;
  std::vector<std::string> texts;
};

/// Writes matrices as doubles and texts as cell arrays, by their names, which MATLAB must allow.
void write_mat(const std::string& path, const std::vector<NamedMatrix>& matrices,
               const std::vector<NamedTextList>& texts);

}  // namespace stepwire::mat
