#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

#include "blocks/register.hpp"
#include "engine/app/language/edits.hpp"
#include "engine/app/language/signal_list.hpp"

namespace stepwire::language {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> examples() {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(STEPWIRE_SOURCE_DIR "/diagrams/examples"))
    if (entry.path().extension() == ".yaml") all.push_back(entry.path().string());
  std::ranges::sort(all);
  return all;
}

bool is_done(DiagramFiles& files, const std::string& file, const Connect& edit) try {
  edited(files, file, edit);
  return true;
} catch (const EditRefused&) {
  return false;
}

/// The inputs of the blocks of a file as they are named in it; of lists the first two.
std::vector<InputName> all_inputs(DiagramFiles& files, const std::string& file) {
  std::vector<InputName> all;
  for (const yaml::Entry& block : files.tree(file)->root.find("blocks")->entries) {
    const yaml::Node* kind = block.value.is_map() ? block.value.find("block") : nullptr;
    const BlockType* type = kind ? files.registry().find(kind->text) : nullptr;
    for (std::size_t i = 0; type && i < type->inputs.size(); ++i)
      all.push_back({block.key, type->inputs[i].name + (type->inputs[i].list ? ".1" : "")});
  }
  return all;
}

}  // namespace

TEST_CASE("each wire that is offered is one that the edit makes, in every example", "[full]") {
  const Registry registry = blocks();
  int made = 0;
  for (const std::string& file : examples()) {
    DiagramFiles files(registry);
    const auto signals = signals_of(analyse(files, file, Depth::draft), files, file, false);
    const std::size_t step = signals.size() / 2 + 1;  // two of each file: each edit reads it again
    for (std::size_t i = 0; i < signals.size(); i += step)
      for (const InputName& input :
           inputs_for(files, analyse(files, file, Depth::draft), file, signals[i].name)) {
        CAPTURE(file, signals[i].name, input.block, input.input);
        CHECK(is_done(files, file, {signals[i].name, input.block, input.input}));
        ++made;
      }
  }
  CHECK(made > 300);
}

TEST_CASE("a wire that is not offered is one that the edit refuses", "[full]") {
  const Registry registry = blocks();
  int refused = 0;
  for (const std::string& file : examples()) {
    DiagramFiles files(registry);
    const auto signals = signals_of(analyse(files, file, Depth::draft), files, file, false);
    if (signals.empty()) continue;
    const auto offered = inputs_for(files, analyse(files, file, Depth::draft), file, signals.back().name);
    for (const InputName& input : all_inputs(files, file)) {
      const InputName bare{input.block, input.input.substr(0, input.input.find('.'))};
      if (std::ranges::count(offered, input) + std::ranges::count(offered, bare) > 0) continue;
      CAPTURE(file, signals.back().name, input.block, input.input);
      CHECK_FALSE(is_done(files, file, {signals.back().name, input.block, input.input}));
      ++refused;
    }
  }
  CHECK(refused > 50);
}

}  // namespace stepwire::language
