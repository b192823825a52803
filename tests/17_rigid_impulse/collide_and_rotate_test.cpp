// Right answers come from the formula in principal axes, which is accurate for every ratio of
// moments. Every test asks for at least two different answers, so that no constant passes one.
#include "collide_and_rotate.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::After;
using exercise::Body;
using exercise::Motion;
using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

/// Variations: the wrong formulas of the misconceptions.
struct Ways {
  bool approach_tested = true;
  bool turning_counts = true;  // in the divisor
  bool world_tensor = true;
  bool arm_from_centre = true;
  bool closing_at_contact = true;
  double turn_sign = 1;       // of ω × r
  double reaction_sign = -1;  // of B's impulse
  double twist_sign = 1;      // of r × J
};

Vector inverse_times(const Body& body, const Vector& angular_impulse, const Ways& ways) {
  if (std::isinf(body.mass)) return Vector::Zero();
  if (!ways.world_tensor) return angular_impulse.cwiseQuotient(body.moments);
  const Vector seen = body.rotation.transpose() * angular_impulse;
  return body.rotation * Vector(seen.cwiseQuotient(body.moments));
}

After compute(const Body& a, const Body& b, const Vector& point, const Vector& n, double e,
              const Ways& ways) {
  const auto lever_arm = [&](const Body& body) -> Vector {
    return ways.arm_from_centre ? Vector(point - body.centre) : point;
  };
  const auto at_point = [&](const Body& body) -> Vector {
    if (!ways.closing_at_contact) return body.velocity;
    return body.velocity + ways.turn_sign * body.angular_velocity.cross(lever_arm(body));
  };
  const auto gives = [&](const Body& body) {
    if (std::isinf(body.mass)) return 0.0;
    const Vector angular_impulse = lever_arm(body).cross(n);
    return 1 / body.mass + (ways.turning_counts
                                ? angular_impulse.dot(inverse_times(body, angular_impulse, ways))
                                : 0.0);
  };
  const double v = n.dot(at_point(a) - at_point(b));
  After after{{a.velocity, a.angular_velocity}, {b.velocity, b.angular_velocity}};
  if (!(v < 0) && ways.approach_tested) return after;
  const double j = -(1 + e) * v / (gives(a) + gives(b));
  const auto push = [&](const Body& body, Motion& motion, double size) {
    if (std::isinf(body.mass)) return;
    motion.velocity += n * (size / body.mass);
    motion.angular_velocity +=
        ways.twist_sign * inverse_times(body, lever_arm(body).cross(n), ways) * size;
  };
  push(a, after.a, j);
  push(b, after.b, ways.reaction_sign * j);
  return after;
}

/// At most thirty roundings from the input to j, and six from there, each of at most the largest
/// velocity; the sums in the divisor have only positive terms, so there is no cancellation. The
/// other stable method, with R diag Rᵀ as a full tensor, loses at most the ratio of the moments,
/// 2⁸, more.
double room_of(const Body& a, const Body& b, const Vector& point, const After& after) {
  double speed = 0;
  double turn = 0;
  const auto add = [&](const Body& body, const Motion& motion) {
    const double lever_arm = (point - body.centre).norm();
    speed = std::max({speed, body.velocity.norm() + body.angular_velocity.norm() * lever_arm,
                      motion.velocity.norm() + motion.angular_velocity.norm() * lever_arm});
    turn = std::max({turn, body.angular_velocity.norm(), motion.angular_velocity.norm()});
  };
  add(a, after.a);
  add(b, after.b);
  return 36 * 0x1p-45 * (speed + turn);
}

/// Whether the momentum is conserved, but the impulse and the normal velocity at the point are
/// wrong.
bool speed_alone_differs(const Body& a, const Body& b, const Vector& point, const Vector& n,
                         const After& got, const After& right, double room) {
  if (std::isinf(a.mass) || std::isinf(b.mass)) return false;
  const Vector gained =
      a.mass * (got.a.velocity - a.velocity) + b.mass * (got.b.velocity - b.velocity);
  const auto speed = [&](const After& after) {
    const Vector at_a = after.a.angular_velocity.cross(Vector(point - a.centre));
    const Vector at_b = after.b.angular_velocity.cross(Vector(point - b.centre));
    return n.dot(after.a.velocity + at_a - after.b.velocity - at_b);
  };
  return gained.norm() <= room * (a.mass + b.mass) &&
         (got.a.velocity - right.a.velocity).norm() > room &&
         std::abs(speed(got) - speed(right)) > 1000 * room;
}

bool near(const After& x, const After& y, double room) {
  const auto one = [room](const Motion& p, const Motion& q) {
    return (p.velocity - q.velocity).norm() <= room &&
           (p.angular_velocity - q.angular_velocity).norm() <= room;
  };
  return one(x.a, y.a) && one(x.b, y.b);
}

void check(const Body& a, const Body& b, const Vector& point, const Vector& n, double e) {
  const After right = compute(a, b, point, n, e, {});
  const auto with = [&](auto change) {
    return [&, change]() -> After {
      Ways ways;
      change(ways);
      return compute(a, b, point, n, e, ways);
    };
  };
  const double room = room_of(a, b, point, right);
  ask("What is the motion of the two bodies after the collision?")
      .given("a", a)
      .given("b", b)
      .given("point", point)
      .given("normal", n)
      .given("e", e)
      .suspect("separating-pushed", with([](Ways& w) { w.approach_tested = false; }))
      .suspect("rotation-not-in-the-divisor", with([](Ways& w) { w.turning_counts = false; }))
      .suspect("closing-of-the-centres", with([](Ways& w) { w.closing_at_contact = false; }))
      .suspect("tensor-in-body-frame", with([](Ways& w) { w.world_tensor = false; }))
      .suspect("arm-from-origin", with([](Ways& w) { w.arm_from_centre = false; }))
      .suspect("omega-cross-r-reversed", with([](Ways& w) { w.turn_sign = -1; }))
      .suspect("no-reaction", with([](Ways& w) { w.reaction_sign = 1; }))
      .suspect("no-reaction", with([](Ways& w) { w.reaction_sign = 0; }))
      .suspect("twist-reversed", with([](Ways& w) { w.twist_sign = -1; }))
      .suspect_if("separates-at-a-wrong-speed",
                  [&](const After& got) {
                    // Not where the bodies separate, nor if it has another cause that is known.
                    const std::vector<After> known{
                        {{a.velocity, a.angular_velocity}, {b.velocity, b.angular_velocity}},
                        with([](Ways& w) { w.turning_counts = false; })(),
                        with([](Ways& w) { w.closing_at_contact = false; })(),
                        with([](Ways& w) { w.world_tensor = false; })(),
                        with([](Ways& w) { w.arm_from_centre = false; })(),
                        with([](Ways& w) { w.turn_sign = -1; })(),
                        with([](Ways& w) { w.twist_sign = -1; })()};
                    return !near(right, known[0], room) &&
                           speed_alone_differs(a, b, point, n, got, right, room) &&
                           std::none_of(known.begin(), known.end(), [&](const After& other) {
                             return near(got, other, 1000 * room);
                           });
                  })
      .answer([&] { return exercise::collide(a, b, point, n, e); })
      .close_to(right, within(room));
}

const Matrix straight = Matrix::Identity();
const double inf = std::numeric_limits<double>::infinity();

Body ball(double mass, const Vector& centre, const Vector& velocity) {
  return {mass, Vector::Constant(mass * 0.4), straight, centre, velocity, {0, 0, 0}};
}

}  // namespace

TEST_CASE("an impulse through the centres of mass rotates nothing") {
  check(ball(2, {1, 0, 0}, {-3, 1, 0}), ball(1, {-1, 0, 0}, {1, 0, 0}), {0, 0, 0}, {1, 0, 0}, 1);
  check(ball(2, {1, 0, 0}, {-3, 1, 0}), ball(1, {-1, 0, 0}, {1, 0, 0}), {0, 0, 0}, {1, 0, 0}, 0.5);
  check(ball(3, {0, 1, 0}, {0, -4, 0}), ball(3, {0, -1, 0}, {0, 0, 2}), {0, 0, 0}, {0, 1, 0}, 0);
}

TEST_CASE("separating bodies are left alone") {
  check(ball(2, {1, 0, 0}, {3, 1, 0}), ball(1, {-1, 0, 0}, {1, 0, 0}), {0, 0, 0}, {1, 0, 0}, 1);
  check(ball(1, {0, 1, 0}, {0, 2, 0}), ball(3, {0, -1, 0}, {0, 1, 1}), {0, 0, 0}, {0, 1, 0}, 0.5);
}

TEST_CASE("a rod that is hit at its end rotates") {
  const Body rod{3, {0.25, 4, 4}, straight, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  check(ball(1, {2, 0, 1}, {0, 0, -6}), rod, {2, 0, 0}, {0, 0, 1}, 1);
  check(ball(1, {2, 0, 1}, {0, 0, -6}), rod, {2, 0, 0}, {0, 0, 1}, 0);
  check(ball(1, {-1, 0, 1}, {0, 0, -6}), rod, {-1, 0, 0}, {0, 0, 1}, 0.5);
}

TEST_CASE("the rotation contributes to the closing velocity") {
  const Body still = ball(1, {5, 0, 1}, {0, 0, 0});
  const Body down{3, {0.25, 4, 4}, straight, {3, 0, 0}, {0, 0, 0}, {0, -2, 0}};
  check(ball(1, {5, 0, 1}, {0, 0, -8}), down, {5, 0, 0}, {0, 0, 1}, 1);
  check(still, down, {5, 0, 0}, {0, 0, 1}, 1);
  const Body up{3, {0.25, 4, 4}, straight, {3, 0, 0}, {0, 0, 0}, {0, 2, 0}};
  check(still, up, {5, 0, 0}, {0, 0, 1}, 1);
}

TEST_CASE("a rotated plank needs its tensor in world axes") {
  Matrix oblique;
  oblique << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1;
  const Body plank{2, {0.25, 3, 4}, oblique, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  check(ball(1, {1, 1, 1}, {0, 0, -4}), plank, {1, 1, 0}, {0, 0, 1}, 1);
  Matrix three;
  three << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  const Body turned{2, {0.25, 3, 4}, three / 3, {0, 0, 0}, {0, 0, 0}, {0, 1, 0}};
  check(ball(1, {1, 1, 1}, {0, 0, -4}), turned, {1, 1, 0}, {0, 0, 1}, 0.5);
}

TEST_CASE("the ground does not move") {
  const Body ground{inf, {1, 1, 1}, straight, {0, 0, -9}, {0, 0, 0}, {0, 0, 0}};
  const Body rod{3, {0.25, 4, 4}, straight, {1, 0, 0}, {0, 0, -2}, {0, 0, 0}};
  check(rod, ground, {3, 0, 0}, {0, 0, 1}, 1);
  check(rod, ground, {1, 0, 0}, {0, 0, 1}, 0.5);
  check(ground, rod, {3, 0, 0}, {0, 0, -1}, 1);
}

TEST_CASE("random collisions") {
  generators::Random random(seed(0));
  const auto vector = [&](double low, double high) {
    return Vector{random.uniform(low, high), random.uniform(low, high), random.uniform(low, high)};
  };
  const auto unit = [&] {
    for (;;) {
      const Vector v = vector(-1, 1);
      if (v.norm() > 0.1) return Vector(v.normalized());
    }
  };
  const auto body = [&]() -> Body {
    const double mass = random.uniform(0.5, 4);
    const double w = random.uniform(0.3, 1);
    const Vector v = vector(-1, 1);
    const Matrix rotation =
        Eigen::Quaterniond(w, v.x(), v.y(), v.z()).normalized().toRotationMatrix();
    const Vector moments = vector(0.05, 4);
    const Vector centre = vector(-2, 2);
    const Vector velocity = vector(-5, 5);
    return {mass, moments, rotation, centre, velocity, vector(-5, 5)};
  };
  for (int asked = 0; asked < 200; ++asked) {
    const Body a = body();
    const Body b = body();
    const Vector point = vector(-2, 2);
    const Vector n = unit();
    // The sign of the normal velocity must be clear.
    const double v = n.dot(a.velocity + a.angular_velocity.cross(Vector(point - a.centre)) -
                           b.velocity - b.angular_velocity.cross(Vector(point - b.centre)));
    if (std::abs(v) < 0x1p-40) continue;
    check(a, b, point, n, random.uniform());
  }
}
