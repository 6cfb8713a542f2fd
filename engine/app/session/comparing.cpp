#include "engine/app/session/comparing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/data_file/recorded_run.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::session {

namespace {

[[noreturn]] void refuse_call(const std::string& what, const std::string& message) {
  throw yaml::Error(yaml::Fault{{what, {}}, "", message, {}});
}

using SetText = std::string (*)(comparison::Tolerance& tolerance, const std::string& text);

/// Appends the rule of a word such as "force=0.1 N" or "1 %".
void add_rule(const std::string& option, const std::string& word, SetText set,
              comparison::Tolerances& tolerances) {
  const std::size_t sign = word.find('=');
  comparison::ToleranceRule rule;
  if (sign != word.npos) rule.signals = word.substr(0, sign);
  std::string text = word.substr(sign == word.npos ? 0 : sign + 1);
  text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
  const std::string fault = set(rule.tolerance, text);
  if (!fault.empty()) refuse_call(option, fault);
  tolerances.rules.push_back(std::move(rule));
}

std::string set_holding(comparison::Tolerance& tolerance, const std::string&) {
  tolerance.hold = true;
  return "";
}

comparison::Tolerances tolerances_of(const CompareCall& call, comparison::Tolerances tolerances) {
  for (const std::string& word : call.absolute)
    add_rule("--absolute", word, comparison::set_absolute, tolerances);
  for (const std::string& word : call.relative)
    add_rule("--relative", word, comparison::set_relative, tolerances);
  for (const std::string& word : call.jitter) add_rule("--jitter", word, comparison::set_jitter, tolerances);
  for (const std::string& name : call.hold) add_rule("--hold", name + "=", set_holding, tolerances);
  if (!call.only.empty()) tolerances.only = call.only;
  return tolerances;
}

/// Adds the columns that are no numbers, unless the comparison leaves them out.
void check_problems(const std::vector<table::RecordTable>& tables, const std::string& file,
                    const comparison::Tolerances& tolerances, yaml::Faults& faults) {
  for (const table::RecordTable& table : tables)
    for (const auto& [name, problem] : table.problems)
      if (tolerances.includes(name))
        faults.add({{file, {}}, "", problem + "; --only names the signals that are compared", {}});
}

/// Adds the columns whose numbers are codes of other words in the two recordings.
void check_words(const ComparedRuns& runs, yaml::Faults& faults) {
  for (const table::RecordTable& a : runs.a)
    for (const auto& [name, words] : a.words)
      for (const table::RecordTable& b : runs.b) {
        const auto other = b.words.find(name);
        if (other != b.words.end() && other->second != words && runs.tolerances.includes(name))
          faults.add(
              {{runs.difference.a, {}},
               name,
               "its numbers stand for other words than in B; --only names the signals that are compared",
               {}});
      }
}

/// Removes columns without rows, which are no signals: texts of HDF5 files.
void drop_unreadable(std::vector<table::RecordTable>& tables) {
  for (table::RecordTable& table : tables)
    std::erase_if(table.columns,
                  [&](const table::Column& column) { return table.problems.contains(column.name); });
}

}  // namespace

std::vector<const table::Table*> tables_of(const std::vector<table::RecordTable>& tables) {
  std::vector<const table::Table*> pointers;
  for (const table::RecordTable& table : tables) pointers.push_back(&table);
  return pointers;
}

/// Adds the columns that cannot be compared, and removes those that are left out.
static void check_columns(ComparedRuns& runs, yaml::Faults& faults) {
  check_problems(runs.a, runs.difference.a, runs.tolerances, faults);
  check_problems(runs.b, runs.difference.b, runs.tolerances, faults);
  check_words(runs, faults);
  drop_unreadable(runs.a);
  drop_unreadable(runs.b);
}

/// Refuses a call with no second run, or with two.
static void require_baseline(const CompareCall& call, const comparison::Acceptance& acceptance) {
  if (call.b.empty() && acceptance.baseline.empty())
    refuse_call(call.a, "is compared with nothing; give a second run, or --within FILE with a 'baseline'");
  if (!call.b.empty() && !acceptance.baseline.empty())
    refuse_call(call.within, fmt::format("names the baseline {}, and the call a second run; give one of them",
                                         acceptance.baseline));
}

ComparedRuns compare_runs(const CompareCall& call) {
  comparison::Acceptance acceptance;
  if (!call.within.empty()) acceptance = comparison::read_acceptance(call.within);
  require_baseline(call, acceptance);
  const std::string a = call.b.empty() ? acceptance.baseline : call.a, b = call.b.empty() ? call.a : call.b;
  ComparedRuns runs{data_file::read_recorded_run(a),
                    data_file::read_recorded_run(b),
                    tolerances_of(call, std::move(acceptance.tolerances)),
                    {a, b}};
  yaml::Faults faults;
  check_columns(runs, faults);
  runs.difference = comparison::compare(tables_of(runs.a), tables_of(runs.b), runs.tolerances);
  runs.difference.a = a;
  runs.difference.b = b;
  for (const std::string& fault : runs.difference.faults)
    faults.add({{fmt::format("{} and {}", a, b), {}}, "", fault, {}});
  faults.throw_if_any();
  return runs;
}

}  // namespace stepwire::session
