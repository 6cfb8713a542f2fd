#include "engine/simulate/codegen/headers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <utility>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/resources.hpp"
#include "engine/model/block/typed_by_file.hpp"
#include "engine/model/diagram/external_input.hpp"
#include "engine/simulate/codegen/event_text.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::codegen {

namespace {

namespace fs = std::filesystem;

bool is_public(const std::string& header) {
  return header.starts_with("stepwire/");
}

std::string path_of(const std::string& header) {
  if (is_of_others(header)) return header;
  return io::resource(is_public(header) ? "public" : "headers") + "/" + header;
}

/// True for a header of stepwire. Foreign code may have folders of the same names.
bool is_ours(const std::string& included) {
  const bool may_be =
      included.starts_with("engine/") || included.starts_with("blocks/") || is_public(included);
  return may_be && fs::exists(path_of(included));
}

/// Collects headers and all that they include.
class Gatherer {
 public:
  explicit Gatherer(const std::vector<std::string>& headers) : open_(headers) {
    while (!open_.empty()) {
      const std::string header = open_.back();
      open_.pop_back();
      if (all_.insert(header).second) follow(header);
    }
    require_one_of_each();
  }

  IncludedHeaders take() const { return {{all_.begin(), all_.end()}, {folders_.begin(), folders_.end()}}; }

 private:
  void follow(const std::string& header) {
    static const std::regex include(R"re(#[ \t]*include[ \t]*("([^"\n]+)"|<(stepwire/[^>\n]+)>))re");
    const std::string text = header_text(header);
    for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it)
      if ((*it)[3].matched) {
        open_.push_back((*it)[3]);
      } else if (is_of_others(header)) {
        follow_quoted(header, (*it)[2]);
      } else {
        open_.push_back((*it)[2]);
      }
  }

  /// Follows an include in quotes as the compiler does: first beside the including file, then among the
  /// headers of stepwire. All others are left to the compiler.
  void follow_quoted(const std::string& header, const std::string& included) {
    const fs::path beside = fs::path(header).parent_path();
    if (fs::exists(beside / included)) return add(beside / included);
    if (is_ours(included)) return open_.push_back(included);
    for (fs::path above = beside.parent_path(); above != above.root_path(); above = above.parent_path()) {
      if (!fs::exists(above / included)) continue;
      folders_.insert(above.string());
      found_.emplace_back(included, fs::canonical(above / included));
      return add(above / included);
    }
  }

  /// Throws if two folders have different headers of the same name. A compiler searches the folders in one
  /// order for all headers, and would use the wrong one.
  void require_one_of_each() const {
    for (const auto& [included, header] : found_)
      for (const std::string& folder : folders_) {
        const fs::path other = fs::path(folder) / included;
        if (fs::exists(other) && fs::canonical(other) != header)
          throw io::EnvironmentError("\"" + included + "\" may be " + header.string() + " or " +
                                     fs::canonical(other).string() + "; one of them needs another name");
      }
  }

  void add(const fs::path& header) { open_.push_back(fs::canonical(header).string()); }

  std::vector<std::string> open_;
  std::set<std::string> all_, folders_;
  std::vector<std::pair<std::string, fs::path>>
      found_;  ///< in one of the folders, by the text of the include
};

}  // namespace

bool is_of_others(const std::string& header) {
  return header.starts_with('/');
}

std::string header_text(const std::string& header) {
  const std::string path = path_of(header);
  std::ifstream file(path);
  if (!file) throw io::EnvironmentError(path + ": is not there; code is made with the headers of the blocks");
  return {std::istreambuf_iterator<char>(file), {}};
}

IncludedHeaders with_included(const std::vector<std::string>& headers) {
  return Gatherer(headers).take();
}

std::vector<std::string> include_options(const IncludedHeaders& headers) {
  std::vector<std::string> options;
  for (const std::string& folder : headers.folders) options.insert(options.end(), {"-idirafter", folder});
  return options;
}

namespace {

/// Returns the reason why no code can be generated for a block type; an empty text without one.
std::string why_not_generated(const BlockType& type) {
  if (!type.not_generated.empty()) return type.not_generated;
  if (type.file_output) return "it writes files";
  if (find_typed_by_file(type.name)) return "it is a foreign unit, of which nothing but a binary is known";
  const auto ends_whole_run = [](const DiagnosticSpec& spec) { return spec.ends_run && !spec.is_fault; };
  if (std::ranges::any_of(type.diagnostics, ends_whole_run)) return "it may end a run before its time";
  const bool declared = !type.header.empty() || &type == &diagram::external_input_type();
  return declared ? "" : "no header declares its struct";
}

}  // namespace

void require_headers(const plan::Plan& plan) {
  yaml::Faults faults;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const diagram::DiagramBlock& block = plan.diagram.blocks[b];
    const BlockType& type = block.type();
    if (const std::string why = why_not_generated(type); !why.empty())
      faults.add(plan.diagram.fault(block.origin, block.name,
                                    fmt::format("{} cannot be generated: {}", type.name, why)));
  }
  // Two structs of the same name would be merged by the compiler or the linker.
  std::map<std::string, const BlockType*> structs;
  for (const diagram::DiagramBlock& block : plan.diagram.blocks) {
    const BlockType& type = block.type();
    const auto [known, is_new] = structs.try_emplace(type.struct_name, &type);
    if (!is_new && known->second->header != type.header)
      faults.add(plan.diagram.fault(
          block.origin, block.name,
          fmt::format("{} cannot be generated beside {}: both structs are called {}, in {} "
                      "and {}; give one another name or namespace",
                      type.name, known->second->name, type.struct_name, type.header, known->second->header)));
  }
  faults.throw_if_any();
}

std::vector<std::string> headers_of(const plan::Plan& plan) {
  std::set<std::string> headers;
  for (const diagram::DiagramBlock& block : plan.diagram.blocks) {
    const std::string& header = block.type().header;
    if (!header.empty()) headers.insert(header);
    if (is_of_others(header)) headers.insert("engine/base/math/floating_point.hpp");
  }
  if (const auto method = solve::find_called(plan.diagram.solver, plan.diagram.error_control.has_value()))
    headers.insert(method->headers.begin(), method->headers.end());
  if (!plan.loops.empty()) headers.insert("engine/simulate/solve/loop_solver.hpp");
  if (plan.splits_steps()) headers.insert("engine/simulate/solve/event_locator.hpp");
  if (plan.splits_steps() && watches(plan)) headers.insert("engine/simulate/solve/watched_step.hpp");
  if (plan.jumps) headers.insert("engine/simulate/solve/left_of.hpp");
  if (plan.diagram.stop_when) headers.insert(language_header);
  headers.insert("engine/model/block/block.hpp");
  return {headers.begin(), headers.end()};
}

}  // namespace stepwire::codegen
