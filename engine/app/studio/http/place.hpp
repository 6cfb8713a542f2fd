#pragma once

#include <cstddef>

namespace stepwire::http {

/// Slot of a limited number; the destructor frees it.
class Place {
 public:
  explicit Place(std::size_t& taken) : taken_(taken) { ++taken_; }
  ~Place() { --taken_; }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

 private:
  std::size_t& taken_;
};

}  // namespace stepwire::http
