#include "engine/simulate/replay/replay_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string_view>

#include "engine/base/io/atomic_file_writer.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/yaml_text.hpp"
#include "engine/model/diagram/flatten.hpp"

namespace stepwire::replay {

namespace {

/// Copies of data files, each with a unique name, to be written into one folder.
class DataCopies {
 public:
  /// Returns the name of the file at this path in the folder. It is its own name, with a number if two are
  /// the same, and with '_' for characters that a diagram file could misread. Throws EnvironmentError if it
  /// cannot be read.
  const std::string& name_of(const std::string& path);
  /// Writes all copies; files that they replace have been read before. Throws EnvironmentError.
  void write(const std::string& folder) const;

 private:
  struct Copy {
    std::string name, content;
  };
  std::string free_name(const std::string& path) const;

  std::map<std::string, Copy> copies_;  ///< by absolute path
  std::set<std::string> taken_;
};

/// Returns the name with '_' for all but letters, digits, '.', '-' and '_'.
std::string safe(std::string name) {
  const auto is_safe = [](unsigned char c) { return std::isalnum(c) || c == '.' || c == '-' || c == '_'; };
  std::replace_if(name.begin(), name.end(), std::not_fn(is_safe), '_');
  return name;
}

const std::string& DataCopies::name_of(const std::string& path) {
  const auto [copy, is_new] = copies_.try_emplace(diagram::absolute_path(path));
  if (!is_new) return copy->second.name;
  copy->second = {free_name(path), io::read_file(path)};
  taken_.insert(copy->second.name);
  return copy->second.name;
}

std::string DataCopies::free_name(const std::string& path) const {
  const std::filesystem::path file(path);
  std::string stem = safe(file.stem().string());
  if (stem.starts_with('-') || stem.starts_with('.')) stem.insert(0, "_");  // no option, no hidden file
  const std::string ending = safe(file.extension().string());
  for (std::size_t index = 0;; ++index)
    if (std::string name = io::numbered(stem, index, ending); !taken_.contains(name)) return name;
}

void DataCopies::write(const std::string& folder) const {
  for (const auto& [path, copy] : copies_) io::write_file(folder + "/" + copy.name, copy.content);
}

std::string diagram_name(const run::Job& job, std::size_t member) {
  return job.family->size() == 1 ? flattened_name : fmt::format("diagrams/{:04}.yaml", member + 1);
}

bool is_file(const diagram::Diagram& diagram, const diagram::Target& target) {
  return target.kind == diagram::Target::Kind::parameter &&
         diagram.blocks[static_cast<std::size_t>(target.block)]
                 .type()
                 .parameters[static_cast<std::size_t>(target.index)]
                 .kind == ParameterKind::file;
}

/// Table of the values that each run of a sweep sets in its flattened diagram, as text lines, since there may
/// be millions.
class SweepTable {
 public:
  SweepTable(const run::Job& job, const diagram::FileName& file_name) : job_(job), file_name_(file_name) {
    for (std::size_t point = 0; point < job.points.size(); ++point) add(point);
  }

  void write(const std::string& path) const {
    io::AtomicFileWriter file(path);
    std::string head;
    table::append_csv_head(head, columns_);
    file.append(head);
    if (!columns_.empty()) append_rows(file);
    file.finish();
  }

 private:
  /// Run of a member, and its diagram with the values of the last point.
  struct Member {
    explicit Member(const plan::Plan& plan) : run(plan), diagram(plan.diagram) {}
    run::Executor run;
    diagram::Diagram diagram;
  };

  void add(std::size_t point) {
    const std::size_t index = job_.points[point].member;
    auto& made = members_[index];
    if (!made) made = std::make_unique<Member>(job_.family->plan(index));
    Member& member = *made;
    job_.family->begin(index, job_.settings_of(point), member.run);
    member.run.put_values(member.diagram);
    cells_.assign(columns_.size(), "");
    if (job_.family->size() > 1) set(diagram_column, diagram_name(job_, index));
    for (const diagram::Target& target : job_.family->targets(index))
      if (const auto value = diagram::flattened_value(member.diagram, target, file_name_))
        set(name_of(member.diagram, target), yaml::yaml_line(*value));
    for (const std::string& cell : cells_) {
      if (&cell != &cells_.front()) rows_ += ',';
      table::append_csv_word(rows_, cell);
    }
    rows_ += '\n';
    if (widths_.empty() || widths_.back().second != cells_.size())
      widths_.emplace_back(rows_.size(), cells_.size());
    widths_.back().first = rows_.size();
  }

  void set(const std::string& name, std::string text) {
    const auto [column, is_new] = places_.try_emplace(name, columns_.size());
    if (is_new) {
      columns_.push_back({name, "", {}});
      cells_.emplace_back();
    }
    cells_[column->second] = std::move(text);
  }

  /// Writes the rows; those that were added before a column have an empty cell in it.
  void append_rows(io::AtomicFileWriter& file) const {
    std::size_t first = 0;
    for (const auto& [end, width] : widths_) {
      const std::string_view rows = std::string_view(rows_).substr(first, end - first);
      first = end;
      if (width == columns_.size()) {
        file.append(rows);
        continue;
      }
      std::string wider(rows);
      text::replace_all(wider, "\n", std::string(columns_.size() - width, ',') + "\n");
      file.append(wider);
    }
  }

  const run::Job& job_;
  const diagram::FileName& file_name_;
  std::map<std::size_t, std::unique_ptr<Member>> members_;
  std::vector<table::Column> columns_;  ///< without rows
  std::map<std::string, std::size_t> places_;
  std::vector<std::string> cells_;  ///< of the present row
  std::string rows_;
  std::vector<std::pair<std::size_t, std::size_t>> widths_;  ///< end of the rows of each width, width
};

}  // namespace

void write_replay(const std::string& folder, const plan::Plan& plan) {
  DataCopies copies;
  const std::string text = diagram::flattened_text(
      plan.diagram, [&](const std::string& path) { return "inputs/" + copies.name_of(path); });
  copies.write(folder + "/inputs");
  io::write_file(folder + "/" + flattened_name, text);
}

void write_replay(const std::string& folder, const run::Job& job) {
  if (job.points.empty()) return write_replay(folder, job.plan);
  DataCopies copies;
  const bool one = job.family->size() == 1;
  const std::string up = one ? "inputs/" : "../inputs/";
  const diagram::FileName name = [&](const std::string& path) { return up + copies.name_of(path); };
  for (std::size_t member = 0; member < job.family->size(); ++member)
    io::write_file(folder + "/" + diagram_name(job, member),
                   diagram::flattened_text(job.family->plan(member).diagram, name));
  const diagram::FileName beside = [&](const std::string& path) { return "inputs/" + copies.name_of(path); };
  SweepTable(job, beside).write(folder + "/" + sweep_name);
  copies.write(folder + "/inputs");
}

std::set<std::string> files_read(const plan::Plan& plan) {
  std::set<std::string> files;
  for (const diagram::ScopeInfo& scope : plan.diagram.scopes) files.insert(scope.file);
  diagram::flattened_text(plan.diagram, [&](const std::string& path) { return *files.insert(path).first; });
  return files;
}

std::set<std::string> files_read(const run::Job& job) {
  std::set<std::string> files = files_read(job.plan);
  for (std::size_t point = 0; point < job.points.size(); ++point) {
    const auto& targets = job.family->targets(job.points[point].member);
    if (std::ranges::none_of(
            targets, [&](const diagram::Target& target) { return is_file(job.plan.diagram, target); }))
      continue;
    run::Executor run(job.plan_of(point));
    job.family->begin(job.points[point].member, job.settings_of(point), run);
    diagram::flattened_text(run.diagram(),
                            [&](const std::string& path) { return *files.insert(path).first; });
  }
  for (std::size_t member = 0; job.family && member < job.family->size(); ++member)
    files.merge(files_read(job.family->plan(member)));
  return files;
}

}  // namespace stepwire::replay
