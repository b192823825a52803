// contact ask: the questions of a chapter, asked and checked in the terminal as in the page.

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "../../grading/progress/progress.hpp"
#include "../commands.hpp"
#include "../terminal/plain_text.hpp"
#include "../terminal/terminal.hpp"
#include "question_judge.hpp"
#include "typed_lines.hpp"

namespace contact::cli {

namespace {

using grading::Chapter;
using grading::Question;
using grading::QuestionGap;
using grading::QuestionKind;
using grading::QuestionProgress;

struct Options {
  std::string chapter;
  std::string id;
  bool all = false;
};

// How a question ended.
enum class End { right, told, compared, in_the_page };

// The reader wants no more: q, or the end of the input.
struct Stop {};

std::string letter(std::size_t index) { return std::string(1, static_cast<char>('a' + index)); }

std::string title(QuestionKind kind) {
  switch (kind) {
    case QuestionKind::predict:
      return "Predict";
    case QuestionKind::choose:
      return "Choose";
    case QuestionKind::order:
      return "Put in order";
    case QuestionKind::construct:
      return "Construct";
    case QuestionKind::complete:
      return "Complete";
    case QuestionKind::say_why:
      return "Say why";
  }
  return {};
}

std::string unit_note(const grading::NumberKey& key) {
  return key.unit.empty() ? "a number without a unit" : "a number and its unit";
}

class Session {
 public:
  Session(const grading::Book& book, grading::Progress& progress)
      : units_(book.book_root() / "grading" / "text" / "units.json"), progress_(progress) {}

  End ask(const Question& question) {
    switch (question.kind) {
      case QuestionKind::predict:
        return until_right(
            question, "Your answer (" + unit_note(question.number) + "):",
            [&](const std::string& line) { return judge_number(units_, question.number, line); },
            [](const std::string& line) { return nlohmann::json(line); });
      case QuestionKind::choose:
        show_choices(question);
        return until_right(
            question, "Your choice (a to " + letter(question.choices.size() - 1) + "):",
            [&](const std::string& line) {
              return judge_choice(question, named_choice(line, question.choices.size()));
            },
            [&](const std::string& line) {
              return nlohmann::json(*named_choice(line, question.choices.size()));
            });
      case QuestionKind::order:
        show_choices(question);
        return until_right(
            question, "Your order, such as " + letter(1) + " " + letter(0) + " ...:",
            [&](const std::string& line) {
              return judge_sequence(question, named_sequence(line, question.choices.size()));
            },
            [&](const std::string& line) {
              return nlohmann::json(*named_sequence(line, question.choices.size()));
            });
      case QuestionKind::construct:
        return in_the_page(question);
      case QuestionKind::complete:
        return complete(question);
      case QuestionKind::say_why:
        return say_why(question);
    }
    return End::told;
  }

 private:
  std::string line(const std::string& prompt) {
    const std::optional<std::string> typed = lines_.next("  " + style_.bold(prompt));
    if (!typed || *typed == "q") throw Stop{};
    return *typed;
  }

  void text(const std::string& markdown, std::size_t by = 2) {
    say(wrapped(plain_text(markdown), by));
  }

  void verdict(const Judged& judged) {
    const std::string mark = judged.right    ? style_.good("Right.") + " "
                             : judged.counts ? style_.bad("Not yet.") + " "
                                             : "";
    say(wrapped(mark + plain_text(judged.say), 2));
  }

  void keep(const Question& question, nlohmann::json answer, bool right,
            std::vector<bool> marks = {}) {
    progress_.record_answer(question.name(), {std::string(key(question.kind)), std::move(answer),
                                              right, std::move(marks)});
  }

  void show_choices(const Question& question) {
    for (std::size_t i = 0; i < question.choices.size(); ++i) {
      const std::string shown = wrapped(plain_text(question.choices[i]), 5);
      say("  " + style_.bold(letter(i)) + "  " + shown.substr(5));
    }
  }

  // Asks until the answer is right; Enter alone asks for the answer.
  template <typename Judge, typename Keep>
  End until_right(const Question& question, const std::string& prompt, const Judge& judge,
                  const Keep& kept) {
    for (;;) {
      const std::string typed = line(prompt);
      if (typed.empty()) {
        text("The answer: " + solution(question));
        text(question.explain);
        return End::told;
      }
      const Judged judged = judge(typed);
      verdict(judged);
      if (!judged.counts) continue;
      keep(question, kept(typed), judged.right);
      if (judged.right) {
        text(question.explain);
        return End::right;
      }
    }
  }

  static std::string solution(const Question& question) {
    if (question.kind == QuestionKind::predict) return shown_key(question.number);
    if (question.kind == QuestionKind::choose)
      return letter(question.right_choice) + ", " + question.choices[question.right_choice];
    std::string sequence;
    for (const std::size_t index : question.sequence)
      sequence += (sequence.empty() ? "" : " ") + letter(index);
    return sequence;
  }

  End in_the_page(const Question& question) {
    say(wrapped("This one is answered in the page, in the figure " + question.figure + ": " +
                    program_as_typed() + " serve, then chapters/" + question.chapter +
                    ".html#question-" + question.id,
                2));
    return End::in_the_page;
  }

  // The steps or the table, with the gaps that are known filled in.
  void show_lines(const Question& question, const std::map<std::string, std::string>& known) {
    const auto filled = [&](std::string shown) {
      for (std::size_t i = 0; i < question.gaps.size(); ++i) {
        const std::string mark = "{{" + question.gaps[i].id + "}}";
        const auto found = known.find(question.gaps[i].id);
        if (const std::size_t at = shown.find(mark); at != std::string::npos)
          shown.replace(
              at, mark.size(),
              found != known.end() ? found->second : "(" + std::to_string(i + 1) + ")____");
      }
      return plain_text(shown);
    };
    for (std::size_t i = 0; i < question.lines.size(); ++i) {
      const std::string shown = wrapped(filled(question.lines[i]), 5);
      say("  " + std::to_string(i + 1) + ". " + shown.substr(5));
    }
    std::vector<std::size_t> widths;
    std::vector<std::vector<std::string>> rows;
    for (const std::vector<std::string>& row : question.table) {
      rows.emplace_back();
      for (std::size_t i = 0; i < row.size(); ++i) {
        rows.back().push_back(filled(row[i]));
        if (widths.size() <= i) widths.push_back(0);
        widths[i] = std::max(widths[i], display_width(rows.back()[i]) + 3);
      }
    }
    for (const std::vector<std::string>& row : rows) {
      std::string shown = "  ";
      for (std::size_t i = 0; i < row.size(); ++i) shown += padded(row[i], widths[i]);
      say(&row == &rows.front() ? style_.bold(shown) : shown);
    }
  }

  End complete(const Question& question) {
    std::map<std::string, std::string> known;
    std::vector<std::string> typed(question.gaps.size());
    show_lines(question, known);
    End end = End::right;
    for (std::size_t i = 0; i < question.gaps.size(); ++i) {
      const QuestionGap& gap = question.gaps[i];
      for (;;) {
        const std::string given = line("(" + std::to_string(i + 1) + ") " + gap.label + " (" +
                                       unit_note(gap.number) + "):");
        if (given.empty()) {
          text("The answer: " + shown_key(gap.number));
          known[gap.id] = shown_key(gap.number);
          end = End::told;
          break;
        }
        const Judged judged = judge_number(units_, gap.number, given);
        verdict(judged);
        if (!judged.counts) continue;
        typed[i] = given;
        const bool all = judged.right && end == End::right && i + 1 == question.gaps.size();
        if (!judged.right || all) keep(question, typed, all);
        if (!judged.right) continue;
        known[gap.id] = given;
        break;
      }
    }
    show_lines(question, known);
    text(question.explain);
    return end;
  }

  End say_why(const Question& question) {
    say(wrapped("Write your answer; an empty line ends it.", 2));
    std::string answer;
    for (;;) {
      const std::string more = line(">");
      if (more.empty()) break;
      answer += (answer.empty() ? "" : "\n") + more;
    }
    if (answer.empty()) {
      text("A model answer: " + question.explain);
      return End::told;
    }
    text("A model answer: " + question.explain);
    // What was written is kept, whatever follows.
    keep(question, answer, false, std::vector<bool>(question.criteria.size(), false));
    say("  Which of these does your answer say? Only you judge it.");
    std::vector<bool> marks;
    for (const std::string& criterion : question.criteria) {
      text("- " + criterion, 4);
      marks.push_back(yes());
    }
    progress_.record_marks(question.name(), marks);
    return End::compared;
  }

  bool yes() {
    for (;;) {
      const std::string typed = line("Does it? (y or n)");
      if (typed == "y" || typed == "yes") return true;
      if (typed == "n" || typed == "no" || typed.empty()) return false;
    }
  }

  grading::Units units_;
  grading::Progress& progress_;
  TypedLines lines_;
  Style style_{stdout};
};

// What has been answered: right, or in the reader's own words.
bool answered(const grading::ProgressRecord& record, const Question& question) {
  const std::optional<QuestionProgress> before = record.answer_to(question.name());
  return before && (before->right || question.kind == QuestionKind::say_why);
}

std::string did_you_mean(const std::string& name, const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& near : grading::nearest(name, names))
    text += (text.empty() ? ". Did you mean " : " or ") + near;
  return text.empty() ? "." : text + "?";
}

const Chapter& chapter_of(const grading::Book& book, const std::string& name) {
  if (const Chapter* chapter = book.find_chapter(name)) return *chapter;
  std::vector<std::string> names;
  for (const Chapter& chapter : book.chapters()) names.push_back(chapter.slug);
  throw grading::UnknownName("there is no chapter called '" + name + "'" +
                             did_you_mean(name, names));
}

std::vector<Question> chosen(const grading::ProgressRecord& record, const Chapter& chapter,
                             const Options& options) {
  std::vector<Question> questions = grading::read_questions(chapter);
  if (questions.empty()) throw grading::UnknownName(chapter.slug + " has no questions yet.");
  if (!options.id.empty()) {
    std::vector<std::string> ids;
    for (const Question& question : questions) {
      if (question.id == options.id || question.name() == options.id) return {question};
      ids.push_back(question.id);
    }
    throw grading::UnknownName(chapter.slug + " has no question called '" + options.id + "'" +
                               did_you_mean(options.id, ids));
  }
  if (!options.all)
    std::erase_if(questions, [&](const Question& question) { return answered(record, question); });
  return questions;
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what;
}

int run(Context& context, const Options& options) {
  const grading::Book& book = context.book();
  grading::Progress progress(book.work());
  if (!progress.notice().empty()) note(progress.notice());
  const Chapter& chapter = chapter_of(book, options.chapter);
  const std::vector<Question> questions = chosen(progress.known(), chapter, options);
  const Style style(stdout);
  say(style.bold(plain_text(chapter.title)) + ": " +
      counted(questions.size(), questions.size() == 1 ? "question" : "questions"));
  if (questions.empty()) {
    say("You have answered all of them; --all asks them again.");
    return exit_passed;
  }
  say(style.dim("Enter alone shows the answer, q ends."));
  std::map<End, std::size_t> ends;
  std::size_t done = 0;
  bool stopped = false;
  try {
    Session session(book, progress);
    for (const Question& question : questions) {
      say("");
      say(style.bold(std::to_string(done + 1) + " of " + std::to_string(questions.size()) + "  " +
                     title(question.kind)) +
          style.dim("  " + question.id));
      say(wrapped(plain_text(question.text), 2));
      ++ends[session.ask(question)];
      ++done;
    }
  } catch (const Stop&) {
    stopped = true;
  }
  say("");
  std::string summary = counted(ends[End::right], "right");
  if (ends[End::told] > 0) summary += ", " + counted(ends[End::told], "shown");
  if (ends[End::compared] > 0) summary += ", " + counted(ends[End::compared], "in your own words");
  if (ends[End::in_the_page] > 0) summary += ", " + counted(ends[End::in_the_page], "for the page");
  if (done < questions.size()) summary += ", " + counted(questions.size() - done, "not answered");
  say(summary);
  return stopped || ends[End::told] > 0 ? exit_not_passed : exit_passed;
}

}  // namespace

void add_ask(Command app, Action& action) {
  auto options = std::make_shared<Options>();
  const Command command = app.add_subcommand(
      "ask", "The questions of a chapter: those that you have not answered right yet");
  command.add_option("chapter", options->chapter, "The chapter").required();
  command.add_flag("--all", options->all, "Also those that you have answered right");
  command.add_option("--id", options->id, "Only the question of this name").type_name("ID");
  command.callback([&action, options] {
    action = [options](Context& context) { return run(context, *options); };
  });
}

}  // namespace contact::cli
