#pragma once

#include <exception>
#include <string>
#include <vector>

#include "engine/base/yaml/message.hpp"
#include "engine/base/yaml/place.hpp"

namespace stepwire::yaml {

/// One thing that is wrong in what a user wrote: where, in which block and port, what is wrong and what would
/// be right.
struct Fault {
  Place place;
  std::string subject;  ///< "lag.tau", "lag", or empty
  Message message;
  std::vector<Place> used_by;  ///< innermost first: the lines that used the part in which the fault lies

  /// "file:line:col: subject: message", with "(used by file:line:col)" for each user.
  std::string text() const;
};

/// The one exception for what a user wrote; carries everything that one pass found, in order of place.
class Error : public std::exception {
 public:
  explicit Error(Fault fault);
  explicit Error(std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return faults_; }
  /// All faults, one line each.
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::vector<Fault> faults_;
  std::string text_;
};

/// Gathers faults of one pass, so that a user sees all of them at once.
class Faults {
 public:
  /// Throws Error with what there is where one more would be too many to read.
  void add(Fault fault);
  bool empty() const { return faults_.empty(); }
  std::size_t size() const { return faults_.size(); }
  /// Throws Error with all faults if there are any.
  void throw_if_any() const;
  const std::vector<Fault>& list() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// "did you mean 'tau'?" as the cure for the nearest of `names`, or nothing if none is near.
Message did_you_mean(const std::string& word, const std::vector<std::string>& names);
/// The same, and a sentence behind it: "; did you mean 'tau'? It has: tau, u", or ". It has: tau, u" if none
/// is near.
Message did_you_mean(const std::string& word, const std::vector<std::string>& names,
                     const std::string& sentence);

/// "; did you mean 'rig.x'? Recorded are: rig.x, rig.v" for what = "recorded are"; of many names the first
/// ones.
Message nearest_or_all(const std::string& word, const std::vector<std::string>& names, std::string what);
/// What is wrong with a key that `owner` does not have: "a claim has no 'finl'; did you mean 'final'? It has:
/// ..", or that it looks like a piece of a broken expression.
Message unknown_key(const std::string& key, const std::vector<std::string>& known, const std::string& owner);

}  // namespace stepwire::yaml
