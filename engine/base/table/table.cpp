#include "engine/base/table/table.hpp"

#include <algorithm>

namespace stepwire::table {

const Column* Table::find(std::string_view name) const {
  const auto at =
      std::find_if(columns.begin(), columns.end(), [name](const Column& c) { return c.name == name; });
  return at == columns.end() ? nullptr : &*at;
}

}  // namespace stepwire::table
