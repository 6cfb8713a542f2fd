#include <fmt/format.h>

#include "engine/analyse/linear/trim.hpp"

namespace stepwire::linear {

using yaml::form;

namespace {

using EntryTable = yaml::KeyTable<TrimEntry, query::NamesReading>;

/// Returns the table of an entry whose numbers have a unit.
EntryTable entry_table(const std::string& unit) {
  const yaml::Key number = form::computed(unit);
  return {
      "a value to be found",
      "{start: 0 m, bounds: [-1 m, 1 m]}",
      {{"fixed", "it is this", number, &TrimEntry::fixed},
       {"start", "from where it is looked for; the file's own value without it", number, &TrimEntry::start},
       {"bounds", "between which it is looked for", form::pair(number),
        [number](TrimEntry& entry, const yaml::Node& node, const query::NamesReading& read) {
          const auto* ends = read.pair(node, yaml::like("[-1 m, 1 m]", {}));
          if (!ends) return;
          read.take((*ends)[0], number, entry.lower);
          read.take((*ends)[1], number, entry.upper);
        }},
       {"steady", "false, of a state: it may go on changing", form::truth(), &TrimEntry::steady}}};
}

std::string unit_of_number(const plan::Plan& plan, const diagram::SignalRef& signal) {
  const auto dimension = plan.dimension(signal);
  return dimension ? unit::si_name(*dimension) : "";
}

enum class Part { state, input, output };

/// Sets the name of a state: its own, or that of the output that equals it.
void name_state(const plan::Plan& plan, const Signal& signal, TrimEntry& entry, yaml::Faults& faults) {
  const diagram::DiagramBlock& block = plan.diagram.blocks[static_cast<std::size_t>(signal.signal.block)];
  const std::string state = signal.signal.output < 0
                                ? block.type().states[static_cast<std::size_t>(signal.signal.state)].name
                                : block.type().outputs[static_cast<std::size_t>(signal.signal.output)].state;
  if (state.empty())
    return faults.add({entry.name.place,
                       entry.name.subject,
                       yaml::fault_text("'{}' is no state; it stands under 'outputs'", signal.name),
                       {}});
  entry.name.name = block.name + "." + state;
  if (signal.element && plan.slot(signal.signal).size > 1)
    entry.name.name += fmt::format(".{}", *signal.element + 1);
}

/// Adds a fault for an input that depends on other signals.
void require_given(const plan::Plan& plan, const Signal& signal, const TrimEntry& entry,
                   yaml::Faults& faults) {
  if (plan.diagram.blocks[static_cast<std::size_t>(signal.signal.block)].type().inputs.empty()) return;
  faults.add({entry.name.place,
              entry.name.subject,
              yaml::fault_text("'{}' follows from other signals; an input is a constant or an input of the "
                               "diagram, and what another signal is to be stands under 'outputs'",
                               signal.name),
              {}});
}

void read_entry(const yaml::Entry& written, const plan::Plan& plan, Part part,
                const query::NamesReading& read, std::vector<TrimEntry>& entries) {
  TrimEntry entry;
  entry.name = {written.key, {read.names.file, written.mark}, read.subject};
  const auto signal = part == Part::input ? find_wire(plan.diagram, entry.name, read.faults)
                                          : find_signal(plan.diagram, entry.name, read.faults);
  if (!signal) return;
  if (part == Part::state) name_state(plan, *signal, entry, read.faults);
  if (part == Part::input) require_given(plan, *signal, entry, read.faults);
  const query::NamesReading inner = yaml::below(read, written.key);
  const EntryTable table = entry_table(unit_of_number(plan, signal->signal));
  if (written.value.is_map())
    table.read(written.value, entry, inner);
  else if (!(written.value.is_scalar() && written.value.text == "free"))
    inner.take(written.value, table.rows.front(), entry.fixed);
  if (entry.lower && entry.upper && *entry.lower > *entry.upper)
    inner.fault(written.value.mark, "the lower bound comes first");
  entries.push_back(std::move(entry));
}

yaml::Key entries_form(yaml::Key::Names names) {
  return form::naming(
      names, form::names(form::either({form::word({"free"}), form::computed(), entry_table("").form}), 1));
}

struct TrimReading : query::NamesReading {
  const plan::Plan& plan;
  TrimReading(const query::SymbolTable& names, const plan::Plan& plan, yaml::Faults& faults)
      : query::NamesReading("trim", names, faults), plan(plan) {}
};

yaml::KeyRow<TrimRequest, TrimReading> entries_row(std::string name, std::string doc, Part part,
                                                   std::vector<TrimEntry> TrimRequest::*member) {
  return {std::move(name), std::move(doc),
          yaml::like("{cart.position: {fixed: 0 m}}", entries_form(yaml::Key::Names::signal)),
          [=](TrimRequest& request, const yaml::Node& node, const TrimReading& read) {
            if (!node.is_map()) return read.fault(node.mark, "is a map: {cart.position: 0 m}");
            for (const yaml::Entry& entry : node.entries)
              read_entry(entry, read.plan, part, read, request.*member);
          }};
}

const yaml::KeyTable<TrimRequest, TrimReading>& trim_table() {
  static const yaml::KeyTable<TrimRequest, TrimReading> table(
      "the operating point", "{inputs: {push: free}, outputs: {cart.position: 1 m}}",
      {entries_row(
           "states",
           "a number that a state has, `free`, or where it is looked for; those that are not named are "
           "free",
           Part::state, &TrimRequest::states),
       entries_row("inputs",
                   "the same of inputs of the diagram and of constants; those that are not named are as the "
                   "file has them",
                   Part::input, &TrimRequest::inputs),
       entries_row("outputs", "the same of any signal, by which the point is looked for", Part::output,
                   &TrimRequest::outputs),
       {"at", "the time for which sources count", form::computed("s"), &TrimRequest::time}});
  return table;
}

}  // namespace

const yaml::Key& trim_form() {
  return trim_table().form;
}

TrimRequest read_trim(const yaml::Node& node, const query::SymbolTable& names, const plan::Plan& plan,
                      yaml::Faults& faults) {
  TrimRequest request;
  trim_table().read(node, request, TrimReading(names, plan, faults));
  return request;
}

}  // namespace stepwire::linear
