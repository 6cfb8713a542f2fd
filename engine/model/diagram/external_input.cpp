#include "engine/model/diagram/external_input.hpp"

namespace stepwire::diagram {

void ExternalInput::declare(Declare<ExternalInput>& is) {
  is.block("ExternalInput",
           {.doc = "An input of the diagram, written from outside.", .timing = Timing::discrete});
  is.parameter<&ExternalInput::value>({.unit = "'u", .doc = "until something is written"});
  is.output<&ExternalInput::y>({.unit = "'u", .doc = "what was written last"});
}

const BlockType& external_input_type() {
  static const BlockType type = [] {
    Declare<ExternalInput> is;
    ExternalInput::declare(is);
    return is.take();
  }();
  return type;
}

}  // namespace stepwire::diagram
