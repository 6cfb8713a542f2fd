#pragma once

#include "engine/model/block/declare.hpp"

namespace stepwire::diagram {

/// An input of a diagram that is run by itself: whoever runs it writes the value, before a tick is evaluated.
/// Until then it holds the `default` of the file.
struct ExternalInput {
  PerElement value = 0.0;
  Output<> y{};

  void start() { y = value; }

  static void declare(Declare<ExternalInput>& is);
};

/// The type of such blocks; no diagram file can name it.
const BlockType& external_input_type();

}  // namespace stepwire::diagram
