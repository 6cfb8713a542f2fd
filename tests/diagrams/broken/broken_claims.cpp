// Applies the changes that the files of this folder list, and checks that the named claims then fail, and
// hold without the change; with --as-they-are the latter alone.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/base/io/file.hpp"
#include "engine/base/yaml/error.hpp"
#include "tests/diagrams/broken/changes.hpp"
#include "tests/diagrams/broken/pictures.hpp"
#include "tests/diagrams/broken/runner.hpp"

using namespace stepwire;
namespace fs = std::filesystem;

namespace {

/// A copy of the diagrams in which texts may be replaced.
class Copy {
 public:
  Copy() : folder_(fs::temp_directory_path() / fmt::format("stepwire-broken-{}", ::getpid())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    for (const char* folder : {"thesis", "examples", "parts"})
      fs::copy(fs::path(STEPWIRE_SOURCE_DIR) / "diagrams" / folder, folder_ / folder,
               fs::copy_options::recursive);
  }
  ~Copy() { fs::remove_all(folder_); }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;

  /// `name` begins with a folder, as "thesis/".
  std::string file(const std::string& name) const { return folder_ / name; }

  /// Replaces texts, each of which occurs once.
  void replace(const std::string& file, const broken::Texts& replaced) const {
    std::string text = io::read_file(file);
    for (const auto& [old, other] : replaced) {
      const std::size_t at = text.find(old);
      if (at == std::string::npos) throw std::runtime_error(fmt::format("'{}' is not in {}", old, file));
      if (text.find(old, at + 1) != std::string::npos)
        throw std::runtime_error(fmt::format("'{}' is in {} more than once", old, file));
      text.replace(at, old.size(), other);
    }
    io::write_file(file, text);
  }

 private:
  fs::path folder_;
};

bool is_statement(const claim::Verdict& verdict) {
  return verdict.kind == claim::Claim::Kind::statement;
}

/// Returns a setting that doubles a parameter; an empty text if the parameter is 0 or no number.
std::string doubled(const diagram::DiagramParameter& parameter) {
  const std::string& text = parameter.text;
  if (const double* number = std::get_if<double>(&parameter.value.content))
    return *number == 0.0 ? "" : fmt::format("= 2*({})", text.starts_with("=") ? text.substr(1) : text);
  const bool formula =
      text.find_first_of("+-*/(") != std::string::npos && text.find('[') == std::string::npos;
  return formula && !parameter.text.starts_with("\"") ? fmt::format("2*({})", text) : "";
}

using Verdicts = std::vector<claim::Verdict>;

template <class T>
std::vector<T> joined(std::vector<T> first, const std::vector<T>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// One diagram with its changes; prints what is not as it should be.
class Check {
 public:
  Check(broken::Runner& runner, const std::string& file)
      : runner_(runner), broken_(broken::read_broken(file)) {
    const std::string stem = fs::path(file).stem().string() + "-";
    for (const char* folder : {"thesis", "examples"})
      for (const auto& entry : fs::directory_iterator(copy_.file(folder)))
        if (entry.path().extension() == ".yaml" && entry.path().filename().string().starts_with(stem))
          name_ = folder / entry.path().filename();
    if (name_.empty())
      throw std::runtime_error(fmt::format("no diagram file of thesis or examples begins with {}", stem));
    copy_.replace(copy_.file(name_), broken_.always);
  }

  /// The number of faults found; without changes, of the claims as they are.
  int run(bool changes) {
    as_it_is();
    if (!changes) {
      fmt::print("{}: {} claims\n", name_, claims_);
      return faults_;
    }
    change_pictures();
    for (const broken::Change& change : broken_.changes) {
      try {
        try_change(change);
      } catch (const std::exception& error) {
        fault(fmt::format("{}: {}", change.what, error.what()));
      }
    }
    for (const std::string& claim : unbroken_) fault(fmt::format("no change breaks the claim '{}'", claim));
    if (!runner_.takes_long()) double_parameters();
    fmt::print(
        "{}: {} claims, {} changes, {} parameters doubled, {} of them without effect, {} wrong pictures, {} "
        "of "
        "them seen: {}\n",
        name_, claims_, broken_.changes.size(), doubled_, broken_.unmoved.size(), pictures_, seen_,
        faults_ == 0 ? "ok" : fmt::format("{} faults", faults_));
    return faults_;
  }

 private:
  void fault(const std::string& text) {
    ++faults_;
    fmt::print("{}: {}\n", name_, text);
    std::fflush(stdout);
  }

  void as_it_is() {
    cuts_[{}] = runner_.verdicts(copy_.file(name_), {});
    for (const claim::Verdict& verdict : cuts_[{}]) {
      if (verdict.fails()) fault(fmt::format("fails as it is: {} ({})", verdict.that, verdict.shown));
      if (!is_statement(verdict)) continue;
      ++claims_;
      if (verdict.disagrees.empty()) unbroken_.insert(verdict.that);
    }
    parameters_ = runner_.model().job.plan.diagram.parameters;
    std::erase_if(parameters_, [&](const diagram::DiagramParameter& one) {
      return runner_.sweeps(one.name) || one.name.find('.') != std::string::npos;  // that of a part
    });
  }

  /// Draws each wrong picture of the run that was made.
  void change_pictures() {
    std::set<std::string> names;
    for (const broken::PictureChange& change : broken::picture_changes(runner_.model(), runner_.outcome()))
      if (const auto drawn = try_picture(change)) {
        names.insert(change.what);
        ++pictures_;
        judge_picture(change, *drawn);
      }
    for (const auto& [name, why] : broken_.unseen)
      if (!names.contains(name)) fault(fmt::format("unseen: there is no change '{}'", name));
    const std::size_t most = std::max<std::size_t>(pictures_ / 10, 2);
    if (pictures_ - seen_ > most)
      fault(fmt::format("{} of {} wrong pictures break no claim, more than {}", pictures_ - seen_, pictures_,
                        most));
  }

  struct DrawnChange {
    const broken::ChangedSection& section;
    bool breaks;
  };

  /// Returns nullopt where the file refuses it, or the picture is as it was.
  std::optional<DrawnChange> try_picture(const broken::PictureChange& change) {
    for (const broken::ChangedSection& section : change.sections) try {
        bool breaks = false;
        for (const claim::Verdict& verdict : runner_.verdicts_with(section.figure)) {
          breaks = breaks || verdict.fails();
          if (is_statement(verdict) && !verdict.holds) unbroken_.erase(verdict.that);
        }
        breaks = breaks || (change.of_text && runner_.has_wrong_texts(section.figure));
        if (!breaks && same_picture(change, section)) continue;
        return DrawnChange{section, breaks};
      } catch (const yaml::Error&) {
      }
    return std::nullopt;
  }

  bool same_picture(const broken::PictureChange& change, const broken::ChangedSection& section) {
    return runner_.picture_with(section.figure, change.picture) ==
           runner_.picture_with(runner_.model().job.plan.diagram.figure, change.picture);
  }

  void judge_picture(const broken::PictureChange& change, const DrawnChange& drawn) {
    const bool listed = broken::Broken::lists(broken_.unseen, change.what);
    const std::string with = drawn.section.with.empty() ? "" : fmt::format(" by {}", drawn.section.with);
    if (drawn.breaks) ++seen_;
    if (!drawn.breaks && !listed) fault(fmt::format("{}{} breaks no claim", change.what, with));
    if (drawn.breaks && listed)
      fault(fmt::format("{}{} breaks a claim; take it out of 'unseen'", change.what, with));
  }

  void try_change(const broken::Change& change) {
    const Verdicts& without = verdicts_without(change);
    const Verdicts with = verdicts_of(change.in, joined(change.cut.replaced, change.replaced),
                                      joined(change.cut.settings, change.settings));
    for (const std::string& words : change.fails) expect_failure(change, words, without, with);
  }

  /// The verdicts with the cut of a change alone; made once for each cut.
  const Verdicts& verdicts_without(const broken::Change& change) {
    std::string key;
    for (const auto& [old, other] : change.cut.replaced)
      key += fmt::format("{}: {} -> {}\n", change.in, old, other);
    for (const diagram::Setting& setting : change.cut.settings)
      key += fmt::format("{} = {}\n", setting.name, setting.value);
    if (const auto known = cuts_.find(key); known != cuts_.end()) return known->second;
    return cuts_[key] = verdicts_of(change.in, change.cut.replaced, change.cut.settings);
  }

  /// The verdicts after texts are replaced in the file `in` beside the diagram (empty: in the diagram
  /// itself).
  Verdicts verdicts_of(const std::string& in, const broken::Texts& replaced,
                       const std::vector<diagram::Setting>& settings) {
    const std::string changed =
        in.empty() ? copy_.file(name_)
                   : (fs::path(copy_.file(name_)).parent_path() / in).lexically_normal().string();
    const std::string original = io::read_file(changed);
    try {
      copy_.replace(changed, replaced);
      Verdicts verdicts = runner_.verdicts(copy_.file(name_), settings);
      io::write_file(changed, original);
      return verdicts;
    } catch (...) {
      io::write_file(changed, original);
      throw;
    }
  }

  void expect_failure(const broken::Change& change, const std::string& words, const Verdicts& without,
                      const Verdicts& with) {
    const claim::Verdict* before = named(change, words, without);
    const claim::Verdict* after = named(change, words, with);
    if (!before || !after) return;
    if (!before->holds)
      return fault(fmt::format("{}: fails without the change, too: {}: {} ({})", change.what, before->that,
                               before->shown, before->check));
    if (after->holds)
      fault(fmt::format("{}: holds all the same: {}: {} ({})", change.what, after->that, after->shown,
                        after->check));
    unbroken_.erase(after->that);
  }

  /// Returns the one claim that begins with these words; nullptr, and a fault, if there is another number.
  const claim::Verdict* named(const broken::Change& change, const std::string& words,
                              const Verdicts& verdicts) {
    const auto begins = [&](const claim::Verdict& verdict) {
      return is_statement(verdict) && verdict.that.starts_with(words);
    };
    const auto count = std::ranges::count_if(verdicts, begins);
    if (count == 1) return &*std::ranges::find_if(verdicts, begins);
    fault(fmt::format("{}: {} claims begin with '{}'", change.what, count, words));
    return nullptr;
  }

  void double_parameters() {
    const auto parameters = parameters_;
    for (const diagram::DiagramParameter& parameter : parameters) {
      const std::string value = doubled(parameter);
      if (value.empty()) continue;
      ++doubled_;
      const bool listed = broken::Broken::lists(broken_.unmoved, parameter.name);
      const bool breaks = breaks_a_claim({parameter.name, value});
      if (!breaks && !listed) fault(fmt::format("doubling '{}' breaks no claim", parameter.name));
      if (breaks && listed)
        fault(fmt::format("doubling '{}' breaks a claim; take it out of 'unmoved'", parameter.name));
    }
    for (const auto& [name, why] : broken_.unmoved)
      if (std::ranges::none_of(parameters,
                               [&](const diagram::DiagramParameter& one) { return one.name == name; }))
        fault(fmt::format("unmoved: there is no parameter '{}' that can be doubled", name));
  }

  /// True if a claim fails, the value is refused, or the run ends with an Error.
  bool breaks_a_claim(const diagram::Setting& setting) {
    try {
      return std::ranges::any_of(runner_.verdicts(copy_.file(name_), {setting}), &claim::Verdict::fails);
    } catch (const yaml::Error&) {
      return true;
    }
  }

  broken::Runner& runner_;
  broken::Broken broken_;
  Copy copy_;
  std::string name_;  // with its folder
  std::vector<diagram::DiagramParameter> parameters_;
  std::set<std::string> unbroken_;
  std::map<std::string, Verdicts> cuts_;  // by the texts and settings of a cut; empty: the diagram as it is
  std::size_t claims_ = 0, doubled_ = 0, pictures_ = 0, seen_ = 0;
  int faults_ = 0;
};

}  // namespace

int main(int count, char** arguments) {
  broken::Runner runner;
  int faults = 0;
  const bool changes = count <= 1 || std::string(arguments[1]) != "--as-they-are";
  for (int i = changes ? 1 : 2; i < count; ++i) {
    try {
      faults += Check(runner, arguments[i]).run(changes);
    } catch (const std::exception& error) {
      fmt::print("{}: {}\n", arguments[i], error.what());
      ++faults;
    }
  }
  return faults == 0 ? 0 : 1;
}
