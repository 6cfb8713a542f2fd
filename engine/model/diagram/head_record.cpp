// Recorded signals of a file, and the condition that ends its run.
#include <fmt/format.h>

#include <algorithm>

#include "engine/base/yaml/message.hpp"
#include "engine/model/diagram/condition.hpp"
#include "engine/model/diagram/element_index.hpp"
#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/diagram/head.hpp"
#include "engine/model/diagram/head_keys.hpp"
#include "engine/model/diagram/keys.hpp"
#include "engine/model/diagram/named_parameters.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"
#include "engine/model/diagram/units.hpp"

namespace stepwire::diagram {

namespace {

/// Returns the block with the value of a parameter; adds a fault and returns -1 for a parameter that is not
/// numeric.
int block_of_parameter(const yaml::Node& node, const std::string& name, const Scope& scope, Report& report) {
  std::vector<DiagramBlock>& blocks = report.diagram().blocks;
  const auto known = std::ranges::find(blocks, name, &DiagramBlock::name);
  if (known != blocks.end()) return static_cast<int>(known - blocks.begin());
  const ParameterSpec& spec = parameter_value_type().parameters.front();
  ParameterUses uses;
  const auto written =
      ValueReader(scope.parameters, report, scope.index, &uses).read_for(spec, {}, node, "record");
  if (!written) return -1;
  const int index = static_cast<int>(blocks.size());
  DiagramBlock& block = blocks.emplace_back(name, parameter_value_type());
  block.origin = scope.at(node.mark);
  block.parameter_marks.push_back(node.mark);
  block.parameter_dimensions.push_back(written->dimension);
  if (!written->each.empty()) block.parameter_elements.emplace_back(0, written->each);
  if (written->columns > 1) block.matrices.emplace_back(0, written->columns);
  spec.set(block.block.get(), written->value);
  report.bindings().bindings.push_back(
      {{Target::Kind::parameter, index, 0}, {node, scope.index, scope.index}, std::move(uses)});
  return index;
}

/// Records a parameter, written `$name`, under a name: as the output of a block with its value.
void record_parameter(const yaml::Node& node, const std::string& name, const Scope& scope,
                      RecordRequest& request, Report& report) {
  const int block = block_of_parameter(node, "parameters." + node.text.substr(1), scope, report);
  if (block >= 0) request.signals.push_back({name, {block, 0, -1}, scope.at(node.mark)});
}

/// Records the fields of a bus, or the signal of another name.
void record_named(const std::string& name, const yaml::Node& node, const Scope& scope,
                  const Resolver& resolver, RecordRequest& request, Report& report) {
  if (node.text.starts_with('$'))
    return record_parameter(node, name.starts_with('$') ? name.substr(1) : name, scope, request, report);
  const Origin origin = scope.at(node.mark);
  const auto fields = resolver.fields(node, scope);
  for (const std::string& field : fields)
    if (const auto signal = resolver.signal(node.text + "." + field, scope, origin, "record"))
      request.signals.push_back({name + "." + field, *signal, origin});
  if (!fields.empty()) return;
  if (const auto signal = resolver.signal(node.text, scope, origin, "record"))
    request.signals.push_back({name, *signal, origin});
}

void record_all(const Scope& scope, const std::string& prefix, const Origin& origin, RecordRequest& request,
                const Diagram& diagram) {
  for (const auto& [name, named] : scope.names) {
    if (named.part) {
      record_all(*named.part, prefix + name + ".", origin, request, diagram);
      continue;
    }
    for (const BusField& field : named.bus)
      if (field.block >= 0)
        request.signals.push_back({prefix + name + "." + field.name, {field.block, 0, -1}, origin});
    if (named.block < 0) continue;  // fields of a bus are signals of other blocks
    const BlockType& type = diagram.blocks[static_cast<std::size_t>(named.block)].type();
    for (std::size_t i = 0; i < type.outputs.size(); ++i)
      if (!is_bare_state(type, i))
        request.signals.push_back(
            {output_name(prefix + name, type, i), {named.block, static_cast<int>(i), -1}, origin});
  }
}

/// Records all signals; of a conditional block it records the output that other blocks read.
void record_all(const Scope& scope, const Origin& origin, const Resolver& resolver, RecordRequest& request,
                Report& report) {
  const std::vector<DiagramBlock>& blocks = report.diagram().blocks;
  const std::size_t known = request.signals.size();
  record_all(scope, "", origin, request, report.diagram());
  const auto stands_for_output = [](const DiagramBlock& block) {
    return &block.type() == &guarded_output_type();
  };
  if (std::ranges::none_of(blocks, stands_for_output)) return;
  for (std::size_t i = known; i < request.signals.size(); ++i)
    if (const auto signal = resolver.signal(request.signals[i].name, scope, origin, "record"))
      request.signals[i].signal = *signal;
}

/// True for a valid name of a column: "x", "rig.x", or "rig.x.2" of an element.
bool may_name_column(std::string name) {
  take_element(name);
  return is_dotted_name(name) && name != "time";
}

/// Reads signals with names given by the file: {position: rig.x, force: push.force}.
void read_named(const yaml::Node& map, const Scope& scope, const Resolver& resolver, RecordRequest& request,
                Report& report) {
  for (const yaml::Entry& entry : map.entries) {
    const Origin origin = scope.at(entry.value.mark);
    if (!may_name_column(entry.key)) {
      report.add(
          scope.at(entry.mark), "record",
          yaml::fault_text("'{}' is no name for a signal; use letters, digits, '_' and dots ('time' has a "
                           "meaning of its own)",
                           entry.key));
    } else if (!entry.value.is_scalar()) {
      report.add(origin, "record", "a name is given to one signal, as {position: rig.x}");
    } else {
      record_named(entry.key, entry.value, scope, resolver, request, report);
    }
  }
}

void read_signal(const yaml::Node& node, const Scope& scope, const Resolver& resolver, RecordRequest& request,
                 Report& report) {
  const Origin origin = scope.at(node.mark);
  if (node.is_map()) return read_named(node, scope, resolver, request, report);
  if (!node.is_scalar()) return report.add(origin, "record", "names signals, as [rig.x, limit]");
  if (node.text == "all") return record_all(scope, origin, resolver, request, report);
  record_named(node.text, node, scope, resolver, request, report);
}

/// Returns the recording for signals of this period, or the one for all instants.
RecordRequest& request_for(std::optional<double> every, bool instants, const Origin& origin,
                           std::vector<RecordRequest>& requests) {
  for (RecordRequest& request : requests)
    if (request.every == every && request.instants == instants) return request;
  return requests.emplace_back(RecordRequest{every, instants, origin, {}});
}

/// Refuses `instants` beside a period, and beside sections that need rows of several runs at the same times.
void check_instants(const yaml::Node& instants, const yaml::Node& entry, const Scope& scope, Report& report) {
  const Origin origin = scope.at(instants.mark);
  if (entry.find("every")) report.add(origin, "record", "'instants' has rows of its own; leave 'every' out");
  for (const std::string section : {"sweep", "study", "tune", "fit"})
    if (scope.document->root.find(section))
      report.add(
          origin, "record",
          fmt::format("'instants' belongs to a single run, whose rows lie where something happens; leave it "
                      "out beside '{}'",
                      section));
}

void read_entry(const yaml::Node& node, const Scope& scope, const Resolver& resolver, Report& report) {
  auto& requests = report.diagram().records;
  if (!node.is_map())
    return read_signal(node, scope, resolver, request_for({}, false, scope.at(node.mark), requests), report);
  const yaml::Key& form = record_form().of.back();
  const HeadReading read("record", scope, report);
  if (const yaml::Node* runs = node.find("runs"); runs)
    return read.fault(runs->mark, "'runs' is a key of 'sweep.record': sweep: {..., record: {runs: 20}}");
  read.check(node, form);
  const yaml::Node *signals = node.find("signals"), *period = node.find("every"),
                   *both = node.find("instants");
  if (!signals) return;
  bool instants = false;
  if (both) yaml::below(read, "instants").take(*both, *form.find("instants"), instants);
  if (instants) check_instants(*both, node, scope, report);
  std::optional<double> every;
  if (period) yaml::below(read, "every").take(*period, *form.find("every"), every);
  RecordRequest& request =
      request_for(every, instants, scope.at(period ? period->mark : node.mark), requests);
  for (const yaml::Node& item : signals->as_list()) read_signal(item, scope, resolver, request, report);
}

/// True for an element whose column already comes from its whole signal, recorded under the same name.
bool comes_with_whole(const RecordedSignal& signal, const RecordRequest& request) {
  if (signal.signal.element.is_whole()) return false;
  SignalRef whole = signal.signal;
  whole.element = {};
  return std::ranges::any_of(request.signals, [&](const RecordedSignal& other) {
    return other.signal == whole && signal.name == other.name + element_text(signal.signal.element);
  });
}

/// Refuses signals named like the elements "v.1", "v.2" of a recorded signal "v".
void refuse_names_of_elements(const RecordRequest& request, Report& report) {
  for (const RecordedSignal& signal : request.signals) {
    std::string whole = signal.name;
    if (take_element(whole).is_whole()) continue;
    if (std::ranges::any_of(request.signals,
                            [&](const RecordedSignal& other) { return other.name == whole; }))
      report.add(signal.origin, "record",
                 fmt::format("'{}' is the name of an element of '{}', recorded here as well; take another "
                             "name",
                             signal.name, whole));
  }
}

/// Removes repeated signals of a recording; refuses two signals of one name.
void drop_repeated(RecordRequest& request, Report& report) {
  std::map<std::string, SignalRef> seen;
  std::erase_if(request.signals,
                [&](const RecordedSignal& signal) { return comes_with_whole(signal, request); });
  refuse_names_of_elements(request, report);
  std::erase_if(request.signals, [&](const RecordedSignal& signal) {
    const auto [first, is_new] = seen.emplace(signal.name, signal.signal);
    if (first->second != signal.signal)
      report.add(signal.origin, "record", fmt::format("two signals are named '{}' here", signal.name));
    return !is_new;
  });
}

/// Refuses recorded signals named like a swept parameter, which is a column as well.
void refuse_swept_names(Report& report) {
  const Diagram& diagram = report.diagram();
  if (!diagram.sweep) return;
  for (const RecordRequest& request : diagram.records)
    for (const RecordedSignal& signal : request.signals)
      for (const Sweep::Axis& axis : diagram.sweep->axes)
        if (axis.parameter == signal.name)
          report.add(signal.origin, "record",
                     fmt::format("'{0}' is a swept parameter as well, and both would be a column '{0}'; give "
                                 "the signal another name: {{{0}_y: {0}}}",
                                 signal.name));
}

/// True for the time, and for the name of a block or an input of a scope.
bool is_signal_in(const Scope& scope, const std::string& name) {
  return name == "time" || !scope.start_of(name).empty() || !scope.input_of(name).empty();
}

}  // namespace

void read_record(const Scope& scope, const Resolver& resolver, Report& report) {
  const yaml::Node* record = scope.document->root.find("record");
  if (!record) return;
  for (const yaml::Node& item : record->as_list()) read_entry(item, scope, resolver, report);
  for (RecordRequest& request : report.diagram().records) drop_repeated(request, report);
  refuse_swept_names(report);
}

void read_stop_condition(const Scope& scope, const Resolver& resolver, Report& report) {
  const yaml::Node* node = scope.document->root.find("stop_when");
  if (!node) return;
  const ValueReader reader(scope.parameters, report, scope.index);
  yaml::Node written = *node;
  if (written.text.starts_with('=')) written.text[0] = ' ';
  const auto is_signal = [&](std::string_view view) { return is_signal_in(scope, std::string(view)); };
  written.text = name_parameters(written.text, scope.parameters, is_signal);
  const auto text = reader.fill_in(written, "stop_when");
  if (!text) return;
  try {
    StopCondition condition{
        expression::Expression::hiding_constants(*text, is_signal), {}, scope.at(node->mark)};
    for (const std::string& name : condition.expression.variables()) {
      if (name == "time") {
        condition.variables.push_back({});
      } else if (const auto signal = resolver.signal(name, scope, scope.at(node->mark), "stop_when")) {
        condition.variables.push_back(*signal);
      }
    }
    const bool is_whole = condition.variables.size() == condition.expression.variables().size();
    if (is_whole) report.diagram().stop_when = std::move(condition);
  } catch (const expression::ExpressionError& error) {
    report.add(scope.at(node->mark), "stop_when", error.what());
  }
}

void check_stop_condition(Report& report) {
  const Diagram& diagram = report.diagram();
  if (!diagram.stop_when) return;
  std::vector<expression::Measure> measures;
  for (const SignalRef& signal : diagram.stop_when->variables) {
    std::optional<unit::Dimension> dimension = unit::parse_unit("s")->dimension;
    if (signal.block >= 0) dimension = dimension_of(diagram, signal);
    measures.push_back({dimension, dimension.has_value()});
  }
  try {
    static_cast<void>(diagram.stop_when->expression.measure(measures));
  } catch (const expression::ExpressionError& error) {
    report.add(diagram.stop_when->origin, "stop_when", error.what());
  }
}

namespace {

/// Returns the unit of a name in a condition.
std::optional<unit::Dimension> dimension_of_name(const std::string& name, const DiagramBlock& block,
                                                 const Diagram& diagram) {
  const auto& variables = static_cast<const Condition*>(block.block.get())->variables;
  const auto index = static_cast<std::size_t>(std::ranges::find(variables, name) - variables.begin());
  if (index >= block.inputs.front().size()) return unit::parse_unit("s")->dimension;  // the time
  const Source& source = block.inputs.front()[index];
  if (source.block < 0) return source.dimension;
  return dimension_of(diagram, {source.block, source.output, -1, source.element});
}

}  // namespace

void check_conditions(Report& report) {
  for (const DiagramBlock& block : report.diagram().blocks) {
    if (&block.type() != &condition_type()) continue;
    try {
      const auto& condition = *static_cast<const Condition*>(block.block.get());
      const auto formula = expression::Expression::hiding_constants(
          condition.expression.view(),
          [&](std::string_view name) { return std::ranges::count(condition.variables, name) > 0; });
      std::vector<expression::Measure> measures;
      for (const std::string& name : formula.variables()) {
        const auto dimension = dimension_of_name(name, block, report.diagram());
        measures.push_back({dimension, dimension.has_value()});
      }
      static_cast<void>(formula.measure(measures));
    } catch (const expression::ExpressionError& error) {
      report.add(block.origin, block.name, error.what());
    }
  }
}

}  // namespace stepwire::diagram
