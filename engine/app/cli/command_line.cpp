#include "engine/app/cli/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "engine/app/cli/call_options.hpp"
#include "engine/app/cli/call_settings.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/report.hpp"
#include "engine/app/cli/version.hpp"
#include "engine/base/io/cache.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire {

namespace {

constexpr DocumentLimits large_limits{.bytes = std::size_t{512} << 20, .depth = 64, .nodes = 64'000'000};

void add_load_options(CLI::App& verb, SettingWords& settings, bool& large) {
  add_setting_options(verb, settings);
  verb.add_flag("--large", large, "read files above 8 MB, up to 512 MB");
}

void add_work_options(CLI::App& verb, RunCommand& command, SettingWords& settings, std::string& stop,
                      bool& large) {
  verb.add_option("FILE", command.files, "diagram files")->required();
  add_load_options(verb, settings, large);
  verb.add_option("--stop", stop, "stop time in place of the file's, e.g. 2s");
  verb.add_flag("--units", command.units, "print the unit of every wire");
  verb.add_flag("--json", command.json, "print the result as JSON");
}

/// All verbs with what they fill in.
class CommandLine {
 public:
  explicit CommandLine(const Registry& registry) : registry_(registry) {
    app_.require_subcommand(1);
    app_.failure_message([](const CLI::App*, const CLI::Error& error) {
      return fmt::format("stepwire: {}; stepwire --help and stepwire VERB --help tell more\n",
                         visible(error.what()));
    });
    app_.set_version_flag("--version", "stepwire " + program_version());
    add_run();
    add_fit();
    add_study();
    add_check();
    add_flatten();
    add_generate();
    add_draw();
    add_verify();
    add_loop();
    add_thesis();
    add_blocks();
    add_format();
    add_schema();
  }

  ExitCode run(int argc, char** argv) {
    if (argc > 1 && *argv[1] != '-' && std::ranges::count(verbs(), std::string(argv[1])) == 0)
      return refuse_verb(argv[1]);
    try {
      app_.parse(argc, argv);
      return action_();
    } catch (const CLI::ParseError& error) {
      return explain(error);
    }
  }

 private:
  /// Prints the help that is asked for, or what is wrong in the call.
  ExitCode explain(const CLI::ParseError& error) const {
    std::ostringstream help, wrong;
    const int code = app_.exit(error, help, wrong);
    put_text(help.str());
    put_trouble(wrong.str());
    return code == 0 ? ExitCode::done : ExitCode::wrong;
  }

  std::vector<std::string> verbs() const {
    std::vector<std::string> names;
    for (const CLI::App* verb : app_.get_subcommands([](const CLI::App*) { return true; }))
      names.push_back(verb->get_name());
    return names;
  }

  ExitCode refuse_verb(const std::string& word) const {
    complain("stepwire: there is no '{}'{}\n", visible(word),
             did_you_mean(word, verbs(), fmt::format("There are: {}", fmt::join(verbs(), ", "))));
    return ExitCode::wrong;
  }

  void add_run() {
    CLI::App* verb = app_.add_subcommand("run", "run diagram files, judge their claims");
    verb->footer("Example:\n  stepwire run lag.yaml --set tau=0.2s --stop 2s --out out/lag");
    add_work_options(*verb, run_, settings_, stop_, large_);
    add_engine_option(*verb, run_.engine,
                      "interpreted, compiled, or auto: compiled once that is worth it; all to the same bits");
    add_out_option(*verb, "--out", run_.out,
                   "folder for signals.csv, signals.mat, pictures, claims.json, run.json, diagram.yaml");
    verb->add_flag("--profile", run_.profile,
                   "measure what each block costs; with --out also in profile.csv and profile.svg");
    verb->callback([this] { action_ = [this] { return run_or_check(); }; });
  }

  void add_fit() {
    CLI::App* verb =
        app_.add_subcommand("fit", "find parameters of diagram files from records, then run them");
    verb->footer("Example:\n  stepwire fit press.yaml --starts 8 --out out/press");
    add_work_options(*verb, run_, settings_, stop_, large_);
    add_engine_option(*verb, run_.engine, "interpreted, compiled, or auto; all to the same bits");
    add_fit_options(*verb, run_.fit);
    add_out_option(*verb, "--out", run_.out, "folder for parameters.yaml, fit.json and all that run writes");
    verb->callback([this] {
      run_.fit_asked = true;
      action_ = [this] { return run_or_check(); };
    });
  }

  void add_study() {
    CLI::App* verb = app_.add_subcommand(
        "study", "run the trials of a human-subject study by simulated operators, and analyse them");
    verb->footer(
        "A file with a sweep makes the whole study at each of its points.\n\n"
        "Example:\n  stepwire study circle.yaml --subjects 20 --out out/circle");
    add_work_options(*verb, run_, settings_, stop_, large_);
    add_engine_option(*verb, run_.engine, "interpreted, compiled, or auto; all to the same bits");
    add_study_options(*verb, run_);
    add_out_option(*verb, "--out", run_.out,
                   "folder for trials.csv, errors.csv, tables.txt, study.json and all that run writes");
    verb->callback([this] {
      run_.study_asked = true;
      if (run_.study_repeats > 0 && run_.out.empty())
        throw CLI::ValidationError("--repeat", "needs --out, the folder in which experiments are kept");
      action_ = [this] { return run_or_check(); };
    });
  }

  void add_check() {
    CLI::App* verb = app_.add_subcommand("check", "do all that run does before the first step");
    verb->footer("Example:\n  stepwire check diagrams/examples/*.yaml");
    add_work_options(*verb, run_, settings_, stop_, large_);
    verb->callback([this] {
      run_.check_only = true;
      action_ = [this] { return run_or_check(); };
    });
  }

  void add_generate() {
    CLI::App* verb = app_.add_subcommand("generate", "write a diagram as C++ that is built without stepwire");
    verb->footer("Example:\n  stepwire generate controller.yaml -o controller");
    verb->add_option("FILE", generate_.file, "a diagram file")->required();
    add_load_options(*verb, settings_, large_);
    add_out_option(*verb, "-o", generate_.out, "folder for the program")->required();
    verb->callback([this] {
      action_ = [this] {
        take_load_options(generate_.options);
        return generate_files(generate_, registry_);
      };
    });
  }

  void add_flatten() {
    CLI::App* verb =
        app_.add_subcommand("flatten", "write a diagram as one file, without parts and parameters");
    verb->footer("Example:\n  stepwire flatten rig.yaml --set rig.mass=2kg -o flat.yaml");
    verb->add_option("FILE", flatten_.file, "a diagram file")->required();
    add_load_options(*verb, settings_, large_);
    verb->add_option("-o", flatten_.out, "file to write; standard output without it");
    verb->callback([this] {
      action_ = [this] {
        take_load_options(flatten_.options);
        return flatten_file(flatten_, registry_);
      };
    });
  }

  void add_draw() {
    CLI::App* verb = app_.add_subcommand("draw", "draw a diagram as blocks and wires");
    verb->footer("Example:\n  stepwire draw rig.yaml --open controller -o rig.svg");
    verb->add_option("FILE", draw_.file, "a diagram file, or one that is used as a part")->required();
    verb->add_option("-o", draw_.out, "SVG file to write; standard output without it");
    verb->add_option("--open", draw_.options.open, "parts whose inside is drawn: rig, rig.mount")
        ->delimiter(',');
    verb->add_option("--depth", draw_.options.depth, "open all parts down to so many levels")
        ->check(CLI::Range(0, 32))
        ->capture_default_str();
    verb->add_option("--hide", draw_.options.hide,
                     "blocks, parts and signals left out: work, rig.energy, 'peak*'")
        ->delimiter(',');
    verb->add_flag("--units", draw_.options.units, "write the unit of its signal on each wire");
    verb->add_flag("--json", draw_.json, "give the graph that is drawn, as JSON");
    verb->callback([this] { action_ = [this] { return draw_file(draw_, registry_); }; });
  }

  void add_verify() {
    CLI::App* verb = app_.add_subcommand("verify", "replay what a run left, and compare it bit by bit");
    verb->footer("Example:\n  stepwire run lag.yaml --out out/lag && stepwire verify out/lag");
    verb->add_option("RUN_DIR", verify_.folders, "folders that run --out wrote")->required();
    verb->callback([this] { action_ = [this] { return verify_folders(verify_, registry_); }; });
  }

  void add_loop() {
    CLI::App* verb = app_.add_subcommand("loop", "run a diagram file in real time, and measure how well");
    verb->footer(
        "Example:\n  stepwire loop lag.yaml --rate 1000 --duration 10 --overrun stop:3 --out out/lag");
    add_loop_options(*verb, loop_);
    add_load_options(*verb, settings_, large_);
    verb->callback([this] {
      action_ = [this] {
        take_load_options(loop_.options);
        return run_loop(loop_, registry_);
      };
    });
  }

  void add_thesis() {
    CLI::App* verb =
        app_.add_subcommand("thesis", "make the figures of the thesis and a page that shows them");
    verb->footer("Example:\n  stepwire thesis --only fig15,fig31 --out out/thesis");
    verb->add_option("--only", thesis_.only, "beginnings of file names, e.g. fig15,fig31")->delimiter(',');
    add_out_option(*verb, "--out", thesis_.out, "folder of the page")->capture_default_str();
    thesis_.diagrams = std::string(STEPWIRE_DIAGRAMS) + "/thesis";
    verb->callback([this] { action_ = [this] { return run_thesis(thesis_, registry_); }; });
  }

  void add_blocks() {
    CLI::App* verb = app_.add_subcommand("blocks", "list the blocks, or explain one");
    verb->footer("Example:\n  stepwire blocks PID\n  stepwire blocks --markdown > blocks.md");
    verb->add_option("NAME", blocks_.name, "a block");
    verb->add_flag("--json", blocks_.json, "as JSON");
    verb->add_flag("--markdown", blocks_.markdown, "as Markdown");
    verb->callback([this] { action_ = [this] { return show_blocks(blocks_, registry_); }; });
  }

  void add_format() {
    CLI::App* verb = app_.add_subcommand("format", "list the sections of a diagram file, or explain one");
    verb->footer("Example:\n  stepwire format claims\n  stepwire format --markdown > format.md");
    verb->add_option("SECTION", format_.section, "a section, or a kind of plot: figure.lines");
    verb->add_flag("--markdown", format_.markdown, "as Markdown");
    verb->callback([this] { action_ = [this] { return show_format(format_); }; });
  }

  void add_schema() {
    CLI::App* verb = app_.add_subcommand("schema", "print the JSON schema of diagram files, for editors");
    verb->footer(
        "Example:\n  stepwire schema > stepwire.schema.json\n  # first line of a diagram file:\n"
        "  # yaml-language-server: $schema=stepwire.schema.json");
    verb->callback([this] { action_ = [this] { return show_schema(registry_); }; });
  }

  void take_load_options(WorkOptions& options) const {
    options.settings = settings_of(settings_);
    if (large_) options.limits = large_limits;
  }

  ExitCode run_or_check() {
    take_load_options(run_.options);
    if (!stop_.empty()) run_.options.stop = stop_;
    return run_files(run_, registry_);
  }

  const Registry& registry_;
  CLI::App app_{"Block diagrams in text, run at a fixed step."};
  RunCommand run_;
  GenerateCommand generate_;
  FlattenCommand flatten_;
  DrawCommand draw_;
  VerifyCommand verify_;
  LoopCommand loop_;
  ThesisCommand thesis_;
  BlocksCommand blocks_;
  FormatCommand format_;
  SettingWords settings_;
  std::string stop_;
  bool large_ = false;
  std::function<ExitCode()> action_;
};

}  // namespace

int run_command_line(int argc, char** argv, Registry (*blocks)()) {
  fill_standard_streams();
  catch_signals();
  const ExitCode code = guarded([&] {
    const Registry registry = blocks();
    return CommandLine(registry).run(argc, argv);
  });
  if (const std::string problem = take_cache_problem(); !problem.empty())
    complain("the cache keeps nothing: {}\n", visible(problem));
  return static_cast<int>(finish_output() ? code : worst(code, ExitCode::surroundings));
}

}  // namespace stepwire
