// Buses: named groups of signals, written in a file like a block.
#include <fmt/format.h>

#include <algorithm>

#include "engine/model/diagram/bus_fields.hpp"
#include "engine/model/diagram/keys.hpp"
#include "engine/model/diagram/open.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/resolve.hpp"

namespace stepwire::diagram {

namespace {

/// True where the only output has the generic unit and the shape of this input.
bool passes(const BlockType& type, std::size_t input) {
  const InputSpec& in = type.inputs[input];
  if (!has_one_output(type) || in.list || !in.unit.starts_with('\'')) return false;
  return in.unit == type.outputs[0].unit && in.shape == type.outputs[0].shape;
}

/// Finds the blocks whose inputs are buses, and copies each for every field. The fields of a block are those
/// of its source, which may be another such block. They are determined recursively, and again until no more
/// are found, since blocks may be in a loop.
class BusStores {
 public:
  BusStores(Scope& root, std::deque<PendingInput>& pending, std::deque<yaml::Node>& written, Report& report)
      : pending_(pending), written_(written), report_(report) {
    name_blocks(root);
    for (const PendingInput& input : pending)
      if (passes(block_of(input.block).type(), static_cast<std::size_t>(input.input)))
        carriers_[input.block].push_back(input);
  }

  void run() {
    while (find_fields()) forget_open();
    for (const auto& [block, fields] : fields_)
      if (!fields.empty()) copy(block, fields);
  }

 private:
  /// Determines the fields that blocks pass on. Returns true if there are more than before; fields of blocks
  /// in a loop may then be known as well.
  bool find_fields() {
    const std::size_t before = fields_.size();
    for (int block = 0; block < static_cast<int>(report_.diagram().blocks.size()); ++block)
      if (names_.contains(block) || shown_.contains(block)) fields_of(block, 0);
    return std::ranges::count_if(fields_, [](const auto& known) { return !known.second.empty(); }) >
           static_cast<std::ptrdiff_t>(before);
  }

  void forget_open() {
    std::erase_if(fields_, [](const auto& known) { return known.second.empty(); });
  }

  void name_blocks(Scope& scope) {
    for (auto& [name, named] : scope.names) {
      if (named.part) name_blocks(*named.part);
      if (named.block >= 0) names_[named.block] = &named;
      if (named.block >= 0 && scope.guarded.contains(name)) guarded_.insert(named.block);
    }
    for (auto& [name, guarded] : scope.guarded)
      for (const auto& [output, block] : guarded.outputs) shown_[block] = {&guarded, output};
  }

  DiagramBlock& block_of(int index) { return report_.diagram().blocks[static_cast<std::size_t>(index)]; }

  /// Returns the fields of the source of a block that passes them on; an empty list without a bus. A block
  /// with feedback has the fields of its other inputs.
  const std::vector<std::string>& fields_of(int block, int hops) {
    const auto [known, is_new] = fields_.try_emplace(block);
    if (!is_new) return known->second;
    const auto carriers = carriers_.find(block);
    if (carriers == carriers_.end()) return known->second;
    const Resolver resolver(report_, [this](int other, int deeper) { return fields_of(other, deeper); });
    for (const PendingInput& input : carriers->second) {
      const auto fields = resolver.fields(*input.node, *input.scope, hops + 1);
      if (known->second.empty()) known->second = fields;
      if (!fields.empty() && known->second != fields) refuse(block, input, known->second, fields);
    }
    return known->second;
  }

  void refuse(int block, const PendingInput& input, const std::vector<std::string>& one,
              const std::vector<std::string>& other) {
    report_.add(input.scope->at(input.node->mark), block_of(block).name,
                fmt::format("is fed a bus of {} and one of {}; both must have the same fields",
                            fmt::join(one, ", "), fmt::join(other, ", ")));
  }

  void copy(int block, const std::vector<std::string>& fields) {
    Diagram& diagram = report_.diagram();
    const std::string name = block_of(block).name;
    if (guarded_.contains(block))
      report_.add(
          block_of(block).origin, name,
          "is fed a bus, and has a condition of its own; put it into a part, and the condition there");
    std::vector<int> copies;
    for (const std::string& field : fields) {
      const int index = copies.empty() ? block : static_cast<int>(diagram.blocks.size());
      if (!copies.empty()) diagram.blocks.push_back(DiagramBlock(block_of(block)));
      if (!copies.empty()) copy_bindings(block, index);
      block_of(index).name = name + "." + field;
      block_of(index).copy_of = name;
      copies.push_back(index);
    }
    if (shown_.contains(block))
      show(shown_.at(block), copies, fields);
    else
      name_copies(*names_.at(block), copies, fields);
    wire(block, copies, fields);
  }

  static void name_copies(Scope::Named& named, const std::vector<int>& copies,
                          const std::vector<std::string>& fields) {
    for (std::size_t k = 0; k < fields.size(); ++k)
      named.bus.push_back({fields[k], nullptr, copies[k], {}, {}, named.mark});
    named.block = -1;
  }

  /// Output of a conditional part, readable as "part.out.force".
  struct Shown {
    Scope::Guarded* guarded;
    std::string output;
  };

  static void show(const Shown& shown, const std::vector<int>& copies,
                   const std::vector<std::string>& fields) {
    shown.guarded->outputs.erase(shown.output);
    for (std::size_t k = 0; k < fields.size(); ++k)
      shown.guarded->outputs[shown.output + "." + fields[k]] = copies[k];
  }

  /// Copies the bindings of values that depend on parameters, for each copy of the block.
  void copy_bindings(int from, int to) {
    auto& bindings = report_.bindings().bindings;
    const std::size_t count = bindings.size();
    for (std::size_t b = 0; b < count; ++b) {
      if (bindings[b].target.block != from) continue;
      Binding copied = bindings[b];
      copied.target.block = to;
      bindings.push_back(std::move(copied));
    }
  }

  void wire(int block, const std::vector<int>& copies, const std::vector<std::string>& fields) {
    std::vector<PendingInput> own;
    for (const PendingInput& input : pending_)
      if (input.block == block) own.push_back(input);
    std::erase_if(pending_, [&](const PendingInput& input) { return input.block == block; });
    for (std::size_t k = 0; k < copies.size(); ++k)
      for (PendingInput input : own) {
        if (is_bus(input)) input.node = field_of(*input.node, fields[k]);
        input.block = copies[k];
        pending_.push_back(input);
      }
  }

  /// True for an input with a bus; an input common to all fields may have a number or a single signal.
  bool is_bus(const PendingInput& input) {
    const Resolver resolver(report_, [this](int other, int hops) { return fields_of(other, hops); });
    return passes(block_of(input.block).type(), static_cast<std::size_t>(input.input)) &&
           !resolver.fields(*input.node, *input.scope).empty();
  }

  /// Returns the source of one field: "wrench.force", or the value of the field in a map.
  const yaml::Node* field_of(const yaml::Node& node, const std::string& field) {
    if (!node.is_map()) return written(node, names_signal(node) ? node.text + "." + field : node.text);
    for (const BusField& one : written_fields(node)) {
      if (one.name == field) return one.signal;
      if (field.starts_with(one.name + "."))
        return written(*one.signal, one.signal->text + field.substr(one.name.size()));
    }
    return &node;
  }

  const yaml::Node* written(const yaml::Node& like, std::string text) {
    written_.push_back(like);
    written_.back().text = std::move(text);
    return &written_.back();
  }

  std::deque<PendingInput>& pending_;
  std::deque<yaml::Node>& written_;
  Report& report_;
  std::map<int, std::vector<PendingInput>>
      carriers_;  ///< as written: the inputs through which a block passes a bus
  std::map<int, Scope::Named*> names_;
  std::map<int, Shown> shown_;                      ///< blocks that replace outputs while these are inactive
  std::set<int> guarded_;                           ///< blocks with a condition of their own
  std::map<int, std::vector<std::string>> fields_;  ///< of visited blocks
};

/// Copies each block whose input is a bus, one copy for each field. This applies to blocks that pass on a
/// signal of any unit and shape, such as Switch, UnitDelay and ZeroOrderHold. Inputs of other units are
/// shared by all copies.
void copy_blocks_for_buses(Scope& root, std::deque<PendingInput>& pending, std::deque<yaml::Node>& written,
                           Report& report) {
  BusStores(root, pending, written, report).run();
}

/// Refuses invalid fields, and invalid properties of fields.
void check_fields(const Scope& scope, const std::string& bus, const yaml::Node& map, Report& report) {
  if (!map.is_map() || map.entries.empty())
    return report.add(scope.at(map.mark), bus, "a bus has fields, as {fields: {force: f, torque: t}}");
  for (const yaml::Entry& entry : map.entries) {
    const std::string field = bus + "." + entry.key;
    if (!is_name(entry.key))
      report.add(scope.at(entry.mark), field, "is no name for a field; use letters, digits and '_'");
    if (!entry.value.is_map() || entry.value.find("value")) continue;
    if (const yaml::Node* inside = entry.value.find("fields")) {
      check_fields(scope, field, *inside, report);
      continue;
    }
    const yaml::Node *unit = entry.value.find("unit"), *shape = entry.value.find("shape");
    if (unit && !unit::parse_unit(unit->text))
      report.add(scope.at(unit->mark), field, yaml::fault_text("'{}' is no unit", unit->text));
    if (shape && !parse_shape(shape->text))
      report.add(scope.at(shape->mark), field,
                 yaml::fault_text("'{}' is no shape; write 3, or 3 x 2 for a matrix of 3 rows", shape->text));
  }
}

}  // namespace

void Opener::make_bus(Scope& scope, const yaml::Entry& entry) {
  for (const yaml::Entry& key : entry.value.entries)
    if (key.key != "fields" && key.key != "doc")
      report_.add(scope.at(key.mark), scope.prefix + entry.key,
                  yaml::fault_text("a bus has no '{}'; it has 'fields:'", key.key));
  const yaml::Node& fields = *entry.value.find("fields");
  check_fields(scope, scope.prefix + entry.key, fields, report_);
  if (!fields.is_map() || fields.entries.empty()) {
    scope.failed.insert(entry.key);
    return;
  }
  scope.names[entry.key] = {-1, nullptr, entry.mark, written_fields(entry.value)};
}

void Opener::copy_for_buses(Scope& root) {
  copy_blocks_for_buses(root, pending_, written_, report_);
}

}  // namespace stepwire::diagram
