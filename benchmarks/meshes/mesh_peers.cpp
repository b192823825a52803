// Compares the book's trees of meshes with those of Embree, CGAL, FCL and Coal: how long they take
// to make, how long a question takes, and the wrong answers of each. Times are those of the
// processor, and each is also given as a share of it that the book takes: the median and the range
// over runs in which all take turns. usage:
//   mesh_peers [rays] [runs]
//   mesh_peers --write FOLDER [rays]  the questions and right answers, for three_peer.mjs and
//                                     igl_peer.py, which ask `mesh_peers --ask FOLDER` in turn
//   mesh_peers --ask FOLDER FAMILY    prints what the book takes for the rays or points of a family
#include "../comparison.hpp"
#include "peers.hpp"
#include "questions.hpp"

#include <algorithm>
#include <contact/mesh_columns.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/point_in_polyhedron.hpp>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <string_view>
#include <utility>

namespace {

using peers::Answers;
using questions::Points;
using questions::Rays;
using questions::Scene;

/// What is computed only to be timed.
volatile double kept = 0;

/// One way to answer all questions of a family.
using Method = comparison::Method<Answers>;
/// A count of an answer that is not right, with its title.
struct Fault {
  const char* title;
  std::function<bool(int got, std::size_t i)> is;
};

/// Prints the times of the methods and counts the faults of their answers to `count` questions.
void compare(const std::string& title, std::size_t count, const char* unit, double per,
             const std::vector<Method>& methods, const std::vector<Fault>& faults, int runs) {
  std::vector<comparison::Fault<Answers>> counts;
  for (const Fault& fault : faults) {
    counts.push_back({fault.title, [&fault, count](const Answers& answers) {
                        std::size_t wrong = 0;
                        for (std::size_t i = 0; i < count; ++i) wrong += fault.is(answers[i], i);
                        return wrong;
                      }});
  }
  comparison::compare(title, unit, per, methods, counts, runs, Answers(count));
}

/// The book's trees and those of the peers.
struct Trees {
  const Scene& scene;
  contact::MeshTree<double> in_double;
  contact::MeshTree<float> in_float;
  contact::MeshColumns<double> columns;
  std::vector<std::pair<std::string, peers::Tree>> peers;

  explicit Trees(const Scene& of)
      : scene(of), in_double(of.body.in_double), in_float(of.body.in_float), columns(in_double) {
#ifdef CONTACT_HAS_EMBREE
    peers.emplace_back("Embree, sse2, robust",
                       peers::embree(scene.plain, "threads=1,isa=sse2", true));
    peers.emplace_back("Embree, its default", peers::embree(scene.plain, "threads=1", false));
#endif
#ifdef CONTACT_HAS_CGAL
    peers.emplace_back("CGAL", peers::cgal(scene.plain));
#endif
#ifdef CONTACT_HAS_FCL
    peers.emplace_back("FCL", peers::fcl(scene.plain));
#endif
#ifdef CONTACT_HAS_COAL
    peers.emplace_back("Coal", peers::coal(scene.plain));
#endif
  }
};

void compare_building(Trees& trees, int runs) {
  const Scene& scene = trees.scene;
  std::vector<Method> methods{
      {"Contact Hours, double",
       [&](Answers&) { trees.in_double = contact::MeshTree<double>(scene.body.in_double); }},
      {"Contact Hours, float",
       [&](Answers&) { trees.in_float = contact::MeshTree<float>(scene.body.in_float); }},
      {"Contact Hours, with columns",
       [&](Answers&) { trees.columns = contact::MeshColumns<double>(scene.body.in_double); }}};
  for (const auto& [name, tree] : trees.peers) {
    methods.push_back({name, [build = tree.build](Answers&) { build(); }});
  }
  compare(scene.title + ", " + std::to_string(scene.plain.triangles.size()) +
              " triangles: building the tree",
          0, "ms", 1e6, methods, {}, runs);
}

/// The peers that have this question.
template <class Question, class Asked>
void add(std::vector<Method>& methods, const Trees& trees, const char* what, Question question,
         const Asked& asked, bool from_far = false) {
  for (const auto& [name, tree] : trees.peers) {
    if (from_far && tree.near_only) continue;
    if (const auto& ask = tree.*question; ask) {
      methods.push_back({name + what, [&ask, &asked](Answers& answers) { ask(asked, answers); }});
    }
  }
}

template <class Lines, class Call>
Method book(const char* name, const Lines& lines, Call call) {
  return {name, [&lines, call](Answers& answers) {
            double sum = 0;
            peers::in_turn(lines.size(), answers,
                           [&](std::size_t i) { return call(lines[i], sum); });
            kept = sum;
          }};
}

/// The triangle of a hit, or −1. t is added up so that it is computed.
template <class Hit>
int named(const Hit& hit, double& sum) {
  if (!hit) return -1;
  sum += static_cast<double>(hit->hit.t);
  return hit->triangle;
}

void compare(const Trees& trees, const Rays& rays, int runs) {
  const Scene& scene = trees.scene;
  const std::size_t count = rays.in_double.size();
  const auto titled = [&](const char* what) {
    return scene.title + ", " + rays.title + ", " + std::to_string(count) + " rays: " + what;
  };
  const auto& of_double = trees.in_double;
  const auto& of_float = trees.in_float;
  std::vector<Method> methods{
      book("Contact Hours, first", rays.in_double,
           [&](const auto& ray, double& sum) { return named(of_double.first(ray), sum); }),
      book("Contact Hours, first, float", rays.in_float,
           [&](const auto& ray, double& sum) { return named(of_float.first(ray), sum); })};
  add(methods, trees, ", first", &peers::Tree::first, rays.plain);
  const auto missed = [&](int got, std::size_t i) {
    return got < 0 && rays.right[i].triangle >= 0;
  };
  const auto invented = [&](int got, std::size_t i) {
    return got >= 0 && rays.right[i].triangle < 0;
  };
  // Another triangle than the first, and none that touches it.
  const auto later = [&](int got, std::size_t i) {
    const int right = rays.right[i].triangle;
    return got >= 0 && right >= 0 && !mesh_truth::share_a_vertex(scene.body.in_double, got, right);
  };
  const double per = static_cast<double>(count);
  compare(titled("the first hit"), count, "ns a ray", per, methods,
          {{"missed", missed}, {"invented", invented}, {"later", later}}, runs);

  const auto no_hit = [&](int got, std::size_t i) {
    return got == 0 && rays.right[i].triangle >= 0;
  };
  const auto wrong_hit = [&](int got, std::size_t i) {
    return got != 0 && rays.right[i].triangle < 0;
  };
  methods = {book("Contact Hours, any", rays.in_double,
                  [&](const auto& ray, double&) { return of_double.any(ray); }),
             book("Contact Hours, any, float", rays.in_float,
                  [&](const auto& ray, double&) { return of_float.any(ray); })};
  add(methods, trees, ", any", &peers::Tree::any, rays.plain);
  compare(titled("any hit"), count, "ns a ray", per, methods,
          {{"missed", no_hit}, {"invented", wrong_hit}}, runs);

  const auto no_segment = [&](int got, std::size_t i) {
    return got == 0 && rays.right_for_segment[i].triangle >= 0;
  };
  const auto wrong_segment = [&](int got, std::size_t i) {
    return got != 0 && rays.right_for_segment[i].triangle < 0;
  };
  methods = {book("Contact Hours, any", rays.segments,
                  [&](const auto& segment, double&) { return of_double.any(segment); })};
  add(methods, trees, ", any", &peers::Tree::segment, rays.plain, rays.name == "rays_far");
  compare(titled("any hit of a segment"), count, "ns a ray", per, methods,
          {{"missed", no_segment}, {"invented", wrong_segment}}, runs);
}

int sign_of(contact::Where where) {
  return where == contact::Where::inside ? 1 : where == contact::Where::on ? 0 : -1;
}

void compare(const Trees& trees, const Points& points, int runs) {
  const Scene& scene = trees.scene;
  const std::size_t count = points.in_double.size();
  const auto wrong = [&](int got, std::size_t i) { return got != points.right[i]; };
  const auto asked = [&](const char* name, const auto& of) {
    std::vector<Method> methods{book(name, points.in_double, [&of](const auto& p, double&) {
      return sign_of(contact::locate_in_mesh(p, of).where);
    })};
    add(methods, trees, ", Side_of_triangle_mesh", &peers::Tree::locate, points.plain);
    compare(scene.title + ", " + points.title + ", " + std::to_string(count) + " points, " +
                std::to_string(std::count(points.right.begin(), points.right.end(), 0)) +
                " on the surface",
            count, "ns a point", static_cast<double>(count), methods, {{"wrong", wrong}}, runs);
  };
  asked("Contact Hours, by the tree", trees.in_double);
  asked("Contact Hours, by columns", trees.columns);
}

std::size_t number(int argc, char** argv, int at, std::size_t otherwise) {
  return argc > at ? static_cast<std::size_t>(std::max(1L, std::atol(argv[at]))) : otherwise;
}

/// The book's time for one family of a folder, in the process that waits for it.
int ask(const std::string& folder, const std::string& family) {
  const Scene scene = questions::read_scene(folder);
  const contact::MeshTree<double> tree(scene.body.in_double);
  Answers answers;
  const auto timed = [&](const auto& lines, const auto& call) {
    const Method method = book("", lines, call);
    answers.resize(lines.size());
    method.ask(answers);
    const double start = comparison::processor_time();
    method.ask(answers);
    std::printf("%.3f\n",
                (comparison::processor_time() - start) / static_cast<double>(lines.size()));
    return 0;
  };
  if (family.starts_with("points")) {
    return timed(questions::read_points(folder, family), [&](const auto& p, double&) {
      return sign_of(contact::locate_in_mesh(p, tree).where);
    });
  }
  return timed(questions::read_rays(folder, family),
               [&](const auto& ray, double& sum) { return named(tree.first(ray), sum); });
}

}  // namespace

int main(int argc, char** argv) {
  constexpr std::size_t usual = 10000;
  const std::string_view option = argc > 2 ? argv[1] : "";
  if (option == "--write") return questions::write(argv[2], number(argc, argv, 3, usual)) ? 0 : 1;
  if (option == "--ask" && argc > 3) return ask(argv[2], argv[3]);
  const std::size_t count = number(argc, argv, 1, usual);
  const int runs = static_cast<int>(number(argc, argv, 2, 15));
  for (const Scene& scene : questions::scenes()) {
    Trees trees(scene);
    compare_building(trees, runs);
    questions::each_family_of_rays(scene, count,
                                   [&](const Rays& rays) { compare(trees, rays, runs); });
    questions::each_family_of_points(scene, count,
                                     [&](const Points& points) { compare(trees, points, runs); });
  }
}
