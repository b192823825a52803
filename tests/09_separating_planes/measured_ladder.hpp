/// @file
/// A ladder whose answers are a signed distance and a normal of two bodies of any kinds.
#pragma once

#include <support/ladder.hpp>

#include <array>
#include <cmath>
#include <contact/oriented_box.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <memory>
#include <string>
#include <variant>

#include "measured_pairs.hpp"
#include "pair_bodies.hpp"
#include "pair_families.hpp"

namespace measured_pairs {

template <class S>
struct Found {
  S distance;  ///< signed, m
  contact::Vector3<S> normal;
};

/// The stored numbers of a body as facts.
template <contact::ConvexBody Body>
void tell(ladder::Example& example, const std::string& name, const Body& body) {
  const auto add = [&](const std::string& what, const auto& numbers) {
    example.facts.push_back(ladder::numbers(name + ", " + what, numbers));
  };
  if constexpr (requires { body.core; }) {
    add("start", body.core.start);
    add("end", body.core.end);
  } else if constexpr (requires { body.vertices; }) {
    for (std::size_t i = 0; i < body.vertices.size(); ++i) {
      add("vertex " + std::to_string(i), body.vertices[i]);
    }
  } else {
    add("centre", body.centre);
  }
  if constexpr (requires { body.axes; }) {
    for (int i = 0; i < 3; ++i) {
      add("axis " + std::to_string(i), body.axes.col(i));
    }
    add("half lengths", body.half_lengths);
  }
  if constexpr (requires { body.radius; }) add("radius", std::array{body.radius});
}

/// A ladder of which each input is one of these pairs.
template <class... Pairs>
struct Measured {
  /// Two bodies, in both types, and their true distance or depth in each.
  struct Input {
    std::variant<Pairs...> bodies;
    Bounds right, right_in_float;
  };
  using Asked = std::shared_ptr<const Input>;
  struct Answer {
    double distance = 0;  ///< signed, m
    V normal = V::Zero();
    bool in_float = false;  ///< whether the method was given the bodies in float
    Asked of = {};          ///< in the true answer
  };
  ladder::Ladder<Asked, Answer> ladder;

  Measured(const char* question, std::size_t most)
      : ladder(
            question,
            [](const Asked& input) {
              return Answer{0, V::Zero(), false, input};
            },
            judge) {
    ladder.at_most(most);
    ladder.show(shown);
  }

  /// Wrong is an answer with the wrong sign; NaN is no answer. The error is in m.
  static ladder::Verdict judge(const Answer& got, const Answer& right) {
    const Bounds& bounds = got.in_float ? right.of->right_in_float : right.of->right;
    ladder::Verdict verdict;
    verdict.undecided = std::isnan(got.distance);
    if (verdict.undecided) return verdict;
    verdict.wrong = !(bounds.low > 0 ? got.distance > 0 : got.distance < 0);
    const double error = std::visit(
        [&](const auto& pair) {
          const auto of = [&](const auto& a, const auto& b) {
            return error_of(a, b, bounds, got.distance, got.normal);
          };
          return got.in_float
                     ? of(in_type<double>(pair.a_in_float), in_type<double>(pair.b_in_float))
                     : of(pair.a, pair.b);
        },
        right.of->bodies);
    if (std::isfinite(error)) verdict.error = error;
    return verdict;
  }

  static ladder::Example shown(const Asked& input, const Answer& got, const Answer&,
                               const ladder::Method&) {
    ladder::Example example;
    const auto tell_both = [&example]<class A, class B>(const A& a, const B& b) {
      const auto kind = []<class Body>(const Body& body) {
        return std::string(pair_bodies::name(pair_bodies::kind_of(in_type<double>(body))));
      };
      example.facts.push_back({"A and B", kind(a) + " and " + kind(b)});
      tell(example, "A", a);
      tell(example, "B", b);
    };
    std::visit(
        [&](const auto& pair) {
          got.in_float ? tell_both(pair.a_in_float, pair.b_in_float) : tell_both(pair.a, pair.b);
        },
        input->bodies);
    const Bounds& right = got.in_float ? input->right_in_float : input->right;
    example.facts.push_back(ladder::number("distance, this method, m", got.distance));
    example.facts.push_back(ladder::numbers("normal, this method", got.normal));
    example.facts.push_back(
        ladder::numbers("distance between, m", std::array{right.low, right.high}));
    example.note = "No figure of the chapter shows these bodies.";
    return example;
  }

  /// Adds a family: draws until `right` knows the answer in both types.
  /// @param right bounds of the signed distance of two bodies; nothing for those that are not asked
  /// about
  template <class Draw, class Right>
  void family(const char* id, const char* title, Draw draw, Right right) {
    ladder.family(
        id, title,
        [draw, right](generators::Random& random) -> Asked {
          for (;;) {
            const auto pair = draw(random);
            const auto bounds = right(pair.a, pair.b);
            if (!bounds) continue;
            const auto in_float =
                right(in_type<double>(pair.a_in_float), in_type<double>(pair.b_in_float));
            if (!in_float) continue;
            return std::make_shared<const Input>(Input{pair, *bounds, *in_float});
          }
        },
        true);
  }

  /// Adds a method that takes bodies in double.
  template <class Call>
  void in_double(const ladder::Method& about, Call call) {
    ladder.method(about, [call](const Asked& input) {
      return std::visit(
          [&call](const auto& pair) {
            const Found<double> found = call(pair.a, pair.b);
            return Answer{found.distance, found.normal};
          },
          input->bodies);
    });
  }
  /// Adds a method in both types.
  template <class Call>
  void in_both(const ladder::Method& of_float, const ladder::Method& of_double, Call call) {
    ladder.method(of_float, [call](const Asked& input) {
      return std::visit(
          [&call](const auto& pair) {
            const Found<float> found = call(pair.a_in_float, pair.b_in_float);
            return Answer{found.distance, found.normal.template cast<double>(), true};
          },
          input->bodies);
    });
    in_double(of_double, call);
  }
};

/// Pairs of a family of pair_families.hpp.
template <class A, class B>
auto pairs_of(pair_families::Family family) {
  return [family](generators::Random& random) { return drawn<A, B>(random, family); };
}

/// The distance of two cores and its direction as an answer about the bodies.
template <class S>
Found<S> beyond_cores(const auto& a, const auto& b, S distance, const contact::Vector3<S>& normal) {
  return {distance - (contact::radius_of(a) + contact::radius_of(b)), normal};
}

}  // namespace measured_pairs
