// What is said of a wrong answer is true of it, and nothing is said of an answer that is only
// wrong.
#include <support/observed.hpp>

#include <catch2/catch_test_macros.hpp>
#include <limits>
#include <numbers>
#include <optional>

namespace {

using namespace contact::testing;
using Vector = Eigen::Vector3d;

struct Proof {
  double displacement = 0;
  bool proven = false;
  int steps = 0;
};

template <class T>
std::string said(const T& got, const T& right, double tolerance = 1e-12) {
  return observed(leaves_of(got), leaves_of(right), [&](std::size_t, double a, double b) {
    return a == b || std::abs(a - b) <= tolerance;
  });
}

}  // namespace

TEST_CASE("a sign that is wrong in all numbers or in some") {
  CHECK(said(-2.5, 2.5) == "Your answer is the right one with the opposite sign.");
  CHECK(said(Vector(-1, 0, 3), Vector(1, 0, -3)) ==
        "Your answer is the right one with the opposite sign.");
  CHECK(said(Vector(1, -2, 3), Vector(1, 2, 3)) == "The sign of y is wrong. The rest is right.");
  CHECK(said(Vector(-1, -2, 4), Vector(1, 2, 3)).find("sign") == std::string::npos);
}

TEST_CASE("a factor is named only if it is the same everywhere") {
  CHECK(said(5.0, 2.5) == "Your answer is twice what is right.");
  CHECK(said(90.0, std::numbers::pi / 2) == "Your answer is 180/π times what is right.");
  CHECK(said(Vector(2, 4, 0), Vector(4, 8, 0)) == "Your answer is half of what is right.");
  CHECK(said(Vector(1, 4, 0), Vector(1, 8, 0)) == "y is half of what is right. The rest is right.");
  CHECK(said(Vector(2, 5, 0), Vector(4, 8, 0)) == "");
  CHECK(said(0.4, 2.5) == "Your answer is the reciprocal of what is right.");
  CHECK(said(6.25, 2.5) == "Your answer is the square of what is right.");
  CHECK(said(1.5, 2.25) == "Your answer is the root of what is right.");
}

TEST_CASE("the wrong part of an answer is named") {
  CHECK(said(Proof{1, true, 4}, Proof{1, true, 5}) ==
        "steps is too small by one. The rest is right.");
  CHECK(said(Proof{1, false, 5}, Proof{1, true, 5}) == "Only proven is wrong.");
  CHECK(said(Proof{2, true, 5}, Proof{1, true, 5}) ==
        "displacement is twice what is right. The rest is right.");
  CHECK(said(Vector(2, 1, 3), Vector(1, 2, 3)) == "x and y are exchanged. The rest is right.");
  CHECK(said(Vector(1, 0, 3), Vector(1, 2, 3)) == "y is 0, and should not be. The rest is right.");
  CHECK(said(3, 4) == "Your answer is too small by one.");
  CHECK(said(2, 4) == "");
  CHECK(said(true, false) == "");
}

TEST_CASE("NaN, infinity and lost digits") {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  CHECK(said(kNaN, 1.0).starts_with("There is a NaN in your answer."));
  CHECK(said(Vector(1, kInfinity, 0), Vector(1, 2, 0)).starts_with("There is an infinity"));
  CHECK(said(kInfinity, kInfinity) == "");
  CHECK(said(1 + 1e-7, 1.0) ==
        "Your answer agrees in its first six digits, but is not as accurate as it has to be.");
  CHECK(said(1 + 1e-4, 1.0) == "");
}

TEST_CASE("lists that lack entries, have more, or have another order") {
  using List = std::vector<int>;
  CHECK(said(List{1, 3}, List{1, 2, 3}) ==
        "What is in your list is right and in the right order, but one entry is missing.");
  CHECK(said(List{1, 2, 3, 4, 5}, List{1, 2, 5}) ==
        "All that belongs into your list is there, in the right order, and 2 entries too many.");
  CHECK(said(List{3, 1, 2}, List{1, 2, 3}) == "Your list has the right entries in another order.");
  CHECK(said(List{1, 1, 2}, List{1, 2, 2}) != "Your list has the right entries in another order.");
  CHECK(said(List{}, List{1}) == "Your list is empty, and the right one is not.");
  CHECK(said(List{3, 1}, List{1, 2, 3}) == "");
  using Proofs = std::vector<Proof>;
  CHECK(said(Proofs{{1, true, 2}}, Proofs{{1, true, 2}, {2, true, 3}}).ends_with("is missing."));
}

TEST_CASE("an answer where there is none, and none where there is one") {
  using Found = std::optional<double>;
  CHECK(said(Found{}, Found{1.0}) == "There is an answer here, and you return none.");
  CHECK(said(Found{1.0}, Found{}) == "There is no answer here, and you return one.");
  CHECK(said(Found{-1.0}, Found{1.0}) == "Your answer is the right one with the opposite sign.");
}
