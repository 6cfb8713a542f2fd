#pragma once

#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/model/block/member_name.hpp"
#include "engine/model/block/value.hpp"

namespace stepwire {

/// Thrown by configure() for an invalid parameter; the loader adds the location.
class ParameterRefused : public std::runtime_error {
 public:
  ParameterRefused(std::string refused, const std::string& message, int at_line = 0, int at_column = 0)
      : std::runtime_error(message), parameter(std::move(refused)), line(at_line), column(at_column) {}
  std::string parameter;
  int line, column;  ///< of the invalid piece of a tree; 0 for the parameter as a whole
};

/// Answers of a block in configure(). Blocks with equal answers fit into the same plan.
struct Configuration {
  std::map<std::string, Eigen::Index> sizes, min_sizes;
  std::map<std::string, std::string> units;
  std::map<std::pair<std::string, std::string>, bool> feedthrough;
  std::vector<std::pair<std::string, std::string>> required;  ///< inputs, with the reasons
  /// State and input, where the input is the derivative of the state; both empty otherwise.
  std::pair<std::string, std::string> slope_source;
  bool skips_outputs = false, skips_update = false, skips_crossings = false;
  bool skips_instants = false, skips_before_instant = false, steady = false, smooth = false,
       keeps_to_ticks = false;
  bool update_keeps_outputs = false, remembers_nothing = false;
  std::set<std::string> asked_initial;  ///< arguments of initial_given()

  bool operator==(const Configuration&) const = default;
};

/// Interface passed to a block's optional configure(). It is called once the parameters, connections and
/// period are known, before shapes, order and memory are determined. The block checks its parameters against
/// each other and decides what its declaration left open.
class Configure {
 public:
  Configure(std::set<std::string> connected, double period, std::map<std::string, Eigen::Index> counts = {},
            std::string name = "", std::map<std::string, double> constants = {},
            std::set<std::string> initial = {}, bool located = false, bool in_stages = false)
      : connected_(std::move(connected)),
        period_(period),
        counts_(std::move(counts)),
        name_(std::move(name)),
        constants_(std::move(constants)),
        initial_(std::move(initial)),
        located_(located),
        in_stages_(in_stages) {}

  /// Returns the block's name in the diagram, "rig.wheel"; for messages only.
  const std::string& name() const { return name_; }

  /// True where this optional input is connected.
  template <auto input>
  bool connected() const {
    return connected_.contains(std::string(member_name<input>()));
  }
  /// Returns the number of elements of this list of inputs.
  template <auto input>
  Eigen::Index count() const {
    const auto found = counts_.find(std::string(member_name<input>()));
    return found == counts_.end() ? 0 : found->second;
  }
  /// Returns the constant given in place of a wire; std::nullopt for a wire and for several numbers.
  template <auto input>
  std::optional<double> constant() const {
    const auto found = constants_.find(std::string(member_name<input>()));
    return found == constants_.end() ? std::nullopt : std::optional(found->second);
  }
  /// True where the file gives this state an initial value.
  template <auto state>
  bool initial_given() {
    const std::string name(member_name<state>());
    answers_.asked_initial.insert(name);
    return initial_.contains(name);
  }
  /// Returns the time between two updates of this block [s].
  double period() const { return period_; }
  /// True where this instance acts at located events.
  bool acts_at_events() const { return located_; }
  /// Sets `holds` for a block whose outputs() reads a mode that outputs_at_instant() stores: true where this
  /// instance acts at located events and in the solver's stages between them. Elsewhere the mode follows the
  /// inputs, and nothing is remembered.
  void hold_mode(bool& holds) {
    holds = located_ && in_stages_;
    if (holds) return;
    skip_instants();
    remember_nothing();
  }

  /// Sets a size that no port or parameter determines, by its letter in the declared shapes.
  void size(const std::string& symbol, Eigen::Index elements) { answers_.sizes[symbol] = elements; }
  /// Requires at least this many elements of a size that a wire determines.
  void size_at_least(const std::string& symbol, Eigen::Index elements) {
    answers_.min_sizes[symbol] = elements;
  }
  /// Sets a unit variable of the declaration for this instance, such as ("'u", "mm") from a file's header.
  void unit(const std::string& variable, const std::string& unit) { answers_.units[variable] = unit; }
  /// Sets whether this instance's output depends on this input at the same instant.
  template <auto input, auto output>
  void feedthrough(bool depends) {
    answers_.feedthrough[{std::string(member_name<input>()), std::string(member_name<output>())}] = depends;
  }
  /// Requires an input that the declaration calls optional.
  template <auto input>
  void require(const std::string& reason) {
    if (!connected<input>()) answers_.required.emplace_back(member_name<input>(), reason);
  }
  /// Outputs that are states need no call of outputs() in this instance.
  void skip_outputs() { answers_.skips_outputs = true; }
  /// This instance needs no call of update().
  void skip_update() { answers_.skips_update = true; }
  /// The states of this instance never change; it is treated as a block without states.
  void remember_nothing() { answers_.remembers_nothing = true; }
  /// The outputs of this instance are the same before and after update(), even where states change.
  void update_keeps_outputs() { answers_.update_keeps_outputs = true; }
  /// This instance has no crossings.
  void skip_crossings() { answers_.skips_crossings = true; }
  /// The outputs of this instance are the same at an instant as in the solver's stages.
  void skip_instants(bool skips = true) { answers_.skips_instants = skips; }
  /// This instance needs no call of update_before_instant().
  void skip_before_instant(bool skips = true) { answers_.skips_before_instant = skips; }
  /// This instance acts only at ticks, although its type acts at events as well.
  void keep_to_ticks() { answers_.keeps_to_ticks = true; }
  /// The outputs of this instance are constant between its crossings.
  void steady() { answers_.steady = true; }
  /// The outputs of this instance jump only where its inputs do; BlockOptions::smooth is the same for all
  /// instances.
  void smooth() { answers_.smooth = true; }
  /// The derivative of this state equals this input, and derivatives() has no other effect. The plan may let
  /// the source of the input write the derivative directly and drop the call.
  template <auto state, auto input>
  void slope_is_input() {
    answers_.slope_source = {std::string(member_name<state>()), std::string(member_name<input>())};
  }
  /// Refuses a parameter with a message of the form "problem; cure".
  template <auto parameter>
  [[noreturn]] void refuse(const std::string& message) const {
    throw ParameterRefused(std::string(member_name<parameter>()), message);
  }
  template <auto parameter>
  [[noreturn]] void refuse(const std::string& message, const Value& where) const {
    throw ParameterRefused(std::string(member_name<parameter>()), message, where.line, where.column);
  }

  const Configuration& answers() const { return answers_; }

 private:
  std::set<std::string> connected_;
  double period_;
  std::map<std::string, Eigen::Index> counts_;
  std::string name_;
  std::map<std::string, double> constants_;
  std::set<std::string> initial_;  ///< states with an initial value in the file
  bool located_, in_stages_;
  Configuration answers_;
};

}  // namespace stepwire
