#include "engine/model/diagram/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/formula_units.hpp"
#include "engine/model/diagram/head.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/temperatures.hpp"
#include "engine/model/diagram/unit_faults.hpp"
#include "engine/model/diagram/unit_terms.hpp"

namespace stepwire::diagram {

namespace {

class Inference : UnitTerms {
 public:
  Inference(Report& report, const OutputShapes& shapes)
      : UnitTerms(report.about(), shapes), report_(report), diagram_(report.diagram()), faults_(report) {}

  void run() {
    add_variables(equations_);
    for (std::size_t i = 0; i < diagram_.blocks.size(); ++i) add_equations(static_cast<int>(i));
    for (const UnitDemand& demand : diagram_.unit_demands) add_demand(demand);
    open().join(equations_);
    equations_.solve(variable_count(), [this](const UnitEquation& equation, const unit::Dimension& wrong,
                                              const std::optional<MissedElement>& element) {
      if (element && equation.constant.is_one()) return faults_.add_number(equation, wrong, element->unit);
      if (element) return faults_.add_element(equation, element->index, wrong, element->unit);
      const auto product = equations_.dimension_of(equation);
      if (!product || product->is_one()) return faults_.add(equation, wrong, dimension_at(equation));
      add_fault_of_element(equation, *product);
    });
    check_elements();
    store();
  }

  PortUnits inputs() {
    PortUnits all(diagram_.blocks.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      for (const auto& expression : units_of(diagram_.blocks[i].type()).inputs)
        all[i].push_back(one_of(evaluate(expression, static_cast<int>(i))));
    return all;
  }

 private:
  void add_equations(int index) {
    const DiagramBlock& block = diagram_.blocks[static_cast<std::size_t>(index)];
    const TypeUnits& units = units_of(block.type());
    add_inputs(index, block, units);
    add_parameters(index, block, units);
    add_pure_factors(index, block, units);
    add_products(index, block, units);
    add_opened(index, block, units);
    for (const auto& [variable, dimension] : block.known_units)
      add(start(block.origin, index, "", {false, false, {}, {{variable.substr(1), 1.0}}}), dimension,
          "what it reads");
    for (const InitialValue& initial : block.initial) {
      const auto& expression = units.states[static_cast<std::size_t>(initial.state)];
      const auto units_given = units_of_numbers(initial.dimension, &initial.each);
      if (!units_given || expression.any) continue;
      UnitEquation equation = start(initial.origin, index, "initial", expression);
      equation.state = initial.state;
      add(std::move(equation), *units_given, "the initial value");
    }
  }

  void add_inputs(int index, const DiagramBlock& block, const TypeUnits& units) {
    for (std::size_t i = 0; i < block.inputs.size(); ++i) {
      if (units.inputs[i].any) continue;
      const InputSpec& spec = block.type().inputs[i];
      if (spec.multiply_units)
        add_product(index, spec, units.inputs[i], block.inputs[i]);
      else if (joins_pieces(spec))
        add_join(index, spec, units.inputs[i], block.inputs[i]);
      else
        for (const Source& source : block.inputs[i])
          add_wire(source, start(source.origin, index, spec.name.c_str(), units.inputs[i]));
    }
  }

  void add_products(int index, const DiagramBlock& block, const TypeUnits& units) {
    for (const TypeUnits::Product& product : units.products) {
      const char* name = block.type().outputs[product.output].name.c_str();
      UnitEquation equation = start(block.origin, index, name, units.outputs[product.output]);
      equation.defines = equation.terms.front().variable;
      include(equation, product.unit, index, -1.0);
      equations_.add(std::move(equation), "what it computes");
    }
  }

  /// Checks the section `units` against the units that a block declares.
  void add_opened(int index, const DiagramBlock& block, const TypeUnits& units) {
    for (std::size_t o = 0; o < units.outputs.size(); ++o) {
      const int output = static_cast<int>(o);
      if (units.outputs[o].any || !open().is_opened(index, output)) continue;
      UnitEquation equation = start(block.origin, index, block.type().outputs[o].name.c_str(), {});
      equation.terms.push_back({open().whole(index, output), 1.0});
      include(equation, units.outputs[o], index, -1.0);
      equation.only_checks = true;
      equations_.add(std::move(equation), "the unit of an element");
    }
  }

  void add_join(int index, const InputSpec& spec, const UnitExpression& expression,
                const std::vector<Source>& sources) {
    UnitJoin join;
    ElementRange range{0, 1, true};
    for (const Source& source : sources) {
      UnitJoin::Piece piece = piece_of(source);
      range.count = piece.size;
      range.known = range.known && piece.size > 0;
      UnitEquation equation = start({}, index, spec.name.c_str(), {});
      equation.origin = source.origin;
      include(equation, expression, index, 1.0, range);
      join.variable = equation.terms.front().variable;
      equation.joins = join.variable;
      add_wire(source, std::move(equation));
      range.first += piece.size;
      join.pieces.push_back(std::move(piece));
    }
    if (join.variable >= 0) equations_.add(std::move(join));
  }

  void add_parameters(int index, const DiagramBlock& block, const TypeUnits& units) {
    for (std::size_t i = 0; i < units.parameters.size(); ++i) {
      const ParameterSpec& spec = block.type().parameters[i];
      // A matrix of elements in several units, such as the gain of a state, has no unit of a port.
      const EachUnit* const each = spec.kind == ParameterKind::matrix ? nullptr : block.elements_of(i);
      const auto units_given = units_of_numbers(block.parameter_dimensions[i], each);
      if (units.parameters[i].variables.empty() || !units_given) continue;
      add(start({block.origin.scope, block.parameter_marks[i]}, index, spec.name.c_str(),
                units.parameters[i]),
          *units_given, "the number");
    }
  }

  /// Returns the units of numbers in one unit or in several; std::nullopt for bare numbers.
  static std::optional<ElementUnits> units_of_numbers(const std::optional<unit::Dimension>& one,
                                                      const EachUnit* each) {
    if (each && !each->empty()) return ElementUnits(*each);
    return one ? std::optional<ElementUnits>(*one) : std::nullopt;
  }

  /// Records factors that the file leaves at their defaults, such as the gain of a Lag.
  void add_pure_factors(int index, const DiagramBlock& block, const TypeUnits& units) {
    for (std::size_t v = 0; v < units.variables.size(); ++v) {
      if (!units.is_factor(units.variables[v])) continue;
      bool given = false;
      for (std::size_t p = 0; p < units.parameters.size(); ++p)
        given = given || (block.parameter_marks[p].line > 0 && units.parameters[p].has(units.variables[v]));
      if (!given) equations_.assume_pure(variable(index, v));
    }
  }

  void add_wire(const Source& source, UnitEquation equation) {
    if (divide_by_source(equation, source)) equations_.add(std::move(equation), faults_.name_of(source));
  }

  /// Adds an equation with the units of numbers.
  void add(UnitEquation equation, const ElementUnits& units, std::string what) {
    equation.constant = equation.constant.times(units, -1.0);
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

  std::optional<ElementUnits> evaluate(const UnitExpression& expression, int block) {
    if (expression.any) return std::nullopt;
    UnitEquation equation;
    include(equation, expression, block, 1.0);
    return equations_.dimension_of(equation);
  }

  /// Reports the first element whose unit does not fit; `wrong` has the units of the product.
  void add_fault_of_element(const UnitEquation& equation, const ElementUnits& wrong) {
    const auto port =
        equation.block < 0 ? units_of_numbers(faults_.demanded(equation), nullptr) : units_at(equation);
    for (std::size_t k = 0; k < wrong.each().size(); ++k)
      if (const auto unit = wrong.of(k); unit && *unit != unit::Dimension{})
        return faults_.add_element(equation, k, *unit, port ? port->of(k) : std::nullopt);
  }

  /// Returns the unit of the port, the own side of an equation, if known.
  std::optional<unit::Dimension> dimension_at(const UnitEquation& equation) {
    return equation.block < 0 ? faults_.demanded(equation) : one_of(units_at(equation));
  }

  /// Returns the units of a block's port, the own side of an equation, if known.
  std::optional<ElementUnits> units_at(const UnitEquation& equation) {
    if (equation.block < 0) return std::nullopt;
    const BlockType& type = diagram_.blocks[static_cast<std::size_t>(equation.block)].type();
    const TypeUnits& units = units_of(type);
    if (equation.state >= 0)
      return evaluate(units.states[static_cast<std::size_t>(equation.state)], equation.block);
    if (const int input = type.input(equation.port); input >= 0)
      return evaluate(units.inputs[static_cast<std::size_t>(input)], equation.block);
    if (const int output = type.output(equation.port); output >= 0)
      return units_of_output(equation.block, output);
    for (std::size_t i = 0; i < type.parameters.size(); ++i)
      if (type.parameters[i].name == equation.port) return evaluate(units.parameters[i], equation.block);
    return std::nullopt;
  }

  static std::optional<unit::Dimension> one_of(const std::optional<ElementUnits>& units) {
    return units ? units->one() : std::nullopt;
  }

  std::optional<ElementUnits> units_of_output(int block, int output) {
    if (!is_open(block, output)) return evaluate(output_unit(block, output), block);
    const int variable = open().find(block, output);
    if (variable < 0) return std::nullopt;
    UnitEquation equation;
    equation.terms = {{variable, 1.0}};
    return equations_.dimension_of(equation);
  }

  void store() {
    diagram_.output_dimensions.resize(diagram_.blocks.size());
    diagram_.state_dimensions.resize(diagram_.blocks.size());
    diagram_.element_dimensions.clear();
    for (std::size_t i = 0; i < diagram_.blocks.size(); ++i) {
      const TypeUnits& units = units_of(diagram_.blocks[i].type());
      const int block = static_cast<int>(i);
      for (int output = 0; output < static_cast<int>(units.outputs.size()); ++output) {
        const auto found = units_of_output(block, output);
        diagram_.output_dimensions[i].push_back(one_of(found));
        if (found && !found->is_one()) diagram_.element_dimensions.push_back({block, output, found->each()});
      }
      for (const auto& expression : units.states)
        diagram_.state_dimensions[i].push_back(one_of(evaluate(expression, block)));
    }
  }

  /// Refuses elements in different units where a block takes one unit, as for the length of a vector.
  void check_elements() {
    for (const DiagramBlock& block : diagram_.blocks)
      for (std::size_t i = 0; i < block.inputs.size(); ++i)
        if (block.type().inputs[i].one_unit && !block.inputs[i].empty()) check_elements(block, i);
  }

  void check_elements(const DiagramBlock& block, std::size_t input) {
    const std::string port = block.name + "." + block.type().inputs[input].name;
    std::optional<ElementUnits> product;
    for (const Source& source : block.inputs[input]) {
      const auto units = units_of_source(source);
      if (!units) return;
      product = product ? product->times(*units, 1.0) : units;
    }
    const std::string names = unit_names(*product);
    if (product->is_one() || names.find(" and ") == std::string::npos) return;
    const Source& first = block.inputs[input].front();
    const std::string what = block.inputs[input].size() > 1 ? "the product"
                             : first.block < 0              ? "the list"
                                                            : faults_.name_of(first);
    report_.add(
        first.origin, port,
        fmt::format("{} has elements in {}, and {} takes one unit; give them one, as by a Gain for each",
                    what, names, block.type().name));
  }

  /// Returns the units of what a source passes on, if known.
  std::optional<ElementUnits> units_of_source(const Source& source) {
    UnitEquation equation;
    if (!divide_by_source(equation, source)) return std::nullopt;
    const auto inverse = equations_.dimension_of(equation);
    return inverse ? std::optional(ElementUnits().times(*inverse, -1.0)) : std::nullopt;
  }

  /// Returns the different known units of elements: "m and rad".
  static std::string unit_names(const ElementUnits& units) {
    std::vector<std::string> names;
    for (const auto& unit : units.each())
      if (unit && std::ranges::find(names, unit::si_name(*unit)) == names.end())
        names.push_back(unit::si_name(*unit));
    return fmt::format("{}", fmt::join(names, " and "));
  }

  Report& report_;
  Diagram& diagram_;
  UnitEquations equations_;
  UnitFaults faults_;
};

void infer_units(Report& report, Inference& inference) {
  inference.run();
  check_temperatures(report);
  check_formulas(report);
  check_stop_condition(report);
  check_conditions(report);
}

}  // namespace

void infer_units(Report& report, const OutputShapes& shapes) {
  Inference inference(report, shapes);
  infer_units(report, inference);
}

PortUnits infer_input_units(Report& report) {
  const OutputShapes none;
  Inference inference(report, none);
  infer_units(report, inference);
  return inference.inputs();
}

}  // namespace stepwire::diagram
