// Every kind of file that the program writes, where the system takes a part of it alone.
#include <sched.h>
#include <sys/mount.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>

#include "engine/base/subprocess/process.hpp"
#include "tests/engine/app/cli/program.hpp"

namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Catch::EndsWith;

/// A call, and a file that it writes: ".out" is the standard output.
struct Kind {
  std::string name;
  std::vector<std::string> arguments;
  std::string target;
  std::string needs{};  ///< a program of the machine

  bool in_folder_of_results() const { return target.starts_with("out/"); }
};

const std::vector<Kind> kinds{
    {"csv", {"run", "a.yaml", "--out", "out", "--files", "csv"}, "out/signals.csv"},
    {"large csv",
     {"run", "wide.yaml", "--engine", "interpreted", "--out", "out", "--files", "csv"},
     "out/signals.csv"},
    {"large csv of one's own",
     {"run", "wide.yaml", "--engine", "interpreted", "--csv", "table.csv"},
     "table.csv"},
    {"csv of one's own", {"run", "a.yaml", "--csv", "table.csv"}, "table.csv"},
    {"csv to the standard output", {"run", "a.yaml", "--csv", "-"}, ".out"},
    {"mat", {"run", "a.yaml", "--out", "out", "--files", "mat"}, "out/signals.mat"},
    {"h5", {"run", "a.yaml", "--out", "out", "--files", "h5"}, "out/signals.h5"},
    {"large h5",
     {"run", "wide.yaml", "--engine", "interpreted", "--out", "out", "--files", "h5"},
     "out/signals.h5"},
    {"mcap", {"run", "a.yaml", "--out", "out", "--files", "mcap"}, "out/signals.mcap"},
    {"large mcap",
     {"run", "wide.yaml", "--engine", "interpreted", "--out", "out", "--files", "mcap"},
     "out/signals.mcap"},
    {"run.json", {"run", "b.yaml", "--out", "out", "--files", "csv"}, "out/run.json"},
    {"figure as svg", {"run", "b.yaml", "--out", "out", "--files", "csv"}, "out/figure.svg", "gnuplot"},
    {"figure as png",
     {"run", "b.yaml", "--out", "out", "--files", "csv", "--pictures", "png"},
     "out/figure.png",
     "gnuplot"},
    {"figure as pdf",
     {"run", "b.yaml", "--out", "out", "--files", "csv", "--pictures", "pdf"},
     "out/figure.pdf",
     "gnuplot"},
    {"archive", {"run", "a.yaml", "--out", "-"}, ".out", "tar"},
    {"table of a sweep", {"run", "sweep.yaml", "--out", "out", "--files", "csv"}, "out/sweep.csv"},
    {"large table of a sweep", {"run", "mixed.yaml", "--out", "out", "--files", "csv"}, "out/sweep.csv"},
    {"points of a sweep", {"run", "sweep.yaml", "--part", "1/2", "--out", "out"}, "out/points.journal"},
    {"profile", {"run", "b.yaml", "--profile", "--out", "out", "--files", "csv"}, "out/profile.csv"},
    {"flattened diagram", {"flatten", "study.yaml", "-o", "flat.yaml"}, "flat.yaml"},
    {"flattened diagram to the standard output", {"flatten", "study.yaml"}, ".out"},
    {"generated code", {"generate", "a.yaml", "-o", "out"}, "out/a.cpp"},
    {"drawing", {"draw", "a.yaml", "-o", "a.svg"}, "a.svg", "node"},
    {"script of a job", {"job", "sweep.yaml", "--slurm", "--tasks", "2", "--script", "job.sh"}, "job.sh"},
    {"linear system as json",
     {"linearize", "a.yaml", "--from", "u", "--to", "lag", "--out", "out"},
     "out/linear.json"},
    {"linear system as mat",
     {"linearize", "a.yaml", "--from", "u", "--to", "lag", "--out", "out"},
     "out/linear.mat"},
    {"operating point", {"trim", "trim.yaml", "--out", "out"}, "out/trim.json"},
    {"fit", {"fit", "fit.yaml", "--out", "out", "--files", "csv"}, "out/fit.json"},
    {"tuning", {"tune", "tune.yaml", "--out", "out", "--files", "csv"}, "out/tune.json"},
    {"steps of a tuning", {"tune", "tune.yaml", "--out", "out", "--files", "csv"}, "out/tune-history.csv"},
    {"errors of a study", {"study", "study.yaml", "--out", "out"}, "out/errors.csv"},
    {"tables of a study", {"study", "study.yaml", "--out", "out"}, "out/tables.txt"},
    {"schema", {"schema"}, ".out"},
    {"blocks", {"blocks", "--json"}, ".out"},
};

const std::string head =
    "stepwire: 1\ntitle: a lag\nstep: 1 ms\nsolver: rk4\nparameters: {tau: {value: 0.1 s, above: 0 s, doc: "
    "x}}\n";
const std::string lag =
    "inputs: {u: {default: 1}}\noutputs: {y: lag}\nblocks:\n  lag: {block: Lag, u: u, tau: $tau}\nrecord: "
    "[u, lag]\n"
    "claims: [{that: the lag gets there, final: lag, at_least: 0}]\n";
const std::string sought =
    "blocks:\n  sine: {block: Sine, frequency: 1 Hz}\n  truth: {block: Lag, u: sine, tau: 0.2 s}\n"
    "  lag: {block: Lag, u: sine, tau: $tau}\nrecord: [lag, truth]\n";

/// The diagrams of the calls. A row has two or three numbers; that of the wide one has 21, and there are
/// 1,050,021 numbers in all.
void write_diagrams(const Scratch& folder) {
  folder.file("a.yaml", head + "stop: 1 s\n" + lag);
  folder.file("b.yaml", head + "stop: 10 ms\n" + lag + "figure: {plot: lines, x: time, y: lag}\n");
  folder.file("wide.yaml",
              "stepwire: 1\ntitle: many numbers\nstep: 1 ms\nstop: 50 s\nblocks:\n  a: {block: Constant, "
              "value: [1, 2, 3, 4, "
              "5, 6, 7, 8, 9, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0]}\nrecord: [a]\n");
  folder.file("sweep.yaml", head + "stop: 10 ms\nsweep: {tau: {from: 0.1 s, to: 0.2 s, count: 600}}\n" + lag);
  folder.file("mixed.yaml",
              head + "stop: 2 ms\nsweep: {tau: {from: 0.1 s, to: 0.2 s, count: 9000}, keep: final}\n" + lag);
  folder.file("fit.yaml",
              head +
                  "stop: 0.2 s\nfit: {parameters: {tau: {start: 0.3 s, bounds: [10 ms, 10 s]}}, compare: "
                  "[{model: lag, measured: truth}]}\n" +
                  sought);
  folder.file("tune.yaml",
              head +
                  "stop: 0.2 s\ntune: {parameters: {tau: {from: 10 ms, to: 10 s}}, minimise: rms(lag - "
                  "truth)}\n" +
                  sought);
  folder.file("trim.yaml", head + "stop: 1 s\n" + lag + "trim: {inputs: {u: 1}}\n");
  folder.file("study.yaml", content_of(STEPWIRE_SOURCE_DIR "/diagrams/examples/88-small-study.yaml"));
}

Call call_of(const Kind& kind) {
  Call call;
  call.arguments = kind.arguments;
  call.arguments.emplace_back("--quiet");
  return call;
}

/// Files of a folder, and those in folders of it, that have no name of their own yet.
std::size_t pieces_in(const Scratch& folder) {
  const auto is_piece = [](const fs::directory_entry& entry) {
    return entry.path().string().find(".part") != std::string::npos;
  };
  return static_cast<std::size_t>(
      std::ranges::count_if(fs::recursive_directory_iterator(folder.path("")), is_piece));
}

/// The target as a call has to find it: of the folder of results none, else a file of before.
void put_former(const Scratch& folder, const Kind& kind) {
  fs::remove_all(folder.path("out"));
  fs::remove(folder.path(".out"));
  if (!kind.in_folder_of_results() && kind.target != ".out") folder.file(kind.target, "former");
}

/// An archive is made of what a run has left, so its line may be a second one; tar does not always give the
/// reason.
void check_refused(const Kind& kind, const Done& done, const std::string& reason) {
  const std::size_t lines = lines_of(done.err).size();
  CHECK(done.code == 3);
  CHECK((lines == 1 || (kind.name == "archive" && lines == 2)));
  CHECK_THAT(done.err, Contains(reason) || Contains("runs.tar: Wrote only "));
}

/// A part of a file is never there under its name. The standard output may have a part, and a journal, of
/// which a later call reads whole records. `size`: of the whole file.
void check_whole_or_former(const Scratch& folder, const Kind& kind, std::size_t size) {
  if (kind.target == ".out" || kind.target.ends_with(".journal")) return;
  const std::string left = content_of(folder.path(kind.target));
  const bool former = kind.in_folder_of_results() ? !fs::exists(folder.path(kind.target)) : left == "former";
  const bool with_another_time =
      left.ends_with("\n") && left.size() + 16 > size;  // in JSON: how long it took
  CHECK((former || left.size() == size || with_another_time));
  CHECK(pieces_in(folder) == 0);
}

/// A file system of 3 MiB in the place of a folder, for this process and those that it starts.
class SmallFileSystem {
 public:
  explicit SmallFileSystem(std::string folder) : folder_(std::move(folder)) {
    mounted_ = ::unshare(CLONE_NEWNS) == 0 &&
               ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
               ::mount("tmpfs", folder_.c_str(), "tmpfs", 0, "size=3m") == 0;
  }
  ~SmallFileSystem() {
    if (mounted_) ::umount2(folder_.c_str(), MNT_DETACH);
  }
  SmallFileSystem(const SmallFileSystem&) = delete;
  SmallFileSystem& operator=(const SmallFileSystem&) = delete;

  bool mounted() const { return mounted_; }
  /// Fills all but `left` bytes, in pages of 4096.
  void fill(std::size_t left) const {
    fs::remove(folder_ + "/fill");
    struct statvfs state {};
    REQUIRE(::statvfs(folder_.c_str(), &state) == 0);
    const std::size_t free = state.f_bavail * state.f_bsize;
    std::ofstream(folder_ + "/fill", std::ios::binary) << std::string(free - std::min(free, left), 'x');
  }

 private:
  std::string folder_;
  bool mounted_ = false;
};

/// Room that is too little: for the list of a folder of results, for one file behind it, for a large one.
std::vector<std::size_t> rooms_for(const Kind& kind) {
  std::vector<std::size_t> rooms{0};
  if (kind.in_folder_of_results()) rooms.push_back(4096);
  if (kind.name.starts_with("large")) rooms.push_back(std::size_t{1} << 20);
  return rooms;
}

/// Sizes of the targets, by the names of their kinds, where the disk takes all.
const std::map<std::string, std::size_t>& whole_sizes() {
  static const std::map<std::string, std::size_t> sizes = [] {
    const Scratch folder;
    write_diagrams(folder);
    std::map<std::string, std::size_t> all;
    for (const Kind& kind : kinds) {
      if (!kind.needs.empty() && stepwire::subprocess::find_program(kind.needs).empty()) continue;
      put_former(folder, kind);
      const Done done = run_program(folder, call_of(kind));
      INFO(kind.name << ": " << done.err);
      CHECK(done.code == 0);
      all[kind.name] = content_of(folder.path(kind.target)).size();
    }
    return all;
  }();
  return sizes;
}

}  // namespace

TEST_CASE("a file that the system does not take ends every call with 3 and a line, and the one before stays",
          "[full]") {
  const Scratch folder;
  write_diagrams(folder);
  for (const Kind& kind : kinds) {
    if (!whole_sizes().contains(kind.name)) continue;
    const std::size_t size = whole_sizes().at(kind.name),
                      least = 200;  // which the line itself has to fit into
    INFO(kind.name);
    REQUIRE(size > least);
    for (const std::size_t limit : {least, size / 4, size / 2, size / 4 * 3, size - 1}) {
      put_former(folder, kind);
      Call limited = call_of(kind);
      limited.max_bytes_of_file = std::max(limit, least);
      const Done refused = run_program(folder, limited);
      INFO(limit << " of " << size << " bytes: " << refused.err);
      check_refused(kind, refused, "File too large");
      check_whole_or_former(folder, kind, size);
    }
  }
}

TEST_CASE("a full file system ends every call with 3 and a line, and the file before stays", "[full]") {
  whole_sizes();  // on another disk
  const Scratch folder, words;
  const SmallFileSystem disk(folder.path(""));
  if (!disk.mounted()) {
    WARN("no file system may be mounted here; nothing was filled");
    return;
  }
  write_diagrams(folder);
  for (const Kind& kind : kinds) {
    if (!whole_sizes().contains(kind.name)) continue;
    for (const std::size_t room : rooms_for(kind)) {
      put_former(folder, kind);
      disk.fill(room);
      Call call = call_of(kind);
      call.err_to = words.path("err");
      Done done = run_program(folder, call);
      done.err = content_of(call.err_to);
      fs::remove(folder.path("fill"));
      INFO(kind.name << " in " << room << " bytes: " << done.err);
      check_refused(kind, done, "No space left on device");
      check_whole_or_former(folder, kind, whole_sizes().at(kind.name));
    }
  }
}
