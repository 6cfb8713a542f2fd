#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "engine/app/python/python_class.hpp"

namespace stepwire::python {

/// Numbers that a method gives: where they go.
struct Target {
  double* numbers;
  Eigen::Index size;
  const char* name;
  Eigen::Index rows = 0;  ///< of a matrix, whose numbers lie column by column; 0 for a vector
};

/// Numbers that a method is given.
struct Given {
  const double* numbers;
  Eigen::Index size;
  Eigen::Index rows = 0;  ///< as of a target
};

/// An object of a class of Python's with the methods that a run calls. The interpreter lock is held for all
/// of its calls, which return false or null where Python has raised something.
class Instance {
 public:
  /// Makes the object: its parameters are set before its __init__ is called.
  static std::shared_ptr<Instance> make(const PythonClass& of, const Value* parameters);

  /// Says where a method's arguments are and where what it gives goes, for all calls that follow.
  void connect(std::size_t method, std::vector<Given> given, std::vector<Target> targets);
  /// Calls a method and writes what it gives.
  bool call(std::size_t method);

 private:
  /// An argument of several numbers: an array that each call fills anew.
  struct Buffer {
    Held array;
    double* numbers = nullptr;
  };
  struct Bound {
    Held method;
    const char* shown = "";
    std::vector<Given> given{};
    std::vector<Target> targets{};
    std::vector<Buffer> buffers{};
    std::vector<_object*> arguments{};  ///< of the call that is made
  };

  bool bind(const PythonClass& of);
  static bool fill(Bound& bound);

  Held object_;
  std::array<Bound, 3> methods_;
};

/// "ValueError: a negative mass (Drag.outputs, drag.py:12)", of an exception; the lock is held.
std::string text_of(_object* exception);

}  // namespace stepwire::python
