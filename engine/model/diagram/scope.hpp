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

/// A field of a bus, or of a port with a bus; fields of nested buses have dotted names.
struct BusField {
  std::string name;
  const yaml::Node* signal = nullptr;  ///< its value in the file: a signal, a number, or another bus
  int block = -1;                      ///< the copy of a block for this field, if `signal` is nullptr
  std::optional<unit::Dimension> dimension;
  std::optional<std::pair<Eigen::Index, Eigen::Index>> shape;  ///< rows and columns
  yaml::Mark mark;
};
using BusFields = std::vector<BusField>;

/// Names of one file at one place of the diagram under construction.
struct Scope {
  int index = 0;  ///< index in Diagram::scopes
  const yaml::Document* document = nullptr;
  Scope* parent = nullptr;
  ParameterScope parameters;
  std::string prefix;

  /// Meaning of a name: a block of the diagram, a part, or a bus.
  struct Named {
    int block = -1;
    std::unique_ptr<Scope> part;
    yaml::Mark mark;
    BusFields bus{};  ///< of a bus, or of a block with a copy for each field; empty otherwise
  };
  std::map<std::string, Named, std::less<>> names;
  /// Names whose block or part could not be created. Their fault is reported once; wires to them add no
  /// further faults.
  std::set<std::string, std::less<>> failed;

  /// An input port of this part: its source in the using file, and its declared properties.
  struct Port {
    const yaml::Node* fed_by = nullptr;  ///< in the parent's file
    const yaml::Node* fallback = nullptr;
    std::optional<unit::Dimension> dimension;
    std::string doc;
    int block = -1;  ///< block of the input in the diagram itself, where no file uses it
    yaml::Mark mark;
    BusFields fields;  ///< declared fields of a bus
    std::optional<std::pair<Eigen::Index, Eigen::Index>> shape;
  };
  std::map<std::string, Port, std::less<>> inputs;

  int guard = -1;               ///< block that activates the blocks of this part; -1: always active
  std::optional<Every> every;   ///< default for this part's blocks
  Origin every_origin;
  /// Additions of `enable` and `trigger` to a block or part of this file.
  struct Guarded {
    int guard = -1;                                   ///< the block whose output is `NAME.active`
    std::map<std::string, int, std::less<>> outputs;  ///< blocks read in place of an output

    /// Returns the block for an output or its field ("out.force"); -1 if there is none.
    int shown(std::string_view output) const {
      const auto found = outputs.find(output);
      return found == outputs.end() ? -1 : found->second;
    }
  };
  std::map<std::string, Guarded, std::less<>> guarded;  ///< by the name of the block or part

  /// An output port of this part: its signal, written in this part's file.
  struct Out {
    const yaml::Node* signal = nullptr;
    const yaml::Node* safe = nullptr;
    std::optional<unit::Dimension> dimension;
    std::string doc;
    yaml::Mark mark;
    BusFields fields;  ///< declared fields of a bus
    std::optional<std::pair<Eigen::Index, Eigen::Index>> shape;
  };
  std::map<std::string, Out, std::less<>> outputs;

  Origin at(const yaml::Mark& mark) const { return {index, mark}; }
  /// Returns the block or part with which a reference begins; empty if there is none. It is "rig.carriage" of
  /// "rig.carriage.position" if that block exists, since names of blocks may have dots.
  std::string_view start_of(std::string_view reference) const;
  /// Returns a block, part or input whose name conflicts with `name`, since one would be a signal of the
  /// other; empty if there is none.
  std::string rival_of(const std::string& name) const;
  /// Returns the input with which a reference begins, "wrench" of "wrench.force"; empty if there is none.
  std::string_view input_of(std::string_view reference) const;
  std::vector<std::string> block_names() const;
};

/// Returns ports in the order of their file.
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
