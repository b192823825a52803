// Compares the book's test of two triangles with its rounded methods and with CGAL, FCL and Coal:
// how long a pair takes, and the wrong answers of each. Times are those of the processor, and each
// is also given as a share of it that the book takes: the median and the range over runs in which
// all take turns. usage:
//   pair_peers [pairs] [runs]
//   pair_peers --write FOLDER [pairs]     the pairs and right answers, for three_peer.mjs and
//                                         igl_peer.py
//   pair_peers --ask FOLDER/pairs FAMILY  prints what the book takes for the pairs of a family, ns
#include <contact/pair_methods.hpp>
#include <contact/pair_orientations.hpp>
#include <contact/triangles_meet.hpp>
#include <string_view>

#include "../comparison.hpp"
#include "pair_scenes.hpp"
#include "peers.hpp"

namespace {

using pair_scenes::Pair;
using pair_scenes::Pairs;
using peers::Answers;
using Method = comparison::Method<Answers>;
using Fault = comparison::Fault<Answers>;

template <class Meet>
Method of_book(const char* name, const std::vector<Pair>& pairs, Meet meet) {
  return {name, [&pairs, meet](Answers& answers) {
            for (std::size_t i = 0; i < pairs.size(); ++i) {
              answers[i] = meet(pairs[i].first, pairs[i].second) ? 1 : 0;
            }
          }};
}

Method exact(const std::vector<Pair>& pairs) {
  return of_book("Contact Hours", pairs, [](const auto& first, const auto& second) {
    return contact::triangles_meet(first, second);
  });
}

std::vector<peers::PairTest> peer_tests() {
  std::vector<peers::PairTest> all;
  [[maybe_unused]] const auto add = [&all](const std::vector<peers::PairTest>& tests) {
    all.insert(all.end(), tests.begin(), tests.end());
  };
#ifdef CONTACT_HAS_CGAL
  add(peers::cgal_pairs());
#endif
#ifdef CONTACT_HAS_FCL
  add(peers::fcl_pairs());
#endif
#ifdef CONTACT_HAS_COAL
  add(peers::coal_pairs());
#endif
  return all;
}

void compare(const Pairs& of, int runs) {
  std::vector<Method> methods{
      exact(of.pairs),
      of_book("Guigue-Devillers, rounded", of.pairs,
              [](const auto& t, const auto& u) { return contact::meet_by_orientations(t, u); }),
      of_book("the lecture's steps, rounded", of.pairs,
              [](const auto& t, const auto& u) { return contact::meet_by_steps(t, u).meet; }),
      of_book("Moller's intervals, with 1e-6", of.pairs,
              [](const auto& t, const auto& u) { return contact::meet_by_intervals(t, u, 1e-6); }),
      of_book("separating axes, rounded", of.pairs,
              [](const auto& t, const auto& u) { return contact::meet_by_axes(t, u); })};
  for (const peers::PairTest& test : peer_tests()) {
    methods.push_back({test.name, test.prepare(of.plain)});
  }
  const auto count = [&of](char right, const Answers& got) {
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < got.size(); ++i) wrong += of.right[i] == right && got[i] != right;
    return wrong;
  };
  const std::vector<Fault> faults{
      {"missed", [&count](const Answers& got) { return count(1, got); }},
      {"invented", [&count](const Answers& got) { return count(0, got); }}};
  const std::string title = of.title + ", " + std::to_string(of.pairs.size()) + " pairs, " +
                            std::to_string(of.meeting()) + " meet";
  comparison::compare<Answers>(title, "ns a pair", static_cast<double>(of.pairs.size()), methods,
                               faults, runs, Answers(of.pairs.size()));
}

/// The book's time for one family of a folder, in the process that waits for it.
int ask(const std::string& folder, const std::string& family) {
  const std::vector<Pair> pairs = pair_scenes::read(folder, family);
  const Method method = exact(pairs);
  Answers answers(pairs.size());
  method.ask(answers);
  const double start = comparison::processor_time();
  method.ask(answers);
  std::printf("%.3f\n", (comparison::processor_time() - start) / static_cast<double>(pairs.size()));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr std::size_t usual = 20000;
  const std::string_view option = argc > 2 ? argv[1] : "";
  if (option == "--write") {
    comparison::leave(pair_scenes::write(argv[2], comparison::number(argc, argv, 3, usual)) ? 0
                                                                                            : 1);
  }
  if (option == "--ask" && argc > 3) comparison::leave(ask(argv[2], argv[3]));
  const std::size_t count = comparison::number(argc, argv, 1, usual);
  const int runs = static_cast<int>(comparison::number(argc, argv, 2, 15));
  pair_scenes::each_family(count, [runs](const Pairs& pairs) { compare(pairs, runs); });
  comparison::leave(0);
}
