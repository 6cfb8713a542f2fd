#include "engine/app/session/build_note.hpp"

#include "engine/base/hash/hash.hpp"
#include "engine/base/io/file.hpp"
#include "engine/simulate/blockset/blockset.hpp"

namespace stepwire::session {

json::Json build_note(const LoadedModel& model) {
  static const std::string program = hash::hash_of(io::read_file("/proc/self/exe"));
  json::Json note = json::Json::object().set("program", program);
  std::vector<std::string> blocks;
  for (const std::string& folder : model.blocksets) blocks.push_back(blockset::blockset_hash(folder));
  if (!blocks.empty()) note.set("blocks", json::Json::list_of(blocks));
  return note;
}

}  // namespace stepwire::session
