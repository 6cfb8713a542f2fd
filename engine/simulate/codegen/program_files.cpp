#include "engine/simulate/codegen/program_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>

#include "engine/base/table/table_file.hpp"
#include "engine/model/plan/plan.hpp"
#include "engine/model/plan/run_ends.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/diagram_struct.hpp"
#include "engine/simulate/codegen/groups.hpp"
#include "engine/simulate/codegen/headers.hpp"
#include "engine/simulate/codegen/names.hpp"
#include "engine/simulate/codegen/program.hpp"
#include "engine/simulate/codegen/tuning_text.hpp"
#include "engine/simulate/codegen/value_text.hpp"
#include "engine/simulate/record/recorder.hpp"

namespace stepwire::codegen {

namespace {

/// C interface of a generated program. Its names begin with `space`; those of macros are in capitals.
struct CInterface {
  std::string header;  ///< C99
  std::string source;  ///< C++
};

/// Replaces every @ by the prefix of all names.
std::string with_space(std::string text, const std::string& space) {
  for (std::size_t at = 0; (at = text.find('@', at)) != std::string::npos; at += space.size())
    text.replace(at, 1, space);
  return text;
}

const char* const lifecycle =
    "/** Makes the instance, at time 0, with the parameters of the file. Comes before all else. */\n"
    "void @_init(@_instance* instance);\n"
    "/** Puts everything at time 0. */\nvoid @_reset(@_instance* instance);\n"
    "/** Reads the inputs and computes the outputs of this tick. */\n"
    "void @_evaluate(@_instance* instance);\n"
    "/** Goes on by a step. */\nvoid @_advance(@_instance* instance);\n"
    "/** Both. */\nvoid @_step(@_instance* instance);\n"
    "int64_t @_tick(const @_instance* instance);\n"
    "/** Of this tick [s]. */\ndouble @_time(const @_instance* instance);\n"
    "/** Is every signal and state a finite number? */\nbool @_finite(const @_instance* instance);\n"
    "/** Why a block has ended the run; NULL while none has. */\n"
    "const char* @_fault(const @_instance* instance);\n"
    "/** Is the diagram's stop_when true? */\nbool @_stops(const @_instance* instance);\n"
    "void @_save(const @_instance* instance, @_state* state);\n"
    "/** False, and nothing happens, for a state of another diagram. */\n"
    "bool @_restore(@_instance* instance, const @_state* state);\n";

const char* const parameter_checks =
    "/** Why these parameters would be refused; NULL where they would not. */\n"
    "const char* @_check(const @_instance* instance, const @_parameters* parameters);\n"
    "/** Why those that were set were refused at the last evaluate or reset; NULL where they hold. "
    "Until they "
    "are right\n    the former ones hold. */\n"
    "const char* @_parameter_fault(const @_instance* instance);\n";

class CText {
 public:
  CText(const plan::Plan& plan, const Tuning& tuning, const Groups& groups, const std::string& space)
      : plan_(plan), tuning_(tuning), groups_(groups), space_(space) {}

  std::string types() const {
    std::string text;
    for (const Group* group : shown()) text += type(*group);
    return text +
           with_space(
               fmt::format("/** All that moves in a run: plain numbers, to be kept anywhere. */\n"
                           "typedef struct {{\n  uint64_t layout; /**< of the diagram that it belongs to */\n"
                           "  int64_t tick;\n  double numbers[{}];\n}} @_state;\n\n"
                           "/** One running diagram; whoever uses it provides the memory. Its content is its "
                           "own. */\n"
                           "typedef struct {{\n  double memory[{}];\n}} @_instance;\n\n",
                           plan_.layout.size, doubles()),
               space_);
  }

  std::string declarations() const {
    std::string text = lifecycle;
    for (const Group* group : shown()) {
      text += fmt::format("void @_get_{0}(const @_instance* instance, @_{0}* {0});\n", group->name);
      if (is_written(*group))
        text += fmt::format("void @_set_{0}(@_instance* instance, const @_{0}* {0});\n", group->name);
    }
    if (tunes()) text += parameter_checks;
    return with_space(text, space_);
  }

  std::string definitions() const {
    std::string text =
        "void @_init(@_instance* instance) { ::new (static_cast<void*>(instance->memory)) Diagram; }\n"
        "void @_reset(@_instance* instance) { of(instance).reset(); }\n"
        "void @_evaluate(@_instance* instance) { of(instance).evaluate(); }\n"
        "void @_advance(@_instance* instance) { of(instance).advance(); }\n"
        "void @_step(@_instance* instance) { of(instance).step(); }\n"
        "int64_t @_tick(const @_instance* instance) { return of(instance).tick; }\n"
        "double @_time(const @_instance* instance) { return of(instance).time(); }\n"
        "bool @_finite(const @_instance* instance) { return of(instance).finite(); }\n"
        "const char* @_fault(const @_instance* instance) { return of(instance).fault(); }\n"
        "bool @_stops(const @_instance* instance) { return of(instance).stops(); }\n"
        "void @_save(const @_instance* instance, @_state* state) {\n"
        "  Diagram::State own;\n  of(instance).save(own);\n  copy(own, *state);\n}\n"
        "bool @_restore(@_instance* instance, const @_state* state) {\n"
        "  Diagram::State own;\n  copy(*state, own);\n  return of(instance).restore(own);\n}\n";
    for (const Group* group : shown()) text += access(*group);
    if (tunes())
      text +=
          "const char* @_check(const @_instance* instance, const @_parameters* parameters) {\n"
          "  Diagram::Parameters own;\n  copy(*parameters, own);\n  return of(instance).check(own);\n}\n"
          "const char* @_parameter_fault(const @_instance* instance) { return "
          "of(instance).parameter_fault(); }\n";
    return with_space(text, space_);
  }

 private:
  bool tunes() const { return !groups_.parameters.members.empty(); }
  bool is_written(const Group& group) const {
    return group.name == "inputs" || group.name == "parameters" || group.name == "states";
  }

  std::vector<const Group*> shown() const {
    std::vector<const Group*> shown;
    for (const Group* group :
         {&groups_.inputs, &groups_.outputs, &groups_.recorded, &groups_.parameters, &groups_.states})
      if (!group->members.empty()) shown.push_back(group);
    return shown;
  }

  std::string type(const Group& group) const {
    std::string text = fmt::format("/** {} */\ntypedef struct {{\n", group.doc);
    for (const GroupMember& member : group.members)
      text += fmt::format("  {}; /**< {} */\n", member.declaration(), cpp_comment(member.meaning));
    return text + fmt::format("}} {}_{};\n\n", space_, group.name);
  }

  std::string access(const Group& group) const {
    if (group.name == "states")
      return "void @_get_states(const @_instance* instance, @_states* states) { copy(of(instance).states(), "
             "*states); }\n"
             "void @_set_states(@_instance* instance, const @_states* states) {\n"
             "  Diagram::States own;\n  copy(*states, own);\n  of(instance).set_states(own);\n}\n";
    std::string text = fmt::format(
        "void @_get_{0}(const @_instance* instance, @_{0}* {0}) {{ copy(of(instance).{0}, *{0}); }}\n",
        group.name);
    if (is_written(group))
      text += fmt::format(
          "void @_set_{0}(@_instance* instance, const @_{0}* {0}) {{ copy(*{0}, of(instance).{0}); }}\n",
          group.name);
    return text;
  }

  static std::size_t doubles(const Group& group) {
    std::size_t count = 0;
    for (const GroupMember& member : group.members) count += member.count();
    return count;
  }

  /// Returns the size of an instance in doubles; the source checks it at compile time.
  std::size_t doubles() const {
    constexpr std::size_t tick_and_pointer = 2;
    std::size_t count = doubles(groups_.inputs) + doubles(groups_.outputs) + doubles(groups_.recorded) +
                        plan_.layout.size + tick_and_pointer;
    if (tunes())
      count += 2 * doubles(groups_.parameters) + std::max<std::size_t>(tuning_.numbers.size(), 1) +
               dependent_count(plan_, tuning_) / 8 + 1;
    return count;
  }

  const plan::Plan& plan_;
  const Tuning& tuning_;
  const Groups& groups_;
  const std::string& space_;
};

const char* const c_tools = R"text(namespace {

Diagram& of(@_instance* instance) { return *std::launder(reinterpret_cast<Diagram*>(instance->memory)); }
const Diagram& of(const @_instance* instance) {
  return *std::launder(reinterpret_cast<const Diagram*>(instance->memory));
}

/// Between structs of C and C++ with the same members.
template <class From, class To>
void copy(const From& from, To& to) {
  static_assert(sizeof from == sizeof to && std::is_trivially_copyable_v<From> && std::is_trivially_copyable_v<To>);
  std::memcpy(static_cast<void*>(&to), &from, sizeof to);
}

static_assert(sizeof(Diagram) <= sizeof(@_instance) && alignof(Diagram) <= alignof(@_instance));
static_assert(std::is_trivially_destructible_v<Diagram>);

}  // namespace

)text";

std::string in_capitals(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// `header` is the name of the C++ header, `c_header` that of the C header.
CInterface c_interface(const plan::Plan& plan, const Tuning& tuning, const Groups& groups,
                       const std::string& space, const std::string& header, const std::string& c_header) {
  const CText text(plan, tuning, groups, space);
  const std::string guard = in_capitals(space) + "_C_H";
  return {fmt::format("#ifndef {0}\n#define {0}\n\n#include <stdbool.h>\n#include <stdint.h>\n\n"
                      "#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n",
                      guard) +
              text.types() + text.declarations() + "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n",
          fmt::format("#include {}\n\n#include <cstring>\n#include <new>\n#include <type_traits>\n\n"
                      "#include {}\n\nusing {}::Diagram;\n\n",
                      cpp_string(c_header), cpp_string(header), space) +
              with_space(c_tools, space) + text.definitions()};
}

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

/// Placeholders: opening of files, rows of a tick, last tick, check of loops, rows of a fault between ticks.
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
    "    fault = d.fault();\n{4}    if (last || fault) break;\n  }}\n  finish();\n"
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

/// Returns the main() of a generated program. It runs the diagram to its stop time and writes the signals
/// files as `stepwire run` does. The struct is in the header `header` and the namespace `space`.
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
  const std::string end = plan::may_end_between(plan)
                              ? fmt::format(
                                    "    if (fault && d.time() < {}) {{\n    d.evaluate();\n    const bool "
                                    "last = true;\n{}    }}\n",
                                    time_text(plan, "d.tick"), rows)
                              : "";
  return text + fmt::format(main_form, opening, rows, plan.steps,
                            plan.loops.empty() ? "" : "    if (!fault) fault = d.unsolved();\n", end);
}

namespace fs = std::filesystem;

/// Check for builds without CMake.
constexpr char eigen_check[] =
    "#if !__has_include(<Eigen/Core>)\n"
    "#error this diagram needs the headers of Eigen 3: -I names their folder, /usr/include/eigen3 with "
    "Debian\n"
    "#error package libeigen3-dev\n"
    "#endif\n\n";
/// Choice of the elementary functions, at the head of the source of a diagram with `functions: portable`.
constexpr char portable_functions[] =
    "// Functions such as sin: with -DSTEPWIRE_SLEEF and -lsleef those of SLEEF, which give the bits of "
    "`stepwire "
    "run` on\n// every processor; otherwise those of the C library, whose last digits may differ.\n"
    "#ifndef STEPWIRE_SLEEF\n#define STEPWIRE_LIBM\n#endif\n\n";
/// The same with `functions: libm`.
constexpr char libm_functions[] =
    "// Functions such as sin are those of the C library, as the diagram says.\n#define STEPWIRE_LIBM\n\n";
constexpr char eigen_search[] =
    "# Solver or blocks need the headers of Eigen.\n"
    "find_package(Eigen3 QUIET NO_MODULE)\n"
    "if(NOT TARGET Eigen3::Eigen)\n"
    "  message(FATAL_ERROR \"{0} needs the headers of Eigen 3; on Debian the package libeigen3-dev has them, "
    "else \"\n"
    "                      \"-DEigen3_DIR=FOLDER names the folder of their Eigen3Config.cmake\")\n"
    "endif()\n\n";

/// Layout of headers in a program's folder: those of stepwire are under stepwire/, foreign ones under
/// blocks_of_others/ in their relative positions.
class HeaderFiles {
 public:
  explicit HeaderFiles(const IncludedHeaders& headers) : headers_(headers) {
    for (const std::string& header : headers.all)
      if (is_of_others(header)) widen(fs::path(header).parent_path());
    for (const std::string& folder : headers.folders) widen(folder);
  }

  /// Returns the path of a header as sources include it.
  std::string included(const std::string& header) const {
    return is_of_others(header) ? moved(header) : header;
  }
  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> files;
    for (const std::string& header : headers_.all) {
      const bool has_place = is_of_others(header) || header.starts_with("stepwire/");
      files[has_place ? included(header) : "stepwire/" + header] = header_text(header);
    }
    return files;
  }
  /// Returns the include folders beside that of the program and stepwire/.
  std::vector<std::string> folders() const {
    std::vector<std::string> folders;
    for (const std::string& folder : headers_.folders) folders.push_back(moved(folder));
    return folders;
  }

 private:
  void widen(const fs::path& folder) {
    if (common_.empty()) common_ = folder;
    while (common_ != common_.root_path() &&
           fs::path(folder).lexically_relative(common_).string().starts_with(".."))
      common_ = common_.parent_path();
  }
  std::string moved(const std::string& path) const {
    return (fs::path("blocks_of_others") / fs::path(path).lexically_relative(common_))
        .lexically_normal()
        .string();
  }

  const IncludedHeaders& headers_;
  fs::path common_;  ///< common parent folder of all foreign headers
};

/// Placeholders: name, sources, flags, main program, then found packages, linked libraries, compile options
/// and include folders.
constexpr char cmake_form[] =
    "cmake_minimum_required(VERSION 3.21)\n"
    "project({0} LANGUAGES CXX)\n\n"
    "if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE)\n  set(CMAKE_BUILD_TYPE Release)\nendif()\n"
    "set(CMAKE_CXX_FLAGS_RELEASE \"\")  # the flags below are all there is to it\n\n"
    "{4}# The diagram, for add_subdirectory() and target_link_libraries(... {0}::{0}).\n"
    "add_library({0} STATIC {1}.cpp{6})\n"
    "add_library({0}::{0} ALIAS {0})\n"
    "target_include_directories({0} PUBLIC ${{CMAKE_CURRENT_SOURCE_DIR}} PRIVATE "
    "${{CMAKE_CURRENT_SOURCE_DIR}}/stepwire{7})\n"
    "set_target_properties({0} PROPERTIES POSITION_INDEPENDENT_CODE ON)\n"
    "# What keeps the bits of `stepwire run`: -ffp-contract=off (no fused multiply-add) and "
    "-fno-builtin-... (functions\n"
    "# of the library, none computed by the compiler). Another -O or -march may be taken, never "
    "-ffast-math.\n"
    "target_compile_options({0} PRIVATE{2})\n"
    "if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)  # passes that cost time or speed here\n"
    "  target_compile_options({0} PRIVATE {8})\n"
    "endif()\n{5}{9}\n"
    "# The program that writes what the diagram records; in another project built on demand only.\n"
    "add_executable({0}_main {3})\n"
    "target_link_libraries({0}_main PRIVATE {0})\n"
    "target_compile_features({0}_main PRIVATE cxx_std_20)\n"
    "set_target_properties({0}_main PROPERTIES OUTPUT_NAME {0} RUNTIME_OUTPUT_DIRECTORY "
    "${{CMAKE_CURRENT_BINARY_DIR}}/bin)\n"
    "if(NOT PROJECT_IS_TOP_LEVEL)\n"
    "  set_target_properties({0}_main PROPERTIES EXCLUDE_FROM_ALL TRUE)\n"
    "endif()\n";

std::string cmake_text(const ProgramNames& names, const std::vector<std::string>& folders, bool c_interface,
                       bool uses_eigen, bool uses_libm) {
  std::string more;
  for (const std::string& folder : folders)
    more += fmt::format(" \"${{CMAKE_CURRENT_SOURCE_DIR}}/{}\"", folder);
  std::string flags;
  for (const std::string& flag : Compiler::flags()) flags += " " + flag;
  return fmt::format(
      cmake_form, names.space, names.stem, flags, names.main,
      uses_eigen ? fmt::format(eigen_search, names.space) : "",
      uses_eigen ? fmt::format("target_link_libraries({} PRIVATE Eigen3::Eigen)\n", names.space) : "",
      c_interface ? " " + names.c_source : "", more, fmt::join(Compiler::gcc_flags, " "),
      uses_libm ? "" : sleef_search(names.space));
}

/// Returns the size of the longest list that a block receives again as parameters change. Lists up to this
/// size are stored without dynamic memory. Returns std::nullopt for foreign blocks, which may make lists of
/// any size.
std::optional<std::size_t> longest_list(const plan::Plan& plan, const Tuning& tuning,
                                        const IncludedHeaders& headers) {
  if (std::ranges::any_of(headers.all, is_of_others)) return std::nullopt;
  auto longest = static_cast<std::size_t>(Numbers::capacity);
  for (const int binding : tuning.bindings) {
    const diagram::Target& target = plan.diagram.bindings->bindings[static_cast<std::size_t>(binding)].target;
    if (target.kind != diagram::Target::Kind::parameter) continue;
    const diagram::DiagramBlock& block = plan.diagram.blocks[static_cast<std::size_t>(target.block)];
    const ParameterSpec& spec = block.type().parameters[static_cast<std::size_t>(target.index)];
    longest = std::max(longest, numbers_of(spec.get(block.block.get())).size());
  }
  return longest;
}

std::string source_text(const GeneratedProgram& program, const ProgramNames& names,
                        const HeaderFiles& headers, const std::optional<std::size_t>& longest,
                        const std::string& definitions) {
  std::string text = fmt::format("#include \"{}\"\n\n", names.header);
  if (longest)
    text += fmt::format(
        "// No list of a block is longer, so that none needs a heap.\n"
        "#define STEPWIRE_LONGEST_LIST {}\n",
        *longest);
  if (needs_eigen(headers.files())) text += eigen_check;
  text += program.uses_libm ? libm_functions : portable_functions;
  text += fmt::format(
      "#include <bit>\n#include <cmath>\n#include <cstring>\n#include <limits>\n\n"
      "// Blocks of another version may be linked beside these.\n#define stepwire stepwire_of_{}\n",
      names.space);
  for (const std::string& header : program.headers)
    text += fmt::format("#include \"{}\"\n", headers.included(header));
  return text + "\nnamespace {\n\nusing namespace stepwire;\n\n" + program.text + "\n}  // namespace\n\n" +
         definitions;
}

}  // namespace

bool needs_eigen(const std::map<std::string, std::string>& files) {
  return std::ranges::any_of(
      files, [](const auto& file) { return file.second.find("#include <Eigen/") != std::string::npos; });
}

ProgramNames::ProgramNames(const std::string& name)
    : stem(cpp_identifier(name)),
      space(stem + "_diagram"),
      header(stem + ".hpp"),
      source(stem + ".cpp"),
      main(stem + "-main.cpp"),
      c_header(stem + "-c.h"),
      c_source(stem + "-c.cpp") {}

std::string sleef_search(const std::string& target) {
  return fmt::format(
      "# Functions such as sin: those of SLEEF give the bits of `stepwire run` on every processor, those of "
      "the C\n"
      "# library may differ in the last digits. On Debian the package libsleef-dev has SLEEF.\n"
      "if(NOT CMAKE_CROSSCOMPILING)\n  find_library(STEPWIRE_SLEEF NAMES sleef)\nendif()\n"
      "if(STEPWIRE_SLEEF)\n  target_compile_definitions({0} PRIVATE STEPWIRE_SLEEF)\n"
      "  target_link_libraries({0} PRIVATE ${{STEPWIRE_SLEEF}})\nendif()\n",
      target);
}

std::map<std::string, std::string> program_files(const plan::Plan& plan, const Tuning& tuning,
                                                 const ProgramOptions& options) {
  const GeneratedProgram program = make_program(plan, tuning, options.between_ticks);
  const ProgramNames names(options.name);
  const IncludedHeaders included = with_included(program.headers);
  const HeaderFiles headers(included);
  const Groups groups(plan, tuning);
  const std::string made =
      cpp_comment(fmt::format("{} made this from {}", options.made_by, plan.diagram.file));
  const std::string note = "// " + made + "\n\n";
  std::map<std::string, std::string> files;
  files[names.header] = note + struct_text(plan, tuning, groups, names.space, options.between_ticks);
  files[names.source] =
      note + source_text(program, names, headers, longest_list(plan, tuning, included),
                         struct_definitions(plan, tuning, groups, names.space, options.between_ticks));
  files[names.main] = note + main_text(plan, names.header, names.space);
  if (options.c_interface) {
    const CInterface c = c_interface(plan, tuning, groups, names.space, names.header, names.c_header);
    files[names.c_header] = "/* " + made + " */\n\n" + c.header;
    files[names.c_source] = note + c.source;
  }
  files.merge(headers.files());
  files["CMakeLists.txt"] =
      cmake_text(names, headers.folders(), options.c_interface, needs_eigen(files), plan.diagram.uses_libm);
  return files;
}

std::vector<std::string> header_folders(const plan::Plan& plan) {
  const IncludedHeaders included = with_included(headers_of(plan));
  return HeaderFiles(included).folders();
}

}  // namespace stepwire::codegen
