#include "engine/app/session/version.hpp"

#include "engine/base/hash/hash.hpp"
#include "engine/base/io/file.hpp"
#include "engine/simulate/blockset/blockset.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire::session {

json::Json build_note(const LoadedModel& model) {
  static const std::string program = hash::hash_of(io::read_file("/proc/self/exe"));
  json::Json note = json::Json::object().set("program", program);
  std::vector<std::string> blocks;
  for (const std::string& folder : model.blocksets) blocks.push_back(blockset::blockset_hash(folder));
  if (!blocks.empty()) note.set("blocks", json::Json::list_of(blocks));
  return note;
}

std::string search_key(const LoadedModel& model) {
  hash::Hash hash;
  hash.add(model.hash).add(build_note(model).text(-1)).add(io::read_file(model.file));
  for (const diagram::Setting& setting : model.options.settings) hash.add(setting.name).add(setting.value);
  hash.add(model.options.stop.value_or(""));
  for (std::size_t point = 0; point < model.job.points.size(); ++point)
    hash.add(run::settings_text(model.job.settings_of(point)));
  return hash.text();
}

std::string program_version() {
  return STEPWIRE_VERSION;
}

std::string compiler_version() {
#ifdef __clang__
  const std::string name = "clang++ ";
#else
  const std::string name = "g++ ";
#endif
  return name + __VERSION__ + " " + STEPWIRE_FLAGS;
}

}  // namespace stepwire::session
