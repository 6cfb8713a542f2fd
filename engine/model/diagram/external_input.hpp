#pragma once

#include "engine/model/block/declare.hpp"

namespace stepwire::diagram {

/// Input of a diagram that runs by itself. The caller of the run may write its value before a tick is
/// evaluated; until then it holds the `default` of the file.
struct ExternalInput {
  PerElement value = 0.0;
  Output<> y{};

  void start() { y = value; }

  static void declare(Declare<ExternalInput>& is);
};

/// Returns the type of such blocks; diagram files cannot name it.
const BlockType& external_input_type();

}  // namespace stepwire::diagram
