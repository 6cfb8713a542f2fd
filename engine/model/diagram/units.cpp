#include "engine/model/diagram/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/head.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/type_units.hpp"
#include "engine/model/diagram/unit_equations.hpp"

namespace stepwire::diagram {

namespace {

class Inference {
 public:
  explicit Inference(Report& report) : report_(report), diagram_(report.diagram()) {}

  void run() {
    first_variable_.reserve(diagram_.blocks.size());
    for (const DiagramBlock& block : diagram_.blocks) add_variables(block.type());
    for (std::size_t i = 0; i < diagram_.blocks.size(); ++i) add_equations(static_cast<int>(i));
    for (const UnitDemand& demand : diagram_.unit_demands) add_demand(demand);
    equations_.solve(variable_count_, [this](const UnitEquation& equation, const unit::Dimension& wrong) {
      complain(equation, wrong);
    });
    store();
  }

  PortUnits inputs() {
    PortUnits all(diagram_.blocks.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      for (const auto& expression : units_of(diagram_.blocks[i].type()).inputs)
        all[i].push_back(evaluate(expression, static_cast<int>(i)));
    return all;
  }

 private:
  const TypeUnits& units_of(const BlockType& type) { return types_.try_emplace(&type, type).first->second; }

  void add_variables(const BlockType& type) {
    first_variable_.push_back(static_cast<int>(variable_count_));
    variable_count_ += units_of(type).variables.size();
  }

  void include(UnitEquation& equation, const UnitExpression& expression, int block, double sign) {
    equation.constant = equation.constant * unit::power(expression.constant, sign);
    const TypeUnits& units = units_of(diagram_.blocks[static_cast<std::size_t>(block)].type());
    for (const auto& [name, exponent] : expression.variables) {
      const auto index =
          std::find(units.variables.begin(), units.variables.end(), name) - units.variables.begin();
      const int variable = first_variable_[static_cast<std::size_t>(block)] + static_cast<int>(index);
      const auto known = std::find_if(equation.terms.begin(), equation.terms.end(),
                                      [&](auto& t) { return t.first == variable; });
      if (known == equation.terms.end()) {
        equation.terms.emplace_back(variable, sign * exponent);
      } else {
        known->second += sign * exponent;
      }
    }
  }

  /// Divides by the unit of what feeds; false if that can be anything.
  bool divide_by_source(UnitEquation& equation, const Source& source) {
    if (source.block < 0) {
      if (!source.dimension) return false;
      equation.constant = equation.constant / *source.dimension;
      return true;
    }
    const TypeUnits& units = units_of(diagram_.blocks[static_cast<std::size_t>(source.block)].type());
    const UnitExpression& expression = units.outputs[static_cast<std::size_t>(source.output)];
    if (expression.any) return false;
    include(equation, expression, source.block, -1.0);
    return true;
  }

  void add_equations(int index) {
    const DiagramBlock& block = diagram_.blocks[static_cast<std::size_t>(index)];
    const TypeUnits& units = units_of(block.type());
    add_inputs(index, block, units);
    add_parameters(index, block, units);
    for (const auto& [variable, dimension] : block.known_units)
      add(start(block.origin, index, "", {false, {}, {{variable.substr(1), 1.0}}}), dimension,
          "what it reads");
    for (const InitialValue& initial : block.initial) {
      const auto& expression = units.states[static_cast<std::size_t>(initial.state)];
      if (!initial.dimension || expression.any) continue;
      UnitEquation equation = start(initial.origin, index, "initial", expression);
      equation.state = initial.state;
      add(std::move(equation), *initial.dimension, "the initial value");
    }
  }

  void add_inputs(int index, const DiagramBlock& block, const TypeUnits& units) {
    for (std::size_t i = 0; i < block.inputs.size(); ++i) {
      if (units.inputs[i].any) continue;
      const InputSpec& spec = block.type().inputs[i];
      if (spec.multiply_units)
        add_product(index, spec, units.inputs[i], block.inputs[i]);
      else
        for (const Source& source : block.inputs[i])
          add_wire(source, start(source.origin, index, spec.name.c_str(), units.inputs[i]));
    }
  }

  void add_parameters(int index, const DiagramBlock& block, const TypeUnits& units) {
    for (std::size_t i = 0; i < units.parameters.size(); ++i) {
      if (units.parameters[i].variables.empty() || !block.parameter_dimensions[i]) continue;
      const ParameterSpec& spec = block.type().parameters[i];
      add(start({block.origin.scope, block.parameter_marks[i]}, index, spec.name.c_str(),
                units.parameters[i]),
          *block.parameter_dimensions[i], "the number");
    }
  }

  void add_wire(const Source& source, UnitEquation equation) {
    if (divide_by_source(equation, source)) equations_.add(std::move(equation), name_of(source));
  }

  /// An equation with what a number is in.
  void add(UnitEquation equation, const unit::Dimension& dimension, std::string what) {
    equation.constant = equation.constant / dimension;
    equations_.add(std::move(equation), std::move(what));
  }

  UnitEquation start(const Origin& origin, int block, const char* port, const UnitExpression& expression) {
    UnitEquation equation;
    equation.origin = origin;
    equation.block = block;
    equation.port = port;
    include(equation, expression, block, 1.0);
    return equation;
  }

  void add_product(int index, const InputSpec& spec, const UnitExpression& expression,
                   const std::vector<Source>& sources) {
    if (sources.empty()) return;
    UnitEquation equation = start(sources.front().origin, index, spec.name.c_str(), expression);
    for (const Source& source : sources)
      if (!divide_by_source(equation, source)) return;
    equations_.add(std::move(equation), "the product");
  }

  void add_demand(const UnitDemand& demand) {
    UnitEquation equation;
    equation.origin = demand.origin;
    equation.port = demand.port.c_str();
    equation.constant = demand.dimension;
    add_wire(demand.source, std::move(equation));
  }

  std::string name_of(const Source& source) const {
    if (source.block < 0) return "the number";
    const DiagramBlock& block = diagram_.blocks[static_cast<std::size_t>(source.block)];
    return output_name(block.name, block.type(), static_cast<std::size_t>(source.output));
  }

  void complain(const UnitEquation& equation, const unit::Dimension& wrong) {
    const std::string owner =
        equation.block < 0 ? "" : diagram_.blocks[static_cast<std::size_t>(equation.block)].name + ".";
    const std::string subject = owner + (equation.state < 0 ? equation.port : initial_key_of(equation));
    const auto taken = dimension_at(equation);
    if (!taken) {
      report_.add(
          equation.origin, subject,
          fmt::format("{} does not fit: the units differ by {}", equation.what, unit::si_name(wrong)));
      return;
    }
    report_.add(equation.origin, subject,
                fmt::format("{} is in {}, but {} is in {}", equation.what, unit::si_name(*taken / wrong),
                            subject, unit::si_name(*taken)));
  }

  std::string initial_key_of(const UnitEquation& equation) const {
    const BlockType& type = diagram_.blocks[static_cast<std::size_t>(equation.block)].type();
    return initial_key(type, type.states[static_cast<std::size_t>(equation.state)]);
  }

  /// The unit that the port takes, where it is known: the equation's own side.
  std::optional<unit::Dimension> dimension_at(const UnitEquation& equation) {
    if (equation.block < 0) {
      for (const UnitDemand& demand : diagram_.unit_demands)
        if (demand.port.c_str() == equation.port) return demand.dimension;
      return std::nullopt;
    }
    const BlockType& type = diagram_.blocks[static_cast<std::size_t>(equation.block)].type();
    const TypeUnits& units = units_of(type);
    if (equation.state >= 0)
      return evaluate(units.states[static_cast<std::size_t>(equation.state)], equation.block);
    if (const int input = type.input(equation.port); input >= 0)
      return evaluate(units.inputs[static_cast<std::size_t>(input)], equation.block);
    for (std::size_t i = 0; i < type.parameters.size(); ++i)
      if (type.parameters[i].name == equation.port) return evaluate(units.parameters[i], equation.block);
    return std::nullopt;
  }

  std::optional<unit::Dimension> evaluate(const UnitExpression& expression, int block) {
    if (expression.any) return std::nullopt;
    UnitEquation equation;
    include(equation, expression, block, 1.0);
    return equations_.dimension_of(equation);
  }

  void store() {
    diagram_.output_dimensions.resize(diagram_.blocks.size());
    diagram_.state_dimensions.resize(diagram_.blocks.size());
    for (std::size_t i = 0; i < diagram_.blocks.size(); ++i) {
      const TypeUnits& units = units_of(diagram_.blocks[i].type());
      for (const auto& expression : units.outputs)
        diagram_.output_dimensions[i].push_back(evaluate(expression, static_cast<int>(i)));
      for (const auto& expression : units.states)
        diagram_.state_dimensions[i].push_back(evaluate(expression, static_cast<int>(i)));
    }
  }

  Report& report_;
  Diagram& diagram_;
  std::unordered_map<const BlockType*, TypeUnits> types_;
  std::vector<int> first_variable_;
  std::size_t variable_count_ = 0;
  UnitEquations equations_;
};

}  // namespace

void infer_units(Report& report) {
  Inference(report).run();
  check_stop_condition(report);
  check_conditions(report);
}

PortUnits infer_input_units(Report& report) {
  Inference inference(report);
  inference.run();
  check_stop_condition(report);
  check_conditions(report);
  return inference.inputs();
}

}  // namespace stepwire::diagram
