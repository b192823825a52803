// The cost of a body's orientation some seconds after an impulse. Two choices: how its inertia is
// handled, in the impact and in flight, and how its orientation is integrated.
#include <support/ladder.hpp>

#include <numbers>
#include <string>

#include <contact/quaternion.hpp>
#include <contact/rigid_body.hpp>
#include <contact/rotation.hpp>

namespace {

template <class S>
using V = contact::Vector3<S>;
template <class S>
using M = contact::Matrix3<S>;

constexpr int steps_a_second = 64;

/// A body at rest with an axis of symmetry, and the impulse on it. In double and in float.
template <class S>
struct Hit {
  S transverse, along;           // moments, kg·m²
  contact::Quaternion<S> start;  // orientation; its axis of symmetry is its own z
  V<S> momentum;                 // r × J, kg·m²/s
  M<S> tensor;                   // in its own axes that are not the principal ones
  M<S> frame;                    // those axes in world coordinates, initially
  int steps = 0;                 // of 1/64 s

  S step() const { return S(1) / S(steps_a_second); }
};

struct Input {
  Hit<double> in_double;
  Hit<float> in_float;
};

/// The orientation at the end.
struct Answer {
  bool of_floats = false;
  M<double> in_double, in_float;
};

template <class To>
Hit<To> convert(const Hit<double>& h) {
  return {static_cast<To>(h.transverse),
          static_cast<To>(h.along),
          contact::normalised<To>({static_cast<To>(h.start.w), h.start.v.cast<To>()}),
          h.momentum.cast<To>(),
          h.tensor.cast<To>(),
          h.frame.cast<To>(),
          h.steps};
}

V<double> direction(generators::Random& random) {
  for (;;) {
    const V<double> v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double length = std::sqrt(v.dot(v));
    if (length > 0.1 && length <= 1) return v / length;
  }
}

Input hit(generators::Random& random, double transverse, double along, int seconds = 1) {
  const auto turn = [&] {
    const V<double> axis = direction(random);
    return contact::exponential<double>(V<double>(axis * random.uniform(0, 3)));
  };
  Hit<double> h{};
  h.transverse = transverse;
  h.along = along;
  h.start = turn();
  // An impulse that makes it rotate at 1 to 4 rad/s.
  const double rate = random.uniform(1, 4);
  const V<double> angular_velocity = direction(random) * rate;
  const M<double> r = contact::matrix_of(h.start);
  const M<double> own = contact::detail::diagonal<double>(transverse, transverse, along);
  h.momentum = contact::rotated<double>(own, r) * angular_velocity;
  // The same body as a full tensor, in arbitrary axes.
  const M<double> left = contact::matrix_of(turn());
  h.tensor = contact::rotated<double>(own, left);
  h.frame = r * left.transpose();
  h.steps = seconds * steps_a_second;
  return {h, convert<float>(h)};
}

template <class S>
M<double> right_end(const Hit<S>& h) {
  contact::Quaternion<double> q{double(h.start.w), h.start.v.template cast<double>()};
  q = contact::normalised<double>(q);
  return contact::matrix_of(contact::free_top<double>(q, h.momentum.template cast<double>(),
                                                      double(h.transverse), double(h.along),
                                                      double(h.steps) / steps_a_second));
}

Answer truth_of(const Input& input) {
  return {false, right_end(input.in_double), right_end(input.in_float)};
}

/// The angular velocity from the angular momentum and the orientation.
struct ByAxes {
  template <class S>
  V<S> operator()(const Hit<S>& h, const M<S>& r) const {
    return contact::free_angular_velocity<S>(h.momentum, V<S>(h.transverse, h.transverse, h.along),
                                             r);
  }
};
struct AsSphere {
  template <class S>
  V<S> operator()(const Hit<S>& h, const M<S>&) const {
    return h.momentum / ((h.transverse + h.transverse + h.along) / S(3));
  }
};
struct ByTensor {
  /// The frame rotates with the body: R R₀ᵀ takes the initial frame to the present one.
  template <class S>
  V<S> operator()(const Hit<S>& h, const M<S>& r) const {
    const M<S> first = contact::matrix_of(h.start);
    const M<S> now = r * first.transpose() * h.frame;
    const M<S> world = contact::rotated<S>(h.tensor, now);
    const auto inverse = contact::inverse_of_symmetric<S>(world);
    return inverse ? V<S>(*inverse * h.momentum) : V<S>(V<S>::Zero());
  }
};

template <class S, class Spin>
M<S> by_matrix(const Hit<S>& h, const Spin& angular_velocity) {
  M<S> r = contact::matrix_of(h.start);
  for (int i = 0; i < h.steps; ++i) {
    r = contact::orthonormalised<S>(contact::matrix_step<S>(r, angular_velocity(h, r), h.step()));
  }
  return r;
}
template <class S, class Spin>
M<S> by_bare_matrix(const Hit<S>& h, const Spin& angular_velocity) {
  M<S> r = contact::matrix_of(h.start);
  for (int i = 0; i < h.steps; ++i)
    r = contact::matrix_step<S>(r, angular_velocity(h, r), h.step());
  return r;
}
template <class S, class Spin>
M<S> by_quaternion(const Hit<S>& h, const Spin& angular_velocity) {
  contact::Quaternion<S> q = h.start;
  for (int i = 0; i < h.steps; ++i) {
    q = contact::quaternion_step<S>(q, angular_velocity(h, contact::matrix_of(q)), h.step());
  }
  return contact::matrix_of(q);
}
template <class S, class Spin>
M<S> by_exponential(const Hit<S>& h, const Spin& angular_velocity) {
  contact::Quaternion<S> q = h.start;
  for (int i = 0; i < h.steps; ++i) {
    q = contact::exponential_step<S>(q, angular_velocity(h, contact::matrix_of(q)), h.step());
  }
  return contact::matrix_of(q);
}
template <class S, class Spin>
M<S> by_midpoint(const Hit<S>& h, const Spin& angular_velocity) {
  contact::Quaternion<S> q = h.start;
  const S step = h.step();
  for (int i = 0; i < h.steps; ++i) {
    const V<S> first = angular_velocity(h, contact::matrix_of(q));
    const auto middle = contact::exponential_step<S>(q, first, step / S(2));
    q = contact::exponential_step<S>(q, angular_velocity(h, contact::matrix_of(middle)), step);
  }
  return contact::matrix_of(q);
}

/// The figure has the body's own axes, in which the impulse is in the plane of x and z, and moments
/// that are divided by the transverse one.
template <class S>
ladder::Example shown(const Hit<S>& h, const M<double>& told, const M<double>& truth,
                      const std::string& method) {
  const auto axis = [](const M<double>& r) { return V<double>(r.col(2)); };
  ladder::Example example;
  example.facts = {ladder::number("moment about the axis of symmetry, kg·m²", h.along),
                   ladder::number("moment perpendicular to it, kg·m²", h.transverse),
                   ladder::numbers("axis at first", V<S>(contact::matrix_of(h.start).col(2))),
                   ladder::numbers("angular momentum, kg·m²/s", h.momentum),
                   ladder::number("time, s", h.steps / double(steps_a_second)),
                   ladder::numbers("axis by this method", axis(told)),
                   ladder::numbers("axis, exact", axis(truth))};
  const V<double> momentum = contact::matrix_of(h.start).template cast<double>().transpose() *
                             h.momentum.template cast<double>();
  const V<double> angular_velocity = momentum.cwiseQuotient(
      V<double>(double(h.transverse), double(h.transverse), double(h.along)));
  const double perpendicular = std::sqrt(angular_velocity.x() * angular_velocity.x() +
                                         angular_velocity.y() * angular_velocity.y());
  const double seconds = h.steps / double(steps_a_second);
  const double faster = seconds > 10 ? 2 : 1;
  example.figure = "drift";
  example.fields = {
      {"steps", {faster * steps_a_second}},
      {"angular_velocity", {faster * angular_velocity.norm()}},
      {"shape", {double(h.along) / double(h.transverse)}},
      {"angle",
       {std::atan2(perpendicular, std::abs(angular_velocity.z())) * 180 / std::numbers::pi}},
      {"also",
       {method == "axes-matrix"          ? 1.0
        : method == "sphere-exponential" ? 2.0
                                         : 0.0}},
      {"at", {seconds / faster}}};
  example.note =
      "The figure shows the body in its own axes, with moments divided by the one perpendicular to "
      "its axis. ";
  example.note +=
      method == "axes-matrix"
          ? "Orthonormalising begins with one of the other two axes, and the figure chooses these "
            "otherwise, so its error differs."
          : "The errors are the same but for rounding.";
  if (faster > 1) {
    example.note +=
        " It ends at 10 s, so it rotates twice as fast, with twice as many steps a second: its 8 s "
        "are these 16 s.";
  }
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  const auto judge = [](const Answer& got, const Answer& right) {
    const M<double> off =
        got.of_floats ? got.in_float - right.in_float : got.in_double - right.in_double;
    ladder::Verdict verdict;
    verdict.error = std::sqrt(off.cwiseAbs2().sum() / 2);
    // Visibly wrong: a tenth of a radian, six degrees.
    verdict.wrong = !(verdict.error <= 0.1);
    return verdict;
  };
  ladder::Ladder<Input, Answer> ladder("What is the orientation of a body after an impulse?",
                                       truth_of, judge);
  ladder.family("balls", "balls", [](generators::Random& random) {
    const double i = random.uniform(0.5, 2);
    return hit(random, i, i);
  });
  const auto brick = [](generators::Random& random, int seconds) {
    const double i = random.uniform(0.5, 2);
    return hit(random, i, i * random.uniform(0.4, 1.8), seconds);
  };
  ladder.family("bricks", "square bricks",
                [brick](generators::Random& random) { return brick(random, 1); });
  ladder.family("plates", "plates", [](generators::Random& random) {
    const double i = random.uniform(0.5, 2);
    return hit(random, i, 2 * i);
  });
  ladder.family("needles", "needles, moments 1 : 100", [](generators::Random& random) {
    const double i = random.uniform(0.5, 2);
    return hit(random, i, 0.01 * i);
  });
  // Drift: bricks of the same kind, later.
  ladder.family("bricks-4", "square bricks, 4 s",
                [brick](generators::Random& random) { return brick(random, 4); });
  ladder.family("bricks-16", "square bricks, 16 s",
                [brick](generators::Random& random) { return brick(random, 16); });

  const auto method = [&ladder](const char* id, const char* title, auto way) {
    ladder.method({.id = std::string(id), .title = title, .scalar = "double", .exact = false},
                  [way](const Input& input) {
                    return Answer{false, way(input.in_double), M<double>::Zero()};
                  });
  };
  const auto method_in_float = [&ladder](const char* id, const char* title, auto way) {
    ladder.method({.id = std::string(id), .title = title, .scalar = "float", .exact = false},
                  [way](const Input& input) {
                    return Answer{true, M<double>::Zero(),
                                  M<double>(way(input.in_float).template cast<double>())};
                  });
  };
  method("sphere-exponential", "scalar, exponential map",
         [](const auto& h) { return by_exponential(h, AsSphere()); });
  method("axes-bare", "axes, Euler's matrix",
         [](const auto& h) { return by_bare_matrix(h, ByAxes()); });
  method("axes-matrix", "axes, Euler's matrix, orthonormalised",
         [](const auto& h) { return by_matrix(h, ByAxes()); });
  method("axes-quaternion", "axes, quaternion",
         [](const auto& h) { return by_quaternion(h, ByAxes()); });
  method("axes-exponential", "axes, exponential map",
         [](const auto& h) { return by_exponential(h, ByAxes()); });
  method("axes-midpoint", "axes, exponential map at the midpoint",
         [](const auto& h) { return by_midpoint(h, ByAxes()); });
  method("tensor-midpoint", "full tensor, exponential map at the midpoint",
         [](const auto& h) { return by_midpoint(h, ByTensor()); });
  method_in_float("axes-midpoint-float", "axes, exponential map at the midpoint",
                  [](const auto& h) { return by_midpoint(h, ByAxes()); });
  method_in_float("tensor-midpoint-float", "full tensor, exponential map at the midpoint",
                  [](const auto& h) { return by_midpoint(h, ByTensor()); });
  ladder.recommend("axes-midpoint");
  ladder.show(
      [](const Input& input, const Answer& got, const Answer& right, const ladder::Method& by) {
        return got.of_floats ? shown(input.in_float, got.in_float, right.in_float, by.id)
                             : shown(input.in_double, got.in_double, right.in_double, by.id);
      });
  return ladder;
}

}  // namespace

LADDER(experiment)
