// Are two boxes apart, what does it save to keep the axis that separated them, and how far apart or
// how deep in each other are two bodies? The methods of the chapter on random pairs and on those
// that are hard to decide.
#include <support/ladder.hpp>

#include <09_separating_planes/measured_ladder.hpp>
#include <09_separating_planes/measured_pairs.hpp>
#include <09_separating_planes/pair_families.hpp>
#include <09_separating_planes/random_poses.hpp>
#include <contact/box_axes.hpp>
#include <contact/closed_proximity.hpp>
#include <contact/gjk.hpp>
#include <contact/penetration.hpp>
#include <contact/proximity.hpp>
#include <contact/signed_distance.hpp>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace {

using contact::OrientedBox;
using contact::Proximity;
using pair_families::Family;
using Point = contact::Vector3<double>;
using Box = OrientedBox<double>;
using measured_pairs::in_type;
using measured_pairs::tell;
using Boxes = measured_pairs::Pair<Box, Box>;

ladder::Method rounded(const char* id, const char* title, const char* scalar = "double") {
  return {.id = id, .title = title, .scalar = scalar, .exact = false};
}
/// What is proven never to decide wrongly.
ladder::Method exact(const char* id, const char* title, const char* scalar = "double, then exact") {
  return {.id = id, .title = title, .scalar = scalar, .exact = true};
}

/// Why no figure shows a pair of boxes.
constexpr const char* to_the_last_digit =
    "The figure of the fifteen axes turns boxes by angles, so it cannot show these to the last "
    "digit.";

/// Whether the cores have no common point: exact.
bool are_apart(const Box& a, const Box& b) {
  return measured_pairs::true_distance(a, b).has_value();
}
template <class S>
bool apart_by_gjk(const OrientedBox<S>& a, const OrientedBox<S>& b) {
  return contact::gjk(a, b).distance > S(0);
}
/// Whether an axis separates the boxes: all fifteen in the frame of A, as in most programs.
///
/// Both boxes are taken for orthonormal. ε is added to every |aᵢ · bⱼ|, so that the cross product
/// of almost parallel edges separates nothing.
/// @see Ericson, *Real-Time Collision Detection* (2004), 4.4.1
template <class S>
bool apart_by_axes(const OrientedBox<S>& a, const OrientedBox<S>& b, S epsilon = S(0)) {
  const contact::Matrix3<S> c = a.axes.transpose() * b.axes;
  const contact::Matrix3<S> m = c.cwiseAbs() + contact::Matrix3<S>::Constant(epsilon);
  const contact::Vector3<S> t = a.axes.transpose() * contact::Vector3<S>(b.centre - a.centre);
  const contact::Vector3<S>&g = a.half_lengths, &h = b.half_lengths;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(t(i)) > g(i) + m.row(i).dot(h)) return true;
  }
  for (int k = 0; k < 3; ++k) {
    if (std::abs(c.col(k).dot(t)) > h(k) + m.col(k).dot(g)) return true;
  }
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int k = 0; k < 3; ++k) {
      const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
      const S extents =
          (g(i1) * m(i2, k) + g(i2) * m(i1, k)) + (h(k1) * m(i, k2) + h(k2) * m(i, k1));
      if (std::abs(t(i2) * c(i1, k) - t(i1) * c(i2, k)) > extents) return true;
    }
  }
  return false;
}
/// The same without rounding, for the stored boxes, whatever the angles between their axes.
bool apart_by_exact_axes(const Box& a, const Box& b) {
  const OrientedBox<contact::Exact> first = contact::detail::exact_body(a);
  const OrientedBox<contact::Exact> second = contact::detail::exact_body(b);
  for (int k = 0; k < contact::box_axis_count; ++k) {
    const auto n = contact::box_axis(first, second, k);
    if (contact::separation_along(first, second, n).sign() > 0) return true;
  }
  return false;
}

namespace boxes {

/// The boxes in both types, which are different boxes, and for each whether they are apart.
struct Input {
  explicit Input(Boxes made)
      : boxes(std::move(made)),
        apart(are_apart(boxes.a, boxes.b)),
        apart_in_float(
            are_apart(in_type<double>(boxes.a_in_float), in_type<double>(boxes.b_in_float))) {
    contact::proximity_with_witness(boxes.a, boxes.b, witness);
  }
  Boxes boxes;
  bool apart, apart_in_float;
  contact::SeparatingWitness witness;  ///< of these boxes
};
using Asked = std::shared_ptr<const Input>;

struct Answer {
  bool apart = false;
  bool in_float = false;  ///< whether the method was given the boxes in float
  Asked of = {};          ///< in the true answer
};

ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.wrong = got.apart != (got.in_float ? right.of->apart_in_float : right.of->apart);
  return verdict;
}

ladder::Example shown(const Asked& input, const Answer& got, const Answer&, const ladder::Method&) {
  const auto words = [](bool apart) { return apart ? "apart" : "not apart"; };
  ladder::Example example;
  const auto tell_both = [&example](const auto& a, const auto& b) {
    tell(example, "A", a);
    tell(example, "B", b);
  };
  if (got.in_float) {
    tell_both(input->boxes.a_in_float, input->boxes.b_in_float);
  } else {
    tell_both(input->boxes.a, input->boxes.b);
  }
  example.facts.push_back({"this method", words(got.apart)});
  example.facts.push_back({"exact", words(!got.apart)});
  example.note = to_the_last_digit;
  return example;
}

/// With the axes of the world for A, with half lengths of 1, or with B at the origin.
std::vector<Asked> simpler(const Asked& input) {
  std::vector<Asked> all;
  const Box &a = input->boxes.a, &b = input->boxes.b;
  const auto offer = [&all](const Box& first, const Box& second) {
    all.push_back(std::make_shared<const Input>(Boxes(first, second)));
  };
  const contact::Matrix3<double> world = contact::Matrix3<double>::Identity();
  if (a.axes != world) offer({a.centre, world, a.half_lengths}, b);
  if (b.axes != world) offer(a, {b.centre, world, b.half_lengths});
  if (a.half_lengths != Point::Ones()) offer({a.centre, a.axes, Point::Ones()}, b);
  if (b.half_lengths != Point::Ones()) offer(a, {b.centre, b.axes, Point::Ones()});
  if (b.centre != Point::Zero()) {
    offer({a.centre - b.centre, a.axes, a.half_lengths}, {Point::Zero(), b.axes, b.half_lengths});
  }
  return all;
}

ladder::Ladder<Asked, Answer> experiment() {
  ladder::Ladder<Asked, Answer> ladder(
      "Are two boxes apart?",
      [](const Asked& input) {
        return Answer{false, false, input};
      },
      judge);
  ladder.at_most(4000);
  const auto family = [&ladder](const char* id, const char* title, Family of) {
    ladder.family(id, title, [of](generators::Random& random) {
      return std::make_shared<const Input>(measured_pairs::drawn<Box, Box>(random, of));
    });
  };
  family("box-random", "random", Family::random);
  family("box-near", "near", Family::near);
  family("box-touching", "touching but for an ulp", Family::touching);
  family("box-grid", "whole numbers, touching", Family::grid);
  family("box-parallel", "parallel, touching but for an ulp", Family::parallel);
  family("box-nearly", "nearly parallel", Family::nearly_parallel);
  family("box-thin", "thin, 1:10⁶", Family::thin);
  family("box-large", "large, 10⁸:1", Family::large);

  const auto in_both = [&ladder](const ladder::Method& of_float, const ladder::Method& of_double,
                                 auto method) {
    ladder.method(of_float, [method](const Asked& input) {
      return Answer{method(input->boxes.a_in_float, input->boxes.b_in_float), true};
    });
    ladder.method(of_double, [method](const Asked& input) {
      return Answer{method(input->boxes.a, input->boxes.b)};
    });
  };
  in_both(rounded("axes-float", "fifteen axes", "float"), rounded("axes-double", "fifteen axes"),
          [](const auto& a, const auto& b) { return apart_by_axes(a, b); });
  in_both(rounded("axes-epsilon-float", "fifteen axes, ε = 10⁻⁶", "float"),
          rounded("axes-epsilon-double", "fifteen axes, ε = 10⁻⁶"),
          []<class S>(const OrientedBox<S>& a, const OrientedBox<S>& b) {
            return apart_by_axes(a, b, S(1e-6));
          });
  in_both(rounded("box-gjk-float", "GJK", "float"), rounded("box-gjk-double", "GJK"),
          [](const auto& a, const auto& b) { return apart_by_gjk(a, b); });
  const auto decided = [&ladder](const ladder::Method& about, auto method) {
    ladder.method(about, [method](const Asked& input) {
      return Answer{method(*input, input->boxes.a, input->boxes.b)};
    });
  };
  decided(exact("axes-exact", "fifteen axes, no filter", "exact"),
          [](const Input&, const Box& a, const Box& b) { return apart_by_exact_axes(a, b); });
  decided(exact("box-decided", "fifteen axes, filtered"),
          [](const Input&, const Box& a, const Box& b) {
            return contact::proximity(a, b) == Proximity::disjoint;
          });
  decided(exact("box-witness", "the same, with their own axis kept"),
          [](const Input& input, const Box& a, const Box& b) {
            contact::SeparatingWitness witness = input.witness;
            return contact::proximity_with_witness(a, b, witness) == Proximity::disjoint;
          });
  decided(exact("box-certified", "GJK, with a proof"),
          [](const Input&, const Box& a, const Box& b) {
            return contact::certified_proximity(a, b).state == Proximity::disjoint;
          });
  ladder.recommend("box-decided");
  ladder.show(shown);
  ladder.simplify(simpler);
  return ladder;
}

}  // namespace boxes

namespace steps {

/// Two boxes after a step, and what the step before has left.
struct Input {
  Box a, b;
  contact::SeparatingWitness axis;
  contact::ProximityWitness proof;
  contact::GjkStart<double> simplex;
  bool apart = false;
};
using Asked = std::shared_ptr<const Input>;

/// Two boxes whose bounding spheres meet, as a broad phase leaves them, and that are apart or not.
/// Then A moves by a share of its mean edge, and turns by as many radians.
Asked made(generators::Random& random, double share, bool apart) {
  Input input;
  for (;;) {
    const Boxes drawn = measured_pairs::drawn<Box, Box>(random, Family::random);
    input.a = drawn.a;
    input.b = drawn.b;
    const double radii = input.a.half_lengths.norm() + input.b.half_lengths.norm();
    const bool close = (input.a.centre - input.b.centre).norm() < radii;
    if (close && are_apart(input.a, input.b) == apart) break;
  }
  contact::proximity_with_witness(input.a, input.b, input.axis);
  contact::certified_proximity_with_witness(input.a, input.b, input.proof);
  input.simplex = contact::start_from(contact::gjk(input.a, input.b));
  input.a.centre += random_poses::direction(random) * (2 * share * input.a.half_lengths.mean());
  const Point turn = random_poses::direction(random) * share;
  input.a.axes = contact::matrix_of(contact::exponential<double>(turn)) * input.a.axes;
  input.apart = are_apart(input.a, input.b);
  return std::make_shared<const Input>(input);
}

ladder::Verdict judge(bool got, bool right) {
  ladder::Verdict verdict;
  verdict.wrong = got != right;
  return verdict;
}

ladder::Example shown(const Asked& input, bool got, bool right, const ladder::Method&) {
  ladder::Example example;
  tell(example, "A", input->a);
  tell(example, "B", input->b);
  example.facts.push_back({"this method", got ? "apart" : "not apart"});
  example.facts.push_back({"exact", right ? "apart" : "not apart"});
  example.note = to_the_last_digit;
  return example;
}

ladder::Ladder<Asked, bool> experiment() {
  ladder::Ladder<Asked, bool> ladder(
      "What does a kept axis save?", [](const Asked& input) { return input->apart; }, judge);
  ladder.at_most(4000);
  const auto family = [&ladder](const char* id, const char* title, double share, bool apart) {
    ladder.family(id, title, [share, apart](generators::Random& random) {
      return made(random, share, apart);
    });
  };
  family("step-1000", "apart, then a step of 0.001 of an edge", 0.001, true);
  family("step-100", "apart, then a step of 0.01 of an edge", 0.01, true);
  family("step-10", "apart, then a step of 0.1 of an edge", 0.1, true);
  family("step-1", "apart, then a step of an edge", 1, true);
  family("step-meeting", "not apart, then a step of 0.01 of an edge", 0.01, false);

  const auto method = [&ladder](const ladder::Method& about, auto decide) {
    ladder.method(about, [decide](const Asked& input) { return decide(*input); });
  };
  method(rounded("step-axes", "fifteen axes"),
         [](const Input& input) { return apart_by_axes(input.a, input.b); });
  method(exact("step-fresh", "fifteen axes, filtered"), [](const Input& input) {
    return contact::proximity(input.a, input.b) == Proximity::disjoint;
  });
  method(exact("step-kept", "the same, the last axis first"), [](const Input& input) {
    contact::SeparatingWitness witness = input.axis;
    return contact::proximity_with_witness(input.a, input.b, witness) == Proximity::disjoint;
  });
  method(rounded("step-gjk", "GJK"),
         [](const Input& input) { return apart_by_gjk(input.a, input.b); });
  method(rounded("step-gjk-kept", "GJK from the last simplex"), [](const Input& input) {
    return contact::gjk(input.a, input.b, input.simplex).distance > 0;
  });
  method(exact("step-certified", "GJK, with a proof"), [](const Input& input) {
    return contact::certified_proximity(input.a, input.b).state == Proximity::disjoint;
  });
  method(exact("step-certified-kept", "the last proof first"), [](const Input& input) {
    contact::ProximityWitness witness = input.proof;
    return contact::certified_proximity_with_witness(input.a, input.b, witness).state ==
           Proximity::disjoint;
  });
  ladder.recommend("step-kept");
  ladder.show(shown);
  return ladder;
}

}  // namespace steps

using contact::Capsule;
using contact::Cylinder;
using contact::Ellipsoid;
using contact::Sphere;
using measured_pairs::beyond_cores;
using measured_pairs::Bounds;
using measured_pairs::Found;
using measured_pairs::Measured;
using measured_pairs::Pair;
using measured_pairs::pairs_of;
using Hull = contact::ConvexHull<double>;

constexpr auto signed_distance = []<class A>(const A& a, const auto& b) {
  const auto found = contact::signed_distance(a, b);
  return Found<contact::ScalarOf<A>>{found.distance, found.normal};
};

namespace distances {

auto experiment() {
  Measured<Boxes, Pair<Hull, Hull>, Pair<Sphere<double>, Capsule<double>>,
           Pair<Capsule<double>, Box>, Pair<Cylinder<double>, Box>,
           Pair<Ellipsoid<double>, Ellipsoid<double>>>
      made("How far apart?", 1000);
  /// With `cores`, of bodies that may overlap, but not their cores; otherwise of bodies apart.
  const auto family = [&made](const char* id, const char* title, auto draw, bool cores = false) {
    made.family(id, title, draw, [cores](const auto& a, const auto& b) -> std::optional<Bounds> {
      const std::optional<Bounds> right = measured_pairs::true_distance(a, b);
      return right && (cores || right->low > 0) ? right : std::nullopt;
    });
  };
  family("far-sphere-capsule", "sphere and capsule",
         pairs_of<Sphere<double>, Capsule<double>>(Family::random));
  family("far-capsule-box", "capsule and box", pairs_of<Capsule<double>, Box>(Family::random));
  family("far-cores", "capsule and box, cores closer than 10⁻⁹ m",
         measured_pairs::almost_meeting_cores, true);
  family("far-boxes", "boxes", pairs_of<Box, Box>(Family::random));
  family("far-near-boxes", "boxes, near", pairs_of<Box, Box>(Family::near));
  family("far-hulls", "hulls", pairs_of<Hull, Hull>(Family::random));
  family("far-cylinder-box", "cylinder and box", pairs_of<Cylinder<double>, Box>(Family::random));
  family("far-ellipsoids", "ellipsoids",
         pairs_of<Ellipsoid<double>, Ellipsoid<double>>(Family::random));

  made.in_both(rounded("gjk-points-float", "GJK, from the difference of its points", "float"),
               rounded("gjk-points-double", "GJK, from the difference of its points"),
               []<class A>(const A& a, const auto& b) {
                 const auto near = contact::gjk(a, b);
                 const contact::Vector3<contact::ScalarOf<A>> between = near.on_a - near.on_b;
                 return beyond_cores(a, b, between.norm(), between);
               });
  made.in_both(rounded("gjk-float", "GJK", "float"), rounded("gjk-double", "GJK"),
               [](const auto& a, const auto& b) {
                 const auto near = contact::gjk(a, b);
                 return beyond_cores(a, b, near.distance, near.between);
               });
  made.in_both(rounded("distance-float", "closed forms, else GJK", "float"),
               rounded("distance-double", "closed forms, else GJK"), signed_distance);
  // Of bodies that overlap it proves just that.
  made.in_double(exact("distance-certified", "GJK, with a proof"),
                 [](const auto& a, const auto& b) {
                   const contact::CertifiedProximity found = contact::certified_proximity(a, b);
                   const bool known = found.state == Proximity::disjoint;
                   const double middle = (found.low + found.high) / 2;
                   return Found<double>{known ? middle : std::nan(""), found.plane.normal};
                 });
  made.ladder.recommend("gjk-double");
  return made.ladder;
}

}  // namespace distances

namespace depths {

/// Less is not asked about: the rounded truth would be in doubt, m.
constexpr double min_depth = 1e-13;

auto experiment() {
  Measured<Boxes, Pair<Box, Hull>, Pair<Hull, Hull>> made("How deep?", 500);
  const auto family = [&made](const char* id, const char* title, auto draw) {
    made.family(id, title, draw, [](const auto& a, const auto& b) -> std::optional<Bounds> {
      const double right = measured_pairs::by_features(a, b).separation;
      if (!(right < -min_depth)) return std::nullopt;
      return Bounds{right, right};
    });
  };
  family("deep-boxes", "boxes", pairs_of<Box, Box>(Family::deep));
  family("deep-near", "boxes that hardly overlap", pairs_of<Box, Box>(Family::near));
  family("deep-parallel", "nearly parallel boxes", pairs_of<Box, Box>(Family::nearly_parallel));
  family("deep-thin", "thin boxes, 1:10⁶", pairs_of<Box, Box>(Family::thin));
  family("deep-box-hull", "box and hull", pairs_of<Box, Hull>(Family::deep));
  family("deep-hulls", "hulls", pairs_of<Hull, Hull>(Family::deep));

  made.in_double(rounded("depth-centres", "along the line of centres"),
                 [](const auto& a, const auto& b) {
                   const Point n = contact::inner_point(a) - contact::inner_point(b);
                   return Found<double>{measured_pairs::separation(a, b, n) / n.norm(), n};
                 });
  made.in_double(rounded("depth-faces", "faces only"), [](const auto& a, const auto& b) {
    const auto found = measured_pairs::by_features(a, b, false);
    return Found<double>{found.separation, found.normal};
  });
  made.in_double(rounded("depth-features", "faces and pairs of edges"),
                 [](const auto& a, const auto& b) {
                   const auto found = measured_pairs::by_features(a, b);
                   return Found<double>{found.separation, found.normal};
                 });
  made.in_both(rounded("epa-float", "EPA", "float"), rounded("epa-double", "EPA"),
               [](const auto& a, const auto& b) {
                 const auto found = contact::penetration(a, b);
                 return beyond_cores(a, b, -found.depth, found.normal);
               });
  made.in_both(rounded("depth-float", "fifteen axes of boxes, else EPA", "float"),
               rounded("depth-double", "fifteen axes of boxes, else EPA"), signed_distance);
  made.ladder.recommend("depth-double");
  return made.ladder;
}

}  // namespace depths

ladder::Parts experiment() {
  ladder::Parts parts("Convex bodies: apart or not, and how far?");
  parts.add(boxes::experiment());
  parts.add(steps::experiment());
  parts.add(distances::experiment());
  parts.add(depths::experiment());
  return parts;
}

}  // namespace

LADDER(experiment)
