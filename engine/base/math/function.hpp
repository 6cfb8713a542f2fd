#pragma once

#include <memory>
#include <string>
#include <utility>

namespace stepwire {

/// A number computed from the numbers v[0], v[1], ..., as blocks use it. In the interpreter a Source evaluates
/// it. A block whose struct is a template over this type has a type of its own in generated code, which the
/// compiler inlines; in other blocks the code is behind a pointer.
class Function {
 public:
  using Code = double (*)(const double* v);

  /// Thread-safe evaluator; copies of a function share it.
  class Source {
   public:
    virtual ~Source() = default;
    virtual double operator()(const double* v) const = 0;
    /// Returns the value as a C++ expression over v, a double or a bool.
    virtual std::string cpp() const = 0;
  };

  /// Makes the function that is always 0.
  Function() = default;
  Function(Code code) : code_(code) {}
  explicit Function(std::shared_ptr<const Source> source) : source_(std::move(source)) {}

  double operator()(const double* v) const { return source_ ? (*source_)(v) : code_(v); }
  /// Returns the source; nullptr for compiled code.
  const Source* source() const { return source_.get(); }

 private:
  Code code_ = [](const double*) { return 0.0; };
  std::shared_ptr<const Source> source_;
};

}  // namespace stepwire
