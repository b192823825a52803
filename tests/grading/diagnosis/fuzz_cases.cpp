#include "fuzz_cases.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>

#include "diagnosis/message_text.hpp"
#include "diagnosis/mistakes/rules.hpp"

namespace fs = std::filesystem;

namespace contact::testing {

namespace {

using grading::ExplainRequest;
using grading::HeaderText;

constexpr std::string_view own_file = "02_triangles/answer.cpp";

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Numbers that a compiler does not print of its own accord.
constexpr auto extremes = std::to_array<std::string_view>(
    {"0", "1", "2", "400000000", "2147483640", "2147483646", "2147483647", "2147483648",
     "4294967295", "4294967296", "9223372036854775807", "99999999999999999999999", "007", "-1"});

constexpr auto types = std::to_array<std::string_view>(
    {"double",
     "int",
     "bool",
     "const double",
     "float",
     "std::size_t",
     "void",
     "<brace-enclosed init>",
     "Eigen::Matrix<double, 3, 1>",
     "const Eigen::Matrix<double, 3, 1, 0, 3, 1>",
     "Eigen::Matrix<float, 2, 1>",
     "Eigen::Matrix<double, 3, 3>",
     "std::optional<contact::TriangleHit<double> >",
     "std::optional<contact::RayHit<double>>",
     "contact::Ray<double>",
     "const contact::Triangle<double>&",
     "std::nullptr_t",
     "std::vector<int, std::allocator<int> >",
     "std::array<double, 3>",
     "Eigen::Product<Eigen::Matrix<double, 3, 1>, Eigen::Matrix<double, 3, 1>, 0>",
     "Eigen::CwiseBinaryOp<Eigen::internal::scalar_sum_op<double, double>, const "
     "Eigen::Matrix<double, 3, 1>, const Eigen::Matrix<double, 3, 1> >",
     "std::__cxx11::basic_string<char>",
     "Eigen::MatrixBase<Eigen::Matrix<double, 3, 1> >::"
     "cross_product_return_type<Eigen::Matrix<double, 3, 1> >::type"});

constexpr auto names = std::to_array<std::string_view>({"cout",
                                                        "sqrt",
                                                        "vector",
                                                        "Vector3d",
                                                        "Ray",
                                                        "TriangleHit",
                                                        "origin",
                                                        "orign",
                                                        "direction",
                                                        "t",
                                                        "barycentric",
                                                        "ray_triangle",
                                                        "signed_distance",
                                                        "Return",
                                                        "IF",
                                                        "retrun",
                                                        "length",
                                                        "legnth",
                                                        "magnitude",
                                                        "norm",
                                                        "normalize",
                                                        "x",
                                                        "dot",
                                                        "size",
                                                        "map",
                                                        "std",
                                                        "exercise",
                                                        "contact",
                                                        "else",
                                                        "operator*",
                                                        "=",
                                                        "+",
                                                        "^",
                                                        "main",
                                                        "i",
                                                        "hit",
                                                        "plane",
                                                        "point",
                                                        "distance"});

constexpr auto signatures = std::to_array<std::string_view>(
    {"double exercise::twice(double)",
     "exercise::ray_triangle(contact::Ray<double> const&, "
     "contact::Triangle<double> const&)",
     "double exercise::signed_distance(const contact::Plane<double>&, const Eigen::Vector3d&)",
     "Eigen::Matrix<double, 3, 1>::dot() const", "helper(int)", "std::string f()",
     "exercise::first_hit", "constexpr const double& std::max(const double&, const double&)"});

// What the kinds of mistakes ask of notes.
constexpr auto notes = std::to_array<std::string_view>(
    {"to match this '('",
     "to match this '{'",
     "candidate: 'double exercise::twice(double)'",
     "  candidate expects 1 argument, 2 provided",
     "candidate expects 3 arguments, 1 provided",
     "candidate function not viable: requires 2 arguments, but 1 was provided",
     "candidate function not viable: requires single argument 'x', but 2 arguments were provided",
     "no known conversion for argument 1 from 'double' to 'const contact::Ray<double>&'",
     "candidate function not viable: no known conversion from 'double' to 'int' for 1st argument",
     "  initializing argument 1 of 'double exercise::twice(double)'",
     "  in call to 'void Eigen::MatrixBase<Derived>::normalize() [with Derived = X]'",
     "candidate: 'x' (near match) discards qualifiers",
     "method is not marked const",
     "'std::map' is defined in header '<map>'; did you forget to '#include <map>'?",
     "'contact::Ray' declared here",
     "previous definition is here",
     "previous declaration 'double exercise::f(double)'",
     "suggested alternatives: 'std::sqrt'",
     "in instantiation of function template specialization 'f' requested here",
     "required from here",
     "remove 'const'"});

constexpr auto other_files = std::to_array<std::string_view>(
    {"/usr/include/c++/12/vector", "/usr/include/eigen3/Eigen/src/Core/Dot.h", "other.cpp",
     "{standard input}", "<built-in>", "cc1plus", "/tmp/ccAbCdEf.s", "collect2",
     "02_triangles/./answer.cpp", "../02_triangles/answer.cpp", "chapters/02/x.hpp"});

constexpr auto snippets =
    std::to_array<std::string_view>({"\n#line 2147483647\n",
                                     "\n#line 2147483640 \"other.cpp\"\n",
                                     "\n# 5 \"02_triangles/answer.cpp\"\n",
                                     "\n#line 1\n",
                                     "\n%:line 400000000\n",
                                     "\n#/**/line 7\n",
                                     "\n#li\\\nne 9\n",
                                     "\n#line N\n",
                                     "/*",
                                     "*/",
                                     "\"",
                                     "'",
                                     "{",
                                     "}",
                                     "(",
                                     ")",
                                     "{{{{{{{{",
                                     "}}}}}}}}",
                                     "\\\n",
                                     "//",
                                     "\t\t\t",
                                     "R\"(",
                                     "namespace a {",
                                     "inline namespace b::c {",
                                     "extern \"C\" {",
                                     "double f(double x) {",
                                     "if (x) {",
                                     "for (i = 0; i < 3; ++i)",
                                     "int /* name */",
                                     "“",
                                     "−",
                                     "\xC2\xA0",
                                     "é",
                                     "\xE2\x80\xAE",
                                     "@",
                                     "$",
                                     "\r\n",
                                     "\v\f",
                                     "= ",
                                     ";",
                                     "return",
                                     "else",
                                     "struct S { double t; }",
                                     "#include \"ray_triangle.hpp\"",
                                     "asm(\".error \\\"x:1:2: error: y\\\"\");"});

std::string repeated(std::string_view text, std::size_t times) {
  std::string result;
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

class Case {
 public:
  Case(const Seed& seed, std::uint64_t number) : random_(number) {
    request_.file = own_file;
    request_.headers = seed.headers;
    request_.source = seed.source;
    request_.columns = random_.chance(50) ? grading::Columns::bytes : grading::Columns::displayed;
    request_.failed = random_.chance(80);
    request_.root = random_.chance(10) ? "/book/" : "";
    if (random_.chance(12)) request_.step = ExplainRequest::Step::link;
  }

  ExplainRequest make() {
    if (random_.below(1500) == 0) request_.source = huge();
    for (std::size_t i = random_.chance(50) ? random_.below(4) : 0; i > 0; --i) spoil_source();
    grading::SourceText source(request_.source);
    source_ = &source;
    const std::size_t messages = random_.chance(3) ? random_.below(300) : 1 + random_.below(5);
    for (std::size_t i = 0; i < messages; ++i) {
      if (request_.step == ExplainRequest::Step::link)
        link_message();
      else
        message();
    }
    if (random_.chance(25)) spoil_log();
    return std::move(request_);
  }

 private:
  // ---- The source

  // What costs too much only where there is much of it: up to the largest submission.
  std::string huge() {
    std::string text;
    for (std::size_t i = 1 + random_.below(4); i > 0; --i) {
      const std::string piece = random_.chance(20)   ? std::string(" ")
                                : random_.chance(25) ? std::string("a")
                                                     : std::string(random_.of(snippets));
      if (random_.chance(20))
        text += "namespace " + std::string(random_.below(100'000), 'b') + " {";
      text += repeated(piece, (1 + random_.below(250'000)) / piece.size());
      if (random_.chance(30)) text += repeated("void f() {}\n", random_.below(20'000));
      if (random_.chance(30)) text += "@";
    }
    return text.substr(0, 1u << 20);
  }

  void spoil_source() {
    std::string& text = request_.source;
    const std::size_t at = random_.below(text.size() + 1);
    switch (random_.below(5)) {
      case 0:
        text.erase(at, random_.below(200));
        break;
      case 1:
        text.insert(at, text.substr(random_.below(text.size()), random_.below(300)));
        break;
      default: {
        const bool many = random_.chance(6);
        text.insert(at, repeated(random_.chance(10) ? " " : random_.of(snippets),
                                 many ? random_.below(3000) : 1));
      }
    }
  }

  // ---- Places

  struct Position {
    std::string line;
    std::string column;
    std::string word;
  };

  // Mostly where a word begins; else anywhere, also where nothing is.
  Position position() {
    Position result;
    const auto count = static_cast<std::size_t>(source_->line_count());
    const std::size_t line = 1 + random_.below(count + 2);
    const std::string_view text = source_->line(static_cast<int>(line));
    std::size_t column = random_.below(text.size() + 3);
    while (column > 0 && column < text.size() && grading::is_identifier_character(text[column]) &&
           grading::is_identifier_character(text[column - 1]))
      --column;
    if (random_.chance(15)) {
      const std::size_t bracket = text.find_first_of("{}()");
      if (bracket != std::string_view::npos) column = bracket;
    }
    result.line = std::to_string(line);
    result.column = std::to_string(column + 1);
    result.word = source_->word_at({static_cast<int>(line), static_cast<int>(column) + 1});
    if (random_.chance(6)) result.line = random_.of(extremes);
    if (random_.chance(6)) result.column = random_.of(extremes);
    return result;
  }

  std::string file() {
    if (random_.chance(80)) return std::string(own_file);
    if (random_.chance(40)) return random_.of(request_.headers).file;
    return std::string(random_.of(other_files));
  }

  // ---- Messages

  std::string hole(const std::string& word) {
    switch (random_.below(6)) {
      case 0:
        return std::string(random_.of(types));
      case 1:
        return std::string(random_.of(names));
      case 2:
        return std::string(random_.of(signatures));
      case 3:
        return random_.chance(3) ? std::string(random_.below(3000), 'a')
                                 : std::string("std::") + word;
      default:
        return word.empty() ? std::string(random_.of(names)) : word;
    }
  }

  std::string filled(std::string_view pattern, const std::string& word) {
    std::string text;
    while (true) {
      const std::size_t at = pattern.find("{}");
      text += pattern.substr(0, at);
      if (at == std::string_view::npos) break;
      text += hole(word);
      pattern.remove_prefix(at + 2);
    }
    if (random_.chance(30)) grading::replace_all(text, "'", "\xE2\x80\x98");
    return text;
  }

  std::string_view pattern() {
    const auto rules = grading::all_rules();
    const std::span<const grading::Rule> kind = rules[random_.below(rules.size())];
    return kind[random_.below(kind.size())].pattern;
  }

  void line(const std::string& text) { request_.log += text + '\n'; }

  void excerpt(const Position& at) {
    if (!random_.chance(60)) return;
    line("  " + at.line + " | " + std::string(source_->line(std::atoi(at.line.c_str()))));
    const std::size_t blanks = random_.chance(90)
                                   ? std::strtoul(at.column.c_str(), nullptr, 10) % 300
                                   : random_.below(5000);
    line("    | " + std::string(blanks, ' ') + "^" + std::string(random_.below(9), '~'));
  }

  std::string head(const Position& at) {
    std::string text = file() + ":" + at.line + ":" + at.column + ":";
    if (random_.chance(15)) {
      const Position end = position();
      text += "{" + at.line + ":" + at.column + "-" + end.line + ":" + end.column + "}:";
    }
    return text + " ";
  }

  void message() {
    if (random_.chance(8)) line(head(position()) + "  required from 'f() [with T = int]'");
    if (random_.chance(8)) line(head(position()) + "  required from here");
    const Position at = position();
    static constexpr std::array<std::string_view, 4> kinds{"error", "error", "warning",
                                                           "fatal error"};
    const std::string text = random_.chance(8) ? hole(at.word) : filled(pattern(), at.word);
    line(head(at) + std::string(random_.of(kinds)) + ": " + text);
    excerpt(at);
    for (std::size_t i = random_.below(3); i > 0; --i) {
      const Position where = position();
      line(head(where) + "note: " + std::string(random_.of(notes)));
      excerpt(where);
    }
  }

  void link_message() {
    static constexpr std::array<std::string_view, 6> forms{
        "mold: error: undefined symbol: {}",
        "mold: error: duplicate symbol: /x/tests.o: answer.o: {}",
        "/usr/bin/ld: answer.o: in function `f': answer.cpp:(.text+0x1): undefined reference to "
        "`{}'",
        "/usr/bin/ld: tests.o: multiple definition of `{}'; answer.o: first defined here",
        "wasm-ld: error: answer.o: undefined symbol: {}",
        "collect2: error: ld returned 1 exit status"};
    line(filled(random_.of(forms), random_.chance(50) ? std::string(random_.of(signatures))
                                                      : std::string(random_.of(names))));
  }

  void spoil_log() {
    std::string& text = request_.log;
    for (std::size_t i = 1 + random_.below(6); i > 0; --i) {
      const std::size_t at = random_.below(text.size() + 1);
      switch (random_.below(7)) {
        case 0:
          text.erase(at, random_.below(20));
          break;
        case 1:
          text.insert(at, random_.of(extremes));
          break;
        case 2:
          text.insert(at, text.substr(random_.below(text.size()), random_.below(200)));
          break;
        case 3:
          text.insert(at, repeated(random_.chance(50) ? "<" : "'",
                                   random_.below(random_.chance(5) ? 9000 : 9)));
          break;
        case 4:
          text.insert(at, 1, static_cast<char>(random_.below(256)));
          break;
        case 5:
          text.insert(at, random_.of(snippets));
          break;
        default:
          if (!text.empty()) text[at % text.size()] = static_cast<char>(random_.below(256));
      }
    }
  }

  Random random_;
  ExplainRequest request_;
  const grading::SourceText* source_ = nullptr;
};

}  // namespace

std::uint64_t Random::next() {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30u)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27u)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31u);
}

std::size_t Random::below(std::size_t n) { return n == 0 ? 0 : next() % n; }

std::vector<Seed> read_seeds(const std::string& root) {
  std::vector<fs::path> folders;
  for (const fs::directory_entry& chapter :
       fs::directory_iterator(fs::path(root) / "tests/grading/mistakes")) {
    if (!chapter.is_directory()) continue;
    for (const fs::directory_entry& exercise : fs::directory_iterator(chapter.path()))
      folders.push_back(exercise.path());
  }
  std::sort(folders.begin(), folders.end());
  const HeaderText shapes{"chapters/00_vectors/contact/shapes.hpp",
                          read(fs::path(root) / "chapters/00_vectors/contact/shapes.hpp")};
  std::vector<Seed> seeds;
  for (const fs::path& folder : folders) {
    const std::string name = folder.filename().string();
    const fs::path id = folder.parent_path().filename() / name;
    const std::vector<HeaderText> headers{
        {("exercises" / id / (name + ".hpp")).string(),
         read(fs::path(root) / "exercises" / id / (name + ".hpp"))},
        shapes};
    std::vector<fs::path> sources{fs::path(root) / "exercises" / id / (name + ".cpp"),
                                  fs::path(root) / "solutions" / id / (name + ".cpp")};
    for (const fs::directory_entry& file : fs::directory_iterator(folder))
      sources.push_back(file.path());
    std::sort(sources.begin(), sources.end());
    for (const fs::path& source : sources) seeds.push_back({read(source), headers});
  }
  return seeds;
}

ExplainRequest fuzzed(const std::vector<Seed>& seeds, std::uint64_t number) {
  Random random(number ^ 0x5eed5eed5eed5eedu);
  return Case(random.of(seeds), random.next()).make();
}

}  // namespace contact::testing
