#include "engine/app/report/junit_suites.hpp"

#include <fmt/format.h>

#include "engine/base/io/file.hpp"

namespace stepwire::report {

namespace {

junit::TestCase case_of(const claim::Verdict& verdict) {
  junit::TestCase one{verdict.that};
  if (verdict.fails() || verdict.surprises())
    one.result = junit::Result::failed;
  else if (!verdict.holds)
    one.result = junit::Result::skipped;
  if (one.result == junit::Result::passed) return one;
  one.message = fmt::format("{}: {}: {} ({})", verdict.that, verdict.word(), verdict.shown, verdict.check);
  if (!verdict.note.empty()) one.message += "; " + verdict.note;
  if (!verdict.disagrees.empty()) one.message += "; " + verdict.disagrees;
  return one;
}

}  // namespace

junit::TestSuite suite_of(const std::string& name, double seconds, std::span<const claim::Verdict> verdicts,
                          const run::RunResult& result) {
  junit::TestSuite suite{name, seconds};
  for (const claim::Verdict& verdict : verdicts) suite.cases.push_back(case_of(verdict));
  for (const auto& fault : result.faults)
    suite.cases.push_back({"the run reaches its end", junit::Result::error, fault.fault.text()});
  if (result.interrupted)
    suite.cases.push_back({"the run reaches its end", junit::Result::error, "interrupted"});
  if (suite.cases.empty()) suite.cases.push_back({"the run reaches its end"});
  return suite;
}

junit::TestSuite suite_of(const session::LoadedModel& model, const session::Outcome& outcome) {
  return suite_of(model.file, outcome.seconds, outcome.verdicts, outcome.result);
}

junit::TestSuite suite_of_fault(const std::string& file, const std::string& fault) {
  return {file, 0.0, {{"the file is run", junit::Result::error, fault}}};
}

junit::TestSuite suite_of(const comparison::RecordingDifference& difference) {
  junit::TestSuite suite{fmt::format("{} and {}", difference.a, difference.b)};
  for (const comparison::SignalDifference& signal : difference.signals) {
    if (signal.agrees)
      suite.cases.push_back({signal.name});
    else
      suite.cases.push_back({signal.name, junit::Result::failed, comparison::difference_text(signal)});
  }
  for (const std::string& name : difference.only_in_a)
    suite.cases.push_back({name, junit::Result::failed, name + ": only in " + difference.a});
  for (const std::string& name : difference.only_in_b)
    suite.cases.push_back({name, junit::Result::failed, name + ": only in " + difference.b});
  return suite;
}

void write_junit(const std::string& file, const std::vector<junit::TestSuite>& suites) {
  io::write_file(file, junit::junit_text(suites));
}

}  // namespace stepwire::report
