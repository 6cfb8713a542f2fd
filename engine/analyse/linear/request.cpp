#include "engine/analyse/linear/request.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>

#include "engine/analyse/linear/prepared_diagram.hpp"
#include "engine/model/diagram/named_signals.hpp"

namespace stepwire::linear {

using yaml::form;

namespace {

std::map<std::string, diagram::SignalRef> all_signals(const diagram::Diagram& diagram) {
  auto all = diagram::named_signals(diagram);
  for (const diagram::DiagramInput& input : diagram.inputs)
    all.emplace(input.name, diagram::SignalRef{input.block, 0, -1});
  return all;
}

/// Splits "v.2" into "v" and 1.
std::optional<std::pair<std::string, Eigen::Index>> element_of(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos || dot + 1 == name.size()) return std::nullopt;
  Eigen::Index number = 0;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + dot + 1, end, number);
  if (read.ec != std::errc{} || read.ptr != end || number < 1) return std::nullopt;
  return std::pair{name.substr(0, dot), number - 1};
}

/// An analysis as read from the file.
struct Draft {
  std::vector<WrittenName> from, to, open;
  double time = 0.0;
  std::optional<double> size;
  enum class Feedback { negative, positive };
  std::optional<Feedback> feedback;
};

using DraftTable = yaml::KeyTable<Draft, query::NamesReading>;

auto names_into(std::vector<WrittenName> Draft::*member) {
  return [member](Draft& draft, const yaml::Node& node, const query::NamesReading& read) {
    for (const yaml::Node& item : node.as_list())
      (draft.*member).push_back({read.text(item), {read.names.file, item.mark}, read.subject});
  };
}

yaml::Key difference_form() {
  yaml::Key key = form::above_zero(form::number());
  key.most = 1.0;
  return key;
}

void read_feedback(Draft& draft, const yaml::Node& node, const query::NamesReading& read) {
  if (const auto word = read.word(node, form::word({"negative", "positive"})))
    draft.feedback = static_cast<Draft::Feedback>(*word);
}

const DraftTable& draft_table() {
  static const DraftTable table(
      "an analysis", "{from: command, to: lag}",
      {yaml::needed(DraftTable::Row{"from",
                                    "the signal to which something is added: an input, an output of a "
                                    "block, v.2 of a vector",
                                    form::signal(), names_into(&Draft::from)}),
       yaml::needed(
           DraftTable::Row{"to", "the signal that is looked at", form::signal(), names_into(&Draft::to)}),
       {"open", "a signal, or a list, whose wire is cut there and holds what it carries",
        form::one_or_list(form::signal()), names_into(&Draft::open)},
       {"at", "when in the run", form::computed("s"), &Draft::time},
       {"feedback",
        "how the loop is closed for margins; negative, but positive where from, to and open are one wire",
        form::word({"negative", "positive"}), read_feedback},
       {"difference", "size of the differences, a share of each number or of 1; many are tried without it",
        difference_form(), &Draft::size}});
  return table;
}

bool has_one_element(const plan::Plan& plan, const WrittenName& written, const Signal& signal,
                     yaml::Faults& faults) {
  const Eigen::Index size = plan.slot(signal.signal).size;
  if (signal.element ? *signal.element < size : size == 1) return true;
  faults.add(
      {written.place,
       written.subject,
       fmt::format("'{}' has {} elements; name one of them, such as '{}.1'", signal.name, size, signal.name),
       {}});
  return false;
}

std::optional<Signal> found(const plan::Plan& plan, const WrittenName& written, bool wire,
                            yaml::Faults& faults) {
  auto signal = wire ? find_wire(plan.diagram, written, faults) : find_signal(plan.diagram, written, faults);
  if (signal && !has_one_element(plan, written, *signal, faults)) return std::nullopt;
  return signal;
}

void read_one(const yaml::Entry& entry, const plan::Plan& plan, const query::NamesReading& read,
              std::vector<NamedAnalysis>& all) {
  const query::NamesReading inner = yaml::below(read, entry.key);
  if (inner.names.find(entry.key) || inner.names.lacks(entry.key))
    inner.fault(entry.mark, fmt::format("'{}' is a signal; give the analysis another name", entry.key));
  Draft draft;
  if (!draft_table().read(entry.value, draft, inner) || draft.from.empty() || draft.to.empty()) return;
  NamedAnalysis analysis{entry.key, {draft.from, draft.to, draft.open, draft.time, draft.size}};
  if (const yaml::Node* at = entry.value.find("at")) analysis.request.at = {inner.names.file, at->mark};
  if (draft.feedback) analysis.feedback = *draft.feedback == Draft::Feedback::positive ? 1.0 : -1.0;
  const auto from = found(plan, draft.from[0], true, inner.faults);
  const auto to = found(plan, draft.to[0], false, inner.faults);
  for (const WrittenName& name : draft.open) find_wire(plan.diagram, name, inner.faults);
  if (!(draft.time >= 0.0 && draft.time <= plan.diagram.stop))
    inner.fault(analysis.request.at.mark,
                fmt::format("the run goes from 0 to {} s; give a time within it, or a later 'stop'",
                            plan.diagram.stop));
  else if (const std::string fault = between_ticks(draft.time, plan.diagram); !fault.empty())
    inner.fault(analysis.request.at.mark, fault);
  if (!from || !to) return;
  const auto in = plan.dimension(from->signal), out = plan.dimension(to->signal);
  if (in && out) analysis.dimension = *out / *in;
  analysis.is_sampled = find_paths(plan, {from->signal.block}, {to->signal.block}, {}).sampled();
  all.push_back(std::move(analysis));
}

}  // namespace

std::string between_ticks(double time, const diagram::Diagram& diagram, std::int64_t ticks) {
  constexpr double rounding = 1e-6;  // share of a step
  const double steps = time / diagram.step, period = static_cast<double>(ticks);
  if (std::abs(steps - period * std::round(steps / period)) <= rounding) return "";
  const double before = period * std::floor(steps / period) * diagram.step,
               after = before + period * diagram.step;
  const std::string what =
      ticks == 1 ? fmt::format("ticks, which are {:.12g} s apart", diagram.step)
                 : fmt::format("common ticks of the blocks that act at ticks, which are {:.12g} s apart",
                               period * diagram.step);
  return fmt::format("{:.12g} s is between two {}; write {:.12g} s{}", time, what, before,
                     after <= diagram.stop ? fmt::format(" or {:.12g} s", after) : "");
}

std::optional<Signal> find_signal(const diagram::Diagram& diagram, const WrittenName& written,
                                  yaml::Faults& faults) {
  const auto all = all_signals(diagram);
  if (const auto found = all.find(written.name); found != all.end())
    return Signal{written.name, found->second};
  if (const auto part = element_of(written.name))
    if (const auto found = all.find(part->first); found != all.end())
      return Signal{written.name, found->second, part->second};
  std::vector<std::string> names;
  for (const auto& [name, signal] : all) names.push_back(name);
  faults.add({written.place,
              written.subject,
              fmt::format("there is no signal '{}'", written.name) +
                  yaml::nearest_or_all(written.name, names, "signals are"),
              {}});
  return std::nullopt;
}

std::optional<Signal> find_wire(const diagram::Diagram& diagram, const WrittenName& written,
                                yaml::Faults& faults) {
  auto found = find_signal(diagram, written, faults);
  if (!found || found->signal.output >= 0) return found;
  const diagram::DiagramBlock& block = diagram.blocks[static_cast<std::size_t>(found->signal.block)];
  const std::string& state = block.type().states[static_cast<std::size_t>(found->signal.state)].name;
  for (std::size_t o = 0; o < block.type().outputs.size(); ++o)
    if (block.type().outputs[o].state == state) {
      found->signal = {found->signal.block, static_cast<int>(o), -1};
      return found;
    }
  faults.add({written.place,
              written.subject,
              yaml::fault_text("'{}' is a state that no wire carries; name an output of '{}'", written.name,
                               block.name),
              {}});
  return std::nullopt;
}

const yaml::Key& linear_form() {
  static const yaml::Key form = [] {
    yaml::Key names = form::names(draft_table().form, 1, "^[A-Za-z_][A-Za-z0-9_]*$");
    return yaml::like("{loop: {from: command, to: lag}}", std::move(names));
  }();
  return form;
}

std::vector<NamedAnalysis> read_linear(const yaml::Node& node, const query::SymbolTable& names,
                                       const plan::Plan& plan, yaml::Faults& faults) {
  std::vector<NamedAnalysis> all;
  const query::NamesReading read("linear", names, faults);
  if (!node.is_map()) {
    read.fault(node.mark, "is a map of analyses by name: {loop: {from: command, to: lag}}");
    return all;
  }
  for (const yaml::Entry& entry : node.entries) read_one(entry, plan, read, all);
  return all;
}

}  // namespace stepwire::linear
