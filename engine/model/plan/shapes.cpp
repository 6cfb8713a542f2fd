#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "engine/model/plan/canonical_order.hpp"
#include "engine/model/plan/configuring.hpp"
#include "engine/model/plan/element_slot.hpp"
#include "engine/model/plan/infer_list_widths.hpp"
#include "engine/model/plan/matrix_lists.hpp"
#include "engine/model/plan/port_sizes.hpp"
#include "engine/model/plan/shape_checks.hpp"

namespace stepwire::plan {

namespace {

bool has_matrix_port(const BlockType& type) {
  const auto is_matrix = [](const auto& port) { return PortShape(port.shape).is_matrix; };
  return std::ranges::any_of(type.inputs, is_matrix) || std::ranges::any_of(type.outputs, is_matrix);
}

/// Returns the blocks in the order in which their sizes are determined. Rows and columns that nothing
/// determines are assumed one by one, so this order must not be that of the file.
std::vector<int> order_of(const Draft& draft) {
  const auto& blocks = draft.plan.diagram.blocks;
  if (std::ranges::any_of(blocks, [](const auto& block) { return has_matrix_port(block.type()); }))
    return canonical_order(draft);
  std::vector<int> order(blocks.size());
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// Determines the size of every port and state: from declarations and parameters, along wires, then from
/// lists.
class Shapes {
 public:
  explicit Shapes(Draft& draft) : draft_(draft), sizes_(draft), matrix_lists_(draft, sizes_) {}

  void run() {
    const std::vector<int> order = order_of(draft_);
    for (const int block : order) declare(static_cast<std::size_t>(block));
    for (const int block : order) connect(static_cast<std::size_t>(block));
    for (const diagram::ShapeDemand& demand : draft_.diagram().shape_demands) demand_shape(demand);
    refused_ = infer_list_widths(draft_, sizes_, matrix_lists_, order);
    check_shapes(draft_, sizes_, refused_);
    matrix_lists_.check();
    for (std::size_t i = 0; i < draft_.blocks.size(); ++i) store(i);
  }

 private:
  void declare(std::size_t index) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    for (const auto& [name, elements] : draft_.blocks[index].says.sizes)
      sizes_.set(sizes_.symbol(index, name), elements);
    declare_matrices(index, block.type());
    for (std::size_t p = 0; p < block.type().parameters.size(); ++p) declare_parameter(index, block, p);
    for (const diagram::InitialValue& initial : block.initial) {
      const StateSpec& spec = block.type().states[static_cast<std::size_t>(initial.state)];
      if (initial.value.size() > 1)
        require(index, spec.shape, initial.value.size(), initial.origin, initial.value.size(),
                "the initial value");
      take_columns(index, spec.shape, initial.value.size(), initial.columns);
    }
    for (const auto& [p, columns] : block.matrices) {
      const ParameterSpec& spec = block.type().parameters[p];
      const Value value = spec.get(block.block.get());
      if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content))
        take_columns(index, spec.shape, vector->size(), columns);
    }
  }

  /// Records the rows and columns of matrix ports.
  void declare_matrices(std::size_t index, const BlockType& type) {
    for (const OutputSpec& output : type.outputs) sizes_.declare_matrix(index, output.shape);
    for (const InputSpec& input : type.inputs)
      if (!input.list) sizes_.declare_matrix(index, input.shape);
  }

  /// Makes the size of a parameter that the file gives as a matrix that of a matrix.
  void take_columns(std::size_t index, const std::string& shape, Eigen::Index size, Eigen::Index columns) {
    if (columns == 1) return;
    const int rows = sizes_.add(), wide = sizes_.add();
    sizes_.set(rows, size / columns);
    sizes_.set(wide, columns);
    sizes_.set_factors(sizes_.symbol(index, shape), rows, wide);
  }

  void declare_parameter(std::size_t index, const diagram::DiagramBlock& block, std::size_t p) {
    const ParameterSpec& spec = block.type().parameters[p];
    if (spec.shape.empty()) return;
    const Value value = spec.get(block.block.get());
    const yaml::Mark mark = block.parameter_marks[p].line ? block.parameter_marks[p] : block.origin.mark;
    const diagram::Origin origin{block.origin.scope, mark};
    if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content)) {
      if (spec.kind == ParameterKind::per_element && vector->size() == 1) return;
      require(index, spec.shape, vector->size(), origin, vector->size(), "'" + spec.name + "'");
    } else if (const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content)) {
      const std::size_t times = spec.shape.find(" x ");
      if (times == std::string::npos || matrix->size() == 0) return;
      require(index, spec.shape.substr(0, times), matrix->rows(), origin, matrix->rows(),
              "the number of rows of '" + spec.name + "'");
      require(index, spec.shape.substr(times + 3), matrix->cols(), origin, matrix->cols(),
              "the number of columns of '" + spec.name + "'");
    }
  }

  void require(std::size_t block, const std::string& shape, Eigen::Index elements,
               const diagram::Origin& origin, Eigen::Index shown, const std::string& what) {
    const int size = sizes_.symbol(block, shape);
    if (!sizes_.set(size, elements))
      draft_.report.add(origin, draft_.diagram().blocks[block].name,
                        fmt::format("{} has {} elements; {} would fit", what, shown, *sizes_.value(size)));
  }

  void connect(std::size_t index) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    for (std::size_t i = 0; i < block.inputs.size(); ++i) {
      const InputSpec& spec = block.type().inputs[i];
      if (spec.list && PortShape(spec.shape).is_matrix) matrix_lists_.add(index, i);
      if (spec.list) continue;
      for (const diagram::Source& source : block.inputs[i])
        if (!counts_for_every_element(spec, source))
          connect_one(sizes_.symbol(index, spec.shape), subject_of(index, spec), source);
    }
  }

  /// True for a single constant, which is repeated for all elements; false for a matrix input.
  static bool counts_for_every_element(const InputSpec& spec, const diagram::Source& source) {
    return source.block < 0 && source.constant.size() == 1 && !PortShape(spec.shape).is_matrix;
  }

  std::string subject_of(std::size_t index, const InputSpec& spec) {
    return draft_.diagram().blocks[index].name + "." + spec.name;
  }

  void connect_one(int wanted, const std::string& subject, const diagram::Source& source) {
    const int given = sizes_.of_source(source);
    const std::string shown = sizes_.shown(given);
    if (sizes_.join(given, wanted)) return;
    if (source.block < 0)
      draft_.report.add(
          source.origin, subject,
          fmt::format("has {} numbers; {} would fit", shape_text(source.constant.size(), source.columns),
                      sizes_.fitting(wanted)));
    else
      draft_.report.add(source.origin, subject,
                        fmt::format("'{}' has {}, but {} takes {}; join or pick elements with Mux or Select",
                                    source_name(draft_, source), shown, subject, sizes_.fitting(wanted)));
  }

  void demand_shape(const diagram::ShapeDemand& demand) {
    const int size = sizes_.add(), rows = sizes_.add(), columns = sizes_.add();
    sizes_.set(size, bounded_product(demand.rows, demand.columns));
    sizes_.set(rows, demand.rows);
    sizes_.set(columns, demand.columns);
    const int given = sizes_.of_source(demand.source);
    const std::string shown = sizes_.shown(given);
    if ((demand.columns > 1 && !sizes_.set_factors(size, rows, columns)) || !sizes_.join(given, size))
      draft_.report.add(
          demand.origin, demand.port,
          fmt::format("'{}' has {}, but {} is declared as {}", source_name(draft_, demand.source), shown,
                      demand.port, shape_text(demand.rows * demand.columns, demand.columns)));
  }

  Eigen::Index factor(std::size_t index, const std::string& letter) {
    return sizes_.value(sizes_.symbol(index, letter)).value_or(1);
  }

  /// Returns the number of elements of a shape; "k x n" has k rows of n elements.
  Eigen::Index size_of(std::size_t index, const std::string& text) {
    const PortShape shape(text);
    return shape.is_matrix ? bounded_product(factor(index, shape.rows), factor(index, shape.columns))
                           : factor(index, shape.rows);
  }

  void store_sizes(std::size_t index, Draft::Block& made) {
    diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    const auto size = [&](const std::string& shape) { return size_of(index, shape); };
    const auto columns = [&](const std::string& shape) {
      return sizes_.columns(sizes_.symbol(index, shape));
    };
    for (const OutputSpec& spec : block.type().outputs) {
      made.output_sizes.push_back(size(spec.shape));
      made.output_columns.push_back(columns(spec.shape));
    }
    for (const StateSpec& spec : block.type().states) {
      made.state_sizes.push_back(size(spec.shape));
      made.state_columns.push_back(columns(spec.shape));
    }
    const auto has_numbers = [&](const CrossingSpec& spec) {
      return !spec.if_connected ||
             !block.inputs[static_cast<std::size_t>(block.type().input(spec.inputs.front()))].empty();
    };
    for (const CrossingSpec& spec : block.type().crossings)
      if (!made.says.skips_crossings && has_numbers(spec)) made.crossings += size(spec.shape);
    for (const InputSpec& spec : block.type().inputs) made.input_sizes.push_back(size(spec.shape));
    for (const SizeSpec& spec : block.type().sizes) {
      draft_.plan.blocks[index].sizes.push_back(factor(index, spec.symbol));
      spec.set(block.block.get(), factor(index, spec.symbol));
    }
  }

  void store(std::size_t index) {
    diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    Draft::Block& made = draft_.blocks[index];
    store_sizes(index, made);
    if (!fits(block, made)) return;
    for (const ParameterSpec& spec : block.type().parameters)
      if (spec.kind == ParameterKind::per_element) expand(block, spec, size_of(index, spec.shape));
  }

  /// Adds the numbers of a block; refuses the block that exceeds the limit.
  bool fits(const diagram::DiagramBlock& block, const Draft::Block& made) {
    if (total_ > max_numbers) return false;
    Eigen::Index own = 0;
    for (const auto* sizes : {&made.output_sizes, &made.state_sizes, &made.input_sizes})
      for (Eigen::Index size : *sizes) own += std::clamp<Eigen::Index>(size, 0, max_numbers + 1);
    total_ += own;
    if (total_ <= max_numbers) return true;
    draft_.report.add(
        block.origin, block.name,
        fmt::format("needs {}{} numbers for its ports and states; all blocks together may have {}",
                    own > max_numbers ? "more than " : "", std::min(own, max_numbers), max_numbers));
    return false;
  }

  static void expand(diagram::DiagramBlock& block, const ParameterSpec& spec, Eigen::Index size) {
    if (size == 1) return;
    if (std::get<Eigen::VectorXd>(spec.get(block.block.get()).content).size() != 1) return;
    spread(block.block, spec, size);
    block.spread.push_back(static_cast<std::size_t>(&spec - block.type().parameters.data()));
  }

  Draft& draft_;
  PortSizes sizes_;
  MatrixLists matrix_lists_;
  std::set<std::pair<std::size_t, std::size_t>> refused_;  ///< lists with a reported fault
  Eigen::Index total_ = 0;
};

}  // namespace

void plan_shapes(Draft& draft) {
  Shapes(draft).run();
}

}  // namespace stepwire::plan
