#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/diagram/load.hpp"

namespace stepwire::drawing {

/// Where a wire begins: an output of a child, or an input of the file itself.
struct WireSource {
  int child = -1;  ///< in Hierarchy::children; -1: the file itself
  int port = 0;
};

/// One thing that an input is fed by.
struct WireFeed {
  std::optional<WireSource> source;
  std::string constant;   ///< as the file writes it, where there is no source
  std::string element{};  ///< of the source: "2", "force" of a bus, "force.2"
  bool is_bus = false;    ///< are several signals on the wire?
};

/// An input of a child. A list has several feeds.
struct ReferenceInput {
  std::string name;
  std::vector<WireFeed> feeds;
  bool is_condition = false;  ///< `enable` or `trigger`
};

struct Hierarchy;

/// A block or a part of a file.
struct BlockReference {
  std::string name;                     ///< as the file calls it
  int block = -1;                       ///< in Diagram::blocks; -1 for a part or a bus
  std::unique_ptr<Hierarchy> part;      ///< null for a block
  const yaml::Node* written = nullptr;  ///< its keys
  std::vector<ReferenceInput> inputs;   ///< those that are fed, in the order of the declaration
  std::vector<std::string> outputs;
  std::size_t own_outputs = 1;  ///< the first of them, which are drawn though they lead nowhere
  int guard = -1;  ///< the block in Diagram::blocks by which it is active, the last of its outputs; -1: none

  /// Is this output not one of its own?
  bool is_active(int port) const { return guard >= 0 && port + 1 == static_cast<int>(outputs.size()); }

  bool is_bus() const { return block < 0 && !part; }
};

/// One file at one place of a diagram as it is written: with its parts as parts, and wires between ports.
/// What a Diagram no longer has, since there the parts are opened.
struct Hierarchy {
  int scope = 0;  ///< in Diagram::scopes
  const Hierarchy* parent = nullptr;
  int place = -1;  ///< among the children of the parent
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;
  std::vector<std::optional<WireSource>> output_sources;  ///< of each output
  std::vector<WireFeed> output_feeds;                     ///< the same with what is said of the wires
  std::vector<BlockReference> children;

  /// The output of a block that a source is in the end; nothing where that is a constant.
  std::optional<diagram::SignalRef> signal(const WireSource& source) const;
};

/// Reads the hierarchy of a file of a checked diagram (`scope`) from the documents that it was loaded from.
std::unique_ptr<Hierarchy> hierarchy_of(const diagram::Diagram& diagram, diagram::Loader& loader,
                                        int scope = 0);

}  // namespace stepwire::drawing
