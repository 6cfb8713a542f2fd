#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/app/language/edits.hpp"
#include "engine/app/language/known_faults.hpp"
#include "engine/app/language/signal_list.hpp"
#include "engine/app/language/wire_edits.hpp"
#include "engine/model/plan/draft_shapes.hpp"

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
  Unit wanted;              ///< std::nullopt: any unit, or unknown
  const yaml::Node* fed{};  ///< present source signal; nullptr if unconnected
};

/// Collector of all inputs of a file.
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
  void add(const std::string& block, const std::string& input, const Unit& wanted,
           const yaml::Node* fed = nullptr) {
    found_.push_back({{block, input}, wanted, fed});
  }

  void add_block(const yaml::Entry& block) {
    if (const std::string path = files_.part_file(file_, block); !path.empty()) {
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

  /// Adds an input; for a list each item, and the next free one.
  void add_input(const yaml::Entry& block, const InputSpec& input) {
    const yaml::Node* fed = block.value.find(input.name);
    const Unit wanted = wanted_unit(block, input, fed != nullptr);
    const std::size_t count = !fed ? 0 : fed->is_list() ? fed->items.size() : 1;
    if (!input.list || count == 0) return add(block.key, input.name, wanted, fed);
    const auto item = [&](std::size_t i) {
      return i >= count ? nullptr : fed->is_list() ? &fed->items[i] : fed;
    };
    if (count == 1) add(block.key, input.name, wanted, item(0));
    for (std::size_t i = count == 1 ? 2 : 1; i <= count + 1; ++i)
      add(block.key, input.name + "." + std::to_string(i), wanted, item(i - 1));
  }

  /// Returns the unit that an input requires. The unit inferred from the present source does not restrict a
  /// new one, so for a connected input only the declared unit counts.
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

/// Units of the signals of a file.
class Signals {
 public:
  Signals(const Analysis& analysis, DiagramFiles& files, const std::string& file) {
    for (const KnownSignal& signal : signals_of(analysis, files, file, false))
      units_.emplace(signal.name, signal.dimension);
  }
  Unit unit(const std::string& name) const {
    const auto known = units_.find(name);
    return known == units_.end() ? std::nullopt : known->second;
  }

 private:
  std::map<std::string, Unit> units_;
};

bool fits(const Unit& unit, const Unit& wanted) {
  return !unit || !wanted || *unit == *wanted;
}

/// True where every signal is a single number, so that no wire has a wrong size.
bool has_single_numbers(const Analysis& analysis) {
  if (!analysis.draft) return false;
  const diagram::OutputShapes shapes = plan::draft_shapes(analysis.draft->diagram).outputs;
  return !shapes.empty() && std::ranges::all_of(shapes, [](const auto& of_block) {
    return std::ranges::all_of(of_block, [](const diagram::OutputShape& shape) { return shape.size == 1; });
  });
}

/// Trial edits of wires. A wire is allowed if the file with it has no additional faults. Local units are not
/// enough: those of gains, of later signals and of feedback loops, and unused parameters, follow from the
/// whole diagram.
class Trials {
 public:
  Trials(DiagramFiles& files, const std::string& file, const yaml::Document& document)
      : files_(files),
        file_(file),
        document_(document),
        known_(files, file),
        text_(files.texts().text(file)) {}

  bool is_right(const Connect& wire) const try {
    TreeEdits edits(*text_, document_);
    connect(edits, files_, file_, document_, wire);
    if (text_->find('&') != std::string::npos) edits.checked();  // an anchor may copy the change
    return known_.added_by(edits.tree()).empty();
  } catch (const EditRefused&) {
    return false;
  }

 private:
  DiagramFiles& files_;
  const std::string& file_;
  const yaml::Document& document_;
  const KnownFaults known_;
  const std::shared_ptr<const std::string> text_;
};

}  // namespace

std::vector<InputName> inputs_for(DiagramFiles& files, const Analysis& analysis, const std::string& file,
                                  const std::string& from) {
  const auto document = files.tree(file);
  if (!document) return {};
  const Signals signals(analysis, files, file);
  const Unit unit = signals.unit(source_text(files, file, *document, from));
  const Trials trials(files, file, *document);
  const bool sizes_fit = has_single_numbers(analysis);
  std::vector<InputName> found;
  for (const auto& [name, wanted, fed] : Inputs(files, analysis, file).all(*document)) {
    // With the unit of the present source, no later unit changes.
    const bool is_same = sizes_fit && unit && fed && signals.unit(fed->text) == unit;
    if (fits(unit, wanted) && (is_same || trials.is_right({from, name.block, name.input})))
      found.push_back(name);
  }
  return found;
}

void check_units(DiagramFiles& files, const Analysis& analysis, const std::string& file,
                 const Connect& edit) {
  const auto document = files.tree(file);
  if (!document) return;
  const Unit unit = Signals(analysis, files, file).unit(source_text(files, file, *document, edit.from));
  for (const auto& [name, wanted, fed] : Inputs(files, analysis, file).all(*document))
    if (name == InputName{edit.to, edit.input} && !fits(unit, wanted))
      throw EditRefused(fmt::format("'{}' is in {}, and '{}' takes {}", edit.from, unit::si_name(*unit),
                                    edit.to.empty() ? edit.input : edit.to + "." + edit.input,
                                    unit::si_name(*wanted)));
}

}  // namespace stepwire::language
