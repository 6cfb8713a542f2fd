#pragma once

#include <exception>
#include <string>
#include <vector>

#include "engine/base/yaml/message.hpp"
#include "engine/base/yaml/place.hpp"

namespace stepwire::yaml {

/// One fault in a user's file: its location, the block and port, the problem and the cure.
struct Fault {
  Place place;
  std::string subject;  ///< block and port, "lag.tau" or "lag"; may be empty
  Message message;
  std::vector<Place> used_by;  ///< innermost first: the lines that use the part with the fault

  /// Returns "file:line:col: subject: message", with "(used by file:line:col)" for each user.
  std::string text() const;
};

/// Exception for invalid user input; carries all faults of one pass, in order of location.
class Error : public std::exception {
 public:
  explicit Error(Fault fault);
  explicit Error(std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return faults_; }
  /// Returns all faults, one line each.
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::vector<Fault> faults_;
  std::string text_;
};

/// Collects the faults of one pass, so that the user sees all of them at once.
class Faults {
 public:
  /// Adds a fault. Throws Error with the faults so far once there are too many to read.
  void add(Fault fault);
  bool empty() const { return faults_.empty(); }
  std::size_t size() const { return faults_.size(); }
  /// Throws Error with all faults if there are any.
  void throw_if_any() const;
  const std::vector<Fault>& list() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// Returns "did you mean 'tau'?" with the nearest of `names` as the cure; an empty message if none is near.
Message did_you_mean(const std::string& word, const std::vector<std::string>& names);
/// Returns the same followed by `sentence`: "; did you mean 'tau'? (sentence)", or ". (sentence)" if none is
/// near.
Message did_you_mean(const std::string& word, const std::vector<std::string>& names,
                     const std::string& sentence);

/// Returns a suggestion followed by all names, as in "Recorded are: rig.x, rig.v" for what = "recorded are";
/// long lists are truncated.
Message nearest_or_all(const std::string& word, const std::vector<std::string>& names, std::string what);
/// Returns the message about a key that `owner` does not have, with a suggestion and the known keys: "a claim
/// has no 'finl'; did you mean 'final'? (known keys)". A key that looks like a piece of a broken expression
/// gets a message of its own.
Message unknown_key(const std::string& key, const std::vector<std::string>& known, const std::string& owner);

}  // namespace stepwire::yaml
