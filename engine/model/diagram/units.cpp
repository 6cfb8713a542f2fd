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
                                              const std::optional<unit::Dimension>& element) {
      if (element) return faults_.add_number(equation, wrong, *element);
      faults_.add(equation, wrong, dimension_at(equation));
    });
    check_norms();
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
      if (units.parameters[i].variables.empty() || !block.parameter_dimensions[i]) continue;
      const ParameterSpec& spec = block.type().parameters[i];
      add(start({block.origin.scope, block.parameter_marks[i]}, index, spec.name.c_str(),
                units.parameters[i]),
          *block.parameter_dimensions[i], "the number");
    }
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

  /// Adds an equation with the unit of a number.
  void add(UnitEquation equation, const unit::Dimension& dimension, std::string what) {
    equation.constant = equation.constant.times(dimension, -1.0);
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

  /// Returns the unit of the port, the own side of an equation, if known.
  std::optional<unit::Dimension> dimension_at(const UnitEquation& equation) {
    if (equation.block < 0) return faults_.demanded(equation);
    const BlockType& type = diagram_.blocks[static_cast<std::size_t>(equation.block)].type();
    const TypeUnits& units = units_of(type);
    if (equation.state >= 0)
      return one_of(evaluate(units.states[static_cast<std::size_t>(equation.state)], equation.block));
    if (const int input = type.input(equation.port); input >= 0)
      return one_of(evaluate(units.inputs[static_cast<std::size_t>(input)], equation.block));
    for (std::size_t i = 0; i < type.parameters.size(); ++i)
      if (type.parameters[i].name == equation.port)
        return one_of(evaluate(units.parameters[i], equation.block));
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

  /// Refuses the length of a vector whose elements are in different units.
  void check_norms() {
    for (const DiagramBlock& block : diagram_.blocks) {
      if (block.type().name != "Norm" || block.inputs[0].empty()) continue;
      const Source& source = block.inputs[0].front();
      if (source.block < 0 || !source.element.is_whole()) continue;
      const auto units = units_of_output(source.block, source.output);
      if (!units || units->is_one()) continue;
      const std::string names = unit_names(*units);
      if (names.find(" and ") != std::string::npos)
        report_.add(
            source.origin, block.name + "." + block.type().inputs[0].name,
            fmt::format("{} has elements in {}, which have no length together; give them one unit, as "
                        "by a Gain for each",
                        faults_.name_of(source), names));
    }
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
