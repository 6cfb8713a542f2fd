#include "engine/app/language/wire_edits.hpp"

#include <fmt/format.h>

#include <charconv>

#include "engine/app/language/signal_list.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire::language {

namespace {

const yaml::Entry& block_of(const yaml::Document& document, const std::string& name) {
  const yaml::Entry* block = DiagramFiles::entry(document, "blocks", name);
  if (!block || !block->value.is_map())
    throw EditRefused(fmt::format("this file has no block '{}'", text::visible(name)));
  return *block;
}

/// Returns the source signal of an output of the file.
const yaml::Node& signal_of_output(const yaml::Document& document, const std::string& name) {
  const yaml::Entry* output = DiagramFiles::entry(document, "outputs", name);
  const yaml::Node* signal = output && output->value.is_map() ? output->value.find("signal")
                             : output                         ? &output->value
                                                              : nullptr;
  if (!signal) throw EditRefused(fmt::format("this file has no output '{}'", text::visible(name)));
  return *signal;
}

/// Replaces an item of a list, or appends one.
void connect_item(TreeEdits& edits, const yaml::Node& list, std::optional<std::size_t> item,
                  const std::string& source) {
  if (!item && list.items.size() == 1) item = 0;
  if (item.value_or(list.items.size()) > list.items.size())
    throw EditRefused(fmt::format("this list has {}", text::counted(list.items.size(), "signal")));
  if (!item || *item == list.items.size()) return edits.add_item(list, source);
  edits.replace(list.items[*item], source);
}

}  // namespace

InputPlace input_place(const std::string& input) {
  const std::size_t dot = input.rfind('.');
  std::size_t number = 0;
  const char* const end = input.data() + input.size();
  if (dot != std::string::npos && std::from_chars(input.data() + dot + 1, end, number).ptr == end &&
      number > 0)
    return {input.substr(0, dot), number - 1};
  return {input};
}

std::string source_text(DiagramFiles& files, const std::string& file, const yaml::Document& document,
                        const std::string& from) {
  const std::string name = from.starts_with('.') ? from.substr(1) : from;
  if (const yaml::Entry* block = DiagramFiles::block_at_start(document, name)) {
    const auto outputs = files.outputs(file, *block);
    const bool only = files.has_one_output(file, *block) && name == block->key + "." + outputs.front();
    return only ? block->key : name;
  }
  if (!DiagramFiles::entry(document, "inputs", name))
    throw EditRefused(fmt::format("this file has no signal '{}'", text::visible(name)));
  return name;
}

void connect(TreeEdits& edits, DiagramFiles& files, const std::string& file, const yaml::Document& document,
             const Connect& edit) {
  const std::string source = source_text(files, file, document, edit.from);
  if (edit.to.empty()) return edits.replace(signal_of_output(document, edit.input), source);
  const yaml::Node& block = block_of(document, edit.to).value;
  const InputPlace place = input_place(edit.input);
  const yaml::Node* fed = block.find(place.key);
  const std::size_t item = place.item.value_or(0);
  if (!fed && item == 0) return edits.add(block, place.key, source);
  if (!fed || (!fed->is_list() && item > 1))
    throw EditRefused(fmt::format("'{}' has no signal {} before it", place.key, item));
  if (fed->is_list()) return connect_item(edits, *fed, place.item, source);
  edits.replace(*fed, item == 0 ? source : fmt::format("[{}, {}]", fed->text, source));
}

void disconnect(TreeEdits& edits, const yaml::Document& document, const Disconnect& edit) {
  if (edit.to.empty()) throw EditRefused("an output of a file always has a signal; connect another one");
  const yaml::Node& block = block_of(document, edit.to).value;
  const InputPlace place = input_place(edit.input);
  for (const yaml::Entry& entry : block.entries) {
    if (entry.key != place.key) continue;
    const std::size_t count = entry.value.items.size();
    if (count < 2 && place.item.value_or(0) == 0) return edits.remove(block, entry);
    if (place.item && *place.item < count)
      return edits.remove_item(entry.value, entry.value.items[*place.item]);
  }
  throw EditRefused(
      fmt::format("nothing feeds '{}' of '{}'", text::visible(edit.input), text::visible(edit.to)));
}

}  // namespace stepwire::language
