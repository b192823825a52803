/// @file
/// Reads a chapter's corpus of hard cases, recomputes every answer, and says which method gets
/// which case right.
///
/// A chapter's tests/NN_slug/hard_cases.cpp is a program:
///
///     int main(int argc, char** argv) {
///       hard_cases::Runner runner("01_planes");
///       runner.question("side", [](const Case& c) -> Json {          // the right answer, by the
///       oracle
///         return {{"class", "a"}, {"side", oracle::sign(...)}};
///       });
///       runner.method("side", "float, n·x - k", [](const Case& c, const Json& answer) {
///         return ... == answer.at("side").get<int>();                // right?
///       });
///       return runner.run(argc, argv);
///     }
///
/// Without arguments it exits 1, with a message for each fault, unless every stored answer is the
/// recomputed one and the methods that get a case wrong are exactly those in its `fails`. `--json`
/// prints what the book's table shows. `--report FILE` prints what a call without arguments prints
/// and, if nothing is wrong, writes the same JSON into FILE.
/// `--answers` prints the corpus with every answer and `fails` filled in, for an author who adds
/// cases and then reads what came out.
///
/// In the corpus, a stored number is a hexadecimal float ("0x1.8p+1", "-0x1p-1074", "0x0p+0"). A
/// number of a case whose meaning is "constructed" may also be a fraction "p/q": number() gives
/// what is stored for it in the case's type, and exact_number() the fraction itself.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <contact/shapes.hpp>

#include "support/oracle.hpp"

namespace hard_cases {

using Json = nlohmann::ordered_json;

/// A corpus that cannot be read; what() names the file or case, and the field.
class CorpusError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One case, with its fields read and checked.
class Case {
 public:
  explicit Case(const Json& source);

  const std::string& name() const { return name_; }
  const std::string& family() const { return family_; }
  const std::string& question() const { return question_; }
  const std::string& type() const {
    return type_;
  }  ///< "double" or "float": what the input is stored in
  const std::string& meaning() const { return meaning_; }  ///< "stored" or "constructed"
  const std::string& why() const { return why_; }
  const std::string& source() const { return source_; }
  const std::vector<std::string>& fails() const { return fails_; }
  const Json& answer() const { return answer_; }
  bool has(const std::string& field) const { return input_.contains(field); }

  /// @name Fields of the input. Each throws CorpusError naming the case and the field.
  /// @{
  double number(const std::string& field) const;
  contact::Vector3<double> vector(const std::string& field) const;   ///< [x, y, z]
  std::vector<double> numbers(const std::string& field) const;       ///< a list of any length
  contact::Segment<double> segment(const std::string& field) const;  ///< {"start": .., "end": ..}
  contact::Ray<double> ray(const std::string& field) const;  ///< {"origin": .., "direction": ..}
  contact::Sphere<double> sphere(const std::string& field) const;  ///< {"centre": .., "radius": ..}
  contact::Triangle<double> triangle(
      const std::string& field) const;                            ///< {"a": .., "b": .., "c": ..}
  contact::Plane<double> plane(const std::string& field) const;   ///< {"normal": .., "offset": ..}
  oracle::Rational exact_number(const std::string& field) const;  ///< the fraction, before storing
  oracle::Vector exact_vector(const std::string& field) const;
  /// @}

 private:
  const Json& find(const Json& object, const std::string& path, const std::string& key) const;
  double stored(const Json& value, const std::string& path) const;
  oracle::Rational fraction(const Json& value, const std::string& path) const;
  contact::Vector3<double> stored_vector(const Json& value, const std::string& path) const;
  [[noreturn]] void fail(const std::string& path, const std::string& problem) const;

  std::string name_, family_, question_, type_, meaning_, why_, source_;
  std::vector<std::string> fails_;
  Json input_, answer_;
};

/// All cases of a file, in order. Names must differ; every text must say something.
std::vector<Case> read(const std::string& path);
/// tests/<chapter>/hard_cases.json of this source tree.
std::string corpus_path(const std::string& chapter);

/// A double as the corpus writes it.
std::string hex(double x);
Json hex(const contact::Vector3<double>& v);
/// The double nearest to x, as the corpus writes it.
std::string hex(const oracle::Rational& x);
/// The double that hex() wrote: an answer, or a field of one.
double unhex(const Json& number);
double unhex(const Json& answer, const char* field);

/// A stored number in the arithmetic of S: double, or fractions.
template <class S>
S convert(double x) {
  if constexpr (std::is_same_v<S, double>) {
    return x;
  } else {
    return oracle::exact(x);
  }
}

/// Whether got is a number and at most `room` away.
bool close(double got, double right, double room);

/// Recomputes a chapter's answers and judges its methods; see the top of this file.
class Runner {
 public:
  using Recompute = std::function<Json(const Case&)>;
  using IsRight = std::function<bool(const Case&, const Json& answer)>;
  /// Whether a case of this question is one that the method answers at all (a float method and a
  /// corpus of doubles).
  using Applies = std::function<bool(const Case&)>;

  explicit Runner(std::string chapter);
  Runner& question(const std::string& name, Recompute recompute);
  /// Methods are shown in the order in which they are added. A method that throws gets the case
  /// wrong.
  Runner& method(const std::string& question, const std::string& name, IsRight is_right);
  Runner& method(const std::string& question, const std::string& name, Applies applies,
                 IsRight is_right);
  int run(int argc, char** argv);

 private:
  struct Method {
    std::string question, name;
    Applies applies;
    IsRight is_right;
  };
  Json judge(const std::vector<Case>& cases, std::vector<std::string>& faults) const;

  std::string chapter_;
  std::map<std::string, Recompute> questions_;
  std::vector<Method> methods_;
};

/// An answer as one line for the reader: "t = 1/2, hit: yes"; the class is left out.
std::string answer_text(const Json& answer);

}  // namespace hard_cases
