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

/// Functions that write tables. A table has its name only once it is complete, so a full disk leaves older
/// ones intact.
const char* const table_functions = R"cpp(
  /// A table that is written, until the end under the name `path`.part.
  struct Table {
    std::string path;
    std::FILE* file;
  };
  std::vector<Table> tables;

  /// Ends the program with the system's reason; tables of an earlier run keep their content.
  [[noreturn]] void refuse(const std::string& path) {
    std::perror(path.c_str());
    for (const Table& table : tables) std::remove((table.path + ".part").c_str());
    std::exit(3);
  }

  std::FILE* open(const std::string& folder, const char* name, const char* titles) {
    const std::string path = folder + "/" + name;
    tables.push_back({path, std::fopen((path + ".part").c_str(), "w")});
    std::FILE* file = tables.back().file;
    if (!file) refuse(path);
    std::fputs(titles, file);
    return file;
  }

  /// Gives the tables their names.
  void finish() {
    for (const Table& table : tables) {
      const bool whole = !std::ferror(table.file);
      if (std::fclose(table.file) != 0 || !whole) refuse(table.path);
    }
    for (const Table& table : tables)
      if (std::rename((table.path + ".part").c_str(), table.path.c_str()) != 0) refuse(table.path);
  }
)cpp";

/// Placeholders: opening of files, rows of a tick, last tick, check of loops.
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
    "  [[maybe_unused]] const std::string folder = argc > 1 ? argv[1] : \".\";\n"
    "#ifdef SIGXFSZ\n  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error like a full "
    "disk\n#endif\n{0}"
    "  static Diagram d;\n  const char* fault = nullptr;\n"
    "  while (true) {{\n    d.evaluate();\n"
    "    if (!d.finite()) fault = \"a signal is no longer a finite number\";\n{3}    if (fault) "
    "break;\n    const bool last = d.tick >= {2} || d.stops();\n{1}"
    "    last ? d.look_at_end() : d.advance();\n"
    "    fault = d.fault();\n    if (last || fault) break;\n  }}\n  finish();\n"
    "  if (!fault) return 0;\n"
    "  std::fprintf(stderr, \"%s (at %g s); the run ends here\\n\", fault, d.time());\n  "
    "return 2;\n}}\n";

/// Returns a function that writes one row of a recording.
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
  return text +
         fmt::format("  std::fputc('\\n', file);\n  if (std::ferror(file)) refuse(tables[{}].path);\n}}\n\n",
                     number);
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
      "#include <charconv>\n#include <cmath>\n#include <csignal>\n#include <cstdio>\n#include <cstdlib>\n"
      "#include <string>\n#include <vector>\n\n#include {0}\n\nnamespace {{\n\nusing {1}::Diagram;\n",
      cpp_string(header), space);
  text += tools;
  text += table_functions;
  std::string opening, rows;
  for (std::size_t i = 0; i < plan.diagram.records.size(); ++i) {
    const diagram::RecordRequest& request = plan.diagram.records[i];
    text += row_function(request, plan, i);
    opening += open_text(request, plan, i);
    const std::int64_t every = record::ticks_between_rows(plan, request);
    rows += every == 1
                ? fmt::format("    write_row_{0}(file_{0}, d);\n", i)
                : fmt::format("    if (d.tick % {1} == 0 || last) write_row_{0}(file_{0}, d);\n", i, every);
  }
  return text + fmt::format(main_form, opening, rows, plan.steps,
                            plan.loops.empty() ? "" : "    if (!fault) fault = d.unsolved();\n");
}

}  // namespace stepwire::codegen
