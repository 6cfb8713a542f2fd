#include "engine/analyse/linear/junction.hpp"

#include <fmt/format.h>

namespace stepwire::linear {

void Junction::declare(Declare<Junction>& is) {
  is.block("Junction", {.doc = "A place in a wire at which a signal is cut, or something is added to it."});
  is.input<&Junction::u>({.unit = "'u", .doc = "the signal"});
  is.output<&Junction::y>({.unit = "'u", .doc = "the signal as all read it"});
  is.state<&Junction::added>({.unit = "'u", .doc = "what is added", .settable = false});
  is.state<&Junction::held>({.unit = "'u", .doc = "what stands there once it is cut", .settable = false});
  is.state<&Junction::cut>({.doc = "1 once it is cut", .settable = false});
}

const BlockType& junction_type() {
  static const BlockType type = [] {
    Declare<Junction> is;
    Junction::declare(is);
    BlockType made = is.take();
    made.timing = Timing::inherited;  // also evaluated between ticks, with its signal
    return made;
  }();
  return type;
}

int add_junction(diagram::Diagram& diagram, const diagram::SignalRef& output) {
  const int index = static_cast<int>(diagram.blocks.size());
  for (diagram::DiagramBlock& block : diagram.blocks)
    for (auto& sources : block.inputs)
      for (diagram::Source& source : sources)
        if (source.block == output.block && source.output == output.output) {
          source.block = index;
          source.output = 0;
        }
  const diagram::Origin origin = diagram.blocks[static_cast<std::size_t>(output.block)].origin;
  diagram::DiagramBlock junction(fmt::format("junction {}", index), junction_type());
  junction.origin = origin;
  diagram::Source source;
  source.block = output.block;
  source.output = output.output;
  source.origin = origin;
  junction.inputs = {{source}};
  junction.input_marks.resize(1);
  diagram.blocks.push_back(std::move(junction));
  return index;
}

}  // namespace stepwire::linear
