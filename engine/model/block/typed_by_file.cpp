#include "engine/model/block/typed_by_file.hpp"

#include <map>
#include <mutex>

namespace stepwire {

namespace {

struct Known {
  std::mutex mutex;
  std::map<std::string, TypeOfFile, std::less<>> types;
};

Known& known() {
  static Known all;
  return all;
}

}  // namespace

void note_typed_by_file(const std::string& name, TypeOfFile of) {
  const std::lock_guard lock(known().mutex);
  known().types[name] = of;
}

TypeOfFile find_typed_by_file(std::string_view name) {
  const std::lock_guard lock(known().mutex);
  const auto found = known().types.find(name);
  return found == known().types.end() ? nullptr : found->second;
}

}  // namespace stepwire
