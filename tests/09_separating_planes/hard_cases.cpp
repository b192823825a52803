// Recomputes the answers of hard_cases.json and says which method gets which case right.
//
// The question "cases": whether two bodies are disjoint (1), touch (0) or overlap (−1); class (a),
// by fractions of the stored numbers. The question "distance": the distance, or minus the depth;
// class (b), a rational number and one square root. A distance may have an error of 64 u of the
// coordinates' magnitudes. The question "normal": how far a plane that is perpendicular to the
// normal of the signed distance separates the bodies, compared with the distance; class (b).
#include "support/hard_cases.hpp"

#include <algorithm>
#include <cmath>
#include <contact/closest_points.hpp>
#include <contact/gjk.hpp>
#include <contact/proximity.hpp>
#include <contact/signed_distance.hpp>

#include "hard_bodies.hpp"
#include "hard_methods.hpp"
#include "pair_proofs.hpp"

using hard_bodies::are;
using hard_bodies::Case;
using hard_bodies::narrow;
using hard_bodies::with;
using hard_cases::Json;
using hard_cases::unhex;
using Box = contact::OrientedBox<double>;
using Capsule = contact::Capsule<double>;
using V = contact::Vector3<double>;

namespace {

int sign(double x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }
int right_sign(const Json& answer) { return answer.at("case").get<int>(); }
/// Whether a method that only says whether bodies meet is right.
bool agrees(bool meet, const Json& answer) { return meet == (right_sign(answer) <= 0); }

double distance_in_double(const Case& c) {
  return with(c,
              [](const auto& a, const auto& b) { return contact::signed_distance(a, b).distance; });
}
bool are_boxes(const Case& c) { return are<Box, Box>(c); }
bool are_capsules(const Case& c) { return are<Capsule, Capsule>(c); }
bool are_bounded(const Case& c) { return !c.has("b_normal"); }

template <class A, class B, class F>
auto of(const Case& c, const F& f) {
  return f(std::get<A>(hard_bodies::body(c, "a")), std::get<B>(hard_bodies::body(c, "b")));
}

double room_of(const Case& c) {
  return with(c, [](const auto& a, const auto& b) {
    return (hard_bodies::size_of(a) + hard_bodies::size_of(b)) * 0x1p-47;
  });
}
bool close(double got, const Case& c, const Json& answer) {
  return std::abs(got - unhex(answer.at("distance"))) <= room_of(c);
}

void ask_cases(hard_cases::Runner& runner) {
  runner.question("cases", [](const Case& c) {
    return Json{{"class", "a"}, {"case", hard_bodies::exactly(c).sign}};
  });
  runner.method("cases", "float", [](const Case& c, const Json& answer) {
    const double d = with(c, [](const auto& a, const auto& b) {
      return double(contact::signed_distance(narrow(a), narrow(b)).distance);
    });
    return sign(d) == right_sign(answer);
  });
  runner.method("cases", "double", [](const Case& c, const Json& answer) {
    return sign(distance_in_double(c)) == right_sign(answer);
  });
  runner.method("cases", "double, touching within 1e-9", [](const Case& c, const Json& answer) {
    const double d = distance_in_double(c);
    return (std::abs(d) <= 1e-9 ? 0 : sign(d)) == right_sign(answer);
  });
  runner.method("cases", "face normals only", are_boxes, [](const Case& c, const Json& answer) {
    return of<Box, Box>(c, [&](const Box& a, const Box& b) {
      double most = -INFINITY;
      for (int k = 0; k < 6; ++k) {
        most = std::max(most, contact::separation_along<double>(a, b, contact::box_axis(a, b, k)));
      }
      return sign(most) == right_sign(answer);
    });
  });
  runner.method("cases", "axes, 1e-6 added", are_boxes, [](const Case& c, const Json& answer) {
    return agrees(of<Box, Box>(c, hard_methods::meet_with_added_epsilon), answer);
  });
  runner.method("cases", "GJK of tutorials", are_bounded, [](const Case& c, const Json& answer) {
    const bool meet = pair_bodies::with(
        hard_bodies::body(c, "a"), hard_bodies::body(c, "b"),
        [](const auto& a, const auto& b) { return hard_methods::meet_by_tutorial(a, b); });
    return agrees(meet, answer);
  });
  runner.method("cases", "GJK in double", are_bounded, [](const Case& c, const Json& answer) {
    const bool meet = pair_bodies::with(
        hard_bodies::body(c, "a"), hard_bodies::body(c, "b"), [](const auto& a, const auto& b) {
          return contact::gjk(a, b).distance <= contact::radius_of(a) + contact::radius_of(b);
        });
    return agrees(meet, answer);
  });
  runner.method("cases", "book", [](const Case& c, const Json& answer) {
    const auto p = with(c, [](const auto& a, const auto& b) { return contact::proximity(a, b); });
    const int right = right_sign(answer);
    return p == (right == 0  ? contact::Proximity::touching
                 : right > 0 ? contact::Proximity::disjoint
                             : contact::Proximity::overlapping);
  });
}

void ask_distance(hard_cases::Runner& runner) {
  runner.question("distance", [](const Case& c) {
    const oracle::Surd d = hard_bodies::exactly(c).distance.value();
    return Json{{"class", "b"}, {"distance", hard_cases::hex(oracle::nearest(d))}};
  });
  runner.method("distance", "textbook segments", are_capsules,
                [](const Case& c, const Json& answer) {
                  return close(of<Capsule, Capsule>(c, hard_methods::textbook_distance), c, answer);
                });
  runner.method("distance", "textbook axes", are_boxes, [](const Case& c, const Json& answer) {
    const double room = of<Box, Box>(
        c, [](const Box& a, const Box& b) { return hard_methods::textbook_room(a, b, 0); });
    return close(room, c, answer);
  });
  runner.method(
      "distance", "axes longer than 1e-6", are_boxes, [](const Case& c, const Json& answer) {
        const double room = of<Box, Box>(
            c, [](const Box& a, const Box& b) { return hard_methods::textbook_room(a, b, 1e-6); });
        return close(room, c, answer);
      });
  runner.method("distance", "book", [](const Case& c, const Json& answer) {
    return close(distance_in_double(c), c, answer);
  });
}

/// The plane that a normal belongs to must separate the bodies by their distance, or let them
/// overlap by no more than their depth.
bool separates_by(const V& normal, const Case& c, const Json& answer) {
  const double length = normal.norm();
  if (!(std::abs(length - 1) <= 1e-12)) return false;
  const double gap =
      pair_proofs::gap_along(hard_bodies::body(c, "a"), hard_bodies::body(c, "b"), normal);
  return close(gap, c, answer);
}

void ask_normal(hard_cases::Runner& runner) {
  runner.question("normal", [](const Case& c) {
    const oracle::Surd d = hard_bodies::exactly(c).distance.value();
    return Json{{"class", "b"}, {"distance", hard_cases::hex(oracle::nearest(d))}};
  });
  runner.method("normal", "line between closest points", [](const Case& c, const Json& answer) {
    const V between = with(c, []<class A, class B>(const A& a, const B& b) -> V {
      if constexpr (std::is_same_v<A, Capsule> && std::is_same_v<B, Capsule>) {
        const auto near = contact::closest_points<double>(a.core, b.core);
        return near.on_a - near.on_b;
      } else if constexpr (std::is_same_v<A, Capsule> && std::is_same_v<B, Box>) {
        const auto near = contact::closest_points<double>(a.core, b);
        return near.on_a - near.on_b;
      } else {
        return V::Zero();
      }
    });
    return separates_by(V(between.normalized()), c, answer);
  });
  runner.method("normal", "book", [](const Case& c, const Json& answer) {
    const V normal =
        with(c, [](const auto& a, const auto& b) { return contact::signed_distance(a, b).normal; });
    return separates_by(normal, c, answer);
  });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("09_separating_planes");
  ask_cases(runner);
  ask_distance(runner);
  ask_normal(runner);
  return runner.run(argc, argv);
}
