// Lookup tables of Simulink.
#include <fmt/format.h>

#include <map>

#include "engine/app/simulink/forms.hpp"

namespace stepwire::simulink {
namespace {

std::string extrapolation_of(const std::string& method) {
  if (method == "Linear") return "linear";
  if (method == "Clip") return "hold";
  throw Untranslated("it extrapolates by " + method);
}

/// Returns the points of a dimension, listed or evenly spaced.
Value points_of(BlockWriter& write, int dimension, const std::string& otherwise) {
  const std::string key = fmt::format("BreakpointsForDimension{}", dimension);
  if (write.text("BreakpointsSpecification", "Explicit values") != "Even spacing") {
    const std::string old = dimension == 1 ? "InputValues" : key;
    return write.finite(write.text(key).empty() && !write.text(old).empty() ? old : key, otherwise);
  }
  const double first = write.known(key + "FirstPoint", "1"), by = write.known(key + "Spacing", "1");
  const Value table = write.finite("Table", "[]");
  const std::size_t count = table.is_vector() ? table.cells.size()
                            : dimension == 1  ? table.rows
                                              : table.columns;
  Value points = Value::matrix(1, count, first);
  for (std::size_t i = 0; i < count; ++i) points.cells[i].number = first + by * static_cast<double>(i);
  return points;
}

void require_linear(const BlockWriter& write) {
  const std::string method = write.text("InterpMethod", "Linear");
  if (!method.starts_with("Linear")) throw Untranslated("it interpolates by " + method);
  require(write, "DataSpecification", "Table and breakpoints");
  require(write, "UseOneInputPortForAllInputData", "off");
}

void table(BlockWriter& write) {
  require_linear(write);
  const int dimensions =
      static_cast<int>(write.known("NumberOfTableDimensions", std::to_string(write.inputs())));
  const std::string extrapolation = extrapolation_of(write.text("ExtrapMethod", "Linear"));
  if (dimensions == 1) {
    write.make("LookupTable").u().key("points", list_node(points_of(write, 1, "")));
    write.key("values", list_node(write.finite("Table", "")));
  } else if (dimensions == 2) {
    write.make("LookupTable2D").key("row", write.source(1)).key("column", write.source(2));
    write.key("rows", list_node(points_of(write, 1, ""))).key("columns", list_node(points_of(write, 2, "")));
    write.key("values", rows_node(write.finite("Table", "")));
  } else {
    throw Untranslated(fmt::format("its table has {} dimensions", dimensions));
  }
  write.key("extrapolation", extrapolation).every();
}

/// Writes the block Lookup of R2010 and before.
void old_table(BlockWriter& write) {
  static const std::map<std::string, std::string> methods{{"Interpolation-Extrapolation", "linear"},
                                                          {"Interpolation-Use End Values", "hold"}};
  const std::string method = write.text("LookUpMeth", "Interpolation-Extrapolation");
  const auto found = methods.find(method);
  if (found == methods.end()) throw Untranslated("its method is " + method);
  const std::string values = write.text("OutputValues").empty() ? "Table" : "OutputValues";
  write.make("LookupTable").u().key("points", list_node(write.finite("InputValues", "")));
  write.key("values", list_node(write.finite(values, ""))).key("extrapolation", found->second).every();
}

}  // namespace

std::vector<Translation> table_translations() {
  return {{"Lookup_n-D", "`LookupTable`, `LookupTable2D`", table}, {"Lookup", "`LookupTable`", old_table}};
}

}  // namespace stepwire::simulink
