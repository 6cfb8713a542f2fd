#include "engine/model/diagram/load.hpp"

#include <fmt/format.h>

#include "engine/model/diagram/head.hpp"
#include "engine/model/diagram/open.hpp"
#include "engine/model/diagram/ports.hpp"
#include "engine/model/diagram/resolve.hpp"
#include "engine/model/diagram/units.hpp"
#include "engine/model/diagram/unused.hpp"

namespace stepwire::diagram {

namespace {

void connect(const PendingInput& pending, const Resolver& resolver, Report& report) {
  DiagramBlock& block = report.diagram().blocks[static_cast<std::size_t>(pending.block)];
  const InputSpec& spec = block.type().inputs[static_cast<std::size_t>(pending.input)];
  auto& sources = block.inputs[static_cast<std::size_t>(pending.input)];
  const std::string subject = block.name + "." + spec.name;
  const auto connect_one = [&](const yaml::Node& node) {
    auto source = resolver.source(node, *pending.scope, subject);
    if (!source) return;
    if (source->text) {
      report.bindings().bindings.push_back(*source->text);
      report.bindings().bindings.back().target = {Target::Kind::constant, pending.block, pending.input,
                                                  static_cast<int>(sources.size())};
      source->text.reset();
    }
    sources.push_back(std::move(*source));
  };
  const yaml::Node& node = *pending.node;
  if (spec.list && node.is_list()) {
    if (node.items.empty())
      report.add(pending.scope->at(node.mark), subject, "is an empty list; name at least one signal");
    for (const yaml::Node& item : node.items) connect_one(item);
  } else {
    connect_one(node);
  }
}

void require_inputs(Report& report) {
  for (const DiagramBlock& block : report.diagram().blocks)
    for (std::size_t i = 0; i < block.inputs.size(); ++i) {
      const InputSpec& spec = block.type().inputs[i];
      if (!spec.optional && block.input_marks[i].line == 0)
        report.add(block.origin, block.name,
                   fmt::format("the input '{}' is missing ({})", spec.name, spec.doc));
    }
}

/// Moves the parameters of a file and its parts to the bindings, by the index of their scopes.
void take_parameters(Scope& scope, Bindings& bindings) {
  bindings.scopes[static_cast<std::size_t>(scope.index)] = std::move(scope.parameters);
  for (auto& [name, named] : scope.names)
    if (named.part) take_parameters(*named.part, bindings);
}

enum class Extent { whole_file, one_run };

/// Reads the blocks of a file and its parts, and all that refers to them.
void read_sections(Scope& root, Opener& opener, Settings& settings, Report& report, Extent extent) {
  opener.open(root, {});
  opener.join_guards();
  read_head(root, settings, report);
  if (extent == Extent::whole_file) read_head_of_file(root, report);
  const Resolver resolver(report);
  opener.copy_for_buses(root);
  for (const PendingInput& pending : opener.pending()) connect(pending, resolver, report);
  require_inputs(report);
  read_record(root, resolver, report);
  read_outputs(root, resolver, report);
  read_stop_condition(root, resolver, report);
  demand_units_and_shapes(root, resolver, report);
  settings.report_unused(report);
  if (report.faults().empty()) refuse_unused_parameters(root, report);  // a fault may hide uses
}

/// A diagram under construction from its document.
class Building {
 public:
  explicit Building(const yaml::Document& document) : report_(diagram_) {
    root_.document = &document;
    diagram_.file = document.file;
    diagram_.scopes.push_back({document.file, "", {-1, {}}});
  }
  Building(const Building&) = delete;

  /// Reads the document and collects its faults; throws Error after faults that prevent further reading.
  void read(Loader& loader, const std::vector<Setting>& given, Extent extent) {
    Settings settings(given, report_);
    check_head_keys(root_, report_);
    Opener opener(loader, settings, report_);
    if (root_.document->root.is_map()) read_sections(root_, opener, settings, report_, extent);
  }
  const yaml::Faults& faults() const { return report_.faults(); }

  Diagram take() {
    Report unsaid(diagram_);
    name_ports(root_, Resolver(unsaid), diagram_);
    report_.bindings().scopes.resize(diagram_.scopes.size());
    take_parameters(root_, report_.bindings());
    diagram_.bindings = std::make_shared<const Bindings>(std::move(report_.bindings()));
    return std::move(diagram_);
  }

 private:
  Diagram diagram_;
  Report report_;
  Scope root_;
};

Diagram build(Loader& loader, const yaml::Document& document, const std::vector<Setting>& given,
              Extent extent = Extent::whole_file) {
  Building building(document);
  building.read(loader, given, extent);
  building.faults().throw_if_any();
  return building.take();
}

}  // namespace

const yaml::Document& Loader::document(const std::string& path) {
  auto& slot = documents_[path];
  if (!slot)
    slot = reader_ ? reader_(path, limits_)
                   : std::make_shared<const yaml::Document>(yaml::read_document(path, limits_));
  return *slot;
}

void Loader::add(yaml::Document document) {
  auto& slot = documents_[document.file];
  slot = std::make_shared<const yaml::Document>(std::move(document));
}

std::vector<std::string> Loader::paths() const {
  std::vector<std::string> paths;
  for (const auto& [path, document] : documents_) paths.push_back(path);
  return paths;
}

Diagram Loader::load(const std::string& path, const std::vector<Setting>& settings) {
  return build(*this, document(path), settings);
}

Diagram Loader::load_point(const std::string& path, const std::vector<Setting>& settings) {
  return build(*this, document(path), settings, Extent::one_run);
}

UnfinishedDiagram Loader::draft(const std::string& path) {
  Building building(document(path));
  std::vector<yaml::Fault> faults;
  try {
    building.read(*this, {}, Extent::whole_file);
    faults = building.faults().list();
  } catch (const yaml::Error& error) {
    faults = error.faults();
  }
  UnfinishedDiagram draft{building.take(), yaml::Error(std::move(faults)).faults()};
  Report units(draft.diagram);
  try {
    draft.input_units = infer_input_units(units);
  } catch (const yaml::Error&) {  // more units disagree than a list of faults may have
  }
  if (draft.faults.empty()) draft.faults = yaml::Error(units.faults().list()).faults();
  return draft;
}

Diagram Loader::load_text(std::string_view text, const std::string& file,
                          const std::vector<Setting>& settings) {
  const yaml::Document document = yaml::parse_document(text, file, limits_);
  return build(*this, document, settings);
}

}  // namespace stepwire::diagram
