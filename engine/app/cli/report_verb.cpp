#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/model_call.hpp"
#include "engine/app/cli/monitoring.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/report/model_report.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/text/count.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cli {
namespace {

struct ReportCall {
  std::string path;
  LoadWords words;
  std::string out = "report.html";
  std::string pdf;  ///< File for the page as PDF; empty: none.
};

/// Returns the exit code of a report: wrong for a file that did not run, fails for a claim.
ExitCode code_of_report(const gallery::Report& report) {
  if (!report.entry.error.empty()) return ExitCode::wrong;
  for (const claim::Verdict& verdict : report.entry.verdicts)
    if (verdict.fails() || verdict.surprises()) return ExitCode::fails;
  return ExitCode::done;
}

bool is_pdf(const std::string& file) {
  return std::filesystem::path(file).extension() == ".pdf";
}

/// Throws yaml::Error for names with an ending other than .html, .htm or .pdf.
void require_names(const ReportCall& call) {
  const std::string ending = std::filesystem::path(call.out).extension().string();
  if (ending != ".html" && ending != ".htm" && ending != ".pdf")
    throw yaml::Error(yaml::Fault{{call.out, {}}, "", "a page is a .html or .pdf file", {}});
  if (!call.pdf.empty() && !is_pdf(call.pdf))
    throw yaml::Error(yaml::Fault{{call.pdf, {}}, "", "--pdf takes a .pdf file", {}});
}

ExitCode write_report(const ReportCall& call, const Registry& registry) {
  require_names(call);
  const EndDelay delay(EndDelay::Signals::first);
  const std::vector<std::string> files = report::diagram_files(call.path);
  const session::LoadOptions options = load_options(call.words);
  std::vector<gallery::Report> reports;
  ExitCode code = ExitCode::done;
  for (const std::string& file : files) {
    reports.push_back(report::model_report(registry, file, options, terminal_monitor(nullptr)));
    code = worst(code, code_of_report(reports.back()));
    if (!reports.back().entry.error.empty()) complain("{}\n", reports.back().entry.error);
    if (interrupted()) return ExitCode::interrupted;
  }
  const std::string title = reports.size() == 1 ? reports.front().entry.title : call.path;
  const std::string page = gallery::report_page(title, reports);
  if (is_pdf(call.out))
    report::print_page(page, call.out);
  else
    io::write_file(call.out, page);
  say("{}: {} of {}\n", call.out, reports.size(), text::counted(files.size(), "diagram"));
  if (call.pdf.empty()) return code;
  report::print_page(page, call.pdf);
  say("{}\n", call.pdf);
  return code;
}

Action declare_report(CLI::App& verb) {
  const auto call = std::make_shared<ReportCall>();
  verb.add_option("FILE|DIR", call->path, "a diagram file, or a folder of them")->required();
  verb.add_option("-o", call->out, "page to write, HTML or PDF by its ending")
      ->capture_default_str()
      ->type_name("FILE");
  verb.add_option("--pdf", call->pdf, "file for the same as PDF, printed by Chromium")->type_name("FILE");
  add_load_options(verb, call->words);
  return [call](const Registry& registry) { return guarded([&] { return write_report(*call, registry); }); };
}

}  // namespace

Verb report_verb() {
  return {"report", "write a page about a diagram: drawing, parameters, figures, claims, coverage",
          "Example:\n  stepwire report lag.yaml -o lag.html --pdf lag.pdf\n"
          "The exit code is that of the runs: 1 where a claim fails, 2 where a file does not run.",
          declare_report};
}

}  // namespace stepwire::cli
