#include "tests/engine/simulate/replay/left_folder.hpp"

#include <catch2/catch.hpp>

#include "engine/app/session/run_files.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/simulate/replay/verify.hpp"

namespace stepwire {

void leave(const DiagramFolder& folder, const std::string& file, const std::string& out,
           const session::FileKinds& kinds) {
  diagram::Loader loader(library());
  const session::LoadedModel model = session::load_model(loader, folder.path(file), {});
  replay::write_replay(folder.path(out), model.job);
  session::write_outputs(folder.path(out), model, session::run_model(model, {}), kinds);
}

void change(const DiagramFolder& folder, const std::string& file, const std::string& what,
            const std::string& by) {
  std::string content = io::read_file(folder.path(file));
  const std::size_t at = content.find(what);
  REQUIRE(at != std::string::npos);
  folder.write(file, content.replace(at, what.size(), by));
}

std::string verdict_of(const DiagramFolder& folder, const std::string& out) {
  std::string text;
  try {
    text = replay::verification_text(replay::verify(folder.path(out), library()));
  } catch (const yaml::Error& error) {
    text = error.what();
  } catch (const table::TableError& error) {
    text = error.what();
  }
  const std::string place = folder.path(out) + "/";
  for (auto at = text.find(place); at != std::string::npos; at = text.find(place))
    text.erase(at, place.size());
  return text;
}

}  // namespace stepwire
