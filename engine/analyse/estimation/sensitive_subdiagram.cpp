#include "engine/analyse/estimation/sensitive_subdiagram.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/model/diagram/external_input.hpp"
#include "engine/model/diagram/variation.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::estimation {

namespace {

/// True for the columns "rig.x" and "rig.x.2" of a signal "rig.x".
bool is_column_of(const std::string& column, const std::string& signal) {
  return column == signal || column.starts_with(signal + ".");
}

template <class Visit>
void each_source(const diagram::DiagramBlock& block, const Visit& visit) {
  for (const auto& sources : block.inputs)
    for (const diagram::Source& source : sources)
      if (source.block >= 0) visit(source);
}

/// Marks the blocks whose values change, and all blocks that depend on them.
std::vector<char> moved_blocks(const diagram::Diagram& diagram, const diagram::Variation& variation) {
  const std::size_t count = diagram.blocks.size();
  std::vector<char> moved(count, 0);
  for (const diagram::Target& target : variation.targets()) moved[static_cast<std::size_t>(target.block)] = 1;
  for (bool more = true; more;) {
    more = false;
    for (std::size_t b = 0; b < count; ++b)
      each_source(diagram.blocks[b], [&](const diagram::Source& source) {
        if (moved[b] || !moved[static_cast<std::size_t>(source.block)]) return;
        moved[b] = more = true;
      });
  }
  return moved;
}

int place_of(const diagram::Binding& binding, const std::vector<int>& place) {
  return place[static_cast<std::size_t>(binding.target.block)];
}

std::shared_ptr<const diagram::Bindings> moved_bindings(const diagram::Bindings& of_whole,
                                                        const std::vector<int>& place) {
  auto bindings = std::make_shared<diagram::Bindings>(of_whole);
  std::erase_if(bindings->bindings,
                [&](const diagram::Binding& binding) { return place_of(binding, place) < 0; });
  for (diagram::Binding& binding : bindings->bindings) binding.target.block = place_of(binding, place);
  return bindings;
}

diagram::Diagram without_blocks(diagram::Diagram diagram) {
  diagram.blocks.clear();
  diagram.unit_demands.clear();  // already checked for the whole diagram
  diagram.outputs.clear();
  diagram.output_dimensions.clear();
  diagram.state_dimensions.clear();
  diagram.element_dimensions.clear();
  diagram.zeros_if_kelvin.clear();
  return diagram;
}

}  // namespace

std::optional<SensitiveSubdiagram> SensitiveSubdiagram::find(const plan::Plan& plan,
                                                             const diagram::Variation& moved,
                                                             const std::vector<std::string>& columns) {
  const diagram::Diagram& diagram = plan.diagram;
  if (diagram.stop_when || !diagram.inputs.empty() || moved.structural()) return std::nullopt;
  SensitiveSubdiagram part;
  part.kept_ = moved_blocks(diagram, moved);
  part.keep_ancestors(diagram, columns);
  const auto all = static_cast<std::ptrdiff_t>(diagram.blocks.size());
  const auto kept = std::count(part.kept_.begin(), part.kept_.end(), 1);
  if (kept == 0 || kept == all || !part.find_reads(plan)) return std::nullopt;
  return part;
}

void SensitiveSubdiagram::keep_ancestors(const diagram::Diagram& diagram,
                                         const std::vector<std::string>& columns) {
  std::vector<char> needed(kept_.size(), 0);
  for (const diagram::RecordRequest& request : diagram.records)
    for (const diagram::RecordedSignal& signal : request.signals) {
      const auto block = static_cast<std::size_t>(signal.signal.block);
      const bool wanted = std::any_of(columns.begin(), columns.end(), [&](const std::string& column) {
        return is_column_of(column, signal.name);
      });
      if (!wanted || !kept_[block]) continue;
      needed[block] = 1;
      recorded_.push_back(signal.name);
    }
  for (bool more = true; more;) {
    more = false;
    for (std::size_t b = 0; b < kept_.size(); ++b)
      if (needed[b])
        each_source(diagram.blocks[b], [&](const diagram::Source& source) {
          const auto from = static_cast<std::size_t>(source.block);
          if (!kept_[from] || needed[from]) return;
          needed[from] = more = true;
        });
  }
  kept_ = std::move(needed);
}

bool SensitiveSubdiagram::find_reads(const plan::Plan& plan) {
  for (std::size_t b = 0; b < kept_.size(); ++b) {
    if (!kept_[b]) continue;
    each_source(plan.diagram.blocks[b], [&](const diagram::Source& source) {
      const diagram::SignalRef signal{source.block, source.output, -1};
      const auto from = static_cast<std::size_t>(source.block);
      const auto same = [&](const Read& read) { return read.signal == signal; };
      if (kept_[from] || std::any_of(reads_.begin(), reads_.end(), same)) return;
      reads_.push_back({signal, plan.slot(signal).size, plan.blocks[from].rate});
    });
  }
  const bool ticks_only = solve::evaluates_ticks_only(plan.diagram.solver);
  for (const Read& read : reads_) {
    if (read.rate.kind == plan::Rate::Kind::continuous && !ticks_only) return false;
    for (Eigen::Index i = 0; i < read.size; ++i)
      offsets_.push_back(plan.slot(read.signal).offset + static_cast<std::size_t>(i));
  }
  return true;
}

void SensitiveSubdiagram::play(const std::vector<double>& tape, run::Executor& simulation) const {
  const double* numbers = tape.data() + static_cast<std::size_t>(simulation.tick()) * width();
  for (std::size_t i = 0; i < reads_.size(); numbers += reads_[i++].size) simulation.write_input(i, numbers);
}

bool SensitiveSubdiagram::gives(const std::string& column) const {
  return std::any_of(recorded_.begin(), recorded_.end(),
                     [&](const std::string& signal) { return is_column_of(column, signal); });
}

diagram::DiagramBlock SensitiveSubdiagram::input(const diagram::Diagram& diagram, const Read& read) const {
  diagram::DiagramBlock block(fmt::format("read_{}_{}", read.signal.block, read.signal.output),
                              diagram::external_input_type());
  static_cast<diagram::ExternalInput*>(block.block.get())->value =
      PerElement(Numbers(std::vector<double>(static_cast<std::size_t>(read.size), 0.0)));
  block.parameter_marks.resize(1);
  block.parameter_dimensions.resize(1);
  block.origin = diagram.blocks[static_cast<std::size_t>(read.signal.block)].origin;
  if (read.rate.kind == plan::Rate::Kind::discrete)
    block.every = diagram::Every{static_cast<double>(read.rate.ticks) * diagram.step,
                                 static_cast<double>(read.rate.first) * diagram.step};
  return block;
}

std::vector<int> SensitiveSubdiagram::keep_blocks(const diagram::Diagram& diagram,
                                                  diagram::Diagram& part) const {
  std::vector<int> place(kept_.size(), -1);
  for (std::size_t b = 0; b < kept_.size(); ++b) {
    if (!kept_[b]) continue;
    place[b] = static_cast<int>(part.blocks.size());
    part.blocks.push_back(diagram.blocks[b]);
  }
  return place;
}

diagram::Source SensitiveSubdiagram::moved(diagram::Source source, const std::vector<int>& place,
                                           int first_read) const {
  if (source.block < 0) return source;
  const diagram::SignalRef signal{source.block, source.output, -1};
  const int kept = place[static_cast<std::size_t>(source.block)];
  const auto read =
      std::find_if(reads_.begin(), reads_.end(), [&](const Read& one) { return one.signal == signal; });
  source.block = kept >= 0 ? kept : first_read + static_cast<int>(read - reads_.begin());
  source.output = kept >= 0 ? source.output : 0;
  return source;
}

diagram::Diagram SensitiveSubdiagram::of(const diagram::Diagram& diagram) const {
  diagram::Diagram part = without_blocks(diagram);
  const std::vector<int> place = keep_blocks(diagram, part);
  const int first_read = static_cast<int>(part.blocks.size());
  for (diagram::DiagramBlock& block : part.blocks)
    for (auto& sources : block.inputs)
      for (diagram::Source& source : sources) source = moved(std::move(source), place, first_read);
  for (const Read& read : reads_) {
    part.inputs.push_back({"", static_cast<int>(part.blocks.size()), ""});
    part.blocks.push_back(input(diagram, read));
  }
  for (diagram::RecordRequest& request : part.records) {
    std::erase_if(request.signals,
                  [&](const diagram::RecordedSignal& signal) { return !gives(signal.name); });
    for (diagram::RecordedSignal& signal : request.signals)
      signal.signal.block = place[static_cast<std::size_t>(signal.signal.block)];
  }
  part.bindings = moved_bindings(*diagram.bindings, place);
  return part;
}

}  // namespace stepwire::estimation
