#include "engine/figure/names.hpp"

#include <algorithm>

namespace stepwire {

const RecordedName* Names::find(std::string_view name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const RecordedName& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

}  // namespace stepwire
