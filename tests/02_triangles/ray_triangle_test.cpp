// Every question's answer is known without the student's: by construction from small integers, or
// by exact arithmetic. Every test asks for a hit before it asks for a miss (or the other way
// round), so that "nothing, always" earns nothing, and a miss in the second place means what its
// suspect says.
#include "ray_triangle.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <02_triangles/exact_hit.hpp>

namespace {

using namespace contact::testing;
using exact::aimed;
using exact::exact_hit;
using Ray = contact::Ray<double>;
using Triangle = contact::Triangle<double>;
using Hit = contact::TriangleHit<double>;
using Vector = Eigen::Vector3d;

/// How far rounding can take a plain method. It works as if each coordinate were off by c·u·L, L
/// the largest one on the way (u = 2^-53), and products of edges by as much of |e₁||e₂|. The plane
/// then moves so that the hit slides along the ray by c·u·L·|e₁||e₂|/(|n| cos), where cos =
/// |n·d|/(|n||d|), and along the triangle by as much; a weight changes by the slide times (longest
/// edge)/|n|. Over 50,000 of the random rays below, Möller–Trumbore, edge tests and the dropped
/// dimension stay within c = 3.5; c = 64 leaves room for longer ways. The largest bound is then
/// 2.1e-11, while every mistake of the bank is off by more than 1e-3 or by a yes for a no.
std::optional<Hit> bound(const Ray& ray, const Triangle& triangle) {
  const Vector e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, n = e1.cross(e2);
  const double slope = std::abs(n.dot(ray.direction)), speed = ray.direction.norm();
  if (slope == 0) return Hit{};
  const double reach = std::abs(n.dot(ray.origin - triangle.a)) / slope * speed;
  const double largest =
      std::max({reach, ray.origin.norm(), triangle.a.norm(), triangle.b.norm(), triangle.c.norm()});
  const double slide = 64 * 0x1p-53 * largest * e1.norm() * e2.norm() * speed / slope;
  const double edge = std::max({e1.norm(), e2.norm(), (e2 - e1).norm()});
  return Hit{slide / speed, Vector::Constant(slide * edge / n.norm())};
}

/// The textbook's way with one mistake in it.
enum class Mistake {
  beta_sign,
  parallelogram,
  direction_normalised,
  hits_behind_origin,
  one_sided,
  touching_rejected,
  drops_smallest_dimension,
  absolute_epsilon,
  metres_for_fraction,
};

std::optional<Hit> mistaken(const Ray& ray, const Triangle& triangle, Mistake mistake) {
  const bool metres =
      mistake == Mistake::direction_normalised || mistake == Mistake::metres_for_fraction;
  const Vector d = metres ? ray.direction.normalized() : ray.direction;
  const Vector e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, n = e1.cross(e2);
  const double det = -n.dot(d);
  if (det == 0) return std::nullopt;
  if (std::abs(det) < 1e-9 && mistake == Mistake::absolute_epsilon) return std::nullopt;
  if (det < 0 && mistake == Mistake::one_sided) return std::nullopt;
  const double t = n.dot(ray.origin - triangle.a) / det;
  const Vector x = ray.origin + t * d - triangle.a;
  Eigen::Index dropped = 0;
  if (mistake == Mistake::drops_smallest_dimension) {
    n.cwiseAbs().minCoeff(&dropped);
  } else {
    n.cwiseAbs().maxCoeff(&dropped);
  }
  const Eigen::Index i = (dropped + 1) % 3, j = (dropped + 2) % 3;
  const auto cross = [&](const Vector& p, const Vector& q) { return p[i] * q[j] - p[j] * q[i]; };
  double beta = cross(x, e2) / cross(e1, e2), gamma = cross(e1, x) / cross(e1, e2);
  if (mistake == Mistake::beta_sign) gamma = -gamma;  // the lecture calls the weight of c beta
  const double alpha = 1 - beta - gamma;
  if (t < 0 && mistake != Mistake::hits_behind_origin) return std::nullopt;
  if (t > 1 && mistake == Mistake::metres_for_fraction) return std::nullopt;
  if (beta < 0 || gamma < 0) return std::nullopt;
  if (mistake == Mistake::parallelogram ? beta > 1 || gamma > 1 : alpha < 0) return std::nullopt;
  if (mistake == Mistake::touching_rejected && (alpha <= 0 || beta <= 0 || gamma <= 0 || t <= 0))
    return std::nullopt;
  return Hit{t, {alpha, beta, gamma}};
}

/// Asks once. `mistakes` are those that this input tells from everything else.
void check(const Ray& ray, const Triangle& triangle, const std::vector<Mistake>& mistakes = {}) {
  constexpr std::string_view kIds[] = {
      "beta-sign",          "parallelogram",     "direction-normalised",     "hits-behind-origin",
      "one-sided",          "touching-rejected", "drops-smallest-dimension", "absolute-epsilon",
      "metres-for-fraction"};
  std::vector<Suspect<std::optional<Hit>>> suspects;
  for (const Mistake mistake : mistakes) {
    suspects.push_back({kIds[static_cast<std::size_t>(mistake)],
                        [&ray, &triangle, mistake] { return mistaken(ray, triangle, mistake); }});
  }
  // The divisor is zero for a ray parallel to the plane, and for a triangle without area.
  const Vector normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
  const auto not_a_number = [&](const std::optional<Hit>& hit) {
    return hit && !(std::isfinite(hit->t) && hit->barycentric.allFinite()) &&
           normal.dot(ray.direction) == 0;
  };
  ask("Where does the ray meet the triangle?")
      .given("ray", ray)
      .given("triangle", triangle)
      .suspects(std::move(suspects))
      .suspect_if("division-by-zero", not_a_number)
      .answer([&] { return exercise::ray_triangle(ray, triangle); })
      .close_to(exact_hit(ray, triangle), within(bound(ray, triangle)));
}

Triangle scaled(const Triangle& triangle, double factor) {
  return {factor * triangle.a, factor * triangle.b, factor * triangle.c};
}

// Its normal (32, 16, 8) has no zero and no tie, so that any dimension may be dropped; its front is
// up.
const Triangle kTilted{{1, 0, 2}, {3, -2, -2}, {1, 4, -6}};
// Legs of 4 in the plane z = 0, front up. Plain arithmetic makes no error at all on halves and
// quarters of it.
const Triangle kFlat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
const Vector kDown{0, 0, -1};

}  // namespace

TEST_CASE("a ray hits where it passes inside the triangle and misses beside it") {
  // Less than a metre away, so that t is right in metres and in multiples of the direction.
  check(aimed(kTilted, 0.5, -0.25, kDown, 0.75), kTilted, {Mistake::beta_sign});
  check(aimed(kTilted, 0.75, 0.75, kDown, 0.75), kTilted, {Mistake::parallelogram});
  check(aimed(kTilted, -0.25, 0.5, kDown, 0.75), kTilted);
  check(aimed(kTilted, 0.25, 0.5, kDown, 0.75), kTilted);
  check(aimed(kTilted, 0.125, 0.125, kDown, 0.625), kTilted);
}

TEST_CASE("t is in multiples of the direction as it is given") {
  // Half a metre away, then half a direction: an answer that hits the first and misses the second
  // treats the ray as a segment that ends at t = 1, and measures t in metres.
  check(aimed(kTilted, 0.25, 0.5, kDown, 0.5), kTilted);
  check(aimed(kTilted, 0.25, 0.5, 4 * kDown, 0.5), kTilted,
        {Mistake::direction_normalised, Mistake::metres_for_fraction});
  for (const double length : {4.0, 0.125}) {
    check(aimed(kTilted, 0.25, 0.5, length * kDown, 3), kTilted, {Mistake::direction_normalised});
  }
}

TEST_CASE("a triangle behind the origin is not hit") {
  check(aimed(kTilted, 0.25, 0.5, kDown, -3), kTilted, {Mistake::hits_behind_origin});
  check(aimed(kTilted, 0.25, 0.5, kDown, 3), kTilted);
}

TEST_CASE("a triangle is hit from both sides") {
  check(aimed(kTilted, 0.25, 0.5, kDown, 3), kTilted);
  check(aimed(kTilted, 0.25, 0.5, -kDown, 3), kTilted, {Mistake::one_sided});
}

TEST_CASE("a triangle is hit in every orientation") {
  check(aimed(kTilted, 0.25, 0.5, kDown, 3), kTilted);
  for (const int turn : {0, 1, 2}) {
    const auto turned = [&](const Vector& v) {
      return Vector(v[turn], v[(turn + 1) % 3], v[(turn + 2) % 3]);
    };
    const Triangle triangle{turned(kFlat.a), turned(kFlat.b), turned(kFlat.c)};
    check(aimed(triangle, 0.25, 0.5, turned(kDown), 3), triangle,
          {Mistake::drops_smallest_dimension});
  }
}

TEST_CASE("touching an edge, a vertex or the origin counts as a hit") {
  check(aimed(kFlat, 0.25, 0.5, kDown, 3), kFlat);
  for (const auto& [beta, gamma] : {std::pair{0.5, 0.0}, {0.0, 0.5}, {0.5, 0.5}}) {
    check(aimed(kFlat, beta, gamma, kDown, 3), kFlat, {Mistake::touching_rejected});
  }
  for (const auto& [beta, gamma] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}) {
    check(aimed(kFlat, beta, gamma, kDown, 3), kFlat, {Mistake::touching_rejected});
  }
  check(aimed(kFlat, 0.25, 0.5, kDown, 0), kFlat, {Mistake::touching_rejected});
}

TEST_CASE("a tiny triangle is hit like a large one") {
  check(aimed(kTilted, 0.25, 0.5, kDown, 3), kTilted);
  // Powers of two change the size and nothing else: the same digits, another exponent.
  for (const double factor : {0x1p40, 0x1p-20, 0x1p-40}) {
    const Triangle triangle = scaled(kTilted, factor);
    check(aimed(triangle, 0.25, 0.5, kDown, 3 * factor), triangle, {Mistake::absolute_epsilon});
    check(aimed(triangle, 0.5, -0.25, kDown, 3 * factor), triangle);
  }
}

TEST_CASE("a parallel ray, a direction of length zero and a triangle without area give no hit") {
  check(aimed(kFlat, 0.25, 0.5, kDown, 3), kFlat);
  check({{1, 1, 0}, {1, 0, 0}}, kFlat);   // in its plane, from inside it
  check({{-1, 1, 0}, {1, 0, 0}}, kFlat);  // in its plane, through it
  check({{1, 1, 2}, {1, 0, 0}}, kFlat);   // in a parallel plane
  check({{1, 1, 0}, {0, 0, 0}}, kFlat);
  check({{1, 1, 2}, {0, 0, 0}}, kFlat);
  check({{1, 0, 2}, kDown}, {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}});
  check({{1, 1, 2}, kDown}, {{1, 1, 0}, {1, 1, 0}, {1, 1, 0}});
}

TEST_CASE("random rays agree with exact arithmetic") {
  // Keep away from slivers, from grazing rays and from ties, where plain arithmetic may err and
  // still be good work.
  const auto beyond_doubt = [](const Ray& ray, const Triangle& triangle) {
    const Vector e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, n = e1.cross(e2);
    const double slope = n.dot(ray.direction);
    if (n.norm() < 4 || std::abs(slope) < n.norm() / 4) return false;
    const double t = -n.dot(ray.origin - triangle.a) / slope;
    const Vector x = ray.origin + t * ray.direction - triangle.a;
    const double beta = n.dot(x.cross(e2)) / n.squaredNorm();
    const double gamma = n.dot(e1.cross(x)) / n.squaredNorm();
    const double alpha = 1 - beta - gamma;
    return std::min({std::abs(t), std::abs(alpha), std::abs(beta), std::abs(gamma)}) >= 1e-3;
  };
  // Only a mistake that says "hit" here: a miss has too many causes.
  const auto check_hits = [](const Ray& ray, const Triangle& triangle) {
    std::vector<Mistake> hits;
    for (const Mistake mistake : {Mistake::beta_sign, Mistake::parallelogram,
                                  Mistake::direction_normalised, Mistake::hits_behind_origin}) {
      if (mistaken(ray, triangle, mistake)) hits.push_back(mistake);
    }
    check(ray, triangle, hits);
  };
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  for (int asked = 0; asked < 500;) {
    const Triangle triangle{vector(8), vector(8), vector(8)};
    const double beta = random.uniform(-1, 2), gamma = random.uniform(-1, 2);
    const double t = random.uniform(-4, 12);
    const Ray ray = aimed(triangle, beta, gamma, vector(2), t);
    if (!beyond_doubt(ray, triangle)) continue;
    ++asked;
    shrinkable(check_hits, beyond_doubt, ray, triangle);
  }
}
