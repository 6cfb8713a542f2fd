#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/model/diagram/parameters.hpp"

namespace stepwire::diagram {

/// A field of a bus, or of a port that is one; those of buses inside have dotted names.
struct BusField {
  std::string name;
  const yaml::Node* signal = nullptr;  ///< what the file writes for it: a signal, a number, or another bus
  int block = -1;                      ///< the copy of a block for this field, where there is no signal
  std::optional<unit::Dimension> dimension;
  std::optional<std::pair<Eigen::Index, Eigen::Index>> shape;  ///< rows and columns
  yaml::Mark mark;
};
using BusFields = std::vector<BusField>;

/// One file at one place of the diagram while it is built: what its names mean.
struct Scope {
  int index = 0;  ///< in Diagram::scopes
  const yaml::Document* document = nullptr;
  Scope* parent = nullptr;
  ParameterScope parameters;
  std::string prefix;

  /// What a name stands for: a block of the diagram, a part, or a bus.
  struct Named {
    int block = -1;
    std::unique_ptr<Scope> part;
    yaml::Mark mark;
    BusFields bus{};  ///< of a bus, or of a block with a copy for each field; empty otherwise
  };
  std::map<std::string, Named, std::less<>> names;
  /// Names whose block or part could not be made: reported once, so what is wired to them stays silent.
  std::set<std::string, std::less<>> failed;

  /// A port of this part: what the using file wrote at it, and what may pass.
  struct Port {
    const yaml::Node* fed_by = nullptr;  ///< in the parent's file
    const yaml::Node* fallback = nullptr;
    std::optional<unit::Dimension> dimension;
    std::string doc;
    int block = -1;  ///< that stands for it in the diagram itself, which nobody uses
    yaml::Mark mark;
    BusFields fields;  ///< of a bus, where they are declared
    std::optional<std::pair<Eigen::Index, Eigen::Index>> shape;
  };
  std::map<std::string, Port, std::less<>> inputs;

  int guard = -1;               ///< the block by which the blocks of this part are active; -1: always
  std::optional<Every> every;   ///< of this part's blocks that have none
  Origin every_origin;
  /// What `enable` and `trigger` add to a block or part of this file.
  struct Guarded {
    int guard = -1;                                   ///< the block whose output is `NAME.active`
    std::map<std::string, int, std::less<>> outputs;  ///< blocks that others read in the place of an output

    /// The one for an output, or for its field ("out.force"); -1 if there is none.
    int shown(std::string_view output) const {
      const auto found = outputs.find(output);
      return found == outputs.end() ? -1 : found->second;
    }
  };
  std::map<std::string, Guarded, std::less<>> guarded;  ///< by the name of the block or part

  /// An output of this part: the signal that it is, written in this part's file.
  struct Out {
    const yaml::Node* signal = nullptr;
    const yaml::Node* safe = nullptr;
    std::optional<unit::Dimension> dimension;
    std::string doc;
    yaml::Mark mark;
    BusFields fields;  ///< of a bus, where they are declared
    std::optional<std::pair<Eigen::Index, Eigen::Index>> shape;
  };
  std::map<std::string, Out, std::less<>> outputs;

  Origin at(const yaml::Mark& mark) const { return {index, mark}; }
  /// The name of a block or part with which a reference begins: "rig.carriage" of "rig.carriage.position"
  /// where there is such a block, since names of blocks may have dots; empty where there is none.
  std::string_view start_of(std::string_view reference) const;
  /// The block, part or input of which `name` would be a signal, or whose name would be a signal of `name`;
  /// empty where there is none.
  std::string rival_of(const std::string& name) const;
  /// The input with which a reference begins: "wrench" of "wrench.force"; empty where there is none.
  std::string_view input_of(std::string_view reference) const;
  std::vector<std::string> block_names() const;
};

/// Ports by their name, as their file lists them.
template <class Ports>
auto in_order_of_file(Ports& ports) {
  std::vector<decltype(&*ports.begin())> all;
  for (auto& port : ports) all.push_back(&port);
  std::ranges::stable_sort(all, [](const auto* a, const auto* b) {
    const yaml::Mark &one = a->second.mark, &other = b->second.mark;
    return std::tie(one.line, one.column) < std::tie(other.line, other.column);
  });
  return all;
}

}  // namespace stepwire::diagram
