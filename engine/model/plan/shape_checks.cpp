#include "engine/model/plan/shape_checks.hpp"

#include <fmt/format.h>

#include "engine/base/text/count.hpp"
#include "engine/model/diagram/element_index.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/parameters.hpp"
#include "engine/model/plan/draft.hpp"
#include "engine/model/plan/element_slot.hpp"
#include "engine/model/plan/infer_list_widths.hpp"
#include "engine/model/plan/port_sizes.hpp"

namespace stepwire::plan {

namespace {

class ShapeChecks {
 public:
  ShapeChecks(Draft& draft, PortSizes& sizes, const ListInputs& refused)
      : draft_(draft), sizes_(sizes), refused_(refused) {}

  void run() {
    for (std::size_t i = 0; i < draft_.blocks.size(); ++i) {
      check_elements(i);
      check_matrices(i);
      refuse_small(i);
    }
  }

 private:
  /// Refuses elements that their signals do not have, and matrices with incomplete rows.
  void check_matrices(std::size_t index) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    for (std::size_t i = 0; i < block.inputs.size(); ++i)
      for (const diagram::Source& source : block.inputs[i])
        if (const std::string missing =
                missing_element(source.element, whole(source), source_name(draft_, source));
            !missing.empty())
          draft_.report.add(source.origin, block.name + "." + block.type().inputs[i].name, missing);
    if (!sizes_.has_matrices()) return;
    for (const InputSpec& spec : block.type().inputs)
      if (!spec.list) check_product(index, block, spec.name, spec.shape);
    for (const OutputSpec& spec : block.type().outputs) check_product(index, block, spec.name, spec.shape);
  }

  void check_product(std::size_t index, const diagram::DiagramBlock& block, const std::string& port,
                     const std::string& shape) {
    const int size = sizes_.symbol(index, shape);
    const auto matrix = sizes_.factors(size);
    if (!matrix || !PortShape(shape).is_matrix) return;
    const Eigen::Index elements = sizes_.value(size).value_or(1),
                       rows = sizes_.value(matrix->first).value_or(1),
                       columns = sizes_.value(matrix->second).value_or(1);
    if (bounded_product(rows, columns) != elements && said_.insert(index).second)
      draft_.report.add(block.origin, block.name + "." + port,
                        fmt::format("takes a matrix of {} x {}, and is fed {}", rows, columns,
                                    text::counted(elements, "element")));
  }

  SignalSlot whole(const diagram::Source& source) {
    if (source.block < 0) return {0, source.constant.size(), source.columns};
    const int size = sizes_.of_output(source);
    return {0, sizes_.value(size).value_or(1), sizes_.columns(size)};
  }

  /// Checks the elements of lists last, since an element's size may be determined after that of its list.
  void check_elements(std::size_t index) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    for (std::size_t i = 0; i < block.inputs.size(); ++i) {
      const InputSpec& spec = block.type().inputs[i];
      if (!spec.list || spec.shape.find('+') != std::string::npos || refused_.contains({index, i})) continue;
      const Eigen::Index size = sizes_.value(sizes_.of_list(index, i)).value_or(1);
      for (const diagram::Source& source : block.inputs[i])
        check_element(source, size, block.name + "." + spec.name);
    }
  }

  void check_element(const diagram::Source& source, Eigen::Index size, const std::string& subject) {
    const auto given = sizes_.value_of(source);
    if (!given || *given == 1 || *given == size) return;
    draft_.report.add(
        source.origin, subject,
        fmt::format("{} has {} elements, but others in this list have {}; all must have the same, or one",
                    quoted_source(draft_, source), *given, size));
  }

  void refuse_small(std::size_t index) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    for (const auto& [name, least] : draft_.blocks[index].says.min_sizes) {
      const Eigen::Index size = sizes_.value(sizes_.symbol(index, name)).value_or(1);
      if (size < least)
        draft_.report.add(
            block.origin, block.name,
            fmt::format("is fed {} {}; it needs at least {}", size, counted_by(block.type(), name), least));
    }
  }

  /// Returns the meaning of a letter in the shapes of inputs: rows, columns or elements.
  static const char* counted_by(const BlockType& type, const std::string& letter) {
    for (const InputSpec& input : type.inputs) {
      const PortShape shape(input.shape);
      if (shape.is_matrix && shape.rows == letter) return "rows";
      if (shape.is_matrix && shape.columns == letter) return "columns";
    }
    return "elements";
  }

  Draft& draft_;
  PortSizes& sizes_;
  const ListInputs& refused_;
  std::set<std::size_t> said_;  ///< blocks with a reported fault
};

// Checks of safe values and stop conditions, once sizes are known.

/// Refuses an element that a signal does not have.
bool check_element(Draft& draft, diagram::SignalRef signal, const std::string& name,
                   const diagram::Origin& origin, const std::string& subject) {
  const diagram::ElementIndex element = std::exchange(signal.element, {});
  const std::string missing = missing_element(element, draft.plan.slot(signal), name);
  if (!missing.empty()) draft.report.add(origin, subject, missing);
  return missing.empty();
}

void check_stop_condition(Draft& draft, const diagram::StopCondition& condition) {
  for (std::size_t i = 0; i < condition.variables.size(); ++i) {
    const diagram::SignalRef& signal = condition.variables[i];
    const std::string& name = condition.expression.variables()[i];
    if (signal.block < 0 || !check_element(draft, signal, name, condition.origin, "stop_when")) continue;
    const Eigen::Index size = draft.plan.slot(signal).size;
    if (size > 1)
      draft.report.add(condition.origin, "stop_when",
                       fmt::format("'{0}' has {1} elements; a condition takes single numbers, so name one, "
                                   "'{0}.1', or take the Norm",
                                   name, size));
  }
}

/// Checks the unit of each number of a safe value.
void check_safe_units(Draft& draft, const diagram::DiagramOutput& output, const std::string& subject) {
  const SignalSlot slot = draft.plan.slot(output.signal);
  for (Eigen::Index k = 0; k < slot.size; ++k) {
    const auto element = slot.size == 1 ? output.signal : element_of(output.signal, slot, k);
    const auto& given =
        output.safe_each.empty() ? output.safe_dimension : output.safe_each[static_cast<std::size_t>(k)];
    const std::string complaint = diagram::unit_complaint(given, draft.plan.dimension(element));
    if (!complaint.empty()) return draft.report.add(output.origin, subject, complaint);
  }
}

/// Checks that the safe value of an output has its size and unit.
void check_safe_value(Draft& draft, diagram::DiagramOutput& output) {
  const std::string subject = output.name + ".safe";
  const Eigen::Index size = draft.plan.slot(output.signal).size;
  if (output.safe->size() == 1) *output.safe = Eigen::VectorXd::Constant(size, (*output.safe)[0]);
  if (output.safe->size() != size)
    draft.report.add(
        output.origin, subject,
        fmt::format("has {} where the signal has {}", text::counted(output.safe->size(), "element"), size));
  if (output.safe->size() == size) check_safe_units(draft, output, subject);
}

}  // namespace

Eigen::Index bounded_product(Eigen::Index a, Eigen::Index b) {
  const double product = static_cast<double>(a) * static_cast<double>(b);
  return product > static_cast<double>(max_numbers) ? max_numbers + 1 : a * b;
}

std::string source_name(const Draft& draft, const diagram::Source& source) {
  if (source.block < 0) return "the numbers";
  const diagram::DiagramBlock& block = draft.plan.diagram.blocks[static_cast<std::size_t>(source.block)];
  return diagram::output_name(block.name, block.type(), static_cast<std::size_t>(source.output)) +
         diagram::element_text(source.element);
}

std::string quoted_source(const Draft& draft, const diagram::Source& source) {
  return source.block < 0 ? "this" : "'" + source_name(draft, source) + "'";
}

void check_shapes(Draft& draft, PortSizes& sizes, const ListInputs& refused) {
  ShapeChecks(draft, sizes, refused).run();
}

void check_stop_and_safe_values(Draft& draft) {
  if (draft.diagram().stop_when) check_stop_condition(draft, *draft.diagram().stop_when);
  for (const diagram::RecordRequest& request : draft.diagram().records)
    for (const diagram::RecordedSignal& signal : request.signals)
      check_element(draft, signal.signal, signal.name, signal.origin, "record");
  for (diagram::DiagramOutput& output : draft.diagram().outputs)
    if (check_element(draft, output.signal, output.name, output.origin, output.name) && output.safe)
      check_safe_value(draft, output);
}

}  // namespace stepwire::plan
