// Compares the book's decisions about two convex bodies, and its signed distances, with those of
// Coal, FCL, libccd, Bullet, ODE and Box3D, for every pair of kinds. Times are those of the
// processor, and each is also given as a share of it that the book takes: the median and the range
// over runs in which all take turns. usage:
//   convex_peers [N] [runs] [KIND KIND]  N pairs of each question; of one pair of kinds, or of all
#include <algorithm>
#include <contact/gjk.hpp>
#include <contact/proximity.hpp>
#include <contact/signed_distance.hpp>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "../comparison.hpp"
#include "careful.hpp"
#include "pair_scenes.hpp"
#include "peers.hpp"

namespace {

using pair_bodies::Kind;
using pair_scenes::Scene;
using peers::Answers;
using peers::Witnesses;

/// An answer that is neither of the two.
constexpr char undecided = 2;

/// The bodies of a scene in their own types, so that no variant is timed.
template <class A, class B>
std::vector<std::pair<A, B>> in_types(const Scene& scene) {
  std::vector<std::pair<A, B>> kept;
  for (const auto& pair : scene.pairs) kept.emplace_back(std::get<A>(pair.a), std::get<B>(pair.b));
  return kept;
}

template <class A, class B, class Meet>
comparison::Method<Answers> deciding(const char* name, const std::vector<std::pair<A, B>>& kept,
                                     Meet meet) {
  return {name, [&kept, meet](Answers& answers) {
            for (std::size_t i = 0; i < kept.size(); ++i) {
              answers[i] = meet(kept[i].first, kept[i].second, i);
            }
          }};
}

std::vector<peers::PairTest> others(Kind a, Kind b) {
  std::vector<peers::PairTest> all;
  const auto add = [&](const std::vector<peers::PairTest>& tests) {
    for (const auto& test : tests) {
      if (test.takes(static_cast<peers::Kind>(a), static_cast<peers::Kind>(b))) all.push_back(test);
    }
  };
#ifdef CONTACT_HAS_COAL
  add(peers::coal_pairs());
#endif
#ifdef CONTACT_HAS_FCL
  add(peers::fcl_pairs());
#endif
#ifdef CONTACT_HAS_CCD
  add(peers::ccd_pairs());
#endif
#ifdef CONTACT_HAS_BULLET
  add(peers::bullet_pairs());
#endif
#ifdef CONTACT_HAS_ODE
  add(peers::ode_pairs());
#endif
#ifdef CONTACT_HAS_BOX3D
  add(peers::box3d_pairs());
#endif
  return all;
}

/// Wrong decisions: bodies with a common point that are said to be apart, or the reverse.
std::size_t wrong(const Scene& scene, const Answers& answers) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < scene.right.size(); ++i) {
    if (answers[i] == undecided) continue;
    count += (answers[i] != 0) != (scene.right[i] <= 0) ? 1 : 0;
  }
  return count;
}
std::size_t inconsistent(const Scene& scene, const Witnesses& witnesses) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
    if (!witnesses[i].found) continue;
    count += pair_scenes::is_inconsistent(scene.pairs[i], witnesses[i]) ? 1 : 0;
  }
  return count;
}

/// What each method got wrong in all scenes, by its name.
struct Total {
  std::size_t asked = 0, wrong = 0, undecided = 0;  ///< of decisions
  std::size_t measured = 0, inconsistent = 0;       ///< of signed distances
};
using Totals = std::map<std::string, Total>;

void print(const Totals& totals) {
  std::printf("all pairs\n  %-34s %9s %9s %9s %9s %9s\n", "", "decided", "wrong", "undecided",
              "distances", "inconsist");
  for (const auto& [name, total] : totals) {
    std::printf("  %-34s %9zu %9zu %9zu %9zu %9zu\n", name.c_str(), total.asked, total.wrong,
                total.undecided, total.measured, total.inconsistent);
  }
}

template <class A, class B>
void decide(const Scene& scene, const std::vector<peers::PairTest>& peers_of_it, int runs,
            Totals& totals) {
  const auto kept = in_types<A, B>(scene);
  std::vector<contact::ProximityWitness> witnesses(kept.size());
  const auto meets = [](contact::Proximity p) {
    if (p == contact::Proximity::undecided) return undecided;
    return static_cast<char>(p == contact::Proximity::disjoint ? 0 : 1);
  };
  std::vector<comparison::Method<Answers>> methods{
      deciding<A, B>(
          "Contact Hours", kept,
          [&](const A& a, const B& b, std::size_t) { return meets(contact::proximity(a, b)); }),
      deciding<A, B>("certified", kept,
                     [&](const A& a, const B& b, std::size_t) {
                       return meets(contact::certified_proximity(a, b).state);
                     }),
      deciding<A, B>("certified, with the witness", kept,
                     [&](const A& a, const B& b, std::size_t i) {
                       return meets(
                           contact::certified_proximity_with_witness(a, b, witnesses[i]).state);
                     }),
      deciding<A, B>("GJK, rounded", kept, [](const A& a, const B& b, std::size_t) {
        const double reach = contact::radius_of(a) + contact::radius_of(b);
        return static_cast<char>(contact::gjk(a, b).distance <= reach ? 1 : 0);
      })};
  for (const auto& test : peers_of_it) {
    const auto fine = careful::answered<char>(test.prepare, scene.plain);
    const auto pairs = careful::without(fine, scene.plain, scene.title + ", " + test.name);
    if (pairs.empty()) continue;
    const auto ask = test.prepare(pairs);
    methods.push_back({test.name, [ask, fine, &scene](Answers& answers) {
                         ask(answers);
                         // No answer is no wrong one; they are told above.
                         for (std::size_t i = 0; i < fine.size(); ++i) {
                           if (fine[i] == 0) answers[i] = scene.right[i] <= 0 ? 1 : 0;
                         }
                       }});
  }
  const auto rows = comparison::compare<Answers>(
      scene.title + ", " + std::to_string(kept.size()) + " pairs", "ns a pair",
      static_cast<double>(kept.size()), methods,
      {{"wrong", [&](const Answers& answers) { return wrong(scene, answers); }},
       {"undecided",
        [](const Answers& answers) {
          return static_cast<std::size_t>(std::count(answers.begin(), answers.end(), undecided));
        }}},
      runs, Answers(kept.size()));
  for (const auto& row : rows) {
    Total& total = totals[row.name];
    total.asked += kept.size();
    total.wrong += row.counted[0];
    total.undecided += row.counted[1];
  }
}

template <class A, class B>
void measure(const Scene& scene, const std::vector<peers::PairTest>& peers_of_it, int runs,
             Totals& totals) {
  const auto kept = in_types<A, B>(scene);
  std::vector<comparison::Method<Witnesses>> methods{
      {"Contact Hours", [&](Witnesses& found) {
         for (std::size_t i = 0; i < kept.size(); ++i) {
           const auto d = contact::signed_distance(kept[i].first, kept[i].second);
           found[i] = {true, d.distance, pair_scenes::plain(d.normal)};
         }
       }}};
  for (const auto& test : peers_of_it) {
    if (!test.measure) continue;
    const auto fine = careful::answered<peers::Witness>(test.measure, scene.plain);
    const auto pairs =
        careful::without(fine, scene.plain, scene.title + ", signed distances, " + test.name);
    if (pairs.empty()) continue;
    const auto ask = test.measure(pairs);
    methods.push_back({test.name, [ask, fine](Witnesses& found) {
                         ask(found);
                         for (std::size_t i = 0; i < fine.size(); ++i) {
                           if (fine[i] == 0) found[i].found = false;
                         }
                       }});
  }
  const auto rows = comparison::compare<Witnesses>(
      scene.title + ", signed distances", "ns a pair", static_cast<double>(kept.size()), methods,
      {{"inconsist", [&](const Witnesses& found) { return inconsistent(scene, found); }},
       {"none",
        [](const Witnesses& found) {
          return static_cast<std::size_t>(
              std::count_if(found.begin(), found.end(), [](const auto& w) { return !w.found; }));
        }}},
      runs, Witnesses(kept.size()));
  for (const auto& row : rows) {
    Total& total = totals[row.name];
    total.measured += kept.size() - row.counted[1];
    total.inconsistent += row.counted[0];
  }
}

void compare(Kind a, Kind b, std::size_t count, int runs, Totals& totals) {
  const auto peers_of_it = others(a, b);
  for (const auto& group : pair_scenes::groups()) {
    const Scene scene = pair_scenes::scene(a, b, group, count);
    if (scene.pairs.empty()) continue;
    pair_bodies::with(scene.pairs[0].a, scene.pairs[0].b, [&](const auto& x, const auto& y) {
      using A = std::decay_t<decltype(x)>;
      using B = std::decay_t<decltype(y)>;
      decide<A, B>(scene, peers_of_it, runs, totals);
      measure<A, B>(scene, peers_of_it, runs, totals);
    });
  }
}

std::optional<Kind> kind_named(std::string_view text) {
  for (const Kind kind : pair_bodies::all_kinds) {
    if (pair_bodies::name(kind) == text) return kind;
  }
  return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = comparison::number(argc, argv, 1, 1000);
  const int runs = static_cast<int>(comparison::number(argc, argv, 2, 5));
  Totals totals;
  if (argc > 4) {
    const auto a = kind_named(argv[3]), b = kind_named(argv[4]);
    if (!a || !b) {
      std::fprintf(stderr, "convex_peers: no kind of body \"%s\"\n", a ? argv[4] : argv[3]);
      comparison::leave(2);
    }
    compare(*a, *b, count, runs, totals);
    print(totals);
    comparison::leave(0);
  }
  for (const Kind a : pair_bodies::all_kinds) {
    for (const Kind b : pair_bodies::all_kinds) {
      if (a <= b) compare(a, b, count, runs, totals);
    }
  }
  print(totals);
  comparison::leave(0);
}
