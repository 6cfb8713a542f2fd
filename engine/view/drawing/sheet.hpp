#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/diagram/load.hpp"

namespace stepwire {

/// Where a wire begins: an output of a child, or an input of the file itself.
struct SheetSource {
  int child = -1;  ///< in Sheet::children; -1: the file itself
  int port = 0;
};

/// One thing that an input is fed by.
struct SheetFeed {
  std::optional<SheetSource> source;
  std::string constant;  ///< as the file writes it, where there is no source
};

/// An input of a child. A list has several feeds.
struct SheetInput {
  std::string name;
  std::vector<SheetFeed> feeds;
};

struct Sheet;

/// A block or a part of a file.
struct SheetChild {
  std::string name;                ///< as the file calls it
  int block = -1;                  ///< in Diagram::blocks; -1 for a part
  std::unique_ptr<Sheet> part;     ///< null for a block
  const Node* written = nullptr;   ///< its keys
  std::vector<SheetInput> inputs;  ///< those that are fed, in the order of the declaration
  std::vector<std::string> outputs;
};

/// One file at one place of a diagram as it is written: with its parts as parts, and wires between ports.
/// What a Diagram no longer has, since there the parts are opened.
struct Sheet {
  int scope = 0;  ///< in Diagram::scopes
  const Sheet* parent = nullptr;
  int place = -1;  ///< among the children of the parent
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;
  std::vector<std::optional<SheetSource>> output_sources;  ///< of each output
  std::vector<SheetChild> children;

  /// The output of a block that a source is in the end; nothing where that is a constant.
  std::optional<SignalRef> signal(const SheetSource& source) const;
};

/// Reads the sheet of a file of a checked diagram (`scope`) from the documents that it was loaded from.
std::unique_ptr<Sheet> reference_of(const Diagram& diagram, Loader& loader, int scope = 0);

}  // namespace stepwire
