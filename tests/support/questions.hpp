/// @file
/// Recomputes the keys of a chapter's questions. One file a chapter,
/// tests/NN_slug/questions_test.cpp, includes this and computes, by C++ and not by copying, what
/// questions.toml holds:
///
///     #include "support/questions.hpp"
///     // predict: a number in the question's unit
///     KEY("bullet-time") { return 3.0 / 7.0; }
///     // choose: the index of the right option
///     KEY("which-side") { return side(...) == ... ? 0 : 1; }
///     // order: indices of the items in the right order
///     KEY("steps") { return std::vector<int>{2, 0, 1}; }
///     // construct: the goal's output for a state that wins, and for one that does not
///     KEY("make-it-touch") {
///       return questions::Construct{compute(win).touching, compute(lose).touching};
///     }
///     // complete: the number of each gap, in the gap's unit
///     KEY("truck-table") { return questions::Gaps{{"truck", after.first}, {"car", after.second}};
///     }
///     // say why: a consequence of the model answer, computed in a case where it must hold and in
///     // one where it must not
///     KEY("why-no-adhesion") { return questions::Claim{sticks(0.0), sticks(0.5)}; }
///
/// The figure's C++ is included in a namespace of its own, after what it includes:
///
///     #define CONTACT_FIGURE_NO_MAIN
///     #include <contact/figure.hpp>
///     namespace sphere { #include "figures/sphere_plane.cpp" }
///
/// The test case fails if a key differs from the file, if a question has no key, a key no question,
/// or if the file is not as the chapters' agreement says.
#pragma once

#include <catch2/catch_test_macros.hpp>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace questions {

/// What the goal's output is in a state that answers the question, and in one that does not.
struct Construct {
  double winning;
  double losing;
};

/// The numbers of the gaps, by their ids.
using Gaps = std::map<std::string, double>;

/// Whether what a model answer claims holds where its reason is present, and where it is not.
struct Claim {
  bool with_reason;
  bool without_reason;
};

/// A step of an "order" question: what it makes, and what it needs that other steps make.
struct Step {
  std::string makes;
  std::vector<std::string> needs;
};

/// The order of the steps, each after those that make what it needs. CHECKs that there is only one.
std::vector<int> only_order(const std::vector<Step>& steps);

using Key = std::variant<double, int, std::vector<int>, Construct, Gaps, Claim>;
using Keys = std::map<std::string, std::vector<std::function<Key()>>>;

/// Remembers a key; used by KEY.
struct Register {
  Register(const char* id, std::function<Key()> key);
};

/// Compares every key with chapters/<chapter>/questions.toml; one sentence for each fault.
std::vector<std::string> faults(const std::string& chapter);
/// The same for the texts of questions.toml and chapter.toml, and these keys.
std::vector<std::string> faults(const std::string& chapter, std::string_view questions,
                                std::string_view about, const Keys& keys);
/// How many questions the chapter has.
int count(const std::string& chapter);

}  // namespace questions

#define CONTACT_KEY_JOIN2(a, b) a##b
#define CONTACT_KEY_JOIN(a, b) CONTACT_KEY_JOIN2(a, b)
#define KEY(id)                                                                       \
  static ::questions::Key CONTACT_KEY_JOIN(contact_key_, __LINE__)();                 \
  static const ::questions::Register CONTACT_KEY_JOIN(contact_registered_, __LINE__){ \
      id, &CONTACT_KEY_JOIN(contact_key_, __LINE__)};                                 \
  static ::questions::Key CONTACT_KEY_JOIN(contact_key_, __LINE__)()

#ifdef CONTACT_CHAPTER  // set for a chapter's tests, and not where this is only declared
TEST_CASE("every question's key is what the code computes") {
  const std::vector<std::string> faults = questions::faults(CONTACT_CHAPTER);
  for (const std::string& fault : faults) UNSCOPED_INFO(fault);
  CHECK(faults.empty());
  CHECK(questions::count(CONTACT_CHAPTER) > 0);
}
#endif
