#include "support/questions.hpp"

#include <catch2/matchers/catch_matchers_vector.hpp>

using Catch::Matchers::Equals;
using questions::Claim;
using questions::Gaps;
using questions::Key;

namespace {

using Faults = std::vector<std::string>;

const std::string about = "[[objectives]]\nid = \"aim\"\ntext = \"an aim\"\n";

std::string question(const std::string& kind, const std::string& rest) {
  return "[[question]]\nid = \"q\"\nobjective = \"aim\"\ntext = \"asked\"\nkind = \"" + kind +
         "\"\n" + rest;
}

std::string gap(const std::string& id, const std::string& rest = "") {
  return "[[question.gaps]]\nid = \"" + id +
         "\"\nlabel = \"a number\"\nanswer = 2.0\ntolerance = 0.1\n" + rest;
}

Faults faults_of(const std::string& text, const Key& key) {
  return questions::faults("01_it", text, about, {{"q", {[key] { return key; }}}});
}

const std::string lines = "explain = \"because\"\nlines = [\"half of it is {{half}}\"]\n";

}  // namespace

TEST_CASE("gaps that the code computes have no fault") {
  CHECK_THAT(faults_of(question("complete", lines + gap("half")), Gaps{{"half", 2.0}}),
             Equals(Faults{}));
  const std::string table =
      "explain = \"because\"\ntable = [[\"a\", \"b\"], [\"{{half}}\", \"2\"]]\n";
  CHECK_THAT(faults_of(question("complete", table + gap("half")), Gaps{{"half", 2.0}}),
             Equals(Faults{}));
}

TEST_CASE("a gap's number differs from the computed one by a tenth of its tolerance at most") {
  const std::string text = question("complete", lines + gap("half"));
  CHECK_THAT(faults_of(text, Gaps{{"half", 2.009}}), Equals(Faults{}));
  CHECK_THAT(
      faults_of(text, Gaps{{"half", 2.011}}),
      Equals(Faults{"01_it/q: gap half: the answer is 2.000000, the code computes 2.011000"}));
}

TEST_CASE("gaps in the text, in the file and in the key are the same") {
  const Gaps half{{"half", 2.0}};
  CHECK_THAT(faults_of(question("complete", lines + gap("half") + gap("more")), half),
             Equals(Faults{"01_it/q: gap more: {{more}} must stand once in lines or table",
                           "01_it/q: gap more: its key does not compute it"}));
  CHECK_THAT(
      faults_of(question("complete", lines + gap("half")), Gaps{{"half", 2.0}, {"more", 1.0}}),
      Equals(Faults{"01_it/q: its key computes 'more', which is no gap"}));
  const std::string twice = "explain = \"because\"\nlines = [\"{{half}} {{half}} {{other}}\"]\n";
  CHECK_THAT(faults_of(question("complete", twice + gap("half")), half),
             Equals(Faults{"01_it/q: gap half: {{half}} must stand once in lines or table",
                           "01_it/q: no gap is called 'other'"}));
  CHECK_THAT(faults_of(question("complete", lines), half),
             Equals(Faults{"01_it/q: it has no [[question.gaps]]"}));
}

TEST_CASE("a question to complete has lines or a table, and each gap a label") {
  const Gaps half{{"half", 2.0}};
  CHECK_THAT(faults_of(question("complete", lines + "table = [[\"x\"]]\n" + gap("half")), half),
             Equals(Faults{"01_it/q: it has either lines or a table"}));
  const std::string unnamed = "[[question.gaps]]\nid = \"half\"\nanswer = 2.0\ntolerance = 0.1\n";
  CHECK_THAT(faults_of(question("complete", lines + unnamed), half),
             Equals(Faults{"01_it/q: gap half: label is empty"}));
}

TEST_CASE("a gap's wrong answers are told from the right one") {
  const std::string near = gap("half", "wrong = [{answer = 2.1, why = \"no\"}]\n");
  CHECK_THAT(
      faults_of(question("complete", lines + near), Gaps{{"half", 2.0}}),
      Equals(Faults{"01_it/q: gap half: a wrong answer is missing or too near the right one"}));
}

TEST_CASE("a model answer has three criteria, and a claim that needs its reason") {
  const std::string text =
      question("say-why", "model = \"since\"\ncriteria = [\"a\", \"b\", \"c\"]\n");
  CHECK_THAT(faults_of(text, Claim{true, false}), Equals(Faults{}));
  CHECK_THAT(faults_of(text, Claim{false, false}),
             Equals(Faults{"01_it/q: what the model answer claims does not hold"}));
  CHECK_THAT(faults_of(text, Claim{true, true}),
             Equals(Faults{"01_it/q: what the model answer claims holds without its reason too"}));
  CHECK_THAT(faults_of(text, Key{1.0}),
             Equals(Faults{"01_it/q: its key must be a questions::Claim"}));
  CHECK_THAT(
      faults_of(question("say-why", "model = \"since\"\ncriteria = [\"a\"]\n"), Claim{true, false}),
      Equals(Faults{"01_it/q: it needs three criteria"}));
  CHECK_THAT(
      faults_of(question("say-why", "criteria = [\"a\", \"b\", \"c\"]\n"), Claim{true, false}),
      Equals(Faults{"01_it/q: model is empty"}));
}

TEST_CASE("an unknown kind is a fault, and so is a question without a key") {
  CHECK_THAT(faults_of(question("guess", "explain = \"because\"\n"), Key{1.0}),
             Equals(Faults{
                 "01_it/q: kind must be predict, choose, order, construct, complete or say-why"}));
  const std::string text =
      question("predict", "explain = \"because\"\nanswer = 1.0\nunit = \"\"\ntolerance = 1\n");
  CHECK_THAT(questions::faults("01_it", text, about, {}),
             Equals(Faults{"01_it/q: no KEY recomputes its answer"}));
}
