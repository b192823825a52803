// Compares the book's tests of a ray against a ball and a box with those of Embree and CGAL:
// medians of several runs, and wrong answers of each. Times are those of the processor. usage:
//   ray_peers [rays] [runs]
//   ray_peers --write FILE [rays]  the questions and right answers, for
//   benchmarks/rays/three_peer.mjs
#include "peers.hpp"

#include <04_rays/families.hpp>

#include <algorithm>
#include <cmath>
#include <contact/ray_box.hpp>
#include <contact/ray_sphere.hpp>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace {

using contact::Exact;
using contact::Ray;
using contact::Sphere;
using Box = contact::Aabb<double>;
using Point = contact::Vector3<double>;
using peers::BallOfFloats;
using peers::BoxOfFloats;

std::array<float, 3> numbers(const contact::Vector3<float>& v) { return {v.x(), v.y(), v.z()}; }
BallOfFloats plain(const Sphere<float>& ball) { return {numbers(ball.centre), ball.radius}; }
BoxOfFloats plain(const contact::Aabb<float>& box) { return {numbers(box.low), numbers(box.high)}; }

contact::Vector3<Exact> in_exact(const Point& v) {
  return {Exact(v.x()), Exact(v.y()), Exact(v.z())};
}

/// By exact numbers without a filter.
bool exactly(const Ray<double>& ray, const Sphere<double>& ball) {
  const contact::Vector3<Exact> m = in_exact(ray.origin) - in_exact(ball.centre);
  const contact::Vector3<Exact> d = in_exact(ray.direction);
  const Exact c = m.dot(m) - Exact(ball.radius) * Exact(ball.radius);
  if (c.sign() <= 0) return true;
  const Exact b = m.dot(d);
  return b.sign() < 0 && (b * b - d.dot(d) * c).sign() >= 0;
}

bool exactly(const Ray<double>& ray, const Box& box) {
  // Bounds on t: numerator and a denominator that is not negative.
  std::vector<std::pair<Exact, Exact>> lower{{Exact(0.0), Exact(1.0)}}, upper;
  for (int k = 0; k < 3; ++k) {
    const Exact rate(ray.direction(k)), to_low = Exact(box.low(k)) - Exact(ray.origin(k)),
                                        to_high = Exact(box.high(k)) - Exact(ray.origin(k));
    if (rate.sign() == 0) {
      if (to_low.sign() > 0 || to_high.sign() < 0) return false;
      continue;
    }
    const bool forwards = rate.sign() > 0;
    lower.push_back(forwards ? std::pair(to_low, rate) : std::pair(-to_high, -rate));
    upper.push_back(forwards ? std::pair(to_high, rate) : std::pair(-to_low, -rate));
  }
  for (const auto& [least, by] : lower) {
    for (const auto& [most, of] : upper) {
      if (most * by < least * of) return false;
    }
  }
  return true;
}

/// A family's rays and bodies in every form, and the right answers.
template <class InFloat, class InDouble, class Plain>
struct Family {
  std::vector<Ray<double>> rays;
  std::vector<InDouble> bodies;
  std::vector<Ray<float>> rays_in_float;
  std::vector<InFloat> bodies_in_float;
  peers::Questions<Plain> questions;
  std::vector<char> right;
};
using Balls = Family<Sphere<float>, Sphere<double>, BallOfFloats>;
using Boxes = Family<contact::Aabb<float>, Box, BoxOfFloats>;

bool asked(const Sphere<float>& ball) { return ball.radius > 0; }
bool asked(const contact::Aabb<float>&) { return true; }

template <class Family, class Draw>
Family drawn(std::size_t count, std::uint64_t seed, const Draw& draw) {
  generators::Random random(seed);
  Family family;
  while (family.rays.size() < count) {
    const auto aimed = draw(random);
    const Ray<double> ray = contact::in_double(aimed.ray);
    const Point second = ray.origin + ray.direction;
    if (Point(second - ray.origin) != ray.direction || !asked(aimed.body)) continue;
    family.rays.push_back(ray);
    family.bodies.push_back(contact::in_double(aimed.body));
    family.rays_in_float.push_back(aimed.ray);
    family.bodies_in_float.push_back(aimed.body);
    family.questions.rays.push_back({numbers(aimed.ray.origin), numbers(aimed.ray.direction)});
    family.questions.bodies.push_back(plain(aimed.body));
    family.right.push_back(exactly(ray, family.bodies.back()) ? 1 : 0);
  }
  return family;
}

struct Method {
  std::string name;
  peers::Ask ask;
};

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

void compare(const std::string& title, const std::vector<char>& right,
             const std::vector<Method>& methods, int runs) {
  std::vector<std::vector<double>> times(methods.size());
  std::vector<std::size_t> missed(methods.size()), invented(methods.size());
  std::vector<char> answers(right.size());
  // In turns, so that a slow moment of the machine does not fall on one method only.
  for (int run = 0; run <= runs; ++run) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const double start = processor_time();
      methods[m].ask(answers);
      const double elapsed = processor_time() - start;
      if (run > 0) {
        times[m].push_back(elapsed / static_cast<double>(right.size()));
        continue;
      }
      for (std::size_t i = 0; i < right.size(); ++i) {  // the first one warms up
        missed[m] += answers[i] == 0 && right[i] != 0;
        invented[m] += answers[i] != 0 && right[i] == 0;
      }
    }
  }
  std::printf("%s, %zu rays, %td hit\n  %-38s %8s %17s %8s %9s\n", title.c_str(), right.size(),
              std::count(right.begin(), right.end(), 1), "", "ns a ray", "least - most", "missed",
              "invented");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::sort(times[m].begin(), times[m].end());
    std::printf("  %-38s %8.1f %7.1f - %7.1f %8zu %9zu\n", methods[m].name.c_str(),
                times[m][times[m].size() / 2], times[m].front(), times[m].back(), missed[m],
                invented[m]);
  }
  std::printf("\n");
  std::fflush(stdout);
}

/// The book's methods: one that finds a passage decides by what a ray meets of it first.
template <class Rays, class Bodies, class Call>
Method decides(const char* name, const Rays& rays, const Bodies& bodies, Call call) {
  return {name, [&rays, &bodies, call](std::vector<char>& answers) {
            peers::in_turn(rays, bodies, answers, call);
          }};
}
template <class Rays, class Bodies, class Call>
Method passes(const char* name, const Rays& rays, const Bodies& bodies, Call call) {
  return decides(name, rays, bodies, [call](const auto& ray, const auto& body) {
    const auto found = call(ray, body);
    return found && contact::first_hit(ray, *found);
  });
}
/// What is computed only to be timed.
volatile double kept = 0;

/// As decides, with t, which is added up so that it is computed.
template <class Rays, class Bodies, class Call>
Method hits(const char* name, const Rays& rays, const Bodies& bodies, Call call) {
  return {name, [&rays, &bodies, call](std::vector<char>& answers) {
            double sum = 0;
            peers::in_turn(rays, bodies, answers, [&](const auto& ray, const auto& body) {
              const auto hit = call(ray, body);
              if (hit) sum += static_cast<double>(hit->t);
              return hit.has_value();
            });
            kept = sum;
          }};
}
template <class Call>
auto first_of(Call call) {
  return [call](const auto& ray, const auto& body) {
    const auto found = call(ray, body);
    return found ? contact::first_hit(ray, *found) : std::nullopt;
  };
}

/// The textbook's formula as a decision alone: no passage is made of it.
bool bare_textbook(const Ray<double>& ray, const Sphere<double>& ball) {
  const Point m = ray.origin - ball.centre;
  const double a = ray.direction.dot(ray.direction), b = 2 * ray.direction.dot(m);
  const double discriminant = b * b - 4 * a * (m.dot(m) - ball.radius * ball.radius);
  return discriminant >= 0 && (-b + std::sqrt(discriminant)) / (2 * a) >= 0;
}

/// The same of the branchless slabs.
bool bare_slabs(const Ray<double>& ray, const Box& box) {
  double entry = 0, exit = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double inverse = 1 / ray.direction(k);
    const double to_low = (box.low(k) - ray.origin(k)) * inverse;
    const double to_high = (box.high(k) - ray.origin(k)) * inverse;
    entry = std::max(entry, std::min(to_low, to_high));
    exit = std::min(exit, std::max(to_low, to_high));
  }
  return entry <= exit;
}

void compare(const std::string& title, const Balls& family, int runs) {
  const auto textbook = [](const auto& ray, const auto& ball) {
    return contact::passage_by_textbook(ray, ball);
  };
  const auto nearest = [](const auto& ray, const auto& ball) {
    return contact::passage_by_nearest_point(ray, ball);
  };
  std::vector<Method> methods{
      passes("Contact Hours, textbook, float", family.rays_in_float, family.bodies_in_float,
             textbook),
      passes("Contact Hours, textbook", family.rays, family.bodies, textbook),
      decides("textbook, decision alone", family.rays, family.bodies, bare_textbook),
      passes("Contact Hours, nearest point", family.rays, family.bodies, nearest),
      decides("Contact Hours, hits_sphere", family.rays, family.bodies,
              [](const auto& ray, const auto& ball) { return contact::hits_sphere(ray, ball); }),
      hits("Contact Hours, textbook, t", family.rays, family.bodies, first_of(textbook)),
      hits("Contact Hours, first_hit, t", family.rays, family.bodies,
           [](const auto& ray, const auto& ball) { return contact::first_hit(ray, ball); })};
#ifdef CONTACT_HAS_CGAL
  methods.push_back({"CGAL, do_intersect", peers::cgal(family.questions)});
#endif
#ifdef CONTACT_HAS_EMBREE
  methods.push_back({"Embree, occluded, sse2, robust",
                     peers::embree(family.questions, "threads=1,isa=sse2", true)});
  methods.push_back(
      {"Embree, occluded, its default", peers::embree(family.questions, "threads=1", false)});
#endif
  compare(title, family.right, methods, runs);
}

void compare(const std::string& title, const Boxes& family, int runs) {
  const auto branchless = [](const auto& ray, const auto& box) {
    return contact::passage_by_branchless_slabs(ray, box);
  };
  std::vector<Method> methods{
      passes("Contact Hours, branchless, float", family.rays_in_float, family.bodies_in_float,
             branchless),
      passes("Contact Hours, branchless", family.rays, family.bodies, branchless),
      decides("branchless, decision alone", family.rays, family.bodies, bare_slabs),
      passes("Contact Hours, divided", family.rays, family.bodies,
             [](const auto& ray, const auto& box) {
               return contact::passage_by_slabs_with_division(ray, box);
             }),
      passes("Contact Hours, padded", family.rays, family.bodies,
             [](const auto& ray, const auto& box) {
               return contact::passage_by_padded_slabs(ray, box);
             }),
      decides("Contact Hours, hits_box", family.rays, family.bodies,
              [](const auto& ray, const auto& box) { return contact::hits_box(ray, box); }),
      hits("Contact Hours, branchless, t", family.rays, family.bodies, first_of(branchless)),
      hits("Contact Hours, first_hit, t", family.rays, family.bodies,
           [](const auto& ray, const auto& box) { return contact::first_hit(ray, box); })};
#ifdef CONTACT_HAS_CGAL
  methods.push_back({"CGAL, do_intersect, Iso_cuboid_3", peers::cgal(family.questions)});
  methods.push_back({"CGAL, do_intersect, Bbox_3", peers::cgal_bbox(family.questions)});
#endif
  compare(title, family.right, methods, runs);
}

/// Calls with the title and the rays of each family, one after the other.
template <class Call>
void each_family(std::size_t count, const Call& call) {
  std::uint64_t seed = 0;
  const auto balls = [&](const char* title, auto draw) {
    call(title, drawn<Balls>(count, ++seed, draw));
  };
  const auto boxes = [&](const char* title, auto draw) {
    call(title, drawn<Boxes>(count, ++seed, draw));
  };
  balls("ball, random", families::sphere_random);
  balls("ball, tangents, rounded", families::sphere_tangent);
  balls("ball, 100 to 1,000,000 m away", families::sphere_far);
  balls("ball, start on the surface, rounded", families::sphere_surface);
  balls("ball, start inside", families::sphere_inside);
  balls("ball, whole numbers", families::sphere_grid);
  boxes("box, random", families::box_random);
  boxes("box, through an edge, rounded", families::box_edge);
  boxes("box, in the plane of a face", families::box_face);
  boxes("box, at an edge, far away", families::box_far);
  boxes("box, start on the surface", families::box_surface);
  boxes("box, start inside", families::box_inside);
  boxes("box, whole numbers", families::box_grid);
}

void write(std::ofstream& out, const std::array<float, 3>& v) {
  out.write(reinterpret_cast<const char*>(v.data()), sizeof v);
}
void write(std::ofstream& out, const BallOfFloats& ball) {
  write(out, ball.centre);
  write(out, std::array<float, 3>{ball.radius, 0, 0});
}
void write(std::ofstream& out, const BoxOfFloats& box) {
  write(out, box.low);
  write(out, box.high);
}
/// A line with the title and the number of rays, then 13 floats a ray: origin, direction, low and
/// high or centre and radius, and whether it hits.
template <class Family>
void write(std::ofstream& out, const char* title, const Family& family) {
  out << title << "\t" << family.right.size() << "\n";
  for (std::size_t i = 0; i < family.right.size(); ++i) {
    write(out, family.questions.rays[i].origin);
    write(out, family.questions.rays[i].direction);
    write(out, family.questions.bodies[i]);
    const auto hit = static_cast<float>(family.right[i]);
    out.write(reinterpret_cast<const char*>(&hit), sizeof hit);
  }
}

std::size_t number(int argc, char** argv, int at, std::size_t otherwise) {
  return argc > at ? static_cast<std::size_t>(std::max(1L, std::atol(argv[at]))) : otherwise;
}

}  // namespace

int main(int argc, char** argv) {
  // Few enough that Embree can have a scene for each ball.
  constexpr std::size_t usual = 20000;
  if (argc > 2 && std::string_view(argv[1]) == "--write") {
    std::ofstream out(argv[2], std::ios::binary);
    each_family(number(argc, argv, 3, usual),
                [&out](const char* title, const auto& family) { write(out, title, family); });
    return out.flush() ? 0 : 1;
  }
  const int runs = static_cast<int>(number(argc, argv, 2, 15));
  each_family(number(argc, argv, 1, usual),
              [runs](const char* title, const auto& family) { compare(title, family, runs); });
}
