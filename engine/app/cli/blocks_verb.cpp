#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/reference/block_json.hpp"
#include "engine/app/reference/block_page.hpp"
#include "engine/app/reference/part_reference.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/inside.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/text/natural_order.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/model/diagram/part_file.hpp"
#include "engine/model/diagram/simulink_names.hpp"

namespace stepwire::cli {
namespace {

struct BlocksCall {
  std::string name;
  bool json = false;
  bool markdown = false;
};

std::string one_block(const BlocksCall& call, const BlockType& type) {
  if (call.json) return reference::block_json(type).text() + "\n";
  return call.markdown ? reference::block_markdown(type) : reference::block_page(type);
}

std::string all_of(const BlocksCall& call, const Registry& registry) {
  if (call.json) return reference::blocks_json(registry).text() + "\n";
  return call.markdown ? reference::blocks_markdown(registry) : reference::block_list(registry);
}

bool is_diagram(const std::filesystem::path& path) {
  return path.extension() == ".yaml" || path.extension() == ".yml";
}

/// Prints the page of a part, in the form of a block's page; for a folder, prints a list of its diagram
/// files.
ExitCode show_parts(const std::string& path) {
  io::require_inside(path);
  if (!std::filesystem::is_directory(path)) {
    const yaml::Document document = yaml::read_document(path);
    put_data(reference::page_text(reference::part_reference(document, io::read_file(path))));
    return ExitCode::done;
  }
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(path))
    if (is_diagram(entry.path())) files.push_back(entry.path().string());
  std::ranges::sort(files, text::naturally_less);
  std::vector<yaml::Document> documents;
  for (const std::string& file : files) documents.push_back(yaml::read_document(file));
  put_data(reference::part_list(documents));
  return ExitCode::done;
}

/// Returns the file of a part by the name that a diagram of the present folder gives it, as
/// stepwire/oscillator. Throws Error with the nearest name if there is none.
std::string part_of(const std::string& name) {
  std::string file = diagram::part_file("", name);
  if (std::filesystem::exists(file)) return file;
  throw yaml::Error(yaml::Fault{
      {name, {}}, "", "no such file" + diagram::other_part_places(name) + diagram::near_part("", name), {}});
}

/// Returns the parts of a name in CamelCase that are long enough to be searched: Motor of DcMotor.
std::vector<std::string> words_of(const std::string& name) {
  constexpr std::size_t shortest = 4;
  std::vector<std::string> words(1);
  for (const char letter : name) {
    if (std::isupper(static_cast<unsigned char>(letter))) words.emplace_back();
    words.back() += letter;
  }
  std::erase_if(words, [&](const std::string& word) { return word.size() < shortest || word == name; });
  return words;
}

/// Prints the results for a word that is no block name: the answer to a name of Simulink, or the blocks with
/// the word, or with a part of it, in their page.
ExitCode search(const std::string& word, const Registry& registry) {
  const std::string answer = diagram::answer_to_simulink(word),
                    found = reference::blocks_about(registry, word);
  if (!answer.empty()) {
    put_data(fmt::format("there is no block '{}'; {}\n", text::visible(word), answer));
    return ExitCode::done;
  }
  if (!found.empty()) {
    put_data(found);
    return ExitCode::done;
  }
  for (const std::string& part : words_of(word))
    if (const std::string about = reference::blocks_about(registry, part); !about.empty()) {
      put_data(fmt::format("there is no block '{}'; blocks about '{}' are:\n\n{}", text::visible(word), part,
                           about));
      return ExitCode::done;
    }
  complain(
      "there is no block '{}', and no page has this word{}\n", text::visible(word),
      yaml::did_you_mean(word, reference::searched_words(registry), "'stepwire blocks' lists them").text());
  return ExitCode::wrong;
}

ExitCode show_blocks(const BlocksCall& call, const Registry& registry) {
  if (call.name.empty()) {
    put_data(all_of(call, registry));
    return ExitCode::done;
  }
  const BlockType* type = registry.find(call.name);
  if (!type && std::filesystem::is_directory(call.name))
    return guarded([&] { return show_parts(call.name); });
  if (!type && (is_diagram(call.name) || call.name.find('/') != std::string::npos))
    return guarded([&] { return show_parts(part_of(call.name)); });
  if (!type) return search(call.name, registry);
  put_data(one_block(call, *type));
  return ExitCode::done;
}

Action declare_blocks(CLI::App& verb) {
  const auto call = std::make_shared<BlocksCall>();
  verb.add_option("NAME", call->name,
                  "a block, a word of its page, or a part: its file, or a folder of them");
  verb.add_flag("--json", call->json, "as JSON");
  verb.add_flag("--markdown", call->markdown, "as Markdown");
  return [call](const Registry& registry) { return show_blocks(*call, registry); };
}

}  // namespace

Verb blocks_verb() {
  return {"blocks", "list the blocks, or explain one",
          "Example:\n  stepwire blocks PID\n  stepwire blocks filter\n  stepwire blocks "
          "diagrams/parts/polar-rig.yaml\n  stepwire blocks --markdown > blocks.md",
          declare_blocks};
}

}  // namespace stepwire::cli
