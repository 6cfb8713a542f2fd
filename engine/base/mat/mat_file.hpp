#pragma once

#include <string>
#include <vector>

#include "engine/base/table/record_table.hpp"

namespace stepwire::mat {

/// Reads every real vector of a MATLAB file (level 4, 5 or 7.3) as a column. A matrix gives columns
/// "name(1)", "name(2)", ...; a field of a struct is "out.signals.values", as in Simulink's structure with
/// time. Columns may differ in length.
///
/// A variable that is not a real array, such as a complex one or an object, is a problem that names the cure
/// in MATLAB. An HDF5 file under this name is read as such. Throws the errors of read_csv, also for a damaged
/// file. Damage inside of a level 7.3 file is detected by the HDF5 library, which runs in a process of its
/// own.
table::RecordTable read_mat(const std::string& path);

inline constexpr std::size_t max_bytes_of_level_5 = 0x7FFF'FFFF;  ///< of one variable

/// Writes each column as a column vector of doubles. Characters that MATLAB does not allow in names become
/// '_', and names are made unique. The cell arrays "names" and "units" have the original names and units in
/// the same order. The file has level 5, or level 7.3 where a column exceeds `max_bytes`.
void write_mat(const std::string& path, const table::Table& table,
               std::size_t max_bytes = max_bytes_of_level_5);

/// A matrix in column-major order.
struct NamedMatrix {
  std::string name;
  std::size_t rows = 0, columns = 0;
  std::vector<double> values;
};
struct NamedTextList {
  std::string name;
  std::vector<std::string> texts;
};

/// Writes matrices as doubles and text lists as cell arrays; their names must be valid in MATLAB.
void write_mat(const std::string& path, const std::vector<NamedMatrix>& matrices,
               const std::vector<NamedTextList>& texts);

}  // namespace stepwire::mat
