#include "engine/analyse/claim/likeness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "engine/base/data_file/recorded_run.hpp"
#include "engine/base/io/inside.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/yaml/near_file.hpp"

namespace stepwire::claim {

namespace {

namespace fs = std::filesystem;

std::vector<const table::Table*> pointers_to(const std::vector<table::Table>& tables) {
  std::vector<const table::Table*> pointers;
  for (const table::Table& table : tables) pointers.push_back(&table);
  return pointers;
}

/// Returns the columns of one run.
table::Table rows_of_run(const record::Recording& recording, std::size_t run) {
  const std::size_t begin = recording.starts[run];
  const std::size_t end =
      run + 1 < recording.starts.size() ? recording.starts[run + 1] : recording.table.rows();
  table::Table table;
  for (const table::Column& column : recording.table.columns) {
    const auto at = [&](std::size_t row) { return column.values.begin() + static_cast<std::ptrdiff_t>(row); };
    table.columns.push_back({column.name, column.unit, {at(begin), at(end)}});
  }
  return table;
}

/// Returns the recorded name of a column; nullptr if the diagram does not record it.
const query::RecordedName* recorded(const query::SymbolTable& names, const std::string& column) {
  const auto is_it = [&](const query::RecordedName& one) {
    return one.name == column || one.column == column;
  };
  const auto found = std::ranges::find_if(names.columns, is_it);
  return found == names.columns.end() ? nullptr : &*found;
}

/// Adds faults for signals of the baseline that the diagram does not record, and sets the compared signals.
void take_signals(Likeness& likeness, const yaml::Node& node, const query::NamesReading& read) {
  std::vector<std::string> faults;
  const auto tables = pointers_to(likeness.tables);
  const comparison::TraceIndex index(tables, faults);
  for (const std::string& fault : faults) read.fault(node.mark, fmt::format("{}: {}", node.text, fault));
  for (const std::string& name : index.names()) {
    if (index.runs(name) > 1)
      return read.fault(node.mark, fmt::format("{} has {} runs; a claim compares each run with one",
                                               node.text, index.runs(name)));
    likeness.tolerances.only.push_back(name);
  }
  if (faults.empty() && index.names().empty()) read.fault(node.mark, node.text + " has no signal");
}

/// Reads the file of a baseline, or the folder of a run. Adds a fault and returns false for an unreadable
/// one.
bool take_table(const std::string& path, Likeness& likeness, const yaml::Node& node,
                const query::NamesReading& read) {
  try {
    for (table::RecordTable& table : data_file::read_recorded_run(path)) {
      std::erase_if(table.columns, [&](const table::Column& column) {
        return table.problems.contains(column.name) || table.words.contains(column.name);
      });
      for (const auto& [name, problem] : table.problems) read.fault(node.mark, problem);
      for (const auto& [name, words] : table.words)
        read.fault(node.mark, fmt::format("'{}' of {} has words; a baseline has numbers", name, path));
      likeness.tables.push_back(std::move(table));
    }
    return true;
  } catch (const std::exception& error) {
    read.fault(node.mark, error.what());
    return false;
  }
}

bool is_infinite(const comparison::SignalDifference& signal) {
  return !signal.agrees && signal.excess <= 1.0;  // other lengths
}

}  // namespace

std::shared_ptr<Likeness> read_baseline(const yaml::Node& node, const query::NamesReading& read) {
  auto likeness = std::make_shared<Likeness>();
  likeness->file = read.text(node);
  if (likeness->file.empty()) return nullptr;
  const std::string path =
      (fs::path(read.names.file).parent_path() / likeness->file).lexically_normal().string();
  std::error_code none;
  io::require_inside(path);
  if (!fs::exists(path, none)) {
    read.fault(node.mark,
               fmt::format("there is no file {}{}; a run without this claim writes one: run --csv {}", path,
                           yaml::near_file(path).text(), path));
    return nullptr;
  }
  if (!take_table(path, *likeness, node, read)) return nullptr;
  take_signals(*likeness, node, read);
  return likeness;
}

void read_likeness_within(Likeness& likeness, const yaml::Node& node, const query::NamesReading& read) {
  likeness.within = read.text(node);
  comparison::ToleranceRule rule;
  const bool is_share = likeness.within.ends_with('%');
  const std::string fault = is_share ? comparison::set_relative(rule.tolerance, likeness.within)
                                     : comparison::set_absolute(rule.tolerance, likeness.within);
  if (!fault.empty()) read.fault(node.mark, fault);
  likeness.tolerances.rules.push_back(std::move(rule));
}

void read_likeness_jitter(Likeness& likeness, const yaml::Node& node, const query::NamesReading& read) {
  likeness.jitter = read.text(node);
  comparison::ToleranceRule rule;
  const std::string fault = comparison::set_jitter(rule.tolerance, likeness.jitter);
  if (!fault.empty()) read.fault(node.mark, fault);
  likeness.tolerances.rules.push_back(std::move(rule));
}

void read_likeness_signals(Likeness& likeness, const yaml::Node& node, const query::NamesReading& read) {
  const std::vector<std::string> all = std::move(likeness.tolerances.only);
  likeness.tolerances.only.clear();
  for (const yaml::Node& item : node.as_list()) {
    const std::string name = read.text(item);
    if (std::ranges::find(all, name) == all.end())
      read.fault(item.mark, fmt::format("{} has no '{}'", likeness.file, name) +
                                yaml::nearest_or_all(name, all, "it has").text());
    likeness.tolerances.only.push_back(name);
  }
}

void check_likeness(const Likeness& likeness, const yaml::Node& node, const query::NamesReading& read) {
  std::vector<table::Table> own{{{{"time", "s", {0.0}}}}};
  for (const std::string& name : likeness.tolerances.only) {
    const query::RecordedName* column = recorded(read.names, name);
    if (!column) {
      read.fault(node.find("like")->mark,
                 fmt::format("'{}' of {} is not recorded; add it to 'record', or name the compared signals: "
                             "signals: [...]",
                             name, likeness.file));
      continue;
    }
    const bool has_unit = column->dimension && *column->dimension != unit::Dimension{};
    own[0].columns.push_back({name, has_unit ? unit::si_name(*column->dimension) : "", {0.0}});
  }
  if (own[0].columns.size() != likeness.tolerances.only.size() + 1) return;
  const auto baseline = pointers_to(likeness.tables), recorded = pointers_to(own);
  for (const std::string& fault : comparison::compare(baseline, recorded, likeness.tolerances).faults)
    read.fault(node.find("like")->mark,
               fmt::format("{}, where A is {} and B this diagram", fault, likeness.file));
}

std::string likeness_text(const Likeness& likeness) {
  std::string text = "like " + likeness.file;
  if (!likeness.within.empty()) text += " within " + likeness.within;
  if (!likeness.jitter.empty()) text += " with jitter " + likeness.jitter;
  return text;
}

std::vector<record::Recording> run_of(std::span<const record::Recording> recordings, std::size_t run) {
  std::vector<record::Recording> one;
  for (const record::Recording& recording : recordings)
    if (run < recording.starts.size())
      one.push_back({rows_of_run(recording, run), {0}, recording.categories});
  return one;
}

void add_likeness(const Likeness& likeness, std::span<const record::Recording> runs, std::size_t first,
                  LikenessFound& found) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto baseline = pointers_to(likeness.tables);
  for (std::size_t run = 0; run < runs.front().starts.size(); ++run) {
    std::vector<table::Table> tables;
    for (const record::Recording& recording : runs)
      if (run < recording.starts.size()) tables.push_back(rows_of_run(recording, run));
    const auto recorded = pointers_to(tables);
    const comparison::RecordingDifference difference =
        comparison::compare(baseline, recorded, likeness.tolerances);
    if (!difference.faults.empty()) found.fault = difference.faults.front();
    for (const std::string& name : difference.only_in_a)
      found.fault = fmt::format("'{}' is not recorded", name);
    if (difference.signals.empty()) continue;
    const comparison::SignalDifference& worst = difference.signals.front();
    const double excess = is_infinite(worst) ? infinity : worst.excess;
    if (found.run && excess <= found.excess) continue;
    found.excess = excess;
    found.text = comparison::difference_text(worst);
    found.run = first + run;
  }
}

}  // namespace stepwire::claim
