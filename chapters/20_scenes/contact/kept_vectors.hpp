/// @file
/// Many vectors of which only the coordinates are kept that may change.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <contact/vector.hpp>

namespace contact {

/// Which coordinates of a run change: all three, two in a plane, or one on a line.
struct KeptAxes {
  std::array<int, 3> axes{0, 1, 2};  ///< the first `count` are kept
  std::size_t count = 3;             ///< 1, 2 or 3
  std::array<bool, 3> held{};        ///< of those kept, which stay as they were put in
};

// [kept-vectors]
/// A vector for each body, with only the coordinates that change: a body on a line has one number.
class KeptVectors {
 public:
  KeptVectors() = default;
  /// @param kept of every vector
  explicit KeptVectors(const KeptAxes& kept) : kept_(kept) {}

  /// The vector with that index; what is not kept is 0.
  Vector3<double> operator[](std::size_t i) const { return over(i, Vector3<double>::Zero()); }

  /// The vector with that index; what is not kept is as in `rest`.
  Vector3<double> over(std::size_t i, Vector3<double> rest) const {
    const double* from = numbers_.data() + i * kept_.count;
    for (std::size_t k = 0; k < kept_.count; ++k) rest(kept_.axes[k]) = from[k];
    return rest;
  }

  /// Puts a vector there; of coordinates that are not kept nothing is seen again.
  void set(std::size_t i, const Vector3<double>& v) {
    double* to = numbers_.data() + i * kept_.count;
    for (std::size_t k = 0; k < kept_.count; ++k)
      if (!kept_.held[k]) to[k] = v(kept_.axes[k]);
  }

  /// Adds to the vector with that index.
  void add(std::size_t i, const Vector3<double>& v) {
    double* to = numbers_.data() + i * kept_.count;
    for (std::size_t k = 0; k < kept_.count; ++k)
      if (!kept_.held[k]) to[k] += v(kept_.axes[k]);
  }

  /// One more, at the end.
  void push_back(const Vector3<double>& v) {
    for (std::size_t k = 0; k < kept_.count; ++k) numbers_.push_back(v(kept_.axes[k]));
  }

  /// How many there are.
  std::size_t size() const { return numbers_.size() / kept_.count; }
  /// Of memory, its spare room included.
  std::size_t bytes() const { return numbers_.capacity() * sizeof(double); }

 private:
  KeptAxes kept_;
  std::vector<double> numbers_;
};
// [/kept-vectors]

}  // namespace contact
