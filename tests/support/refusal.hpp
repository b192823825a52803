#pragma once

// What a function says of an argument that it does not take.

#include <functional>
#include <stdexcept>
#include <string>

namespace support {

/// The words of the std::invalid_argument that `call` throws; none if it throws nothing.
inline std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace support
