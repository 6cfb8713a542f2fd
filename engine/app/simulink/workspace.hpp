#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/app/simulink/model.hpp"
#include "engine/app/simulink/value.hpp"

namespace stepwire::simulink {

/// Variables of a model: those that its callbacks set, and those without a value in the file.
class Workspace {
 public:
  /// Evaluates the assignments in PreLoadFcn, PostLoadFcn and InitFcn of a model. `notes` gets a sentence for
  /// each statement that is not one.
  Workspace(const Model& model, std::vector<std::string>& notes);

  bool has(const std::string& name) const { return variables_.contains(name); }
  /// Returns a variable as a formula of its parameter. A name without a value becomes a missing variable.
  Value find(const std::string& name);

  /// A variable as a parameter of a diagram.
  struct Variable {
    std::string written;          ///< name of the parameter
    Value value;                  ///< with formulas of other variables
    std::set<std::string> reads;  ///< variables in its formulas
    bool is_plain = false;        ///< set more than once: others use its number
  };
  const Variable& variable(const std::string& name) const { return variables_.at(name); }
  /// Returns the names and those of the variables in their formulas, sorted.
  std::set<std::string> with_read(const std::set<std::string>& names) const;

 private:
  void run(const std::string& script, const std::string& callback, std::vector<std::string>& notes);
  void assign(const std::string& name, const std::string& expression, const std::string& callback,
              std::vector<std::string>& notes);
  std::string free_name(const std::string& name);

  std::map<std::string, Variable> variables_;
  std::map<std::string, int> counts_;  ///< assignments to each name, of all callbacks
  std::set<std::string> written_;
};

}  // namespace stepwire::simulink
