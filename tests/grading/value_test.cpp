// Values as text, as bytes and compared.
#include <catch2/catch_test_macros.hpp>
#include <cstdlib>
#include <limits>

#include <contact/prelude.hpp>
#include <contact/shapes.hpp>
#include <contact/value_bytes.hpp>
#include <contact/value_compare.hpp>
#include <contact/value_text.hpp>

namespace {

using namespace contact;

enum class Side { behind = -1, on, front };
enum class Small : std::uint8_t { one = 1, two };
enum Loose { loose };

struct Inner {
  double a = 0;
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  std::array<double, 3> c{};
};
struct Full {
  bool yes = false;
  int count = 0;
  std::int64_t many = 0;
  Side side = Side::on;
  std::string name;
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Eigen::VectorXd list;
  std::vector<Inner> inner;
  std::optional<Eigen::Vector3d> maybe;
  std::variant<int, double, std::string> one_of;
  std::vector<bool> flags;
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
};
struct Thirteen {
  int a, b, c, d, e, f, g, h, i, j, k, l, m;
};
struct WithPointer {
  double* p;
};
struct Empty {};
class Hidden {
 public:
  explicit Hidden(int x) : x_(x) {}

 private:
  int x_;
};

static_assert(Value<bool> && Value<int> && Value<std::int64_t> && Value<double> &&
              Value<std::string>);
static_assert(Value<Side> && Value<Small> && Value<Inner> && Value<Full>);
static_assert(Value<Ray<double>> && Value<Triangle<double>> &&
              Value<std::optional<TriangleHit<double>>>);
static_assert(Value<Eigen::MatrixXd> && Value<Eigen::Matrix3Xd> && Value<Eigen::Array3d>);
static_assert(!Value<float> && !Value<char> && !Value<unsigned> && !Value<double*> &&
              !Value<const char*>);
static_assert(!Value<Eigen::Vector3f> && !Value<Eigen::Vector3i> && !Value<Ray<float>>);
static_assert(!Value<Loose> && !Value<Thirteen> && !Value<WithPointer> && !Value<Empty> &&
              !Value<Hidden>);
static_assert(!Value<std::vector<float>> && !Value<std::optional<float>> &&
              !Value<std::variant<int, float>>);
static_assert(field_count<Inner> == 3 && field_count<Full> == 12);

Full full() {
  Full f;
  f.yes = true;
  f.count = -7;
  f.many = std::int64_t{1} << 60;
  f.side = Side::front;
  f.name = std::string("a\0\"\\\xff", 5);
  f.matrix << 1, 2, 3, 4;
  f.list = Eigen::VectorXd::LinSpaced(4, 0, 1);
  f.inner = {Inner{0.1, {1, 2, 3}, {4, 5, 6}}, Inner{}};
  f.maybe = Eigen::Vector3d(-0.0, 5e-324, 1e308);
  f.one_of = "text";
  f.flags = {true, false, true};
  f.turn = Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5);
  return f;
}

}  // namespace

TEST_CASE("a value comes back from its bytes as it was") {
  const Full before = full();
  const Bytes bytes = to_bytes(before);
  const Full after = from_bytes<Full>(bytes);
  CHECK(equal(before, after));
  CHECK(to_bytes(after) == bytes);
  CHECK(std::signbit((*after.maybe)[0]));
}

TEST_CASE("every double crosses with all its bits") {
  using Limits = std::numeric_limits<double>;
  for (const std::uint64_t bits :
       {std::bit_cast<std::uint64_t>(Limits::quiet_NaN()), std::uint64_t{0x7ff4000000000001},
        std::bit_cast<std::uint64_t>(-Limits::infinity()), std::uint64_t{1}, std::uint64_t{1} << 63,
        std::bit_cast<std::uint64_t>(0.1), std::bit_cast<std::uint64_t>(Limits::max())}) {
    const double x = std::bit_cast<double>(bits);
    CHECK(std::bit_cast<std::uint64_t>(from_bytes<double>(to_bytes(x))) == bits);
  }
}

TEST_CASE("whatever is cut off or appended is refused") {
  const Bytes bytes = to_bytes(full());
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    CHECK_THROWS_AS(from_bytes<Full>(Bytes(bytes.begin(), bytes.begin() + std::ptrdiff_t(n))),
                    BadBytes);
  }
  Bytes longer = bytes;
  longer.push_back(0);
  CHECK_THROWS_AS(from_bytes<Full>(longer), BadBytes);
}

TEST_CASE("any single changed byte is refused or read as some value, and never does harm") {
  const Bytes bytes = to_bytes(full());
  std::size_t refused = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const int change : {1, 0x7f, 0x80, 0xff}) {
      Bytes changed = bytes;
      changed[at] = static_cast<std::uint8_t>(changed[at] ^ change);
      try {
        const Full read = from_bytes<Full>(changed);
        CHECK(to_bytes(read) == changed);
      } catch (const BadBytes&) {
        ++refused;
      }
    }
  }
  CHECK(refused > 0);
}

TEST_CASE("lengths that lie are refused before anything is allocated") {
  const Bytes huge{0xff, 0xff, 0xff, 0xff, 0, 0, 0, 0};
  CHECK_THROWS_AS(from_bytes<std::string>(huge), BadBytes);
  CHECK_THROWS_AS(from_bytes<std::vector<bool>>(huge), BadBytes);
  CHECK_THROWS_AS(from_bytes<std::vector<Inner>>(huge), BadBytes);
  CHECK_THROWS_AS(from_bytes<Eigen::VectorXd>(huge), BadBytes);
  CHECK_THROWS_AS(from_bytes<Eigen::MatrixXd>(Bytes(8, 0xff)), BadBytes);
}

TEST_CASE("a few bytes that unfold into much memory are refused") {
  // Each element is one byte, "nothing here", and takes 8 kB in memory.
  using Wide = std::vector<std::optional<std::array<double, 1000>>>;
  Bytes bytes{0, 0, 1, 0};  // 65,536 elements: half a gigabyte
  bytes.resize(4 + 65536);
  CHECK_THROWS_AS(from_bytes<Wide>(bytes), BadBytes);
  Reader generous(bytes, std::size_t{1} << 30);
  CHECK(generous.read<Wide>().size() == 65536);
}

TEST_CASE("matrices without coefficients cost what it takes to go through them") {
  const auto empty = [](std::uint32_t rows, std::uint32_t columns) {
    Bytes bytes = to_bytes(std::array<int, 2>{});
    std::memcpy(bytes.data(), &rows, sizeof rows);
    std::memcpy(bytes.data() + sizeof rows, &columns, sizeof columns);
    return bytes;
  };
  CHECK(from_bytes<Eigen::MatrixXd>(empty(0, 3)).cols() == 3);
  CHECK(from_bytes<Eigen::MatrixXd>(empty(3, 0)).rows() == 3);
  CHECK_THROWS_AS(from_bytes<Eigen::MatrixXd>(empty(0, 0xffffffff)), BadBytes);
  CHECK_THROWS_AS(from_bytes<Eigen::MatrixXd>(empty(0xffffffff, 0)), BadBytes);
  // Many of them, each small enough.
  Bytes many{0x00, 0x40, 0, 0};  // 16,384 matrices of 65,536 empty columns each
  const Bytes one = empty(0, 65536);
  for (int i = 0; i < 16384; ++i) many.insert(many.end(), one.begin(), one.end());
  CHECK_THROWS_AS(from_bytes<std::vector<Eigen::MatrixXd>>(many), BadBytes);
}

TEST_CASE("bools, enumerations and variants are checked") {
  CHECK_THROWS_AS(from_bytes<bool>(Bytes{2}), BadBytes);
  CHECK_THROWS_AS(from_bytes<std::optional<int>>(Bytes{2}), BadBytes);
  CHECK_THROWS_AS(from_bytes<Small>(to_bytes(std::int64_t{256})), BadBytes);
  CHECK(from_bytes<Small>(to_bytes(std::int64_t{255})) == static_cast<Small>(255));
  CHECK_THROWS_AS((from_bytes<std::variant<int, bool>>(Bytes{2, 0, 0, 0, 0})), BadBytes);
}

TEST_CASE("a value reads as a person would write it") {
  CHECK(text_of(Ray<double>{{0, 0, 1}, {0.1, -0.0, 1e300}}) ==
        "Ray{origin: (0, 0, 1), direction: (0.1, -0, 1e+300)}");
  CHECK(text_of(std::optional<int>{}) == "nullopt");
  CHECK(text_of(Side::behind) == "Side::behind");
  CHECK(text_of(static_cast<Side>(9)) == "Side(9)");
  CHECK(text_of(std::numeric_limits<double>::quiet_NaN()) == "NaN");
  CHECK(text_of(Eigen::Matrix2d(Eigen::Matrix2d::Identity())) == "[1 0; 0 1]");
  CHECK(text_of(std::string("a\n\"b\"")) == R"("a\x0a\"b\"")");
  CHECK(text_of(std::vector<int>(30, 1), {.elements = 2}) == "[1, 1, and 28 more]");
  CHECK(text_of(std::variant<int, bool>{true}) == "true");
  CHECK(text_of(1.0 / 3.0, {.digits = 2}) == "0.33");
}

TEST_CASE("the text of a double brings the same double back") {
  for (double x : {0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, 123456789.0 / 7.0}) {
    CHECK(std::strtod(text_of(x).c_str(), nullptr) == x);
  }
}

TEST_CASE("NaN equals nothing, and -0 equals 0") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(equal(std::vector<double>{nan}, std::vector<double>{nan}));
  CHECK(equal(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(-0.0, 0, 0)));
  CHECK_FALSE(equal(std::vector<int>{1}, std::vector<int>{1, 1}));
  CHECK_FALSE(equal(std::optional<int>{}, std::optional<int>{0}));
  CHECK_FALSE(equal(std::variant<int, double>{1}, std::variant<int, double>{1.0}));
}
