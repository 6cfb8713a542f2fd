#include <fmt/format.h>

#include <algorithm>

#include "engine/app/language/edits.hpp"
#include "engine/app/language/signal_list.hpp"
#include "engine/app/language/wire_edits.hpp"

namespace stepwire::language {

namespace {

using Unit = std::optional<unit::Dimension>;

Unit unit_text(const yaml::Node& declared) {
  const yaml::Node* unit = declared.is_map() ? declared.find("unit") : nullptr;
  const auto parsed = unit ? unit::parse_unit(unit->text) : std::nullopt;
  return parsed ? std::optional(parsed->dimension) : std::nullopt;
}

struct InputUnit {
  InputName name;
  Unit wanted;  ///< none where any will do, or it is not known
};

/// Gathers all inputs of a file.
class Inputs {
 public:
  Inputs(DiagramFiles& files, const Analysis& analysis, const std::string& file)
      : files_(files), analysis_(analysis), file_(file) {}

  std::vector<InputUnit> all(const yaml::Document& document) {
    if (const yaml::Node* blocks = document.root.find("blocks"))
      for (const yaml::Entry& block : blocks->entries) add_block(block);
    if (const yaml::Node* outputs = document.root.find("outputs"))
      for (const yaml::Entry& output : outputs->entries) add("", output.key, unit_text(output.value));
    return std::move(found_);
  }

 private:
  void add(const std::string& block, const std::string& input, const Unit& wanted) {
    found_.push_back({{block, input}, wanted});
  }

  void add_block(const yaml::Entry& block) {
    if (const std::string path = DiagramFiles::part_file(file_, block); !path.empty()) {
      const auto part = files_.tree(path);
      const yaml::Node* inputs = part ? part->root.find("inputs") : nullptr;
      for (std::size_t i = 0; inputs && i < inputs->entries.size(); ++i)
        add(block.key, inputs->entries[i].key, unit_text(inputs->entries[i].value));
      return;
    }
    const yaml::Node* kind = block.value.is_map() ? block.value.find("block") : nullptr;
    const BlockType* type = kind ? files_.registry().find(kind->text) : nullptr;
    for (std::size_t i = 0; type && i < type->inputs.size(); ++i) add_input(block, type->inputs[i]);
  }

  /// Of a list each signal and one more.
  void add_input(const yaml::Entry& block, const InputSpec& input) {
    const yaml::Node* fed = block.value.find(input.name);
    const Unit wanted = wanted_unit(block, input, fed != nullptr);
    const std::size_t count = !fed ? 0 : fed->is_list() ? fed->items.size() : 1;
    if (!input.list || count == 0) return add(block.key, input.name, wanted);
    if (count == 1) add(block.key, input.name, wanted);
    for (std::size_t i = count == 1 ? 2 : 1; i <= count + 1; ++i)
      add(block.key, input.name + "." + std::to_string(i), wanted);
  }

  /// What feeds an input now says nothing about what may feed it, unless its block declares the unit.
  Unit wanted_unit(const yaml::Entry& block, const InputSpec& input, bool is_fed) const {
    if (!is_fed) return unit_of_input(analysis_, block.key, input.name);
    const auto declared = unit::parse_unit(input.unit);
    return declared ? std::optional(declared->dimension) : std::nullopt;
  }

  DiagramFiles& files_;
  const Analysis& analysis_;
  const std::string& file_;
  std::vector<InputUnit> found_;
};

Unit unit_of(const Analysis& analysis, DiagramFiles& files, const std::string& file,
             const std::string& source) {
  const auto signals = signals_of(analysis, files, file, false);
  const auto known = std::ranges::find(signals, source, &KnownSignal::name);
  return known == signals.end() ? std::nullopt : known->dimension;
}

bool fits(const Unit& unit, const Unit& wanted) {
  return !unit || !wanted || *unit == *wanted;
}

}  // namespace

std::vector<InputName> inputs_for(DiagramFiles& files, const Analysis& analysis, const std::string& file,
                                  const std::string& from) {
  const auto document = files.tree(file);
  if (!document) return {};
  const Unit unit = unit_of(analysis, files, file, source_text(files, file, *document, from));
  std::vector<InputName> found;
  for (const InputUnit& input : Inputs(files, analysis, file).all(*document))
    if (fits(unit, input.wanted)) found.push_back(input.name);
  return found;
}

void check_units(DiagramFiles& files, const Analysis& analysis, const std::string& file,
                 const Connect& edit) {
  const auto document = files.tree(file);
  if (!document) return;
  const Unit unit = unit_of(analysis, files, file, source_text(files, file, *document, edit.from));
  for (const auto& [name, wanted] : Inputs(files, analysis, file).all(*document))
    if (name == InputName{edit.to, edit.input} && !fits(unit, wanted))
      throw EditRefused(fmt::format("'{}' is in {}, and '{}' takes {}", edit.from, unit::si_name(*unit),
                                    edit.to.empty() ? edit.input : edit.to + "." + edit.input,
                                    unit::si_name(*wanted)));
}

}  // namespace stepwire::language
