#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/diagram/load.hpp"

namespace stepwire::drawing {

/// Source of a wire: an output of a child, or an input of the file itself.
struct WireSource {
  int child = -1;  ///< in Hierarchy::children; -1: the file itself
  int port = 0;
};

/// Connection of an input to a source or a constant.
struct WireFeed {
  std::optional<WireSource> source;
  std::string constant;   ///< text of a constant, if there is no source
  std::string element{};  ///< of the source: "2", "force" of a bus, "force.2"
  bool is_bus = false;    ///< true for several signals on the wire
};

/// Input of a child. A list has several feeds.
struct ReferenceInput {
  std::string name;
  std::vector<WireFeed> feeds;
  bool is_condition = false;  ///< `enable` or `trigger`
};

struct Hierarchy;

/// Block or part of a file.
struct BlockReference {
  std::string name;                     ///< name in the file
  int block = -1;                       ///< in Diagram::blocks; -1 for a part or a bus
  std::unique_ptr<Hierarchy> part;      ///< nullptr for a block
  const yaml::Node* written = nullptr;  ///< keys in the file
  std::vector<ReferenceInput> inputs;   ///< connected inputs, in the order of the declaration
  std::vector<std::string> outputs;
  std::size_t own_outputs = 1;  ///< count of the first outputs, which are drawn without a sink
  int guard = -1;               ///< guard in Diagram::blocks, the last output; -1: none

  /// True for the output `active` of a guarded child, which is not one of its own.
  bool is_active(int port) const { return guard >= 0 && port + 1 == static_cast<int>(outputs.size()); }

  bool is_bus() const { return block < 0 && !part; }
};

/// Hierarchy of one file at one place of a diagram, as it is written: with parts and with wires between
/// ports. A Diagram has lost it, because its parts are flattened.
struct Hierarchy {
  int scope = 0;  ///< in Diagram::scopes
  const Hierarchy* parent = nullptr;
  int place = -1;  ///< index among the children of the parent
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;
  std::vector<std::optional<WireSource>> output_sources;  ///< Source of each output.
  std::vector<WireFeed> output_feeds;                     ///< The same with the texts on the wires.
  std::vector<BlockReference> children;

  /// Returns the output of a block that a source resolves to; std::nullopt for a constant.
  std::optional<diagram::SignalRef> signal(const WireSource& source) const;
};

/// Reads the hierarchy of a file (`scope`) of a checked diagram from the documents that it was loaded from.
std::unique_ptr<Hierarchy> hierarchy_of(const diagram::Diagram& diagram, diagram::Loader& loader,
                                        int scope = 0);

}  // namespace stepwire::drawing
