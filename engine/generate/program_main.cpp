#include "engine/generate/program_main.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/generate/diagram_struct.hpp"
#include "engine/record/recorder.hpp"

namespace stepwire {

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

std::string title_of(const RecordedColumn& column) {
  const std::string unit = column.dimension ? si_name(*column.dimension) : "";
  const std::string title = unit.empty() ? column.name : fmt::format("{} [{}]", column.name, unit);
  return title.find(',') == std::string::npos ? title : "\\\"" + title + "\\\"";
}

/// A function that writes one row of a recording.
std::string row_function(const RecordRequest& request, const Plan& plan, std::size_t number) {
  std::string text = fmt::format(
      "void write_row_{}(std::FILE* file, const Diagram& d) {{\n"
      "  char digits[32];\n"
      "  std::fwrite(digits, 1, static_cast<std::size_t>(std::to_chars(digits, digits + "
      "sizeof digits, d.time()).ptr - digits), file);\n",
      number);
  for (const RecordedSignal& signal : request.signals) {
    const Index size = plan.slot(signal.signal).size;
    for (Index k = 0; k < size; ++k)
      text += fmt::format("  write_number(file, d.recorded.{}{}, ',');\n", recorded_member(signal),
                          size == 1 ? "" : fmt::format("[{}]", k));
  }
  return text + "  std::fputc('\\n', file);\n}\n\n";
}

std::string file_name(std::size_t number) {
  return number == 0 ? "signals.csv" : fmt::format("signals-{}.csv", number + 1);
}

std::string open_text(const RecordRequest& request, const Plan& plan, std::size_t number) {
  std::string titles;
  for (const RecordedColumn& column : recorded_columns(plan, request))
    titles += (titles.empty() ? "" : ",") + title_of(column);
  return fmt::format("  std::FILE* file_{0} = open(folder, \"{1}\", \"{2}\");\n", number, file_name(number),
                     titles);
}

std::int64_t ticks_between(const RecordRequest& request, const Plan& plan) {
  return request.every ? std::llround(*request.every / plan.diagram.step) : 1;
}

}  // namespace

std::string main_text(const Plan& plan, const std::string& name) {
  std::string text = fmt::format(
      "#include <charconv>\n#include <cmath>\n#include <cstdio>\n#include <cstdlib>\n"
      "#include <string>\n\n#include \"{0}.hpp\"\n\nnamespace {{\n\nusing {0}::Diagram;\n",
      name);
  text += tools;
  text +=
      "\nstd::FILE* open(const std::string& folder, const char* name, const char* titles) {\n"
      "  std::FILE* file = std::fopen((folder + \"/\" + name).c_str(), \"w\");\n"
      "  if (!file) {\n    std::perror((folder + \"/\" + name).c_str());\n    std::exit(3);\n  }\n"
      "  std::fprintf(file, \"%s\\n\", titles);\n  return file;\n}\n\n";
  std::string opening, rows, closing;
  for (std::size_t i = 0; i < plan.diagram.records.size(); ++i) {
    const RecordRequest& request = plan.diagram.records[i];
    text += row_function(request, plan, i);
    opening += open_text(request, plan, i);
    const std::int64_t every = ticks_between(request, plan);
    rows += every == 1 ? fmt::format("    write_row_{0}(file_{0}, d);\n", i)
                       : fmt::format("    if (d.tick % {1} == 0) write_row_{0}(file_{0}, d);\n", i, every);
    closing += fmt::format("  if (std::fclose(file_{0}) != 0) return 3;\n", i);
  }
  return text + fmt::format(
                    "}}  // namespace\n\n"
                    "/// Runs the diagram to its stop; what it records goes into the folder that is named, "
                    "or this one.\n"
                    "int main(int argc, char** argv) {{\n"
                    "  [[maybe_unused]] const std::string folder = argc > 1 ? argv[1] : \".\";\n{0}"
                    "  static Diagram d;\n  const char* fault = nullptr;\n"
                    "  while (true) {{\n    d.evaluate();\n"
                    "    if (!d.finite()) fault = \"a signal is no longer a finite number\";\n    if (fault) "
                    "break;\n{1}"
                    "    if (d.tick >= {2} || d.stops()) break;\n    d.advance();\n"
                    "    fault = d.fault();\n    if (fault) break;\n  }}\n{3}"
                    "  if (!fault) return 0;\n"
                    "  std::fprintf(stderr, \"%s (at %g s); the run ends here\\n\", fault, d.time());\n  "
                    "return 2;\n}}\n",
                    opening, rows, plan.steps, closing);
}

}  // namespace stepwire
