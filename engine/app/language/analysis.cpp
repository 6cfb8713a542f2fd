#include "engine/app/language/analysis.hpp"

#include <algorithm>
#include <iterator>

#include "engine/app/session/loaded_model.hpp"
#include "engine/model/diagram/part_alone.hpp"
#include "engine/model/plan/draft_shapes.hpp"

namespace stepwire::language {

namespace {

/// True for a diagram file. Editors send any YAML file; one without these top-level keys is no diagram.
bool is_diagram(std::string_view text) {
  const auto has = [&](const std::string& key) {
    return text.starts_with(key) || text.find("\n" + key) != std::string_view::npos;
  };
  return has("stepwire:") || has("blocks:");
}

/// Returns the faults of a complete load, which also checks order, sizes, figures and claims. It needs a
/// correct draft.
std::vector<yaml::Fault> faults_of_model(diagram::Loader& loader, const std::string& file) {
  try {
    session::load_model(loader, file, session::LoadOptions{});
  } catch (const yaml::Error& error) {
    return error.faults();
  } catch (const std::exception& error) {  // EnvironmentError, or a fault in a data table
    return {yaml::Fault{{file, {}}, "", error.what(), {}}};
  }
  return {};
}

/// Removes the places of the generated diagram around a part that is analysed on its own.
std::vector<yaml::Fault> without_user(std::vector<yaml::Fault> faults, const std::string& user) {
  std::erase_if(faults, [&](const yaml::Fault& fault) { return fault.place.file == user; });
  for (yaml::Fault& fault : faults) {
    std::erase_if(fault.used_by, [&](const yaml::Place& place) { return place.file == user; });
    if (fault.subject.starts_with("part.")) fault.subject.erase(0, 5);
  }
  return faults;
}

void analyse_part(diagram::Loader& loader, const yaml::Document& document, Analysis& result) {
  yaml::Document user = diagram::user_of_part(document.file, document.root);
  const std::string name = user.file;
  loader.add(std::move(user));
  result.draft = std::make_shared<const diagram::UnfinishedDiagram>(loader.draft(name));
  result.faults = without_user(result.draft->faults, name);
  result.prefix = "part.";
  result.scope = result.draft->diagram.scopes.size() > 1 ? 1 : 0;
}

}  // namespace

Analysis analyse(DiagramFiles& files, const std::string& file, Depth depth) {
  Analysis result;
  if (!is_diagram(*files.texts().text(file))) return result;
  diagram::Loader loader(files.registry(), {}, files.texts().reader());
  try {
    const yaml::Document& document = loader.document(file);
    if (document.root.is_map() && diagram::is_part(document.root)) {
      analyse_part(loader, document, result);
    } else {
      result.draft = std::make_shared<const diagram::UnfinishedDiagram>(loader.draft(file));
      result.faults = result.draft->faults;
      if (depth == Depth::sizes)
        std::ranges::move(plan::draft_shapes(result.draft->diagram).faults,
                          std::back_inserter(result.faults));
      if (result.faults.empty() && depth == Depth::model) result.faults = faults_of_model(loader, file);
    }
  } catch (const yaml::Error& error) {
    result.faults = error.faults();
  } catch (const std::exception& error) {
    result.faults = {yaml::Fault{{file, {}}, "", error.what(), {}}};
  }
  result.uses = loader.paths();
  return result;
}

}  // namespace stepwire::language
