#pragma once

#include <string>
#include <vector>

#include "engine/app/cli/fitting.hpp"
#include "engine/app/cli/loop_settings.hpp"
#include "engine/app/cli/work.hpp"
#include "engine/model/block/registry.hpp"
#include "engine/view/drawing/graph.hpp"

namespace stepwire {

struct RunCommand {
  std::vector<std::string> files;
  WorkOptions options;
  std::string out;  ///< folder; empty: nothing is written
  bool json = false;
  bool units = false;
  bool profile = false;  ///< measure what each block costs
  bool check_only = false;
  bool fit_asked = false;    ///< a file without a section `fit` is refused
  bool study_asked = false;  ///< a file without a section `study` is refused
  FitWords fit;
  unsigned study_threads = 0;     ///< 0: all cores
  std::size_t study_repeats = 0;  ///< experiments; 0: the one of the file
  Engine engine = Engine::automatic;
};

struct FlattenCommand {
  std::string file;
  WorkOptions options;
  std::string out;  ///< file; empty: standard output
};

struct DrawCommand {
  std::string file;
  GraphOptions options;
  std::string out;    ///< file; empty: standard output
  bool json = false;  ///< the graph that is drawn, not the picture
};

struct VerifyCommand {
  std::vector<std::string> folders;
};

struct ThesisCommand {
  std::vector<std::string> only;  ///< beginnings of file names: "fig15"
  std::string diagrams;           ///< folder with the diagram files
  std::string out = "out/thesis";
};

struct GenerateCommand {
  std::string file;
  WorkOptions options;
  std::string out;  ///< folder
};

struct LoopCommand {
  std::string file;
  WorkOptions options;
  LoopWords words;
  std::string out;  ///< folder; empty: nothing is recorded
  bool baseline = false;
  Engine engine = Engine::interpreted;
};

struct BlocksCommand {
  std::string name;
  bool json = false;
  bool markdown = false;
};

struct FormatCommand {
  std::string section;  ///< empty: all of them
  bool markdown = false;
};

/// `run`, `fit`, `study` and `check`.
ExitCode run_files(const RunCommand& command, const Registry& registry);
/// `flatten`: a diagram as one file without parts and parameters.
ExitCode flatten_file(const FlattenCommand& command, const Registry& registry);
/// `draw`: a diagram as a picture of blocks and wires.
ExitCode draw_file(const DrawCommand& command, const Registry& registry);
/// `verify`: replays what runs left in their folders.
ExitCode verify_folders(const VerifyCommand& command, const Registry& registry);
/// `thesis`: every figure, and the page that shows them.
ExitCode run_thesis(const ThesisCommand& command, const Registry& registry);
/// `generate`: a diagram as C++.
ExitCode generate_files(const GenerateCommand& command, const Registry& registry);
/// `loop`: runs in real time. Judges no claims.
ExitCode run_loop(const LoopCommand& command, const Registry& registry);
/// `blocks`.
ExitCode show_blocks(const BlocksCommand& command, const Registry& registry);
/// `format`.
ExitCode show_format(const FormatCommand& command);
/// `schema`.
ExitCode show_schema(const Registry& registry);

}  // namespace stepwire
