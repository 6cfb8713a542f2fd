#include "engine/app/simulink/placeholder.hpp"

#include <fmt/format.h>

#include "engine/app/simulink/plain_text.hpp"
#include "engine/base/yaml/yaml_text.hpp"

namespace stepwire::simulink {

namespace {

/// Returns the type of a block for people: "Reference simulink/Continuous/PID Controller".
std::string type_of(const BlockWriter& write) {
  const std::string library = on_one_line(write.text("SourceBlock"));
  return write.block().type + (library.empty() ? "" : " " + library);
}

/// Returns the parameters of a block as comments.
std::string parameter_comments(const Block& block) {
  std::string text;
  for (const auto& [name, value] : block.texts)
    if (!value.empty() && name != "Position" && name != "ZOrder" && name != "Ports" &&
        !name.starts_with("PortCounts"))
      text += fmt::format("#   {} = {}\n", on_one_line(name), on_one_line(value).substr(0, 500));
  for (const auto& [name, value] : block.mask)
    text += fmt::format("#   {} = {}\n", on_one_line(name), on_one_line(value).substr(0, 500));
  return text;
}

}  // namespace

std::string write_placeholder(BlockWriter& write, const std::string& reference, const std::string& reason) {
  const int inputs = write.inputs(), outputs = write.outputs();
  yaml::Node root, in, out, blocks;
  add(root, "stepwire", word("1"));
  add(root, "title", word(fmt::format("To be written: {}", on_one_line(write.block().name))));
  write.make_part(reference);
  for (int i = 1; i <= inputs; ++i) {
    add(in, fmt::format("u{}", i), yaml::Node{});
    write.key(fmt::format("u{}", i), write.source(i));
  }
  for (int i = 1; i <= outputs; ++i) {
    add(out, fmt::format("y{}", i), word("nothing"));
    if (outputs > 1) write.output(i, fmt::format("{}.y{}", write.name(), i));
  }
  if (inputs > 0) add(root, "inputs", std::move(in));
  if (outputs > 0) add(root, "outputs", std::move(out));
  if (outputs > 0) add(blocks, "nothing", map_of({{"block", word("Constant")}, {"value", word("0")}}));
  add(blocks, fmt::format("write_the_blocks_of_{}_here", valid_name(write.block().name)),
      map_of({{"block", word("Assert")}, {"u", word("0")}}));
  add(root, "blocks", std::move(blocks));
  return fmt::format(
      "# In place of a block of Simulink, {}: {}.\n# Write its blocks here, and remove the Assert.\n{}{}",
      type_of(write), reason, parameter_comments(write.block()), yaml::yaml_text(root));
}

}  // namespace stepwire::simulink
