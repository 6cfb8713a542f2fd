// Each signal in kelvin has a number of zeros: the count of temperature scales (degC) added up in it. A
// temperature has 1, a difference of two has 0. A sum adds the zeros of its inputs, a gain multiplies them. A
// mean of temperatures has 1 again. Any other number at the end of a chain is meaningless: 20 degC plus 30
// degC is 596 K.
//
// A factor with degC in its unit (W/degC) multiplies differences only; a product with one that is in kelvin
// is a difference.
//
// Zeros spread forward from numbers written in degC or delta_degC. Within a block all ports with the same
// declared unit have the same zeros.
#include "engine/model/diagram/temperatures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "engine/base/unit/meaning.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/type_units.hpp"
#include "engine/model/diagram/unit_expression.hpp"

namespace stepwire::diagram {

namespace {

using Zeros = std::optional<double>;

constexpr std::string_view difference_prefix = "delta ";

Zeros zeros_of(const std::optional<unit::Dimension>& dimension) {
  return dimension ? dimension->zeros : std::nullopt;
}

/// A port or value of a block with known zeros.
struct Known {
  Origin origin;
  std::string port, what;
  double zeros = 0.0;
  bool sure = true;  ///< false: only if its signal is in K
};

/// Known ports of one unit of one block.
using Group = std::vector<Known>;

class Temperatures {
 public:
  explicit Temperatures(Report& report) : report_(report), diagram_(report.diagram()) {}

  void run() {
    diagram_.zeros_if_kelvin.resize(diagram_.blocks.size());
    for (std::size_t i = 0; i < diagram_.blocks.size(); ++i)
      diagram_.zeros_if_kelvin[i].assign(diagram_.output_dimensions[i].size(), std::nullopt);
    // A unit that the file gives to an output does not change what the block computes.
    spread_all();
    for (const UnitDemand& demand : diagram_.unit_demands) take(demand);
    spread_all();
    for (std::size_t i = 0; i < diagram_.blocks.size(); ++i) check(i);
    for (const UnitDemand& demand : diagram_.unit_demands) check(demand);
    check_ends();
  }

 private:
  const DiagramBlock& block(std::size_t index) const { return diagram_.blocks[index]; }

  /// Sets the zeros of a unit that the section `units` gives to an output.
  void take(const UnitDemand& demand) {
    if (demand.source.block >= 0 && demand.dimension.zeros)
      set(static_cast<std::size_t>(demand.source.block), static_cast<std::size_t>(demand.source.output),
          demand.dimension.zeros);
  }

  void spread_all() {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < diagram_.blocks.size(); ++i) changed = spread(i) || changed;
    }
  }

  bool set(std::size_t block, std::size_t output, const Zeros& zeros) {
    Zeros* const place = place_of_zeros(block, output);
    if (!zeros || !place || *place) return false;
    *place = zeros;
    return true;
  }

  /// Returns where the zeros of an output are kept; nullptr for an output that is in another unit than K.
  Zeros* place_of_zeros(std::size_t block, std::size_t output) {
    auto& dimension = diagram_.output_dimensions[block][output];
    if (!dimension) return &diagram_.zeros_if_kelvin[block][output];
    return unit::is_temperature(*dimension) ? &dimension->zeros : nullptr;
  }

  Zeros zeros_of_source(const Source& source) const {
    if (source.block < 0) return zeros_of(source.dimension);
    const auto block = static_cast<std::size_t>(source.block),
               output = static_cast<std::size_t>(source.output);
    const auto& dimension = diagram_.output_dimensions[block][output];
    return dimension ? dimension->zeros : diagram_.zeros_if_kelvin[block][output];
  }

  bool has_unit(const Source& source) const {
    return source.block < 0 || diagram_.output_dimensions[static_cast<std::size_t>(source.block)]
                                                         [static_cast<std::size_t>(source.output)];
  }

  std::string name_of(const Source& source) const {
    if (source.block < 0) return "the number";
    const DiagramBlock& owner = block(static_cast<std::size_t>(source.block));
    return output_name(owner.name, owner.type(), static_cast<std::size_t>(source.output));
  }

  /// Returns the known ports whose declared unit is this text.
  Group known(std::size_t index, const std::string& unit) const {
    const DiagramBlock& block = this->block(index);
    Group group;
    for (std::size_t i = 0; i < block.inputs.size(); ++i)
      if (const InputSpec& spec = block.type().inputs[i]; spec.unit == unit)
        for (const Source& source : block.inputs[i])
          if (const Zeros zeros = zeros_of_source(source))
            group.push_back({source.origin, spec.name, name_of(source), *zeros, has_unit(source)});
    for (std::size_t i = 0; i < block.type().parameters.size(); ++i)
      if (const Zeros zeros = zeros_of(block.parameter_dimensions[i]);
          zeros && block.type().parameters[i].unit == unit)
        group.push_back({{block.origin.scope, block.parameter_marks[i]},
                         block.type().parameters[i].name,
                         "the number",
                         *zeros});
    for (const auto& [variable, dimension] : block.known_units)
      if (variable == unit && dimension.zeros)
        group.push_back({block.origin, "y", "what it reads", *dimension.zeros});
    for (const InitialValue& initial : block.initial)
      if (const Zeros zeros = zeros_of(initial.dimension);
          zeros && block.type().states[static_cast<std::size_t>(initial.state)].unit == unit)
        group.push_back({initial.origin, "initial", "the initial value", *zeros});
    return group;
  }

  bool spread(std::size_t index) {
    bool changed = false;
    const auto& outputs = block(index).type().outputs;
    for (std::size_t o = 0; o < outputs.size(); ++o)
      if (const Zeros* const place = place_of_zeros(index, o); place && !*place)
        changed = set(index, o, zeros_of_output(index, outputs[o])) || changed;
    return changed;
  }

  Zeros zeros_of_output(std::size_t index, const OutputSpec& output) const {
    const BlockType& type = block(index).type();
    if (output.unit.starts_with(difference_prefix)) return 0.0;
    if (has_kelvin(index, output) && factor_of_differences(index, members_of(index, output))) return 0.0;
    if (!type.symbol.signs.empty()) return zeros_of_sum(index);
    if (const auto scaled = zeros_of_gain(index, output.unit)) return scaled;
    if (multiplies(type)) return zeros_of_product(index);
    const Group group = known(index, output.unit);
    if (group.empty()) return std::nullopt;
    const bool differ = std::ranges::any_of(
        group, [&](const Known& one) { return !unit::are_zeros(one.zeros, group.front().zeros); });
    return differ ? std::nullopt : Zeros(group.front().zeros);
  }

  Zeros zeros_of_sum(std::size_t index) const {
    const DiagramBlock& block = this->block(index);
    const BlockType& type = block.type();
    const std::string signs = *type.parameter(type.symbol.signs)->get(block.block.get()).text();
    Zeros sum = 0.0;
    for (std::size_t i = 0; i < block.inputs.front().size(); ++i)
      sum = unit::joined_zeros(sum, zeros_of_source(block.inputs.front()[i]),
                               i < signs.size() && signs[i] == '-');
    return sum;
  }

  /// Returns the zeros of an output declared as the product of an input and a parameter, which is a pure
  /// number here.
  Zeros zeros_of_gain(std::size_t index, const std::string& unit) const {
    const DiagramBlock& block = this->block(index);
    for (std::size_t p = 0; p < block.type().parameters.size(); ++p) {
      const ParameterSpec& factor = block.type().parameters[p];
      for (std::size_t i = 0; i < block.inputs.size(); ++i) {
        if (unit != factor.unit + " " + block.type().inputs[i].unit || block.inputs[i].size() != 1) continue;
        const auto& dimension = block.parameter_dimensions[p];
        const Zeros zeros = zeros_of_source(block.inputs[i].front());
        const Zeros number = number_of(factor.get(block.block.get()));
        if (zeros && number && (!dimension || *dimension == unit::Dimension{})) return *zeros * *number;
      }
    }
    return std::nullopt;
  }

  /// Variables of the unit of an output that is a product, by name; "*" for one of any unit.
  using Members = std::set<std::string>;

  Members members_of(std::size_t index, const OutputSpec& output) const {
    if (multiplies(block(index).type())) return {block(index).type().inputs.front().unit.substr(1)};
    const auto unit = parse_unit_expression(output.unit);
    if (!unit || unit->any) return {"*"};
    Members members;
    if (unit->variables.size() > 1)
      for (const auto& [name, exponent] : unit->variables) members.insert(name);
    return members;
  }

  static bool is_member(const std::string& unit, const Members& members) {
    const auto expression = parse_unit_expression(unit);
    if (!expression || expression->any) return members.contains("*");
    return std::ranges::any_of(expression->variables,
                               [&](const auto& term) { return members.contains(term.first); });
  }

  std::optional<unit::Dimension> dimension_of_source(const Source& source) const {
    if (source.block < 0) return source.dimension;
    return diagram_
        .output_dimensions[static_cast<std::size_t>(source.block)][static_cast<std::size_t>(source.output)];
  }

  /// Returns the unit of the first parameter or input with degC in its unit; std::nullopt without one.
  std::optional<unit::Dimension> factor_of_differences(std::size_t index, const Members& members) const {
    const DiagramBlock& block = this->block(index);
    for (std::size_t p = 0; p < block.type().parameters.size(); ++p)
      if (const auto& own = block.parameter_dimensions[p];
          own && own->per_difference && is_member(block.type().parameters[p].unit, members))
        return own;
    for (std::size_t i = 0; !members.contains("*") && i < block.inputs.size(); ++i)
      for (const Source& source : block.inputs[i])
        if (const auto own = dimension_of_source(source);
            own && own->per_difference && is_member(block.type().inputs[i].unit, members))
          return own;
    return std::nullopt;
  }

  bool has_kelvin(std::size_t index, const OutputSpec& output) const {
    const auto o = static_cast<std::size_t>(&output - block(index).type().outputs.data());
    const auto& own = diagram_.output_dimensions[index][o];
    return own && unit::is_temperature(*own);
  }

  /// Refuses temperatures that a factor of differences multiplies.
  void check_products(std::size_t index) {
    const DiagramBlock& block = this->block(index);
    for (const OutputSpec& output : block.type().outputs) {
      const Members members = members_of(index, output);
      const auto factor = factor_of_differences(index, members);
      for (std::size_t i = 0; factor && i < block.inputs.size(); ++i) {
        const InputSpec& spec = block.type().inputs[i];
        if (!members.contains("*") && !is_member(spec.unit, members)) continue;
        for (const Source& source : block.inputs[i])
          if (const std::string refused = unit::refused_product(zeros_of_source(source), *factor);
              !refused.empty())
            report_.add(source.origin, block.name + "." + spec.name,
                        fmt::format("{} {}", name_of(source), refused));
      }
    }
  }

  static bool multiplies(const BlockType& type) {
    return std::ranges::any_of(type.inputs, [](const InputSpec& spec) { return spec.multiply_units; });
  }

  /// Returns the zeros of the product of one temperature and pure numbers. A difference times any factor is a
  /// difference.
  Zeros zeros_of_product(std::size_t index) const {
    Zeros zeros, factor = 1.0;
    for (const Source& source : block(index).inputs.front()) {
      const Zeros own = zeros_of_source(source);
      const Zeros number = own ? 1.0 : pure_number(source);
      if (own && zeros) return std::nullopt;
      if (own) zeros = own;
      factor = factor && number ? Zeros(*factor * *number) : std::nullopt;
    }
    if (zeros && unit::are_zeros(*zeros, 0.0)) return 0.0;
    return zeros && factor ? Zeros(*zeros * *factor) : std::nullopt;
  }

  /// Returns the number of a source that is a constant for all elements; std::nullopt for other sources.
  Zeros pure_number(const Source& source) const {
    if (source.block < 0) return number_of({source.constant});
    const DiagramBlock& owner = block(static_cast<std::size_t>(source.block));
    const BlockType& type = owner.type();
    const bool is_constant = type.inputs.empty() && type.states.empty() && type.parameters.size() == 1 &&
                             type.outputs.front().unit == type.parameters.front().unit;
    return is_constant ? number_of(type.parameters.front().get(owner.block.get())) : std::nullopt;
  }

  static Zeros number_of(const Value& value) {
    if (const auto* number = std::get_if<double>(&value.content)) return *number;
    const auto* list = std::get_if<Eigen::VectorXd>(&value.content);
    const bool alike = list && list->size() > 0 && (list->array() == (*list)[0]).all();
    return alike ? Zeros((*list)[0]) : std::nullopt;
  }

  /// True for sums, gains and products, whose inputs may have any number of zeros.
  bool takes_any_zeros(std::size_t index) const {
    const BlockType& type = block(index).type();
    if (!type.symbol.signs.empty() || multiplies(type)) return true;
    return std::ranges::any_of(type.inputs, joins_pieces) ||
           std::ranges::any_of(type.outputs, [&](const OutputSpec& output) {
             return zeros_of_gain(index, output.unit).has_value();
           });
  }

  void check(std::size_t index) {
    const BlockType& type = block(index).type();
    check_factors(index);
    check_products(index);
    if (takes_any_zeros(index)) return check_initial(index);
    std::map<std::string, bool> units;
    for (const InputSpec& spec : type.inputs) units[spec.unit] = true;
    for (const ParameterSpec& spec : type.parameters) units[spec.unit] = true;
    for (const auto& [unit, used] : units)
      if (unit.find('\'') != std::string::npos) check_group(index, unit);
  }

  /// Checks initial values against the output that begins with them.
  void check_initial(std::size_t index) {
    const DiagramBlock& block = this->block(index);
    const auto& outputs = block.type().outputs;
    for (const InitialValue& initial : block.initial)
      for (std::size_t o = 0; o < outputs.size(); ++o)
        if (const Zeros own = zeros_of(initial.dimension),
            begun = zeros_of(diagram_.output_dimensions[index][o]);
            own && begun &&
            outputs[o].unit == block.type().states[static_cast<std::size_t>(initial.state)].unit)
          complain({initial.origin, "initial", "the initial value", *own}, *begun, index);
  }

  void check_group(std::size_t index, const std::string& unit) {
    Group group = known(index, unit);
    std::erase_if(group, [](const Known& one) { return !one.sure; });
    if (group.empty()) return;
    const auto usual = std::ranges::find_if(group, [](const Known& one) {
      return unit::are_zeros(one.zeros, 0.0) || unit::are_zeros(one.zeros, 1.0);
    });
    const Known& first = usual == group.end() ? group.front() : *usual;
    const double wanted = unit.starts_with(difference_prefix) ? 0.0 : first.zeros;
    for (const Known& one : group) complain(one, wanted, index);
  }

  /// Refuses factors with temperature units: a factor is neither a temperature nor a difference, and one in
  /// degC is likely a difference.
  void check_factors(std::size_t index) {
    const DiagramBlock& block = this->block(index);
    const BlockType& type = block.type();
    for (std::size_t p = 0; p < type.parameters.size(); ++p) {
      const std::string& unit = type.parameters[p].unit;
      const auto has_its_unit = [&](const auto& spec) { return spec.unit == unit; };
      const Zeros zeros = zeros_of(block.parameter_dimensions[p]);
      if (zeros && unit.find('\'') != std::string::npos && std::ranges::none_of(type.inputs, has_its_unit) &&
          std::ranges::none_of(type.outputs, has_its_unit))
        complain(
            {{block.origin.scope, block.parameter_marks[p]}, type.parameters[p].name, "the number", *zeros},
            0.0, index);
    }
  }

  static unit::Dimension kelvin(double zeros) {
    unit::Dimension dimension{{0, 0, 0, 0, 1}};
    dimension.zeros = zeros;
    return dimension;
  }

  void complain(const Known& one, double wanted, std::size_t index) {
    const bool is_number = one.what.starts_with("the ");
    const std::string other = is_number ? unit::other_meaning_of_number(kelvin(one.zeros), kelvin(wanted))
                                        : unit::other_meaning(kelvin(one.zeros), kelvin(wanted));
    if (!other.empty())
      report_.add(one.origin, block(index).name + "." + one.port, fmt::format("{} {}", one.what, other));
  }

  void check(const UnitDemand& demand) {
    const Zeros zeros = zeros_of_source(demand.source);
    if (!zeros || !demand.dimension.zeros) return;
    const std::string other = unit::other_meaning(kelvin(*zeros), demand.dimension);
    if (!other.empty())
      report_.add(demand.origin, demand.port, fmt::format("{} {}", name_of(demand.source), other));
  }

  /// Refuses the end of a chain of sums and gains that is neither a temperature nor a difference.
  void check_ends() {
    std::vector<std::vector<bool>> goes_on(diagram_.blocks.size());
    for (std::size_t i = 0; i < goes_on.size(); ++i) goes_on[i].resize(diagram_.output_dimensions[i].size());
    // A unit that the file gives is checked at its place.
    for (const UnitDemand& demand : diagram_.unit_demands)
      if (demand.source.block >= 0 && demand.dimension.zeros)
        goes_on[static_cast<std::size_t>(demand.source.block)]
               [static_cast<std::size_t>(demand.source.output)] = true;
    for (std::size_t i = 0; i < diagram_.blocks.size(); ++i)
      for (const auto& sources : block(i).inputs)
        for (const Source& source : sources)
          if (source.block >= 0)
            goes_on[static_cast<std::size_t>(source.block)][static_cast<std::size_t>(source.output)] = true;
    for (std::size_t i = 0; i < goes_on.size(); ++i)
      for (std::size_t o = 0; o < goes_on[i].size(); ++o)
        if (const Zeros zeros = zeros_of(diagram_.output_dimensions[i][o]); zeros && !goes_on[i][o])
          complain({block(i).origin, block(i).type().outputs[o].name,
                    output_name(block(i).name, block(i).type(), o), *zeros},
                   *zeros, i);
  }

  Report& report_;
  Diagram& diagram_;
};

bool has_zeros(const DiagramBlock& block) {
  const auto known = [](const auto& dimension) {
    return dimension && (dimension->zeros || dimension->per_difference);
  };
  return std::ranges::any_of(block.parameter_dimensions, known) ||
         std::ranges::any_of(block.known_units,
                             [&](const auto& of) { return known(std::optional(of.second)); }) ||
         std::ranges::any_of(block.initial,
                             [&](const InitialValue& initial) { return known(initial.dimension); }) ||
         std::ranges::any_of(block.inputs, [&](const auto& sources) {
           return std::ranges::any_of(sources, [&](const Source& source) { return known(source.dimension); });
         });
}

}  // namespace

void check_temperatures(Report& report) {
  const Diagram& diagram = report.about();
  const bool demanded = std::ranges::any_of(
      diagram.unit_demands, [](const UnitDemand& demand) { return demand.dimension.zeros.has_value(); });
  if (demanded || std::ranges::any_of(diagram.blocks, has_zeros)) Temperatures(report).run();
}

}  // namespace stepwire::diagram
