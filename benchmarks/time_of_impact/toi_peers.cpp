// Compares the book's times of impact with those of FCL, Bullet, Box2D and Box3D: of boxes and
// other bodies that translate, of boxes that turn, and of vertices, faces and edges that move.
// Times are those of the processor, in turns of all methods. usage:
//   toi_peers [N] [runs] [PART]   N pairs of each family; of one part: translating, bodies, turning
//                                 or points
//   toi_peers --write FOLDER [N]     writes the moving points, for ipctk_peer.py
//   toi_peers --ask FOLDER NAME      the book's time for those of a file, ns each
#include <algorithm>
#include <cmath>
#include <contact/box_sweep.hpp>
#include <contact/conservative_advancement.hpp>
#include <contact/moving_spheres.hpp>
#include <contact/moving_triangles.hpp>
#include <contact/oriented_box.hpp>
#include <contact/translating_impact.hpp>
#include <contact/turning_impact.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "../comparison.hpp"
#include "11_time_of_impact/hard_moving.hpp"
#include "body_scenes.hpp"
#include "careful.hpp"
#include "peers.hpp"
#include "toi_scenes.hpp"

namespace {

using peers::Answer;
using peers::Answers;
using peers::Motion;
using toi_scenes::V;

/// Times later than this after the touch count as past it: the error of the time that FCL is asked
/// for, 1e-4 of the step.
constexpr double late = 1e-4;
/// A touch that is reported where the boxes are still farther apart counts as early: a hundredth of
/// their largest half length.
constexpr double close_enough = 0.01;
double close_to(const std::array<peers::Box, 2>& pair) {
  double largest = 0;
  for (const peers::Box& box : pair) {
    for (const double h : box.half_lengths) largest = std::max(largest, h);
  }
  return close_enough * largest;
}

std::vector<peers::Caster> others(bool turning, bool in_plane) {
  std::vector<peers::Caster> all;
  const auto add = [&](const std::vector<peers::Caster>& casters) {
    for (const auto& caster : casters) {
      if ((!turning || caster.turns) && (!caster.in_plane || in_plane)) all.push_back(caster);
    }
  };
#ifdef CONTACT_HAS_FCL
  add(peers::fcl_casters());
#endif
#ifdef CONTACT_HAS_BULLET
  add(peers::bullet_casters());
#endif
#ifdef CONTACT_HAS_BOX2D
  add(peers::box2d_casters());
#endif
#ifdef CONTACT_HAS_BOX2D_V3
  add(peers::box2d_v3_casters());
#endif
#ifdef CONTACT_HAS_BOX3D
  add(peers::box3d_casters());
#endif
  return all;
}

/// What each method got wrong in all scenes of a part, by its name.
struct Total {
  std::size_t asked = 0;
  std::vector<std::size_t> counted;
};
using Totals = std::map<std::string, Total>;

void add_to(Totals& totals, const std::vector<comparison::Row>& rows, std::size_t asked) {
  for (const auto& row : rows) {
    Total& total = totals[row.name];
    total.asked += asked;
    total.counted.resize(row.counted.size());
    for (std::size_t i = 0; i < row.counted.size(); ++i) total.counted[i] += row.counted[i];
  }
}
void print(const char* title, const Totals& totals, const std::vector<const char*>& faults) {
  std::printf("%s\n  %-36s %9s", title, "", "asked");
  for (const char* fault : faults) std::printf(" %9s", fault);
  std::printf("\n");
  for (const auto& [name, total] : totals) {
    std::printf("  %-36s %9zu", name.c_str(), total.asked);
    for (const std::size_t count : total.counted) std::printf(" %9zu", count);
    std::printf("\n");
  }
  std::printf("\n");
}

/// Counts the answers for which something is true of answer i.
template <class Is>
std::function<std::size_t(const Answers&)> counting(Is is) {
  return [is](const Answers& answers) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) count += is(answers[i], i) ? 1 : 0;
    return count;
  };
}

// ------------------------------------------------------------------------ boxes that translate

void compare_translating(const toi_scenes::Translating& scene, int runs, Totals& totals) {
  const auto& pairs = scene.pairs;
  std::vector<std::array<contact::OrientedBox<double>, 2>> bodies;
  for (const auto& [a, b] : pairs) {
    bodies.push_back({contact::OrientedBox<double>{a.frame.origin, a.frame.axes, a.half_lengths},
                      contact::OrientedBox<double>{b.frame.origin, b.frame.axes, b.half_lengths}});
  }
  std::vector<comparison::Method<Answers>> methods{
      {"Contact Hours, box_impact",
       [&](Answers& answers) {
         for (std::size_t i = 0; i < pairs.size(); ++i) {
           const auto touch = contact::box_impact(pairs[i][0], pairs[i][1]);
           answers[i] = {touch.has_value(), touch ? touch->t : 0, false};
         }
       }},
      {"Contact Hours, translating_impact", [&](Answers& answers) {
         for (std::size_t i = 0; i < pairs.size(); ++i) {
           const auto found = contact::translating_impact(bodies[i][0], pairs[i][0].displacement,
                                                          bodies[i][1], pairs[i][1].displacement);
           answers[i] = {found.meets, found.t, false};
         }
       }}};
  for (const auto& caster : others(false, scene.in_plane))
    methods.push_back(
        careful::method<peers::Pairs>(caster.name, caster.prepare, scene.plain, scene.title));
  const auto& right = scene.right;
  const auto speed = [&pairs](std::size_t i) {
    return V(pairs[i][0].displacement - pairs[i][1].displacement).norm();
  };
  const auto touching = static_cast<std::size_t>(
      std::count_if(right.begin(), right.end(), [](const auto& t) { return t.has_value(); }));
  const auto rows = comparison::compare<Answers>(
      scene.title + ", " + std::to_string(pairs.size()) + " pairs, " + std::to_string(touching) +
          " touch",
      "ns a pair", static_cast<double>(pairs.size()), methods,
      {{"missed",
        counting([&](const Answer& x, std::size_t i) { return right[i] && !x.hit && !x.failed; })},
       {"false", counting([&](const Answer& x, std::size_t i) { return !right[i] && x.hit; })},
       {"past", counting([&](const Answer& x, std::size_t i) {
          return right[i] && x.hit && !(x.t <= *right[i] + late);
        })},
       {"early", counting([&](const Answer& x, std::size_t i) {
          return right[i] && x.hit && (*right[i] - x.t) * speed(i) > close_to(scene.plain[i]);
        })},
       {"unknown", counting([&](const Answer& x, std::size_t) { return x.failed; })}},
      runs, Answers(pairs.size()));
  add_to(totals, rows, pairs.size());
}

// ----------------------------------------------------------------------- bodies that translate

void compare_bodies(const body_scenes::Scene& scene, int runs, Totals& totals) {
  const auto& pairs = scene.pairs;
  std::vector<comparison::Method<Answers>> methods{
      {"Contact Hours, translating_impact", [&pairs](Answers& answers) {
         for (std::size_t i = 0; i < pairs.size(); ++i) {
           const auto& p = pairs[i];
           const auto found = std::visit(
               [&](const auto& a, const auto& b) {
                 return contact::translating_impact(a, p.displacement_a, b, p.displacement_b);
               },
               p.a, p.b);
           answers[i] = {found.meets, found.t, false};
         }
       }}};
  using Ball = contact::Sphere<double>;
  if (std::holds_alternative<Ball>(pairs[0].a) && std::holds_alternative<Ball>(pairs[0].b)) {
    methods.push_back({"Contact Hours, moving_spheres_impact", [&pairs](Answers& answers) {
                         for (std::size_t i = 0; i < pairs.size(); ++i) {
                           const auto& p = pairs[i];
                           const auto t = contact::moving_spheres_impact(
                               std::get<Ball>(p.a), p.displacement_a, std::get<Ball>(p.b),
                               p.displacement_b);
                           answers[i] = {t.has_value(), t.value_or(0), false};
                         }
                       }});
  }
  std::vector<peers::BodyCaster> casters;
#ifdef CONTACT_HAS_FCL
  for (const auto& caster : peers::fcl_body_casters()) casters.push_back(caster);
#endif
#ifdef CONTACT_HAS_BULLET
  for (const auto& caster : peers::bullet_body_casters()) casters.push_back(caster);
#endif
  const auto& [first, second] = scene.plain_pairs.front();
  for (const auto& caster : casters) {
    if (caster.takes(first.kind) && caster.takes(second.kind))
      methods.push_back(careful::method<peers::BodyPairs>(caster.name, caster.prepare,
                                                          scene.plain_pairs, scene.title));
  }
  const auto exact = [](double t) { return oracle::exact(std::clamp(t, 0.0, 1.0)); };
  const auto rows = comparison::compare<Answers>(
      scene.title + ", " + std::to_string(pairs.size()) + " pairs, " +
          std::to_string(std::count(scene.right.begin(), scene.right.end(), 1)) + " touch",
      "ns a pair", static_cast<double>(pairs.size()), methods,
      {{"missed", counting([&](const Answer& x, std::size_t i) {
          return scene.right[i] != 0 && !x.hit && !x.failed;
        })},
       {"false",
        counting([&](const Answer& x, std::size_t i) { return scene.right[i] == 0 && x.hit; })},
       {"past", counting([&](const Answer& x, std::size_t i) {
          return scene.right[i] != 0 && x.hit && x.t > late && scene.touch_by(i, exact(x.t - late));
        })},
       {"early", counting([&](const Answer& x, std::size_t i) {
          return scene.right[i] != 0 && x.hit && scene.distance_at(i, exact(x.t)) > close_enough;
        })},
       {"unknown", counting([&](const Answer& x, std::size_t) { return x.failed; })}},
      runs, Answers(pairs.size()));
  add_to(totals, rows, pairs.size());
}

// ----------------------------------------------------------------------------- boxes that turn

void compare_turning(const toi_scenes::Turning& scene, int runs, Totals& totals) {
  const auto& pairs = scene.pairs;
  std::map<Motion, std::vector<toi_scenes::Sampled>> proved;
  const auto proofs = [&](Motion motion) -> const std::vector<toi_scenes::Sampled>& {
    auto& all = proved[motion];
    for (std::size_t i = all.size(); i < pairs.size(); ++i)
      all.push_back(toi_scenes::sampled(scene.plain[i], motion));
    return all;
  };
  std::map<std::size_t, Motion> motions;
  std::vector<comparison::Method<Answers>> methods;
  const auto advance = [&](double tolerance) {
    return [&pairs, tolerance](Answers& answers) {
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto found =
            contact::rotating_boxes_impact<double>(pairs[i][0], pairs[i][1], 1.0, tolerance, 1000);
        answers[i] = {found.end == contact::ConservativeEnd::impact, found.t,
                      found.end == contact::ConservativeEnd::gave_up};
      }
    };
  };
  using Box = contact::OrientedBox<double>;
  std::vector<std::array<std::pair<Box, contact::TurningMotion<double>>, 2>> bodies;
  for (const auto& pair : pairs) {
    const auto turning = [](const contact::RotatingBox<double>& box) {
      return std::pair{
          Box{box.position, contact::matrix_of(box.orientation), box.half_lengths},
          contact::turning_motion<double>(box.position, box.velocity, box.angular_velocity)};
    };
    bodies.push_back({turning(pair[0]), turning(pair[1])});
  }
  const auto by_planes = [&](double tolerance) {
    return [&bodies, tolerance](Answers& answers) {
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto& [a, b] = bodies[i];
        const auto found = contact::turning_impact(a.first, a.second, b.first, b.second, tolerance);
        answers[i] = {found.end == contact::ConservativeEnd::impact, found.t,
                      found.end == contact::ConservativeEnd::gave_up};
      }
    };
  };
  methods.push_back({"Contact Hours, turning_impact 1e-4", by_planes(1e-4)});
  methods.push_back({"Contact Hours, turning_impact 1e-9", by_planes(1e-9)});
  methods.push_back({"Contact Hours, rotating_boxes 1e-4", advance(1e-4)});
  methods.push_back({"Contact Hours, rotating_boxes 1e-9", advance(1e-9)});
  for (const auto& caster : others(true, scene.in_plane)) {
    motions[methods.size()] = caster.motion;
    methods.push_back(
        careful::method<peers::Pairs>(caster.name, caster.prepare, scene.plain, scene.title));
  }
  // Each method is judged by its own motion between the same poses: the answers carry no name, so
  // the methods are counted one after the other, as compare() does.
  std::size_t judged = 0;
  const std::size_t faults = 5;
  const auto counted = [&](auto is) {
    return [&, is](const Answers& answers) {
      const std::size_t method = judged++ / faults;
      const Motion motion = motions.contains(method) ? motions.at(method) : Motion::constant_rate;
      const auto& right = proofs(motion);
      std::size_t count = 0;
      for (std::size_t i = 0; i < answers.size(); ++i)
        count += is(answers[i], right[i], i, motion) ? 1 : 0;
      return count;
    };
  };
  using toi_scenes::Sampled;
  std::size_t touch = 0, clear = 0;
  for (const Sampled& p : proofs(Motion::constant_rate)) {
    touch += p.touches ? 1 : 0;
    clear += p.clear ? 1 : 0;
  }
  const auto rows = comparison::compare<Answers>(
      scene.title + ", " + std::to_string(pairs.size()) + " pairs, " + std::to_string(touch) +
          " touch, " + std::to_string(clear) + " stay apart by 1 cm",
      "ns a pair", static_cast<double>(pairs.size()), methods,
      {{"missed", counted([](const Answer& x, const Sampled& p, std::size_t, Motion) {
          return p.touches && !x.hit && !x.failed;
        })},
       {"false", counted([](const Answer& x, const Sampled& p, std::size_t, Motion) {
          return p.clear && x.hit;
        })},
       {"past", counted([](const Answer& x, const Sampled& p, std::size_t, Motion) {
          return p.touches && x.hit && !(x.t <= p.by + late);
        })},
       {"early", counted([&](const Answer& x, const Sampled& p, std::size_t i, Motion motion) {
          return !p.clear && x.hit &&
                 toi_scenes::gap(scene.plain[i][0], scene.plain[i][1], motion,
                                 std::clamp(x.t, 0.0, 1.0)) > close_to(scene.plain[i]);
        })},
       {"unknown",
        counted([](const Answer& x, const Sampled&, std::size_t, Motion) { return x.failed; })}},
      runs, Answers(pairs.size()));
  add_to(totals, rows, pairs.size());
}

// --------------------------------------------------------------------------------- moving points

Answer asked_of_book(const families::MovingPoints& p, bool edges) {
  std::optional<contact::FeatureImpact<double>> found;
  if (edges) {
    found = contact::edge_edge_impact<double>({{p.start[0], p.start[1]}, {p.end[0], p.end[1]}},
                                              {{p.start[2], p.start[3]}, {p.end[2], p.end[3]}});
  } else {
    found = contact::vertex_face_impact<double>(
        {p.start[0], p.end[0]},
        {{p.start[1], p.start[2], p.start[3]}, {p.end[1], p.end[2], p.end[3]}});
  }
  return {found.has_value(), found ? found->t : 0, false};
}

void compare_points(const toi_scenes::Points& scene, int runs, Totals& totals) {
  const auto& all = scene.all;
  const auto rounded = [&](double tolerance) {
    return [&all, &scene, tolerance](Answers& answers) {
      for (std::size_t i = 0; i < all.size(); ++i) {
        const hard_moving::Moving p{scene.edges, all[i].start, all[i].end};
        const auto t = hard_moving::by_cubic(p, tolerance);
        answers[i] = {t.has_value(), t.value_or(0), false};
      }
    };
  };
  const std::vector<comparison::Method<Answers>> methods{
      {"Contact Hours",
       [&](Answers& answers) {
         for (std::size_t i = 0; i < all.size(); ++i)
           answers[i] = asked_of_book(all[i], scene.edges);
       }},
      {"cubic in double", rounded(0)},
      {"cubic in double, tolerance 1e-6", rounded(1e-6)}};
  const auto& right = scene.right;
  const auto touching = static_cast<std::size_t>(
      std::count_if(right.begin(), right.end(), [](const auto& t) { return t.has_value(); }));
  const auto rows = comparison::compare<Answers>(
      scene.title + ", " + std::to_string(all.size()) + " queries, " + std::to_string(touching) +
          " touch",
      "ns a query", static_cast<double>(all.size()), methods,
      {{"missed", counting([&](const Answer& x, std::size_t i) { return right[i] && !x.hit; })},
       {"false", counting([&](const Answer& x, std::size_t i) { return !right[i] && x.hit; })},
       {"past", counting([&](const Answer& x, std::size_t i) {
          return right[i] && x.hit && x.t > *right[i];
        })}},
      runs, Answers(all.size()));
  add_to(totals, rows, all.size());
}

/// Eight points of each query, and −1 or the exact time.
void write(const std::filesystem::path& folder, std::size_t count) {
  std::filesystem::create_directories(folder);
  std::ofstream list(folder / "families.tsv");
  for (const bool edges : {false, true}) {
    for (const auto family : families::all_points) {
      const auto scene = toi_scenes::points(family, edges, count);
      std::ofstream out(folder / (scene.name + ".f64"), std::ios::binary);
      std::ofstream times(folder / (scene.name + ".right.f64"), std::ios::binary);
      const auto put = [](std::ofstream& to, double x) {
        to.write(reinterpret_cast<const char*>(&x), sizeof x);
      };
      for (std::size_t i = 0; i < scene.all.size(); ++i) {
        for (const auto* at : {&scene.all[i].start, &scene.all[i].end}) {
          for (const V& v : *at) {
            for (int k = 0; k < 3; ++k) put(out, v(k));
          }
        }
        put(times, scene.right[i].value_or(-1));
      }
      list << scene.name << '\t' << scene.title << '\n';
    }
  }
}

int ask(const std::filesystem::path& folder, const std::string& name) {
  std::ifstream in(folder / (name + ".f64"), std::ios::binary);
  std::vector<families::MovingPoints> all;
  std::array<double, 24> x{};
  while (in.read(reinterpret_cast<char*>(x.data()), sizeof x)) {
    families::MovingPoints p;
    for (std::size_t k = 0; k < 4; ++k) {
      p.start[k] = V(x[3 * k], x[3 * k + 1], x[3 * k + 2]);
      p.end[k] = V(x[12 + 3 * k], x[13 + 3 * k], x[14 + 3 * k]);
    }
    all.push_back(p);
  }
  if (all.empty()) return 1;
  double least = 0;
  std::size_t hits = 0;
  for (int run = 0; run < 3; ++run) {
    const double start = comparison::processor_time();
    for (const auto& p : all) hits += asked_of_book(p, name[0] == 'e').hit ? 1 : 0;
    const double took = (comparison::processor_time() - start) / static_cast<double>(all.size());
    least = run == 0 ? took : std::min(least, took);
  }
  std::printf("%.1f %zu\n", least, hits / 3);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  if (first == "--write" && argc > 2) {
    write(argv[2], comparison::number(argc, argv, 3, 1000));
    comparison::leave(0);
  }
  if (first == "--ask" && argc > 3) comparison::leave(ask(argv[2], argv[3]));
  const std::size_t count = comparison::number(argc, argv, 1, 2000);
  const int runs = static_cast<int>(comparison::number(argc, argv, 2, 5));
  const std::string part = argc > 3 ? argv[3] : "";
  const std::vector<const char*> faults{"missed", "false", "past", "early", "unknown"};
  if (part.empty() || part == "translating") {
    using boxes::Kind;
    Totals space, plane;
    const auto compare = [&](const char* title, std::optional<Kind> kind, bool in_plane) {
      compare_translating(toi_scenes::translating(title, kind, in_plane, count), runs,
                          in_plane ? plane : space);
    };
    compare("oblique boxes anywhere", Kind::plain, false);
    compare("along the axes", Kind::aligned, false);
    compare("integers, along the axes", Kind::grid, false);
    compare("touching as the step ends", Kind::last_moment, false);
    compare("edges crosswise, to rounding", Kind::edges, false);
    compare("10,000 km from the origin", Kind::far, false);
    compare("bullets and a wall of 1 cm", Kind::thin_and_fast, false);
    compare("of every size, 2^-90 to 2^90 m", Kind::sized, false);
    compare("in the plane, rectangles anywhere", Kind::plain, true);
    compare("in the plane, bullets and a wall", std::nullopt, true);
    print("all boxes that translate", space, faults);
    print("all rectangles that translate", plane, faults);
  }
  if (part.empty() || part == "bodies") {
    using moving_bodies::Family;
    Totals totals;
    // Kinds as in moving_bodies: sphere, capsule, lozenge, box, triangle, hull.
    const auto compare = [&](const char* title, Family family, int a, int b) {
      compare_bodies(body_scenes::scene(title, family, a, b, count), runs, totals);
    };
    compare("two spheres", Family::plain, 0, 0);
    compare("a sphere and a box", Family::plain, 0, 3);
    compare("two capsules", Family::plain, 1, 1);
    compare("a capsule and a box", Family::plain, 1, 3);
    compare("a box and a triangle", Family::plain, 3, 4);
    compare("two hulls", Family::plain, 5, 5);
    compare("a small fast capsule and a box", Family::bullet, 1, 3);
    compare("a small fast hull and a hull", Family::bullet, 5, 5);
    compare("a capsule and a box on integers", Family::whole, 1, 3);
    compare("two hulls on integers", Family::whole, 5, 5);
    print("all bodies that translate", totals, faults);
  }
  if (part.empty() || part == "turning") {
    Totals totals, plane;
    for (const auto family : families::all_turning) {
      const auto scene = toi_scenes::turning(family, count);
      compare_turning(scene, runs, scene.in_plane ? plane : totals);
    }
    print("all boxes that turn", totals, faults);
    print("all rectangles that turn", plane, faults);
  }
  if (part.empty() || part == "points") {
    Totals totals;
    for (const bool edges : {false, true}) {
      for (const auto family : families::all_points)
        compare_points(toi_scenes::points(family, edges, count), runs, totals);
    }
    print("all moving points", totals, {"missed", "false", "past"});
  }
  comparison::leave(0);
}
