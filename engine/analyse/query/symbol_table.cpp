#include "engine/analyse/query/symbol_table.hpp"

#include <algorithm>

namespace stepwire::query {

const RecordedName* SymbolTable::find(std::string_view name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const RecordedName& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

bool SymbolTable::lacks(std::string_view name) const {
  return find(name) == nullptr && std::find(signals.begin(), signals.end(), name) != signals.end();
}

}  // namespace stepwire::query
