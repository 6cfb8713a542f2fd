#pragma once

#include <string>

#include "engine/app/simulink/head.hpp"

namespace stepwire::simulink {

/// Purpose of a text: the file itself, or a check, in which missing values are 1.
enum class Purpose { file, check };

/// Writes the texts of the units of a translated model.
class UnitTexts {
 public:
  UnitTexts(FlatModel& model, const Head& head, const Collected& collected)
      : model_(model), head_(head), collected_(collected) {}

  bool solves_loops = false;  ///< writes `algebraic_loops: solve`
  bool has_figure = true;

  /// Chooses the parameters that the texts use, and wires parts to their users. Once, before text().
  void join_units();
  std::string text(const Unit& unit, Purpose purpose) const;

 private:
  void outputs_of(Unit& unit);
  void keep_used_variables(Unit& unit);
  void wire_part(Unit& unit);
  /// Puts blocks behind an output of a part, by which it has the value of the model while the part is off.
  static void replace_output(FlatBlock& part, Unit& in, int port, const Rest& rest);
  yaml::Node resolved(const yaml::Node& node) const;
  std::string blocks_text(const Unit& unit) const;
  std::string comments_text(const Unit& unit) const;
  yaml::Node head_node(const Unit& unit, Purpose purpose) const;
  yaml::Node parameters(const Unit& unit, Purpose purpose) const;
  yaml::Node ports(const Unit& unit) const;
  void add_outputs(yaml::Node& root, const Unit& unit) const;
  std::string record_name(const Collected::Recorded& one) const;
  void add_record(yaml::Node& root) const;
  void add_figure(yaml::Node& root) const;

  FlatModel& model_;
  const Head& head_;
  const Collected& collected_;
};

}  // namespace stepwire::simulink
