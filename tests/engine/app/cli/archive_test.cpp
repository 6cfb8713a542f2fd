// Runs of former versions, which tests/archive has: each is verified, run anew and compared.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/base/yaml/document.hpp"
#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

namespace fs = std::filesystem;

const fs::path archive = fs::path(STEPWIRE_SOURCE_DIR) / "tests" / "archive";

/// Folders of versions, named by their numbers.
std::vector<fs::path> versions() {
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(archive))
    if (entry.is_directory() && entry.path().filename() != "diagrams") folders.push_back(entry.path());
  return folders;
}

/// A copy of the folder of a version, in which the program may write.
class Copy {
 public:
  explicit Copy(const fs::path& version) : version_(version.filename().string()) {
    fs::copy(version, folder.path("old"), fs::copy_options::recursive);
  }

  /// Returns the signals of a run that reasons.yaml names, and checks that each has a version and a reason.
  std::set<std::string> reasons_of(const std::string& run) const {
    const auto document = stepwire::yaml::read_document((archive / "reasons.yaml").string());
    std::set<std::string> signals;
    for (const stepwire::yaml::Node& item : document.root.find("reasons")->items) {
      for (const char* key : {"of", "run", "signal", "version", "reason"}) REQUIRE(item.find(key));
      if (item.find("of")->text == version_ && item.find("run")->text == run)
        signals.insert(item.find("signal")->text);
    }
    return signals;
  }

  /// Compares an archived run with a new one, and returns the signals whose bits differ.
  std::set<std::string> changed(const std::string& run) const {
    const Done done = run_program(
        folder, {"compare", "old/" + run, "new/" + run, "--absolute", "0", "--relative", "0 %", "--json"});
    INFO(done.out << done.err);
    REQUIRE(done.code <= 1);
    std::set<std::string> signals;
    const auto result = nlohmann::json::parse(done.out);
    for (const auto& signal : result["signals"])
      if (!signal["agrees"]) signals.insert(signal["name"].get<std::string>());
    for (const char* side : {"only_in_a", "only_in_b"})
      for (const auto& name : result[side]) signals.insert(name.get<std::string>());
    return signals;
  }

  Scratch folder;

 private:
  std::string version_;
};

}  // namespace

TEST_CASE("runs of former versions have the same bits today, or a reason for other ones") {
  REQUIRE(!versions().empty());
  for (const fs::path& version : versions()) {
    const Copy copy(version);
    const std::vector<std::vector<std::string>> calls{
        {"run", "old/rig.yaml", "--out", "new/rig", "--files", "h5"},
        {"run", "old/sweep.yaml", "--out", "new/sweep", "--files", "csv"},
        {"fit", "old/fit.yaml", "--out", "new/fit"},
        {"study", "old/study.yaml", "--out", "new/study"}};
    for (const auto& call : calls) {
      const std::string run = call[3].substr(4);
      INFO(version << " " << run);
      const Done again = run_program(copy.folder, call);
      INFO(again.out << again.err);
      REQUIRE(again.code == 0);
      const std::set<std::string> reasons = copy.reasons_of(run);
      const Done verified = run_program(copy.folder, {"verify", "old/" + run});
      INFO(verified.out << verified.err);
      CHECK(verified.code == (reasons.empty() ? 0 : 1));
      if (run != "study") CHECK(copy.changed(run) == reasons);
    }
  }
}

TEST_CASE("results of former versions are read, and the journal of another build is refused in words") {
  for (const fs::path& version : versions()) {
    const Copy copy(version);
    INFO(version);
    const auto fit = nlohmann::json::parse(content_of(copy.folder.path("old/fit/fit.json")));
    CHECK(fit["parameters"][0]["value"].get<double>() == Approx(0.08).epsilon(0.01));
    const auto note = nlohmann::json::parse(content_of(copy.folder.path("old/rig/run.json")));
    CHECK(note["version"].get<std::string>() == version.filename().string());
    CHECK(note["file"] == "rig.yaml");
    const Done journal = run_program(copy.folder, {"collect", "old/share", "--out", "all"});
    CHECK(journal.code == 2);
    CHECK(!journal.err.empty());
  }
}
