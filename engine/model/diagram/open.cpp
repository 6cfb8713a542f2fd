#include "engine/model/diagram/open.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "engine/base/yaml/message.hpp"
#include "engine/model/block/block_type.hpp"
#include "engine/model/block/typed_by_file.hpp"
#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/guard_keys.hpp"
#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/diagram/keys.hpp"
#include "engine/model/diagram/named_parameters.hpp"
#include "engine/model/diagram/parameters.hpp"
#include "engine/model/diagram/resolve.hpp"
#include "engine/model/diagram/simulink_names.hpp"

namespace stepwire::diagram {

namespace {

const BlockType* read(const BlockType& type, TypeOfFile of, const yaml::Entry& entry, const Scope& scope,
                      Report& report) {
  const ValueReader reader(scope.parameters, report, scope.index);
  const std::string subject = scope.prefix + entry.key;
  const yaml::Node& file = *entry.value.find("file");
  const yaml::Node* interface = entry.value.find("interface");
  const auto path = reader.read_for(*type.parameter("file"), {}, file, subject + ".file");
  const auto word =
      interface ? reader.fill_in(*interface, subject + ".interface") : std::optional<std::string>("");
  if (!path || !word) return nullptr;
  try {
    return &of(*path->value.text(), *word);
  } catch (const std::runtime_error& error) {
    report.add(reader.at(file.mark), subject + ".file", yaml::fault_text("{}", error.what()));
    return nullptr;
  }
}

/// Returns the type of a block whose ports are described by the file under its key `file`; `type` itself for
/// all others. For an unusable file it adds a fault with the line, marks the name as failed, and returns
/// nullptr.
const BlockType* type_by_file(const BlockType& type, const yaml::Entry& entry, Scope& scope, Report& report) {
  const TypeOfFile of = find_typed_by_file(type.name);
  if (!of || !type.parameter("file") || !entry.value.find("file")) return &type;
  const BlockType* found = read(type, of, entry, scope, report);
  if (!found) scope.failed.insert(entry.key);
  return found;
}

yaml::Message no_block_type(const std::string& name, const Registry& registry) {
  const std::string message = fmt::format("there is no block '{}'", name);
  if (const std::string answer = answer_to_simulink(name); !answer.empty()) return message + "; " + answer;
  return message + yaml::did_you_mean(name, registry.names(), "'stepwire blocks' lists them");
}

/// Returns the fault of a word that would be a condition for another block: `trigger: index` of a block whose
/// reset has a `trigger`. Empty for other words.
std::string meant_as_condition(const ParameterSpec& spec, const yaml::Node& node) {
  const std::string& text = node.text;
  if (!is_guard_key(spec.name) || spec.words.empty() || !node.is_scalar() || text.starts_with('$') ||
      std::ranges::find(spec.words, text) != spec.words.end())
    return {};
  return fmt::format(
      "'{0}' is not allowed; the block has a key of this name, with one of: {1}. A condition on which it "
      "runs is {{when: {0}}}",
      text, fmt::join(spec.words, ", "));
}

/// Returns the text with '$' before names of parameters, and '=' before formulas, where only these are
/// possible.
yaml::Node with_named_parameters(const ParameterSpec& spec, const BlockType& type,
                                 const std::vector<std::string>& words, const yaml::Node& text,
                                 const ValueReader& reader, const ParameterScope& parameters) {
  if (!spec.formulas.empty()) return name_parameters(text, spec.formulas, type, words, parameters);
  const bool is_number = spec.kind == ParameterKind::number || spec.kind == ParameterKind::integer ||
                         spec.kind == ParameterKind::per_element || spec.kind == ParameterKind::vector ||
                         spec.kind == ParameterKind::matrix;
  return is_number ? reader.with_formulas(text, true) : text;
}

}  // namespace

void Opener::open(Scope& scope, const Overrides& overrides) {
  const yaml::Node& root = scope.document->root;
  open_files_.push_back(std::filesystem::path(scope.document->file).lexically_normal().string());
  read_uses(scope);
  declare_ports(scope);
  define_parameters(scope, overrides, settings_, report_);
  if (!scope.parent) make_inputs(scope);
  const yaml::Node* blocks = root.find("blocks");
  if (!blocks || !blocks->is_map() || blocks->entries.empty()) {
    report_.add(scope.at(blocks ? blocks->mark : root.mark), scope.prefix.empty() ? "" : "blocks",
                "blocks are missing; a diagram has 'blocks:' with a map of name: {block: ..}");
    report_.faults().throw_if_any();  // without the blocks all names would be unknown
  }
  if (scope.index == 0) report_.diagram().blocks.reserve(blocks->entries.size());
  for (const yaml::Entry& entry : blocks->entries) open_block(scope, entry);
  open_files_.pop_back();
}

void Opener::fail(Scope& scope, const yaml::Entry& entry, const yaml::Mark& mark, yaml::Message message) {
  scope.failed.insert(entry.key);
  report_.add(scope.at(mark), scope.prefix + (entry.key.empty() ? "''" : entry.key), std::move(message));
}

void Opener::open_block(Scope& scope, const yaml::Entry& entry) {
  const yaml::Node& map = entry.value;
  if (!is_dotted_name(entry.key) || entry.key == "time" || entry.key == "all")
    return fail(
        scope, entry, entry.mark,
        "is no name for a block; use letters, digits and '_' ('time' and 'all' have a meaning of their own)");
  const yaml::Node *kind = map.find("block"), *part = map.find("diagram");
  const bool is_hidden = kind && find_guard_type(kind->text);  // beside its blocks in a flattened file
  if (const std::string rival = scope.rival_of(entry.key);
      !rival.empty() && !is_hidden && !hidden(scope, rival))
    return fail(scope, entry, entry.mark,
                fmt::format("and '{}' cannot stand side by side: one would be a signal of the other", rival));
  if (!map.is_map())
    return fail(scope, entry, map.mark, "must be a map such as {block: Gain, gain: 2, u: source}");
  if (scope.inputs.contains(entry.key))
    return fail(scope, entry, entry.mark, "is also the name of an input of this part; choose another");
  if (map.find("fields") && !kind && !part) return make_bus(scope, entry);
  if (part && !kind) return open_part(scope, entry, *part);
  if (!kind || part)
    return fail(scope, entry, map.mark,
                "needs either 'block:' (a type), 'diagram:' (a file) or 'fields:' (of a bus)");
  if (!kind->is_scalar()) return fail(scope, entry, kind->mark, "'block:' names one type, as Gain");
  const BlockType* type = loader_.registry().find(kind->text);
  if (!type && !(type = find_guard_type(kind->text)))
    return fail(scope, entry, kind->mark, no_block_type(kind->text, loader_.registry()));
  if ((type = type_by_file(*type, entry, scope, report_))) make_block(scope, entry, *type);
}

/// True for a hidden block, which in other files an `enable` or `trigger` creates.
bool Opener::hidden(const Scope& scope, const std::string& name) const {
  const auto found = scope.names.find(name);
  return found != scope.names.end() && found->second.block >= 0 &&
         find_guard_type(report_.about().blocks[static_cast<std::size_t>(found->second.block)].type().name);
}

void Opener::make_block(Scope& scope, const yaml::Entry& entry, const BlockType& type) {
  Diagram& diagram = report_.diagram();
  const auto is_own = [&](const char* key) { return type.input(key) >= 0 || type.parameter(key); };
  const Guarding guarding =
      find_guard_type(type.name) ? Guarding{} : open_guard(scope, entry, is_own, "active");
  const int index = static_cast<int>(diagram.blocks.size());
  scope.names[entry.key] = {index, nullptr, entry.mark};
  DiagramBlock& block = diagram.blocks.emplace_back(scope.prefix + entry.key, type);
  block.origin = scope.at(entry.value.mark);
  make_room(block);
  block.guard = guarding.guard >= 0 ? guarding.guard : scope.guard;
  block_words_ = words_given_to(type, entry.value);
  apply_preset(scope, entry.value, block);
  for (const yaml::Entry& key : entry.value.entries) read_key(scope, key, block, index);
  read_settings(scope, block, block.name);
  require_parameters(scope, entry.value, block);
  take_period_of_part(scope, block);
  if (guarding.guard < 0) return;
  DiagramBlock& guard = diagram.blocks[static_cast<std::size_t>(guarding.guard)];
  guard.every = block.every;
  guard.every_origin = block.every_origin;
  show_outputs(scope, entry, guarding, index);
}

void Opener::apply_preset(Scope& scope, const yaml::Node& map, DiagramBlock& block) {
  const yaml::Node* preset = map.find("preset");
  const BlockType& type = block.type();
  if (!preset || type.presets.empty()) return;
  std::vector<std::string> names;
  const ValueReader reader(scope.parameters, report_, scope.index);
  const auto wanted = reader.fill_in(*preset, block.name + ".preset");
  if (!wanted) return;
  for (const PresetSpec& known : type.presets) {
    if (known.name == *wanted) return known.apply(block.block.get());
    names.push_back(known.name);
  }
  report_.add(
      scope.at(preset->mark), block.name + ".preset",
      fmt::format("there is no preset '{}'", *wanted) +
          yaml::did_you_mean(*wanted, names, fmt::format("{} has: {}", type.name, fmt::join(names, ", "))));
}

/// True for a key that connects an input: of a key that may have a value or a signal, as `lower: -1` and
/// `lower: floor`, one that names a signal.
bool Opener::is_fed(const Scope& scope, const yaml::Entry& key, const BlockType& type) const {
  if (!has_value(type, key.key)) return true;
  if (!names_signal(key.value)) return false;
  const yaml::Node* blocks = scope.document->root.find("blocks");
  for (std::string name = key.value.text; !name.empty();
       name.resize(name.find('.') == std::string::npos ? 0 : name.rfind('.')))
    if (scope.inputs.contains(name) || (blocks && blocks->is_map() && blocks->find(name))) return true;
  // An unknown name is more likely a missing signal than a number.
  const std::string& text = key.value.text;
  const bool constant = text == "pi" || text == "e";
  return is_dotted_name(text) && !constant && !scope.parameters.defined(text.substr(0, text.find('.')));
}

void Opener::read_key(Scope& scope, const yaml::Entry& key, DiagramBlock& block, int index) {
  const BlockType& type = block.type();
  if (key.key == "block" || (key.key == "preset" && !type.presets.empty())) return;
  if (key.key == "every") return read_period(scope, key.value, block);
  if (is_condition(key.key, key.value) && !find_guard_type(type.name)) return;
  if (const int input = type.input(key.key); input >= 0 && is_fed(scope, key, type)) {
    block.input_marks[static_cast<std::size_t>(input)] = key.value.mark;
    pending_.push_back({index, input, &key.value, &scope});
    return;
  }
  if (const ParameterSpec* parameter = type.parameter(key.key))
    return read_parameter(scope, scope.index, key.value, block,
                          static_cast<std::size_t>(parameter - type.parameters.data()));
  if (const int state = state_of_key(type, key.key); state >= 0)
    return read_initial(scope, key.value, block, state);
  if (key.key == "guard") return within_.push_back({index, &key.value, &scope});
  if (is_guard_key(key.key)) return;
  const auto known = keys_of(type);
  const std::string all = fmt::format("It has: {}", fmt::join(known, ", "));
  report_.add(
      scope.at(key.mark), block.name,
      fmt::format("{} has no '{}'", type.name, key.key) +
          (is_name(key.key) ? yaml::did_you_mean(key.key, known, all)
                            : yaml::Message("; a comma ends a value: a number has a point, and what has a "
                                            "comma in it stands in quotes")));
}

void Opener::read_settings(Scope& scope, DiagramBlock& block, const std::string& full) {
  const BlockType& type = block.type();
  for (const ParameterSpec& parameter : type.parameters)  // for a misspelt name of the block
    if (settings_.set_some(parameter.name)) settings_.offer(full + "." + parameter.name);
  for (const std::string& key : settings_.keys_of(full + ".")) {
    for (const ParameterSpec& parameter : type.parameters) settings_.offer(full + "." + parameter.name);
    const ParameterSpec* parameter = type.parameter(key);
    const int state = state_of_key(type, key);
    if (!parameter && state < 0) continue;
    Settings::Entry* setting = settings_.take(full + "." + key);
    const yaml::Node& node = setting->document.root;
    Scope at_setting;
    at_setting.index = setting->origin.scope;
    if (parameter)
      set_parameter(scope, at_setting.index, node, block,
                    static_cast<std::size_t>(parameter - type.parameters.data()));
    else
      set_initial(at_setting, node, block, state);
  }
}

void Opener::set_parameter(const Scope& scope, int reader_scope, const yaml::Node& text, DiagramBlock& block,
                           std::size_t parameter) {
  auto& dimension = block.parameter_dimensions[parameter];
  const auto in_file = dimension;
  const EachUnit* const each = block.elements_of(parameter);
  const EachUnit each_in_file = each ? *each : EachUnit{};
  read_parameter(scope, reader_scope, text, block, parameter);
  if (dimension || block.elements_of(parameter)) return;
  dimension = in_file;
  if (!each_in_file.empty()) block.parameter_elements.emplace_back(parameter, each_in_file);
}

void Opener::set_initial(const Scope& scope, const yaml::Node& text, DiagramBlock& block, int state) {
  const auto of_state = [&](const InitialValue& value) { return value.state == state; };
  const auto before = std::ranges::find_if(block.initial, of_state);
  const auto in_file = before == block.initial.end() ? InitialValue{} : *before;
  read_initial(scope, text, block, state);
  const auto after = std::ranges::find_if(block.initial, of_state);
  if (after == block.initial.end() || after->dimension || !after->each.empty()) return;
  after->dimension = in_file.dimension;
  if (after->value.size() == in_file.value.size()) after->each = in_file.each;
}

void Opener::read_parameter(const Scope& scope, int reader_scope, const yaml::Node& text, DiagramBlock& block,
                            std::size_t parameter) {
  const ParameterSpec& spec = block.type().parameters[parameter];
  if (const std::string fault = meant_as_condition(spec, text); !fault.empty())
    return report_.add({reader_scope, text.mark}, block.name + "." + spec.name, fault);
  ParameterUses uses;
  const ValueReader reader(scope.parameters, report_, reader_scope, &uses);
  const yaml::Node node =
      with_named_parameters(spec, block.type(), block_words_, text, reader, scope.parameters);
  const auto written = reader.read_for(spec, demanded_dimension(spec), node, block.name + "." + spec.name);
  block.parameter_marks[parameter] = node.mark;
  if (!written) return;
  std::erase_if(block.matrices, [&](const auto& matrix) { return matrix.first == parameter; });
  if (written->columns > 1) block.matrices.emplace_back(parameter, written->columns);
  if (written->columns > 1 && !block.type().inputs.empty())
    report_.add({reader_scope, node.mark}, block.name + "." + spec.name,
                "is a matrix, and stands for numbers of single elements; for a product with a matrix see "
                "MatrixGain");
  block.parameter_dimensions[parameter] = written->dimension;
  std::erase_if(block.parameter_elements, [&](const auto& of) { return of.first == parameter; });
  if (!written->each.empty()) block.parameter_elements.emplace_back(parameter, written->each);
  spec.set(block.block.get(), written->value);
  bind({Target::Kind::parameter, index_of(block), static_cast<int>(parameter)},
       {node, scope.index, reader_scope}, std::move(uses));
}

int Opener::index_of(const DiagramBlock& block) {
  return static_cast<int>(&block - report_.diagram().blocks.data());
}

void Opener::bind(const Target& target, ValueText text, ParameterUses uses) {
  auto& bindings = report_.bindings().bindings;
  for (std::size_t b = bindings.size(); b-- > 0 && bindings[b].target.block == target.block;)
    if (bindings[b].target == target)
      bindings.erase(bindings.begin() + static_cast<std::ptrdiff_t>(b));  // a setting overrides the file
  if (!uses.empty()) bindings.push_back({target, std::move(text), std::move(uses)});
}

void Opener::read_initial(const Scope& scope, const yaml::Node& node, DiagramBlock& block, int state) {
  const StateSpec& declared = block.type().states[static_cast<std::size_t>(state)];
  ParameterUses uses;
  const ValueReader reader(scope.parameters, report_, scope.index, &uses);
  const auto written = reader.read_for(numbers_of_any_unit(), {}, node,
                                       block.name + "." + initial_key(block.type(), declared));
  if (!written) return;
  std::erase_if(block.initial, [&](const InitialValue& value) { return value.state == state; });
  block.initial.push_back({state, std::get<Eigen::VectorXd>(written->value.content), written->dimension,
                           scope.at(node.mark), written->columns, written->each});
  bind({Target::Kind::initial, index_of(block), state}, {node, scope.index, scope.index}, std::move(uses));
}

void Opener::require_parameters(const Scope& scope, const yaml::Node& map, const DiagramBlock& block) {
  for (std::size_t i = 0; i < block.type().parameters.size(); ++i) {
    const ParameterSpec& spec = block.type().parameters[i];
    if (spec.required && block.parameter_marks[i].line == 0 && !map.find(spec.name))
      report_.add(scope.at(map.mark), block.name, fmt::format("'{}' is missing ({})", spec.name, spec.doc));
  }
}

}  // namespace stepwire::diagram
