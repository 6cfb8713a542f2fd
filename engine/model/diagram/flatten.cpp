#include "engine/model/diagram/flatten.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

#include "engine/base/hash/hash.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/yaml/yaml_text.hpp"
#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/diagram.hpp"
#include "engine/model/diagram/element_index.hpp"
#include "engine/model/diagram/external_input.hpp"
#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/written.hpp"

namespace stepwire::diagram {

namespace {

/// Returns the number of a value that is the same for all elements; std::nullopt for other values.
std::optional<double> number_of(const Value& value) {
  if (const double* number = std::get_if<double>(&value.content)) return *number;
  const auto* numbers = std::get_if<Eigen::VectorXd>(&value.content);
  if (numbers && numbers->size() > 0 && (numbers->array() == (*numbers)[0]).all()) return (*numbers)[0];
  return std::nullopt;
}

/// True for a number that the file omits and that equals the default of its type. An omitted gain is a pure
/// number; a gain in the file may have any unit.
bool is_left_out(const DiagramBlock& block, std::size_t parameter) {
  const auto& marks = block.parameter_marks;
  if (parameter < marks.size() && marks[parameter].line > 0) return false;
  if (block.parameter_dimensions[parameter]) return false;
  const ParameterSpec& spec = block.type().parameters[parameter];
  const AnyBlock fresh(block.type());
  const auto own = number_of(spec.get(block.block.get())), of_type = number_of(spec.get(fresh.get()));
  return own && of_type && *own == *of_type;
}

bool is_triggered(const Diagram& diagram, const DiagramBlock& block) {
  const auto trigger = static_cast<std::size_t>(guard_type().input("trigger"));
  for (int guard = block.guard; guard >= 0; guard = diagram.blocks[static_cast<std::size_t>(guard)].guard)
    if (!diagram.blocks[static_cast<std::size_t>(guard)].inputs[trigger].empty()) return true;
  return false;
}

/// True where a block has a rate whatever it reads.
bool has_rate(const Diagram& diagram, const DiagramBlock& block) {
  const BlockType& type = block.type();
  return type.timing != Timing::inherited || type.run_update || (block.every && !block.every_of_part) ||
         &type == &guard_type() || is_triggered(diagram, block);
}

bool reads(const DiagramBlock& block, const std::vector<bool>& constant) {
  return std::ranges::any_of(block.inputs, [&](const std::vector<Source>& sources) {
    return std::ranges::any_of(sources, [&](const Source& source) {
      return source.block >= 0 && !constant[static_cast<std::size_t>(source.block)];
    });
  });
}

/// Returns for each block whether it computes from constants alone. A period of its part does not act on such
/// a block, and gives no rate to those that read it.
std::vector<bool> constant_blocks(const Diagram& diagram) {
  std::vector<bool> constant;
  for (const DiagramBlock& block : diagram.blocks) constant.push_back(!has_rate(diagram, block));
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t b = 0; b < constant.size(); ++b)
      if (constant[b] && reads(diagram.blocks[b], constant)) {
        constant[b] = false;
        changed = true;
      }
  }
  return constant;
}

constexpr unit::Dimension time_dimension{{0.0, 0.0, 1.0}};

/// Purpose of the text. The hash covers only data that determine numbers.
enum class Reader { anyone, hash };

/// Builder of the tree of a diagram's flattened file.
class Flattener {
 public:
  Flattener(const Diagram& diagram, const FileName& file_name, Reader reader)
      : diagram_(diagram), file_name_(file_name), reader_(reader) {}

  std::optional<yaml::Node> value(const Target& target) const {
    const DiagramBlock& of = block(target.block);
    const auto index = static_cast<std::size_t>(target.index);
    if (target.kind == Target::Kind::parameter) return parameter(of, index, of.parameter_dimensions[index]);
    if (target.kind == Target::Kind::constant)
      return source(of.inputs[index][static_cast<std::size_t>(target.element)]);
    for (const InitialValue& initial : of.initial)
      if (initial.state == target.index)
        return numbers(initial.value, initial.dimension, initial.each, initial.columns);
    return std::nullopt;
  }

  yaml::Node run() {
    yaml::Node root;
    add_head(root);
    add_if_any(root, "inputs", inputs());
    add_if_any(root, "outputs", outputs());
    if (reader_ == Reader::anyone) add_if_any(root, "units", units());
    add_if_any(root, "blocks", blocks());
    add_if_any(root, "record", record());
    return root;
  }

 private:
  void add_head(yaml::Node& root) const {
    const std::optional<unit::Dimension> time = unit(time_dimension);
    add_key(root, "stepwire", written_text("1"));
    if (reader_ == Reader::anyone && !diagram_.title.empty())
      add_key(root, "title", written_text(diagram_.title));
    add_key(root, "step", written_numbers(one(diagram_.step), time));
    add_key(root, "stop", written_numbers(one(diagram_.stop), time));
    if (!diagram_.solver.empty()) add_key(root, "solver", solver());
    if (diagram_.tolerance != Diagram{}.tolerance)
      add_key(root, "tolerance", written_numbers(one(diagram_.tolerance), std::nullopt));
    if (diagram_.algebraic_loops.solve) add_key(root, "algebraic_loops", algebraic_loops());
    if (diagram_.events.locate) add_key(root, "events", events());
    if (diagram_.uses_libm) add_key(root, "functions", written_text("libm"));
    if (diagram_.stop_when) add_key(root, "stop_when", stop_condition(*diagram_.stop_when));
  }

  yaml::Node solver() const {
    if (!diagram_.error_control) return written_text(diagram_.solver);
    const ErrorControl& control = *diagram_.error_control;
    yaml::Node keys;
    add_key(keys, "name", written_text(diagram_.solver));
    add_key(keys, "relative", written_numbers(one(control.relative), std::nullopt));
    add_key(keys, "absolute", written_numbers(one(control.absolute), std::nullopt));
    add_key(keys, "max_steps", written_text(std::to_string(control.max_steps)));
    return keys;
  }

  yaml::Node algebraic_loops() const {
    const AlgebraicLoops& loops = diagram_.algebraic_loops;
    yaml::Node keys;
    if (loops.tolerance != AlgebraicLoops{}.tolerance)
      add_key(keys, "tolerance", written_numbers(one(loops.tolerance), std::nullopt));
    if (loops.max_iterations != AlgebraicLoops{}.max_iterations)
      add_key(keys, "max_iterations", written_text(std::to_string(loops.max_iterations)));
    return keys.entries.empty() ? written_text("solve") : keys;
  }

  yaml::Node events() const {
    const Events& events = diagram_.events;
    const Events usual;
    if (events.max_per_step == usual.max_per_step && events.rounds == usual.rounds &&
        events.looks == usual.looks)
      return written_text("locate");
    yaml::Node keys;
    add_key(keys, "max_per_step", written_text(std::to_string(events.max_per_step)));
    add_key(keys, "rounds", written_text(std::to_string(events.rounds)));
    add_key(keys, "looks", written_text(std::to_string(events.looks)));
    return keys;
  }

  static void add_if_any(yaml::Node& map, const char* key, yaml::Node value) {
    if (!value.entries.empty() || !value.items.empty()) add_key(map, key, std::move(value));
  }

  static Eigen::VectorXd one(double number) { return Eigen::VectorXd::Constant(1, number); }

  std::optional<unit::Dimension> unit(const std::optional<unit::Dimension>& dimension) const {
    return reader_ == Reader::anyone ? dimension : std::nullopt;
  }

  /// Returns numbers in one unit or in several.
  static yaml::Node numbers(const Eigen::VectorXd& values, const std::optional<unit::Dimension>& dimension,
                            const EachUnit& each, Eigen::Index columns = 1) {
    if (each.size() == static_cast<std::size_t>(values.size())) return written_each(values, each, columns);
    return written_numbers(values, dimension, columns);
  }

  EachUnit units(const EachUnit& each) const { return reader_ == Reader::anyone ? each : EachUnit{}; }

  const DiagramBlock& block(int index) const { return diagram_.blocks[static_cast<std::size_t>(index)]; }

  std::string name(const SignalRef& signal) const { return whole(signal) + element_text(signal.element); }

  std::string whole(const SignalRef& signal) const {
    const DiagramBlock& owner = block(signal.block);
    const BlockType& type = owner.type();
    if (signal.output < 0) return owner.name + "." + type.states[static_cast<std::size_t>(signal.state)].name;
    return output_name(owner.name, type, static_cast<std::size_t>(signal.output));
  }

  yaml::Node stop_condition(const StopCondition& condition) const {
    std::vector<std::string> names;
    for (const SignalRef& signal : condition.variables)
      names.push_back(signal.block < 0 ? "time" : name(signal));
    return written_text(condition.expression.renamed(names));
  }

  void add_doc(yaml::Node& port, const std::string& doc) const {
    if (reader_ == Reader::anyone && !doc.empty()) add_key(port, "doc", written_text(doc));
  }

  yaml::Node inputs() const {
    yaml::Node map;
    for (const DiagramInput& input : diagram_.inputs) {
      const DiagramBlock& source = block(input.block);
      const auto dimension = unit(source.parameter_dimensions[0]);
      yaml::Node port;
      if (dimension) add_key(port, "unit", written_text(unit::si_name(*dimension)));
      add_key(port, "default", *parameter(source, 0, {}));
      add_doc(port, input.doc);
      add_key(map, input.name, std::move(port));
    }
    return map;
  }

  yaml::Node outputs() const {
    yaml::Node map;
    for (const DiagramOutput& output : diagram_.outputs) {
      yaml::Node port;
      add_key(port, "signal", written_text(name(output.signal)));
      if (output.safe)
        add_key(port, "safe", numbers(*output.safe, unit(output.safe_dimension), units(output.safe_each)));
      add_doc(port, output.doc);
      add_key(map, output.name, std::move(port));
    }
    return map;
  }

  /// Returns the units that ports of parts require of their signals.
  yaml::Node units() const {
    yaml::Node map;
    std::set<std::string> said;
    for (const UnitDemand& demand : diagram_.unit_demands) {
      if (demand.source.block < 0) continue;
      std::string signal = name({demand.source.block, demand.source.output, -1, demand.source.element});
      if (said.insert(signal).second)
        add_key(map, std::move(signal), written_text(unit::si_name(demand.dimension)));
    }
    return map;
  }

  yaml::Node blocks() const {
    yaml::Node map;
    map.entries.reserve(diagram_.blocks.size());
    const std::vector<bool> constant = constant_blocks(diagram_);
    for (std::size_t b = 0; b < constant.size(); ++b)
      if (const DiagramBlock& block = diagram_.blocks[b]; &block.type() != &external_input_type())
        add_key(map, block.name, keys(block, block.every && !constant[b]));
    return map;
  }

  yaml::Node keys(const DiagramBlock& block, bool has_period) const {
    const BlockType& type = block.type();
    yaml::Node map;
    add_key(map, "block", written_text(type.name));
    if (has_period) add_key(map, "every", written_every(*block.every, unit(time_dimension)));
    if (block.guard >= 0) add_key(map, "guard", written_text(this->block(block.guard).name));
    for (std::size_t i = 0; i < block.inputs.size(); ++i)
      if (!block.inputs[i].empty()) add_key(map, type.inputs[i].name, input(type.inputs[i], block.inputs[i]));
    for (std::size_t i = 0; i < type.parameters.size(); ++i)
      if (auto value = parameter(block, i, unit(block.parameter_dimensions[i]));
          value && !is_left_out(block, i) && !map.find(type.parameters[i].name))  // a signal replaces it
        add_key(map, type.parameters[i].name, std::move(*value));
    for (const InitialValue& initial : block.initial)
      add_key(map, initial_key(type, type.states[static_cast<std::size_t>(initial.state)]),
              numbers(initial.value, unit(initial.dimension), units(initial.each), initial.columns));
    return map;
  }

  yaml::Node input(const InputSpec& spec, const std::vector<Source>& sources) const {
    if (!spec.list) return source(sources.front());
    yaml::Node list;
    list.kind = yaml::Node::Kind::list;
    for (const Source& element : sources) list.items.push_back(source(element));
    return list;
  }

  yaml::Node source(const Source& source) const {
    if (source.block < 0) return constant(source);
    return written_signal(name({source.block, source.output, -1, source.element}));
  }

  yaml::Node constant(const Source& source) const {
    const auto dimension = unit(source.dimension);
    if (source.element.is_whole())
      return numbers(source.constant, dimension, units(source.each), source.columns);
    const Eigen::Index rows = source.constant.size() / source.columns;
    const Eigen::Index place =
        std::max<Eigen::Index>(source.element.column - 1, 0) * rows + source.element.row - 1;
    if (const EachUnit each = units(source.each); !each.empty())
      return written_each(one(source.constant[place]), {each[static_cast<std::size_t>(place)]}).items.front();
    return written_numbers(one(source.constant[place]), dimension);
  }

  std::optional<yaml::Node> parameter(const DiagramBlock& block, std::size_t index,
                                      const std::optional<unit::Dimension>& dimension) const {
    const ParameterSpec& spec = block.type().parameters[index];
    Value value = spec.get(block.block.get());
    if (spec.kind == ParameterKind::file) return written_filled_in(file_name_(*value.text()));
    if (std::find(block.spread.begin(), block.spread.end(), index) != block.spread.end()) {
      const auto& elements = std::get<Eigen::VectorXd>(value.content);
      if (elements.size() == 0) return std::nullopt;  // of a signal without elements
      value.content = one(elements[0]);
    }
    if (const EachUnit* each = block.elements_of(index); each && !units(*each).empty())
      if (auto written = in_units(value, *each, columns_of(block, index))) return written;
    for (const auto& [matrix, columns] : block.matrices)
      if (matrix == index)
        return written_numbers(std::get<Eigen::VectorXd>(value.content), dimension, columns);
    return written_value(spec, value, dimension);
  }

  static Eigen::Index columns_of(const DiagramBlock& block, std::size_t parameter) {
    for (const auto& [matrix, columns] : block.matrices)
      if (matrix == parameter) return columns;
    return 1;
  }

  /// Returns numbers in the units of their elements; std::nullopt for a value of another size.
  static std::optional<yaml::Node> in_units(const Value& value, const EachUnit& each, Eigen::Index columns) {
    const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content);
    const auto* vector = std::get_if<Eigen::VectorXd>(&value.content);
    if (!matrix && !vector) return std::nullopt;
    const Eigen::VectorXd all = matrix ? Eigen::VectorXd(matrix->reshaped()) : *vector;
    if (static_cast<std::size_t>(all.size()) != each.size()) return std::nullopt;
    return written_each(all, each, matrix ? matrix->cols() : columns);
  }

  yaml::Node record() const {
    yaml::Node list;
    list.kind = yaml::Node::Kind::list;
    for (const RecordRequest& request : diagram_.records) {
      yaml::Node entry;
      if (request.every) add_key(entry, "every", written_numbers(one(*request.every), unit(time_dimension)));
      if (request.instants) add_key(entry, "instants", written_text("true"));
      yaml::Node signals;
      signals.kind = yaml::Node::Kind::list;
      for (const RecordedSignal& signal : request.signals) signals.items.push_back(recorded(signal));
      add_key(entry, "signals", std::move(signals));
      list.items.push_back(std::move(entry));
    }
    return list;
  }

  yaml::Node recorded(const RecordedSignal& signal) const {
    std::string full = name(signal.signal);
    if (full == signal.name) return written_text(std::move(full));
    yaml::Node renamed;
    add_key(renamed, signal.name, written_text(std::move(full)));
    return renamed;
  }

  const Diagram& diagram_;
  const FileName& file_name_;
  Reader reader_;
};

}  // namespace

std::string absolute_path(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

std::optional<yaml::Node> flattened_value(const Diagram& diagram, const Target& target,
                                          const FileName& file_name) {
  return Flattener(diagram, file_name, Reader::anyone).value(target);
}

std::string flattened_text(const Diagram& diagram, const FileName& file_name) {
  return yaml::yaml_text(Flattener(diagram, file_name, Reader::anyone).run());
}

std::string diagram_hash(const Diagram& diagram) {
  std::map<std::string, std::string> known;
  const FileName content = [&](const std::string& path) {
    const auto [hash, is_new] = known.try_emplace(path);
    if (is_new) hash->second = hash::hash_of(io::read_file(path));
    return hash->second;
  };
  return hash::hash_of(yaml::yaml_text(Flattener(diagram, content, Reader::hash).run()));
}

}  // namespace stepwire::diagram
