/// @file
/// The book's smallest sphere and small oriented box compared with those of other programs.
#pragma once

#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <contact/grown_sphere.hpp>
#include <contact/principal_axes.hpp>
#include <contact/smallest_box.hpp>
#include <contact/smallest_sphere.hpp>
#include <contact/welzl_sphere.hpp>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../comparison.hpp"
#include "peers.hpp"
#include "volume_pairs.hpp"
#include "volume_scenes.hpp"

namespace compare_fits {

using volume_scenes::Point;
using volume_scenes::Points;
using volume_scenes::Scene;
using volume_scenes::title_of;

/// Nanoseconds: methods that take longer for all sets are timed once.
inline constexpr double patience = 3e8;

inline std::span<const Point> span_of(const Points& points) { return points; }

/// Whether a method ends within 10 s of processor time. Some programs do not for some input, so it
/// is asked in a process of its own first.
template <class Answer>
bool ends(const comparison::Method<Answer>& method, Answer answer) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const itimerval limit{{0, 0}, {10, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);  // of processor time, then it is ended
    method.ask(answer);
    comparison::leave(0);
  }
  int status = 1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}
/// Adds those that end, and tells of the others.
template <class Volume>
void add(std::vector<comparison::Method<std::vector<Volume>>>& methods, const Scene& scene,
         const std::vector<peers::Fit<Volume>>& fits) {
  for (const peers::Fit<Volume>& fit : fits) {
    if (scene.plain.front().size() > fit.max_points) continue;
    comparison::Method<std::vector<Volume>> method{fit.name, fit.prepare(scene.plain)};
    if (ends(method, std::vector<Volume>(scene.sets.size()))) {
      methods.push_back(std::move(method));
    } else {
      std::printf("%s, %s: crashes or takes more than 10 s\n", scene.title.c_str(),
                  fit.name.c_str());
    }
  }
}

// ---------------------------------------------------------------- the smallest sphere

using Balls = std::vector<peers::Ball>;
using BallMethod = comparison::Method<Balls>;

inline peers::Ball plain(const contact::Sphere<double>& sphere) {
  return {volume_scenes::plain(sphere.centre), sphere.radius};
}

inline BallMethod of_book(const char* name, const Scene& scene, auto make) {
  return {name, [&scene, make](Balls& balls) {
            for (std::size_t i = 0; i < balls.size(); ++i) {
              balls[i] = plain(make(span_of(scene.sets[i])));
            }
          }};
}
inline BallMethod smallest(const Scene& scene) {
  return of_book("Contact Hours", scene, [](std::span<const Point> points) {
    return contact::smallest_sphere<double>(points).sphere;
  });
}

/// The right radius of each set; the program ends if the support of the book's sphere proves none.
inline std::vector<double> right_radii(const Scene& scene) {
  std::vector<double> radii;
  for (const Points& points : scene.sets) {
    const auto found = contact::smallest_sphere<double>(span_of(points));
    const auto support =
        std::span<const int>(found.support).first(static_cast<std::size_t>(found.support_count));
    const std::optional<double> radius = volume_scenes::proven_radius(points, support);
    if (!radius) {
      std::printf("%s: the support of Contact Hours proves no smallest sphere\n",
                  scene.title.c_str());
      comparison::leave(1);
    }
    radii.push_back(*radius);
  }
  return radii;
}

/// The largest share of the time of CGAL's fastest exact sphere that the book takes, and where.
struct SphereGoal {
  double largest = 0;
  std::string where;
  std::size_t wrong = 0;
};

inline void compare_spheres(const Scene& scene, int runs, SphereGoal& goal) {
  const std::vector<double> right = right_radii(scene);
  std::vector<BallMethod> methods{
      smallest(scene), of_book("the lecture's, enclosing", scene,
                               [](auto points) { return contact::grown_sphere<double>(points); })};
  // It recurses as deep as there are points, and need not end.
  if (scene.sets.front().size() <= 1000) {
    add(methods, scene,
        {{"Welzl's, rounded", [&scene](const peers::Sets&) {
            return of_book("", scene,
                           [](auto points) { return contact::welzl_sphere<double>(points); })
                .ask;
          }}});
  }
#ifdef CONTACT_HAS_CGAL
  add(methods, scene, peers::cgal_balls());
#endif
#ifdef CONTACT_HAS_BULLET
  add(methods, scene, peers::bullet_balls());
#endif
  const auto count = [&scene](const Balls& balls, const auto& fault) {
    std::size_t faults = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) faults += fault(balls[i], i);
    return faults;
  };
  const std::vector<comparison::Fault<Balls>> faults{
      {"outside",
       [&](const Balls& balls) {
         return count(balls, [&](const peers::Ball& ball, std::size_t i) {
           return volume_scenes::misses_a_point(ball, scene.sets[i]);
         });
       }},
      {"wrong", [&](const Balls& balls) {
         return count(balls, [&](const peers::Ball& ball, std::size_t i) {
           return volume_scenes::is_wrong(ball, right[i], scene.sets[i]);
         });
       }}};
  const auto rows =
      comparison::compare<Balls>(title_of(scene) + ": the smallest sphere", "us a set",
                                 1e3 * static_cast<double>(scene.sets.size()), methods, faults,
                                 runs, Balls(scene.sets.size()), patience);
  goal.wrong += rows.front().counted[1];
  double share = 0;  // of the fastest of CGAL's exact ones
  for (const comparison::Row& row : rows) {
    if (row.name.ends_with("EPECK") || row.name.ends_with("Gmpq")) {
      share = std::max(share, row.share.median);
    }
  }
  if (share > goal.largest) goal = {share, title_of(scene), goal.wrong};
}

// ---------------------------------------------------------------- oriented boxes

using Boxes = std::vector<peers::Box>;
using BoxMethod = comparison::Method<Boxes>;

inline BoxMethod box_of_book(const char* name, const Scene& scene, auto make) {
  return {name, [&scene, make](Boxes& boxes) {
            for (std::size_t i = 0; i < boxes.size(); ++i) {
              boxes[i] = volume_pairs::plain(make(span_of(scene.sets[i])));
            }
          }};
}

/// The largest volume of the book's box as a share of CGAL's, and of its time.
struct BoxGoal {
  double volume = 0, time = 0;
  std::string volume_where, time_where;
};

inline void compare_boxes(const Scene& scene, int runs, BoxGoal& goal) {
  std::vector<BoxMethod> methods{
      box_of_book("Contact Hours", scene,
                  [](auto points) { return contact::smallest_box<double>(points); }),
      box_of_book("principal axes", scene,
                  [](auto points) { return contact::principal_box<double>(points); })};
#ifdef CONTACT_HAS_CGAL
  add(methods, scene, peers::cgal_boxes());
#endif
#ifdef CONTACT_HAS_COAL
  add(methods, scene, peers::coal_boxes());
#endif
  const auto count = [&scene](const Boxes& boxes, double room) {
    std::size_t faults = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      faults += volume_scenes::misses_a_point(boxes[i], scene.sets[i], room);
    }
    return faults;
  };
  const std::vector<comparison::Fault<Boxes>> faults{
      {"outside", [&](const Boxes& boxes) { return count(boxes, 0); }},
      {"by 1e-9", [&](const Boxes& boxes) { return count(boxes, 1e-9); }}};
  const auto rows = comparison::compare<Boxes>(
      title_of(scene) + ": a small box", "us a set", 1e3 * static_cast<double>(scene.sets.size()),
      methods, faults, runs, Boxes(scene.sets.size()), patience);
  Boxes ours(scene.sets.size()), theirs = ours;
  methods.front().ask(ours);
  std::printf("  the book's volume as a share of that of\n");
  for (std::size_t m = 1; m < methods.size(); ++m) {
    methods[m].ask(theirs);
    std::vector<double> shares;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      shares.push_back(volume_scenes::volume(ours[i]) / volume_scenes::volume(theirs[i]));
    }
    const comparison::Spread share = comparison::spread(shares);
    std::printf("  %-34s %9.5f %9.5f - %9.5f\n", methods[m].name.c_str(), share.median, share.least,
                share.most);
    if (!methods[m].name.starts_with("CGAL")) continue;
    if (share.most > goal.volume) {
      goal.volume = share.most;
      goal.volume_where = title_of(scene);
    }
    if (rows[m].share.median > goal.time) {
      goal.time = rows[m].share.median;
      goal.time_where = title_of(scene);
    }
  }
  std::printf("\n");
}

}  // namespace compare_fits
