#include "engine/model/diagram/units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <deque>
#include <map>
#include <unordered_map>

#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/head.hpp"
#include "engine/model/diagram/type_units.hpp"

namespace stepwire {

namespace {

/// A product of powers that must be dimensionless: constant times variables.
struct Equation {
  Dimension constant;
  std::vector<std::pair<int, double>> terms;
  Origin origin;
  int block = -1;  ///< whose port it is about, -1: `port` holds the name
  const char* port = "";
  int state = -1;    ///< whose initial value it is about, where it is
  std::string what;  ///< what is wired or written there
  bool queued = true;
};

class Inference {
 public:
  explicit Inference(Report& report) : report_(report), diagram_(report.diagram()) {}

  void run() {
    first_variable_.reserve(diagram_.blocks.size());
    for (const DiagramBlock& block : diagram_.blocks) add_variables(block.type());
    values_.resize(variable_count_);
    in_question_.resize(variable_count_);
    for (std::size_t i = 0; i < diagram_.blocks.size(); ++i) add_equations(static_cast<int>(i));
    for (const UnitDemand& demand : diagram_.unit_demands) add_demand(demand);
    solve();
    store();
  }

 private:
  const TypeUnits& units_of(const BlockType& type) { return types_.try_emplace(&type, type).first->second; }

  void add_variables(const BlockType& type) {
    first_variable_.push_back(static_cast<int>(variable_count_));
    variable_count_ += units_of(type).variables.size();
  }

  void include(Equation& equation, const UnitExpression& expression, int block, double sign) {
    equation.constant = equation.constant * power(expression.constant, sign);
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
  bool divide_by_source(Equation& equation, const Source& source) {
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
    for (std::size_t i = 0; i < block.inputs.size(); ++i) {
      if (units.inputs[i].any) continue;
      const InputSpec& spec = block.type().inputs[i];
      if (spec.multiply_units) {
        add_product(index, spec, units.inputs[i], block.inputs[i]);
        continue;
      }
      for (const Source& source : block.inputs[i]) {
        Equation equation = start(source.origin, index, spec.name.c_str(), units.inputs[i]);
        if (divide_by_source(equation, source)) add(std::move(equation), name_of(source));
      }
    }
    for (std::size_t i = 0; i < units.parameters.size(); ++i) {
      if (units.parameters[i].variables.empty() || !block.parameter_dimensions[i]) continue;
      const ParameterSpec& spec = block.type().parameters[i];
      Equation equation = start({block.origin.scope, block.parameter_marks[i]}, index, spec.name.c_str(),
                                units.parameters[i]);
      equation.constant = equation.constant / *block.parameter_dimensions[i];
      add(std::move(equation), "the number");
    }
    for (const auto& [variable, dimension] : block.known_units) {
      Equation equation = start(block.origin, index, "", {false, {}, {{variable.substr(1), 1.0}}});
      equation.constant = equation.constant / dimension;
      add(std::move(equation), "what it reads");
    }
    for (const InitialValue& initial : block.initial) {
      const auto& expression = units.states[static_cast<std::size_t>(initial.state)];
      if (!initial.dimension || expression.any) continue;
      Equation equation = start(initial.origin, index, "initial", expression);
      equation.constant = equation.constant / *initial.dimension;
      equation.state = initial.state;
      add(std::move(equation), "the initial value");
    }
  }

  Equation start(const Origin& origin, int block, const char* port, const UnitExpression& expression) {
    Equation equation;
    equation.origin = origin;
    equation.block = block;
    equation.port = port;
    include(equation, expression, block, 1.0);
    return equation;
  }

  void add_product(int index, const InputSpec& spec, const UnitExpression& expression,
                   const std::vector<Source>& sources) {
    if (sources.empty()) return;
    Equation equation = start(sources.front().origin, index, spec.name.c_str(), expression);
    for (const Source& source : sources)
      if (!divide_by_source(equation, source)) return;
    add(std::move(equation), "the product");
  }

  void add_demand(const UnitDemand& demand) {
    Equation equation;
    equation.origin = demand.origin;
    equation.port = demand.port.c_str();
    equation.constant = demand.dimension;
    if (divide_by_source(equation, demand.source)) add(std::move(equation), name_of(demand.source));
  }

  void add(Equation equation, std::string what) {
    std::erase_if(equation.terms, [](const auto& term) { return term.second == 0.0; });
    equation.what = std::move(what);
    equations_.push_back(std::move(equation));
  }

  std::string name_of(const Source& source) const {
    if (source.block < 0) return "the number";
    const DiagramBlock& block = diagram_.blocks[static_cast<std::size_t>(source.block)];
    const auto& outputs = block.type().outputs;
    return outputs.size() == 1 ? block.name
                               : block.name + "." + outputs[static_cast<std::size_t>(source.output)].name;
  }

  void solve() {
    std::vector<std::vector<int>> users(variable_count_);
    std::deque<int> queue;
    for (std::size_t i = 0; i < equations_.size(); ++i) {
      for (const auto& [variable, exponent] : equations_[i].terms)
        users[static_cast<std::size_t>(variable)].push_back(static_cast<int>(i));
      queue.push_back(static_cast<int>(i));
    }
    while (!queue.empty()) {
      Equation& equation = equations_[static_cast<std::size_t>(queue.front())];
      queue.pop_front();
      equation.queued = false;
      const int solved = step(equation);
      if (solved < 0) continue;
      for (int user : users[static_cast<std::size_t>(solved)]) {
        Equation& other = equations_[static_cast<std::size_t>(user)];
        if (other.queued || &other == &equation) continue;
        other.queued = true;
        queue.push_back(user);
      }
    }
  }

  /// Solves for the only unknown variable and returns it; checks where none is unknown; -1 where nothing is
  /// learnt.
  int step(const Equation& equation) {
    Dimension known = equation.constant;
    int unknown = -1;
    double exponent = 0.0;
    for (const auto& [variable, power_of] : equation.terms) {
      const auto& value = values_[static_cast<std::size_t>(variable)];
      if (value) {
        known = known * power(*value, power_of);
      } else {
        if (unknown >= 0) return -1;
        unknown = variable;
        exponent = power_of;
      }
    }
    if (unknown < 0) {
      if (known != Dimension{} && !follows_from_another(equation)) complain(equation, known);
      return -1;
    }
    values_[static_cast<std::size_t>(unknown)] = power(known, -1.0 / exponent);
    return unknown;
  }

  /// Once a unit is in question, all that it is held against would be told as well.
  bool follows_from_another(const Equation& equation) {
    bool known = false;
    for (const auto& [variable, exponent] : equation.terms) {
      known = known || in_question_[static_cast<std::size_t>(variable)];
      in_question_[static_cast<std::size_t>(variable)] = true;
    }
    return known;
  }

  void complain(const Equation& equation, const Dimension& wrong) {
    const std::string owner =
        equation.block < 0 ? "" : diagram_.blocks[static_cast<std::size_t>(equation.block)].name + ".";
    const std::string subject = owner + (equation.state < 0 ? equation.port : initial_key_of(equation));
    const auto taken = dimension_at(equation);
    if (!taken) {
      report_.add(equation.origin, subject,
                  fmt::format("{} does not fit: the units differ by {}", equation.what, si_name(wrong)));
      return;
    }
    report_.add(equation.origin, subject,
                fmt::format("{} is in {}, but {} is in {}", equation.what, si_name(*taken / wrong), subject,
                            si_name(*taken)));
  }

  std::string initial_key_of(const Equation& equation) const {
    const BlockType& type = diagram_.blocks[static_cast<std::size_t>(equation.block)].type();
    return initial_key(type, type.states[static_cast<std::size_t>(equation.state)]);
  }

  /// The unit that the port takes, where it is known: the equation's own side.
  std::optional<Dimension> dimension_at(const Equation& equation) {
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

  std::optional<Dimension> evaluate(const UnitExpression& expression, int block) {
    if (expression.any) return std::nullopt;
    Equation equation;
    include(equation, expression, block, 1.0);
    Dimension result = equation.constant;
    for (const auto& [variable, exponent] : equation.terms) {
      const auto& value = values_[static_cast<std::size_t>(variable)];
      if (!value) return std::nullopt;
      result = result * power(*value, exponent);
    }
    return result;
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
  std::vector<std::optional<Dimension>> values_;
  std::vector<bool> in_question_;
  std::vector<Equation> equations_;
};

}  // namespace

void infer_units(Report& report) {
  Inference(report).run();
  check_stop_condition(report);
}

}  // namespace stepwire
