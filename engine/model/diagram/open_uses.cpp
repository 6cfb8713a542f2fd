// The section `uses`: repositories whose files are parts.
#include <fmt/format.h>

#include <algorithm>

#include "engine/model/diagram/head_keys.hpp"
#include "engine/model/diagram/open.hpp"

namespace stepwire::diagram {

namespace {

/// True if a block of the file is a part of the repository.
bool is_used(const yaml::Node& root, const std::string& name) {
  const yaml::Node* blocks = root.find("blocks");
  return blocks && std::ranges::any_of(blocks->entries, [&](const yaml::Entry& entry) {
           const yaml::Node* path = entry.value.is_map() ? entry.value.find("diagram") : nullptr;
           return path && path->is_scalar() && path->text.starts_with(name + "/");
         });
}

/// Adds the faults of an entry's values. Returns false if there was one.
bool check_values(const Use& use, const Scope& scope, Report& report) {
  const std::string subject = scope.prefix + "uses." + use.name;
  bool is_right = true;
  const auto refuse = [&](const yaml::Mark& mark, const yaml::Message& message) {
    if (message.empty()) return;
    report.add(scope.at(mark), subject, message);
    is_right = false;
  };
  const std::string fetch = "`stepwire fetch` ";
  refuse(use.mark, name_problem(use.name, scope.document->file));
  refuse(use.mark, git_problem(use.git, scope.document->file));
  if (!is_full_commit(use.rev))
    refuse(use.rev_mark, yaml::Message(fmt::format("'{}' is no commit of 40 digits", use.rev),
                                       fetch + "prints the commit of a tag or branch, which may move"));
  if (!is_sha256(use.sha256))
    refuse(use.sha256_mark, yaml::Message(fmt::format("'{}' is no sha256 of 64 digits", use.sha256),
                                          fetch + "prints the right one"));
  if (!is_used(scope.document->root, use.name))
    refuse(use.mark, yaml::Message("no part of this file begins with '" + use.name + "/'",
                                   "use one, or remove the entry"));
  return is_right;
}

}  // namespace

bool Opener::read_use(const Scope& scope, const Use& use) {
  const yaml::Node& entry = *scope.document->root.find("uses")->find(use.name);
  const std::size_t faults = report_.faults().size();
  HeadReading(scope.prefix + "uses." + use.name, scope, report_).check(entry, use_form());
  if (report_.faults().size() > faults || !check_values(use, scope, report_)) return false;
  const std::string& top =
      fetched_root(scope.document->file).empty() ? scope.document->file : report_.diagram().file;
  const yaml::Message problem = fetched_.problem(use, top);
  if (!problem.empty()) report_.add(scope.at(use.mark), scope.prefix + "uses." + use.name, problem);
  return problem.empty();
}

void Opener::read_uses(const Scope& scope) {
  const yaml::Node* section = scope.document->root.find("uses");
  if (!section || !with_uses_read_.insert(scope.document).second) return;
  if (!section->is_map())
    return report_.add(scope.at(section->mark), scope.prefix + "uses",
                       "must be a map of name: {git: .., rev: .., sha256: ..}");
  for (const Use& use : uses_of(scope.document->root)) {
    const Origin origin = scope.at(use.mark);
    const auto known = uses_.try_emplace(use.name, KnownUse{use, origin, true}).first;
    if (!use.is_version_of(known->second.use)) {
      report_.add(origin, scope.prefix + "uses." + use.name,
                  versions_problem(use, known->second.use, report_.diagram().place(known->second.origin)));
      known->second.usable = false;
    } else if (!read_use(scope, use)) {
      known->second.usable = false;
    }
  }
}

bool Opener::refuse_fetched(Scope& scope, const yaml::Entry& entry, const yaml::Node& path,
                            const std::string& file) {
  const auto use = use_of(scope.document->root, path.text);
  if (use && !uses_[use->name].usable) {
    scope.failed.insert(entry.key);  // its fault is that of the entry of `uses`
    return true;
  }
  const std::string root = use ? fetched_folder(*use) : fetched_root(scope.document->file);
  if (root.empty() || is_in_folder(file, root) || path.text.starts_with("stepwire/")) return false;
  fail(scope, entry, path.mark,
       yaml::fault_text("'{}' is outside of the fetched files; parts of a repository are below its folder",
                        path.text));
  return true;
}

}  // namespace stepwire::diagram
