/// @file
/// Random inputs are long. `shrinkable` marks a question whose inputs may be replaced by simpler
/// ones, so that a reader who has failed the same test several times sees one that fits the head:
///
///     shrinkable(check, judged, ray, triangle);   // instead of check(ray, triangle)
///
/// `check(inputs...)` asks, with an oracle for any inputs that `judged(inputs...)` accepts: those
/// that the contract allows and for which the right answer is beyond doubt, as when they were made.
#pragma once

#include <cmath>
#include <cstdlib>
#include <limits>
#include <tuple>

#include <support/exercise.hpp>

namespace contact::testing {
namespace shrinking {

/// How often a check is asked for simpler inputs, at most.
inline constexpr int kMaxProbes = 1500;

/// Replaces parts of an input by simpler values, one after the other, and keeps those with which
/// `fails` still holds.
class Shrinker {
 public:
  explicit Shrinker(std::function<bool()> fails) : fails_(std::move(fails)) {}

  /// Whether anything in `part` became simpler.
  template <class T>
  bool simplify(T& part) {
    constexpr Kind kind = kind_of<T>;
    bool simpler = false;
    if constexpr (kind == Kind::boolean) {
      return part && replaced(part, false);
    } else if constexpr (kind == Kind::integer) {
      return simplify_integer(part);
    } else if constexpr (kind == Kind::real) {
      return simplify_real(part);
    } else if constexpr (kind == Kind::text) {
      return shorten(part);
    } else if constexpr (kind == Kind::matrix) {
      simpler = shorten_columns(part);
      if constexpr (std::is_base_of_v<Eigen::MatrixBase<T>, T> && T::ColsAtCompileTime == 1 &&
                    T::RowsAtCompileTime > 1)
        simpler |= turn_to_axis(part);
      for (Eigen::Index i = 0; i < part.size(); ++i) simpler |= simplify_real(part.data()[i]);
    } else if constexpr (kind == Kind::rotation) {
      return !part.coeffs().isApprox(T::Identity().coeffs()) && replaced(part, T::Identity());
    } else if constexpr (kind == Kind::sequence) {
      if constexpr (requires { part.erase(part.begin(), part.end()); }) simpler = shorten(part);
      for (std::size_t i = 0; i < part.size(); ++i) simpler |= simplify_element(part, i);
    } else if constexpr (kind == Kind::optional) {
      if (!part) return false;
      return replaced(part, T{}) || simplify(*part);
    } else if constexpr (kind == Kind::variant) {
      return std::visit([this](auto& held) { return simplify(held); }, part);
    } else if constexpr (kind == Kind::aggregate) {
      for_each_field(part, [&](auto& field) { simpler |= simplify(field); });
    }
    return simpler;
  }

 private:
  std::function<bool()> fails_;

  template <class T>
  bool replaced(T& part, T simpler) {
    std::swap(part, simpler);
    if (fails_()) return true;
    std::swap(part, simpler);
    return false;
  }

  // A vector of bool gives no reference to its elements.
  template <class S>
  bool simplify_element(S& sequence, std::size_t i) {
    if constexpr (std::is_same_v<typename S::value_type, bool>) {
      if (!sequence[i]) return false;
      sequence[i] = false;
      if (fails_()) return true;
      sequence[i] = true;
      return false;
    } else {
      return simplify(sequence[i]);
    }
  }

  // Without a half, a quarter, ..., one of its elements.
  template <class S>
  bool shorten(S& sequence) {
    bool simpler = false;
    for (std::size_t count = sequence.size() / 2 + sequence.size() % 2; count > 0; count /= 2) {
      for (std::size_t at = 0; at + count <= sequence.size();) {
        S shorter = sequence;
        const auto first = shorter.begin() + static_cast<std::ptrdiff_t>(at);
        shorter.erase(first, first + static_cast<std::ptrdiff_t>(count));
        if (replaced(sequence, std::move(shorter)))
          simpler = true;
        else
          at += count;
      }
    }
    return simpler;
  }

  template <class M>
  bool shorten_columns(M& matrix) {
    bool simpler = false;
    if constexpr (M::ColsAtCompileTime == Eigen::Dynamic) {
      for (Eigen::Index at = 0; at < matrix.cols();) {
        const Eigen::Index rest = matrix.cols() - 1 - at;
        M shorter(matrix.rows(), matrix.cols() - 1);
        shorter.leftCols(at) = matrix.leftCols(at);
        shorter.rightCols(rest) = matrix.rightCols(rest);
        if (replaced(matrix, std::move(shorter)))
          simpler = true;
        else
          ++at;
      }
    }
    return simpler;
  }

  // A unit vector stays one.
  template <class V>
  bool turn_to_axis(V& vector) {
    V axis = V::Zero(vector.rows());
    Eigen::Index most = 0;
    vector.cwiseAbs().maxCoeff(&most);
    axis[most] = std::copysign(1.0, vector[most]);
    return !(vector == axis) && (vector != V::Zero(vector.rows())) && replaced(vector, axis);
  }

  template <class I>
  bool simplify_integer(I& x) {
    if (x == std::numeric_limits<I>::min()) return replaced(x, I{0});
    for (const I simpler : {I{0}, I{1}, I(-x), I(x / 2), I(x - 1)}) {
      const bool nearer = std::abs(simpler) < std::abs(x) || (simpler == -x && x < 0);
      if (nearer && replaced(x, simpler)) return true;
    }
    return false;
  }

  bool simplify_real(double& x) {
    if (!std::isfinite(x)) return false;
    for (const double simpler :
         {0.0, 1.0, 2.0, -1.0, -x, std::trunc(x / 2), std::round(x), std::trunc(x), rounded(x, 1),
          rounded(x, 2), rounded(x, 3), rounded(x, 5)}) {
      if (length(simpler) < length(x) && replaced(x, simpler)) return true;
    }
    return false;
  }

  // Shorter in print, or as short and nearer to zero.
  static std::pair<std::size_t, double> length(double x) {
    return {text_of(x).size(), std::abs(x)};
  }

  static double rounded(double x, int digits) {
    return std::strtod(text_of(x, {.digits = digits}).c_str(), nullptr);
  }
};

}  // namespace shrinking

/// Asks `check(inputs...)`. In a closer look that is to find smaller inputs, a wrong answer is
/// asked for again with simpler inputs that `judged` accepts, as long as it is wrong in the same
/// way.
template <class Check, class Judged, Value... Inputs>
void shrinkable(const Check& check, const Judged& judged, const Inputs&... inputs) {
  check(inputs...);
  if (!detail::wants_smaller()) return;
  const std::optional<Failure> first = detail::probe([&] { check(inputs...); });
  if (!first) return;
  std::tuple<Inputs...> smallest(inputs...);
  int probes = 0;
  const auto fails = [&] {
    if (++probes > shrinking::kMaxProbes || !std::apply(judged, std::as_const(smallest)))
      return false;
    std::optional<Failure> found = detail::probe([&] { std::apply(check, smallest); });
    if (!found || found->asked != first->asked || found->stopped != first->stopped ||
        found->misconceptions != first->misconceptions)
      return false;
    detail::found_smaller(*std::move(found));
    return true;
  };
  shrinking::Shrinker shrinker(fails);
  bool simpler = true;
  while (simpler && probes < shrinking::kMaxProbes) {
    simpler = false;
    std::apply([&](auto&... part) { ((simpler |= shrinker.simplify(part)), ...); }, smallest);
  }
}

}  // namespace contact::testing
