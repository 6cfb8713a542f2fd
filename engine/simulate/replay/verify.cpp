#include "engine/simulate/replay/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

#include "engine/base/text/count.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/replay/recorded.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/simulate/replay/run_replay.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::replay {

namespace {

/// Content of run.json.
struct RunNote {
  std::vector<std::string> swept{};  ///< swept parameters in the order of their columns
  std::size_t runs = 1;
  std::string keep{};                   ///< value of the sweep's `keep`
  std::vector<std::size_t> recorded{};  ///< indices of runs whose rows are kept beside numbers of all runs
  bool interrupted = false;
  std::optional<double> ticks{};  ///< of all runs
  bool uses_libm = true;  ///< as Diagram::uses_libm; versions before the key `functions` had no others
  yaml::Node document{};  ///< the whole file
};

/// Returns the index of a run that a file numbers from 1.
std::size_t run_number(const yaml::Node& node, std::size_t runs, const std::string& file) {
  const auto number = unit::parse_quantity(node.text);
  if (number && number->value >= 1.0 && number->value <= static_cast<double>(runs))
    return static_cast<std::size_t>(number->value) - 1;
  throw yaml::Error(
      yaml::Fault{{file, node.mark}, "recorded_runs", "has a run that is none of those of 'runs'", {}});
}

/// Reads run.json; JSON is a subset of YAML. Throws Error for one that is cut short.
yaml::Node read_json(const std::string& file) try {
  return yaml::read_document(file, wide_limits).root;
} catch (const yaml::Error& error) {
  throw yaml::Error(yaml::Fault{
      error.faults().front().place, "", "the text is cut short or was edited; what is there is no JSON", {}});
}

/// Throws Error if the file lacks an entry that every run writes.
RunNote read_run_note(const std::string& file) {
  RunNote note;
  note.document = read_json(file);
  const yaml::Node *sweep = note.document.find("sweep"), *runs = note.document.find("runs");
  const auto count = runs ? unit::parse_quantity(runs->text) : std::nullopt;
  if (!sweep || !count || !(count->value >= 1.0 && count->value < 1e9))
    throw yaml::Error(yaml::Fault{{file, {}}, "", "does not say 'sweep' and 'runs', as every run does", {}});
  note.runs = static_cast<std::size_t>(count->value);
  for (const yaml::Node& axis : sweep->items)
    if (const yaml::Node* parameter = axis.find("parameter")) note.swept.push_back(parameter->text);
  if (const yaml::Node* keep = note.document.find("keep")) note.keep = keep->text;
  if (const yaml::Node* recorded = note.document.find("recorded_runs"))
    for (const yaml::Node& run : recorded->items) note.recorded.push_back(run_number(run, note.runs, file));
  if (const yaml::Node* interrupted = note.document.find("interrupted"))
    note.interrupted = interrupted->text == "true";
  if (const yaml::Node* ticks = note.document.find("ticks"))
    if (const auto number = unit::parse_quantity(ticks->text)) note.ticks = number->value;
  if (const yaml::Node* functions = note.document.find("functions"))
    note.uses_libm = functions->text == "libm";
  return note;
}

/// Plans a diagram of the folder; `uses_libm` replaces that of the file.
plan::Plan plan_of_file(const std::string& path, const Registry& registry,
                        const std::optional<bool>& uses_libm) {
  diagram::Diagram diagram = diagram::Loader(registry, wide_limits).load(path);
  diagram.uses_libm = uses_libm.value_or(diagram.uses_libm);
  return plan::make_plan(std::move(diagram));
}

/// Runs of a sweep in its folder: the diagrams, and the values that each run sets in one of them.
class SweepRuns {
 public:
  /// Throws Error if the table of the sweep is missing or does not have a row for each run.
  SweepRuns(std::string folder, const RunNote& note, const Registry& registry);
  ~SweepRuns();

  /// Returns the simulation of a run, at time 0. Throws Error if the diagram refuses the values.
  run::Executor& begin(std::size_t run);

 private:
  struct Diagram;

  Diagram& diagram_of(std::size_t run);
  const std::string& text(std::size_t column, std::size_t run) const;

  std::string folder_;
  const Registry& registry_;
  bool uses_libm_;
  table::Table table_;
  table::ColumnWords words_;
  std::map<std::string, std::unique_ptr<Diagram>> diagrams_;  ///< by their names in the folder
};

/// Diagram of the folder, with its run.
struct SweepRuns::Diagram {
  Diagram(const std::string& path, const Registry& registry, bool uses_libm)
      : plan(plan_of_file(path, registry, uses_libm)), run(plan) {}

  plan::Plan plan;
  run::Executor run;
};

SweepRuns::SweepRuns(std::string folder, const RunNote& note, const Registry& registry)
    : folder_(std::move(folder)), registry_(registry), uses_libm_(note.uses_libm) {
  const std::string path = folder_ + "/" + sweep_name;
  for (const table::Column& column : table::read_csv_header(path).columns) words_[column.name];
  table_ = table::read_csv(path, words_);
  if (table_.rows() != note.runs)
    throw yaml::Error(
        yaml::Fault{{path, {}},
                    "",
                    fmt::format("has {}, and run.json says {}", text::counted(table_.rows(), "row"),
                                text::counted(note.runs, "run")),
                    {}});
}

SweepRuns::~SweepRuns() = default;

const std::string& SweepRuns::text(std::size_t column, std::size_t run) const {
  const table::Column& of = table_.columns[column];
  return words_.at(of.name)[static_cast<std::size_t>(of.values[run])];
}

SweepRuns::Diagram& SweepRuns::diagram_of(std::size_t run) {
  const bool several = !table_.columns.empty() && table_.columns.front().name == diagram_column;
  const std::string name = several ? text(0, run) : flattened_name;
  auto& diagram = diagrams_[name];
  if (!diagram) diagram = std::make_unique<Diagram>(folder_ + "/" + name, registry_, uses_libm_);
  return *diagram;
}

run::Executor& SweepRuns::begin(std::size_t run) {
  Diagram& diagram = diagram_of(run);
  const std::string place = folder_ + "/" + sweep_name;
  const yaml::Mark mark{static_cast<int>(run) + 2, 1};
  std::vector<diagram::Assignment> values;
  std::vector<std::string> names;
  for (std::size_t column = 0; column < table_.columns.size(); ++column) {
    const std::string& name = table_.columns[column].name;
    const std::string& value = text(column, run);
    if (name == diagram_column || value.empty()) continue;
    names.push_back(name);
    values.push_back({name, diagram::value_of_text(value, place), place});
    values.back().value.mark = mark;
  }
  if (diagram.run.set(diagram::Variation(diagram.plan.diagram, names), values) !=
      run::Executor::Setting::done)
    throw yaml::Error(yaml::Fault{{place, mark}, "", diagram.run.structure_change(), {}});
  diagram.run.reset();
  return diagram.run;
}

[[noreturn]] void refuse(const std::string& file, std::string message) {
  throw yaml::Error(yaml::Fault{{file, {}}, "", std::move(message), {}});
}

const char* plural(std::size_t count) {
  return count == 1 ? "" : "s";
}

class Verifier {
 public:
  Verifier(std::string folder, const Registry& registry, const std::atomic<bool>* interrupt,
           const NumbersReader& numbers)
      : folder_(std::move(folder)), registry_(registry), numbers_(numbers) {
    options_.interrupt = interrupt;
  }

  Verification run() {
    std::error_code none;
    if (!std::filesystem::is_directory(folder_, none)) refuse(folder_, "there is no such folder");
    recorded_file(folder_, 0);
    try {
      replay();
    } catch (const yaml::Error& error) {
      std::vector<yaml::Fault> faults = error.faults();
      std::ranges::move(missing_blocksets(), std::back_inserter(faults));
      throw yaml::Error(std::move(faults));
    }
    return std::move(result_);
  }

 private:
  void replay() {
    if (is_loop()) {
      verify_loop();
    } else if (const RunNote note = read_note(); note.swept.empty()) {
      verify_run(note);
    } else if (note.keep == "final") {
      verify_last_rows(note);
    } else if (note.keep == "numbers") {
      verify_numbers(note);
    } else {
      verify_sweep(note);
    }
  }

  std::string path(const std::string& name) const { return (std::filesystem::path(folder_) / name).string(); }

  bool has(const std::string& name) const {
    std::error_code none;
    return std::filesystem::exists(path(name), none);
  }

  void require_file(const std::string& name) const {
    if (!has(name))
      refuse(path(name),
             "is missing; verify needs all that 'run --out' or 'loop --out' wrote, of a diagram that records "
             "something");
  }

  plan::Plan plan_of(const std::string& name, const std::optional<bool>& uses_libm = {}) const {
    require_file(name);
    return plan_of_file(path(name), registry_, uses_libm);
  }

  /// Returns the faults for folders of blocks that the run had loaded and this program has not.
  std::vector<yaml::Fault> missing_blocksets() const {
    std::vector<yaml::Fault> missing;
    if (!has("run.json")) return missing;
    const yaml::Node note = read_json(path("run.json"));
    const yaml::Node* folders = note.find("block_folders");
    if (!folders) return missing;
    for (const yaml::Node& folder : folders->items)
      if (std::ranges::find(registry_.blocksets(), folder.text) == registry_.blocksets().end())
        missing.push_back(
            {{path("run.json"), folder.mark},
             "",
             fmt::format("the run had the blocks of this folder; give --blocks {}", folder.text),
             {}});
    return missing;
  }

  /// True for the folder of a loop. The table of a loop has tick and wall clock after the time. A run may
  /// have signals of these names, but then its table has two columns fewer.
  bool is_loop() const {
    const bool may_be_run = has("run.json");
    if (!has("signals.csv")) return false;
    if (!may_be_run) require_file(flattened_name);
    const auto header = table::read_csv_header(path("signals.csv")).columns;
    if (!has(flattened_name) || header.size() < first_signal_of_loop || header[1].name != "tick" ||
        header[2].name != "wall")
      return false;
    const plan::Plan plan = plan_of(flattened_name);
    return !may_be_run || (!plan.diagram.records.empty() &&
                           has_columns({header}, first_signal_of_loop, plan, plan.diagram.records.front()));
  }

  RunNote read_note() const {
    require_file("run.json");
    return read_run_note(path("run.json"));
  }

  /// Reads the table of each recording, whose signals begin after its other columns.
  std::vector<Recorded> read_tables(const plan::Plan& plan, std::size_t first_signal,
                                    const table::ColumnWords& words = {}) {
    std::vector<Recorded> tables;
    for (std::size_t i = 0; i < plan.diagram.records.size(); ++i) {
      table::ColumnWords found = words;
      tables.push_back(read_recorded(recorded_file(folder_, i), first_signal, found));
      require_columns(tables.back(), plan, plan.diagram.records[i]);
      result_.signals += tables.back().signals();
    }
    return tables;
  }

  void verify_loop() {
    const plan::Plan plan = plan_of(flattened_name);
    const std::vector<Recorded> tables = read_tables(plan, first_signal_of_loop);
    result_.loop = true;
    if (!plan.diagram.inputs.empty()) require_file("inputs.csv");
    result_.end_of_loop = end_of_loop();
    replay_loop(plan, tables, path("inputs.csv"), options_, result_);
  }

  /// Returns what is known of rows after the last one.
  std::string end_of_loop() const {
    if (!has("loop.json"))
      return "there is no loop.json: the loop has not come to its end or its disk was full, and rows may be "
             "missing after these";
    const yaml::Node report = read_json(path("loop.json"));
    const yaml::Node* const rows = report.find("rows");
    const yaml::Node* const lost = rows ? rows->find("lost_to_disk") : nullptr;
    return lost && lost->text != "0" ? fmt::format("the disk refused {} rows after these", lost->text) : "";
  }

  void verify_run(const RunNote& note) {
    const plan::Plan plan = plan_of(flattened_name, note.uses_libm);
    const std::vector<Recorded> tables = read_tables(plan, 1);
    std::vector<RecordedRows> rows;
    for (const Recorded& table : tables) rows.push_back({&table, 0, table.table.rows()});
    run::Executor simulation(plan);
    replay_run(simulation, rows, options_, result_);
    require_early_end(note, note.ticks);
  }

  /// Makes the first missing row a difference, unless the runs were interrupted or ended before it.
  void require_early_end(const RunNote& note, const std::optional<double>& ticks) {
    if (!goes_on() || result_.first_missing.empty() || note.interrupted) return;
    if (ticks && *ticks <= static_cast<double>(result_.ticks)) return;
    result_.difference = result_.first_missing + ", and run.json does not say that the run ended before it";
  }

  bool goes_on() const { return result_.difference.empty() && !result_.interrupted; }

  void verify_sweep(const RunNote& note) {
    result_.runs = note.runs;
    SweepRuns runs(folder_, note, registry_);
    std::vector<std::size_t> all(note.runs);
    std::iota(all.begin(), all.end(), std::size_t{0});
    verify_rows(note, all, 0, runs);
    require_early_end(note, note.ticks);
  }

  /// Compares the rows of these runs; `first_file` is the number of their first file.
  void verify_rows(const RunNote& note, const std::vector<std::size_t>& numbers, std::size_t first_file,
                   SweepRuns& runs) {
    std::vector<std::unique_ptr<RecordedRuns>> recordings;
    for (std::size_t i = 0; i < numbers.size() && goes_on(); ++i) {
      run::Executor& simulation = runs.begin(numbers[i]);
      if (i == 0)
        recordings = open_recordings({simulation.plan(), note.swept, numbers.size(), &numbers}, first_file);
      std::vector<RecordedRows> rows;
      for (const auto& recording : recordings) rows.push_back(recording->next());
      const auto used = replay_run(simulation, rows, options_, result_);
      for (std::size_t r = 0; r < used.size(); ++r) recordings[r]->take(used[r]);
    }
    for (const auto& recording : recordings)
      if (goes_on()) result_.difference = recording->left_over();
  }

  std::vector<std::unique_ptr<RecordedRuns>> open_recordings(const RecordedSweep& sweep,
                                                             std::size_t first_file) {
    std::vector<std::unique_ptr<RecordedRuns>> recordings;
    for (std::size_t i = 0; i < sweep.plan.diagram.records.size(); ++i) {
      recordings.push_back(open_recorded_runs(recorded_file(folder_, first_file + i), i, sweep));
      result_.signals += record::recorded_columns(sweep.plan, sweep.plan.diagram.records[i]).size() - 1;
    }
    return recordings;
  }

  /// Verifies a sweep that keeps the last row of each run.
  void verify_last_rows(const RunNote& note) {
    result_.runs = note.runs;
    SweepRuns runs(folder_, note, registry_);
    table::ColumnWords words;
    for (const std::string& parameter : note.swept) words[parameter];
    std::vector<Recorded> tables;
    for (std::size_t run = 0; run < note.runs && goes_on(); ++run) {
      run::Executor& simulation = runs.begin(run);
      if (run == 0) tables = read_tables(simulation.plan(), 1 + note.swept.size(), words);
      for (const Recorded& table : tables)
        if (table.table.rows() != note.runs)
          refuse(table.file, fmt::format("has {} of {}", text::counted(table.table.rows(), "row"),
                                         text::counted(note.runs, "run")));
      replay_last_row(simulation, tables, run, options_, result_);
    }
  }

  /// Verifies a sweep that keeps numbers of each run.
  void verify_numbers(const RunNote& note) {
    if (!numbers_)
      refuse(path("run.json"), "says that numbers of the runs are kept, which are not read here");
    result_.runs = note.runs;
    SweepRuns runs(folder_, note, registry_);
    const KeptTable table = read_kept_table(recorded_file(folder_, 0), note.swept, note.runs);
    result_.signals = table.recorded.signals();
    std::shared_ptr<const run::RunNumbers> numbers;
    for (std::size_t run = 0; run < note.runs && goes_on(); ++run) {
      run::Executor& simulation = runs.begin(run);
      if (!numbers) numbers = numbers_(simulation.plan(), note.document, table.swept, table.words);
      if (numbers->columns.size() != table.recorded.signals())
        refuse(table.recorded.file,
               fmt::format("has {} of each run, and run.json {}",
                           text::counted(table.recorded.signals(), "number"), numbers->columns.size()));
      replay_numbers(simulation, *numbers, table, run, options_, result_);
    }
    verify_rows(note, note.recorded, 1, runs);
    require_early_end(note, {});
  }

  std::string folder_;
  const Registry& registry_;
  const NumbersReader& numbers_;
  run::RunOptions options_;
  Verification result_;
};

}  // namespace

Verification verify(const std::string& folder, const Registry& registry, const std::atomic<bool>* interrupt,
                    const NumbersReader& numbers) {
  return Verifier(folder, registry, interrupt, numbers).run();
}

/// Returns a clause about rows of a loop that are not compared; "" without any.
static std::string without_inputs_text(std::size_t rows) {
  if (rows == 0) return "";
  return fmt::format("; the inputs of {} are missing in inputs.csv, and {} not compared",
                     text::counted(rows, "row"), rows == 1 ? "it is" : "they are");
}

std::string verification_text(const Verification& verification) {
  if (!verification.difference.empty()) return verification.difference;
  const std::size_t rows = verification.rows, missing = verification.missing_rows;
  const bool early = missing > 0 && !verification.loop;
  const char* const agree =
      rows == 0 && verification.without_inputs > 0 ? "nothing is compared" : "all bits agree";
  return fmt::format("{} signal{} in {}{} row{}{}: {}{}{}{}{}", verification.signals,
                     plural(verification.signals), rows, early ? fmt::format(" of {}", rows + missing) : "",
                     plural(rows + (early ? missing : 0)),
                     verification.runs > 1 ? fmt::format(" of {} runs", verification.runs) : "", agree,
                     early ? "; the run ended early" : "",
                     missing > 0 && verification.loop
                         ? fmt::format("; {} row{} lost", missing, missing == 1 ? " is" : "s are")
                         : "",
                     without_inputs_text(verification.without_inputs),
                     verification.end_of_loop.empty() ? "" : "; " + verification.end_of_loop);
}

}  // namespace stepwire::replay
