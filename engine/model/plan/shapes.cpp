#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "engine/model/diagram/output_names.hpp"
#include "engine/model/plan/configuring.hpp"
#include "engine/model/plan/infer_list_widths.hpp"

namespace stepwire::plan {

namespace {

/// a b, but no more than what is refused anyway.
Eigen::Index bounded_product(Eigen::Index a, Eigen::Index b) {
  const double product = static_cast<double>(a) * static_cast<double>(b);
  return product > static_cast<double>(max_numbers) ? max_numbers + 1 : a * b;
}

/// Finds the size of every port and state: from declarations and parameters, along wires, then from lists.
class Shapes {
 public:
  explicit Shapes(Draft& draft) : draft_(draft), sizes_(draft) {}

  void run() {
    for (std::size_t i = 0; i < draft_.blocks.size(); ++i) declare(i);
    for (std::size_t i = 0; i < draft_.blocks.size(); ++i) connect(i);
    refused_ = infer_list_widths(draft_, sizes_);
    for (std::size_t i = 0; i < draft_.blocks.size(); ++i) {
      check_elements(i);
      refuse_small(i);
    }
    for (std::size_t i = 0; i < draft_.blocks.size(); ++i) store(i);
  }

 private:
  void declare(std::size_t index) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    for (const auto& [name, elements] : draft_.blocks[index].says.sizes)
      sizes_.set(sizes_.symbol(index, name), elements);
    for (std::size_t p = 0; p < block.type().parameters.size(); ++p) declare_parameter(index, block, p);
    for (const diagram::InitialValue& initial : block.initial) {
      const StateSpec& spec = block.type().states[static_cast<std::size_t>(initial.state)];
      if (initial.value.size() > 1)
        require(index, spec.shape, initial.value.size(), initial.origin, initial.value.size(),
                "the initial value");
    }
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
      if (spec.list) continue;
      for (const diagram::Source& source : block.inputs[i]) connect_one(index, spec, source);
    }
  }

  void connect_one(std::size_t index, const InputSpec& spec, const diagram::Source& source) {
    const int wanted = sizes_.symbol(index, spec.shape);
    const std::string subject = draft_.diagram().blocks[index].name + "." + spec.name;
    if (source.block < 0) {
      if (source.constant.size() > 1 && !sizes_.set(wanted, source.constant.size()))
        draft_.report.add(
            source.origin, subject,
            fmt::format("has {} numbers; {} would fit", source.constant.size(), *sizes_.value(wanted)));
    } else if (const int given = sizes_.of_output(source); !sizes_.join(given, wanted)) {
      draft_.report.add(
          source.origin, subject,
          fmt::format("'{}' has {} elements, but {} takes {}; join or pick elements with Mux or Select",
                      name_of(source), *sizes_.value(given), subject, *sizes_.value(wanted)));
    }
  }

  std::string name_of(const diagram::Source& source) const {
    const diagram::DiagramBlock& block = draft_.plan.diagram.blocks[static_cast<std::size_t>(source.block)];
    return diagram::output_name(block.name, block.type(), static_cast<std::size_t>(source.output));
  }

  /// At the end, since an element's own size may come to be known only after that of its list.
  void check_elements(std::size_t index) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    for (std::size_t i = 0; i < block.inputs.size(); ++i) {
      const InputSpec& spec = block.type().inputs[i];
      if (!spec.list || spec.shape.starts_with('+') || refused_.contains({index, i})) continue;
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
                    source.block < 0 ? "this" : "'" + name_of(source) + "'", *given, size));
  }

  void refuse_small(std::size_t index) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    for (const auto& [name, least] : draft_.blocks[index].says.min_sizes) {
      const Eigen::Index size = sizes_.value(sizes_.symbol(index, name)).value_or(1);
      if (size < least)
        draft_.report.add(block.origin, block.name,
                          fmt::format("is fed {} elements; it needs at least {}", size, least));
    }
  }

  void store(std::size_t index) {
    diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    Draft::Block& made = draft_.blocks[index];
    const auto factor = [&](const std::string& name) {
      return sizes_.value(sizes_.symbol(index, name)).value_or(1);
    };
    const auto size = [&](const std::string& shape) {  // "k x n": k rows of n elements, one behind the other
      const std::size_t times = shape.find(" x ");
      return times == std::string::npos
                 ? factor(shape)
                 : bounded_product(factor(shape.substr(0, times)), factor(shape.substr(times + 3)));
    };
    for (const OutputSpec& spec : block.type().outputs) made.output_sizes.push_back(size(spec.shape));
    for (const StateSpec& spec : block.type().states) made.state_sizes.push_back(size(spec.shape));
    if (!made.says.skips_crossings)
      for (const CrossingSpec& spec : block.type().crossings) made.crossings += size(spec.shape);
    for (const InputSpec& spec : block.type().inputs)
      made.input_sizes.push_back(
          size(spec.list && spec.shape.starts_with('+') ? spec.shape.substr(1) : spec.shape));
    if (!fits(block, made)) return;
    for (const ParameterSpec& spec : block.type().parameters)
      if (spec.kind == ParameterKind::per_element) expand(block, spec, size(spec.shape));
  }

  /// Refuses the block with which it becomes too much.
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
  std::set<std::pair<std::size_t, std::size_t>> refused_;  ///< lists of which enough has been said
  Eigen::Index total_ = 0;
};

}  // namespace

void plan_shapes(Draft& draft) {
  Shapes(draft).run();
}

}  // namespace stepwire::plan
