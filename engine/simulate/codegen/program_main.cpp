#include "engine/simulate/codegen/program_main.hpp"

#include <fmt/format.h>

#include "engine/base/table/table_file.hpp"
#include "engine/simulate/codegen/cpp_words.hpp"
#include "engine/simulate/codegen/groups.hpp"
#include "engine/simulate/record/recorder.hpp"

namespace stepwire::codegen {

namespace {

const char* const tools = R"cpp(
  /// Shortest digits that read back to the same bits.
  void write_number(std::FILE* file, double value, char before) {
    char digits[32];
    const auto end = std::isnan(value) ? digits : std::to_chars(digits, digits + sizeof digits, value).ptr;
    std::fputc(before, file);
    if (end == digits) std::fputs("nan", file);
    std::fwrite(digits, 1, static_cast<std::size_t>(end - digits), file);
  }
)cpp";

const char* const open_function =
    "\nstd::FILE* open(const std::string& folder, const char* name, const char* titles) {\n"
    "  std::FILE* file = std::fopen((folder + \"/\" + name).c_str(), \"w\");\n"
    "  if (!file) {\n    std::perror((folder + \"/\" + name).c_str());\n    std::exit(3);\n  }\n"
    "  std::fputs(titles, file);\n  return file;\n}\n\n";

/// Of what opens the files, the rows of a tick, the last tick, what closes the files, a check of loops.
constexpr char main_form[] =
    "}}  // namespace\n\n"
    "/// Runs the diagram to its stop; what it records goes into the folder that is named, "
    "or this one.\n"
    "int main(int argc, char** argv) {{\n"
    "  if (argc > 2 || (argc > 1 && argv[1][0] == '-')) {{\n"
    "    std::fputs(\"usage: PROGRAM [FOLDER]; the recorded signals are written into FOLDER, "
    "by default the current one\\n\", "
    "stderr);\n"
    "    return 2;\n  }}\n"
    "  [[maybe_unused]] const std::string folder = argc > 1 ? argv[1] : \".\";\n{0}"
    "  static Diagram d;\n  const char* fault = nullptr;\n"
    "  while (true) {{\n    d.evaluate();\n"
    "    if (!d.finite()) fault = \"a signal is no longer a finite number\";\n{4}    if (fault) "
    "break;\n    const bool last = d.tick >= {2} || d.stops();\n{1}"
    "    if (last) break;\n    d.advance();\n"
    "    fault = d.fault();\n    if (fault) break;\n  }}\n{3}"
    "  if (!fault) return 0;\n"
    "  std::fprintf(stderr, \"%s (at %g s); the run ends here\\n\", fault, d.time());\n  "
    "return 2;\n}}\n";

/// A function that writes one row of a recording.
std::string row_function(const diagram::RecordRequest& request, const plan::Plan& plan, std::size_t number) {
  std::string text = fmt::format(
      "void write_row_{}(std::FILE* file, const Diagram& d) {{\n"
      "  char digits[32];\n"
      "  std::fwrite(digits, 1, static_cast<std::size_t>(std::to_chars(digits, digits + "
      "sizeof digits, d.time()).ptr - digits), file);\n",
      number);
  for (const diagram::RecordedSignal& signal : request.signals) {
    const Index size = plan.slot(signal.signal).size;
    for (Index k = 0; k < size; ++k)
      text += fmt::format("  write_number(file, d.recorded.{}{}, ',');\n", recorded_member(signal),
                          size == 1 ? "" : fmt::format("[{}]", k));
  }
  return text + "  std::fputc('\\n', file);\n}\n\n";
}

std::string open_text(const diagram::RecordRequest& request, const plan::Plan& plan, std::size_t number) {
  std::vector<table::Column> columns;
  for (const record::RecordedColumn& column : record::recorded_columns(plan, request))
    columns.push_back({column.name, column.dimension ? unit::si_name(*column.dimension) : "", {}});
  std::string titles;
  table::append_csv_head(titles, columns);
  return fmt::format("  std::FILE* file_{0} = open(folder, {1}, {2});\n", number,
                     cpp_string(io::numbered("signals", number, ".csv")), cpp_string(titles));
}

}  // namespace

std::string main_text(const plan::Plan& plan, const std::string& header, const std::string& space) {
  std::string text = fmt::format(
      "#include <charconv>\n#include <cmath>\n#include <cstdio>\n#include <cstdlib>\n"
      "#include <string>\n\n#include {0}\n\nnamespace {{\n\nusing {1}::Diagram;\n",
      cpp_string(header), space);
  text += tools;
  text += open_function;
  std::string opening, rows, closing;
  for (std::size_t i = 0; i < plan.diagram.records.size(); ++i) {
    const diagram::RecordRequest& request = plan.diagram.records[i];
    text += row_function(request, plan, i);
    opening += open_text(request, plan, i);
    const std::int64_t every = record::ticks_between_rows(plan, request);
    rows += every == 1
                ? fmt::format("    write_row_{0}(file_{0}, d);\n", i)
                : fmt::format("    if (d.tick % {1} == 0 || last) write_row_{0}(file_{0}, d);\n", i, every);
    closing += fmt::format("  if (std::fclose(file_{0}) != 0) return 3;\n", i);
  }
  return text + fmt::format(main_form, opening, rows, plan.steps, closing,
                            plan.loops.empty() ? "" : "    if (!fault) fault = d.unsolved();\n");
}

}  // namespace stepwire::codegen
