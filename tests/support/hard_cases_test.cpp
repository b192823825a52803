#include "support/hard_cases.hpp"

#include <unistd.h>
#include <catch2/catch_test_macros.hpp>
#include <cstdio>
#include <cstdlib>
#include <fstream>

using hard_cases::Case;
using hard_cases::CorpusError;
using hard_cases::Json;

namespace {

Json good() {
  return Json::parse(R"({"name": "a-case", "family": "grid", "question": "q", "type": "double",
    "meaning": "stored", "why": "because", "source": "here",
    "input": {"x": "0x1.8p+1", "v": ["-0x1p-1074", "0x0p+0", "0x1p+1023"]},
    "answer": {"class": "a"}, "fails": []})");
}

std::string complaint(const Json& source, const char* field) {
  try {
    const Case c(source);
    if (std::string(field) == "x") {
      c.number(field);
    } else {
      c.vector(field);
    }
  } catch (const CorpusError& problem) {
    return problem.what();
  }
  return "";
}

bool names(const std::string& text, const char* first, const char* second) {
  return text.find(first) != std::string::npos && text.find(second) != std::string::npos;
}

}  // namespace

TEST_CASE("hexadecimal floats are read to the last bit") {
  const Case c(good());
  CHECK(c.number("x") == 3.0);
  CHECK(c.vector("v") == contact::Vector3<double>(-5e-324, 0, 8.98846567431158e307));
  CHECK(c.numbers("v") == std::vector<double>{-5e-324, 0, 8.98846567431158e307});
  CHECK(c.exact_number("x") == 3);
  CHECK(hard_cases::hex(0.1) == "0x1.999999999999ap-4");
}

TEST_CASE("a bad corpus is refused with the case and the field in the message") {
  for (const char* bad : {"1.5", "0x1p+5000", "0x", "0x1p+1 ", "nan", "1/2"}) {
    Json source = good();
    source["input"]["x"] = bad;
    CAPTURE(bad);
    CHECK(names(complaint(source, "x"), "a-case", "\"x\""));
  }
  Json number = good();
  number["input"]["x"] = 1.5;
  CHECK(names(complaint(number, "x"), "a-case", "\"x\""));
  Json missing = good();
  missing["input"].erase("x");
  CHECK(names(complaint(missing, "x"), "a-case", "\"x\""));
  Json entry = good();
  entry["input"]["v"][1] = "one";
  CHECK(names(complaint(entry, "v"), "a-case", "\"v[1]\""));
  CHECK_THROWS_AS(Case(good()).numbers("x"), CorpusError);
  CHECK_THROWS_AS(Case(entry).numbers("v"), CorpusError);
  Json type = good();
  type["type"] = "float";
  CHECK(names(complaint(type, "v"), "a-case", "v[0]"));  // -0x1p-1074 is no float
  for (const char* field :
       {"family", "why", "source", "question", "type", "meaning", "input", "answer", "fails"}) {
    Json source = good();
    source.erase(field);
    CHECK(names(complaint(source, "x"), "a-case", field));
  }
}

TEST_CASE("a constructed number keeps its fraction, and is stored in the case's type") {
  Json source = good();
  source["meaning"] = "constructed";
  source["input"]["x"] = "1/10";
  CHECK(Case(source).number("x") == 0.1);
  CHECK(Case(source).exact_number("x") == oracle::Rational(1, 10));
  source["type"] = "float";
  CHECK(Case(source).number("x") == static_cast<double>(0.1f));
}

TEST_CASE("an answer is described in words") {
  CHECK(hard_cases::answer_text(Json{{"class", "a"}, {"hit", true}, {"t", "1/2"}}) ==
        "hit: yes, t = 1/2");
  CHECK(hard_cases::answer_text(
            Json{{"class", "b"}, {"t", "0x1.8p+1"}, {"at", Json::array({"1", nullptr})}}) ==
        "t = 3, at = (1, none)");
}

TEST_CASE("two cases of one name, and a file that is not there, are refused") {
  const std::string path =
      std::string(std::getenv("TMPDIR") != nullptr ? std::getenv("TMPDIR") : "/tmp") +
      "/contact_corpus_" + std::to_string(::getpid()) + ".json";
  std::ofstream(path) << Json{{"cases", Json::array({good(), good()})}};
  CHECK_THROWS_AS(hard_cases::read(path), CorpusError);
  std::remove(path.c_str());
  CHECK_THROWS_AS(hard_cases::read(path), CorpusError);
}
