#include <array>
#include <map>
#include <optional>

#include "plain_text.hpp"

namespace contact::cli {

namespace {

using Table = std::map<std::string_view, std::string_view>;

const Table& letters() {
  static const Table table{
      {"alpha", "α"},   {"beta", "β"},   {"gamma", "γ"},    {"delta", "δ"},      {"epsilon", "ε"},
      {"theta", "θ"},   {"kappa", "κ"},  {"lambda", "λ"},   {"varepsilon", "ε"}, {"mu", "μ"},
      {"nu", "ν"},      {"pi", "π"},     {"rho", "ρ"},      {"sigma", "σ"},      {"tau", "τ"},
      {"phi", "φ"},     {"psi", "ψ"},    {"varphi", "φ"},   {"omega", "ω"},      {"Delta", "Δ"},
      {"Sigma", "Σ"},   {"Omega", "Ω"},  {"Phi", "Φ"},      {"ell", "ℓ"},        {"infty", "∞"},
      {"partial", "∂"}, {"dots", "…"},   {"ldots", "…"},    {"cdots", "⋯"},      {"perp", "⟂"},
      {"lceil", "⌈"},   {"rceil", "⌉"},  {"lfloor", "⌊"},   {"rfloor", "⌋"},     {"prime", "′"},
      {"circ", "°"},    {"lvert", "|"},  {"rvert", "|"},    {"lVert", "|"},      {"rVert", "|"},
      {"langle", "⟨"},  {"rangle", "⟩"}, {"parallel", "∥"}, {"top", "T"}};
  return table;
}

// With a blank on each side.
const Table& operators() {
  static const Table table{{"cdot", "·"},  {"times", "×"},  {"pm", "±"},         {"mp", "∓"},
                           {"le", "≤"},    {"leq", "≤"},    {"ge", "≥"},         {"geq", "≥"},
                           {"ne", "≠"},    {"neq", "≠"},    {"approx", "≈"},     {"sim", "~"},
                           {"to", "→"},    {"in", "∈"},     {"Rightarrow", "⇒"}, {"ll", "≪"},
                           {"gg", "≫"},    {"propto", "∝"}, {"mid", "|"},        {"equiv", "≡"},
                           {"mapsto", "↦"}};
  return table;
}

constexpr std::array<std::string_view, 14> functions{"sin",    "cos", "tan", "arctan", "arcsin",
                                                     "arccos", "log", "ln",  "exp",    "min",
                                                     "max",    "det", "sgn", "gcd"};
// Their argument is shown as it is.
constexpr std::array<std::string_view, 8> wrappers{
    "text", "mathrm", "mathsf", "mathbf", "mathit", "hat", "operatorname", "boldsymbol"};
// Nothing to show.
constexpr std::array<std::string_view, 8> sizes{"left", "right", "big",          "Big",
                                                "bigl", "bigr",  "displaystyle", "limits"};

const Table& raised() {
  static const Table table{{"0", "⁰"}, {"1", "¹"}, {"2", "²"}, {"3", "³"}, {"4", "⁴"}, {"5", "⁵"},
                           {"6", "⁶"}, {"7", "⁷"}, {"8", "⁸"}, {"9", "⁹"}, {"-", "⁻"}, {"−", "⁻"},
                           {"+", "⁺"}, {"n", "ⁿ"}, {"T", "ᵀ"}, {"k", "ᵏ"}, {"i", "ⁱ"}, {"′", "′"}};
  return table;
}

const Table& lowered() {
  static const Table table{{"0", "₀"}, {"1", "₁"}, {"2", "₂"}, {"3", "₃"}, {"4", "₄"}, {"5", "₅"},
                           {"6", "₆"}, {"7", "₇"}, {"8", "₈"}, {"9", "₉"}, {"+", "₊"}, {"−", "₋"},
                           {"a", "ₐ"}, {"e", "ₑ"}, {"i", "ᵢ"}, {"j", "ⱼ"}, {"k", "ₖ"}, {"n", "ₙ"},
                           {"p", "ₚ"}, {"r", "ᵣ"}, {"s", "ₛ"}, {"t", "ₜ"}, {"x", "ₓ"}};
  return table;
}

template <std::size_t N>
bool has(const std::array<std::string_view, N>& words, std::string_view word) {
  for (const std::string_view one : words) {
    if (one == word) return true;
  }
  return false;
}

// The first character, of one or more bytes.
std::string_view character(std::string_view text) {
  std::size_t size = 1;
  while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0u) == 0x80u) ++size;
  return text.substr(0, size);
}

std::size_t characters(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(character(text).size());
  return count;
}

// All of it in raised or lowered characters, if there are such.
std::optional<std::string> shifted(std::string_view text, const Table& table) {
  std::string result;
  while (!text.empty()) {
    const std::string_view one = character(text);
    const auto found = table.find(one);
    if (found == table.end()) return {};
    result += found->second;
    text.remove_prefix(one.size());
  }
  return result;
}

bool is_letter_or_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         (static_cast<unsigned char>(c) & 0x80u) != 0;
}

// Whether it needs no parentheses in a fraction or under a root.
bool is_one(std::string_view text) {
  for (const std::string_view mark : {" ", "/", "−", "+", ","}) {
    if (text.find(mark) != std::string_view::npos) return false;
  }
  return true;
}

std::string in_parentheses(const std::string& text) {
  return is_one(text) || (text.starts_with("|") && text.ends_with("|") &&
                          text.find('|', 1) == text.size() - 1)
             ? text
             : "(" + text + ")";
}

class Formula {
 public:
  explicit Formula(std::string_view tex) : rest_(tex) {}

  std::string read() {
    while (!rest_.empty()) one();
    while (out_.ends_with(' ')) out_.pop_back();
    return out_.substr(out_.find_first_not_of(' ') == std::string::npos
                           ? out_.size()
                           : out_.find_first_not_of(' '));
  }

 private:
  void one() {
    const std::string_view next = character(rest_);
    if (next == "\\") return command();
    if (next == "^" || next == "_") return shift(next == "^");
    rest_.remove_prefix(next.size());
    if (next == " " || next == "&") return;
    if (next == "{" && rest_.starts_with(",}")) {  // {,} separates thousands
      rest_.remove_prefix(2);
      return atom(",");
    }
    if (next == "{") {
      rest_ = std::string_view(next.data(), rest_.size() + 1);
      return atom(plain_formula(argument()));
    }
    if (next == "'") return attach("′");
    if (next == "~") return space();
    if (next == "=" || next == "<" || next == ">") return binary(next);
    if (next == "-" || next == "+") return sign(next == "-" ? "−" : "+");
    if (next == ",") {
      attach(",");
      return space();
    }
    atom(next);
  }

  void command() {
    rest_.remove_prefix(1);
    std::size_t size = 0;
    while (size < rest_.size() && ((rest_[size] >= 'a' && rest_[size] <= 'z') ||
                                   (rest_[size] >= 'A' && rest_[size] <= 'Z')))
      ++size;
    if (size == 0) {
      const std::string_view mark = character(rest_);
      rest_.remove_prefix(mark.size());
      if (mark == "," || mark == ";" || mark == ":" || mark == " ") return space();
      if (mark == "!") return;
      if (mark == "\\") return attach(";"), space();
      return atom(mark == "|" ? "|" : mark);
    }
    const std::string_view name = rest_.substr(0, size);
    rest_.remove_prefix(size);
    if (const auto letter = letters().find(name); letter != letters().end())
      return atom(letter->second);
    if (const auto mark = operators().find(name); mark != operators().end())
      return binary(mark->second);
    if (has(functions, name)) return function(name);
    if (has(wrappers, name)) return wrapped_text(name);
    if (has(sizes, name)) return;
    if (name == "frac" || name == "tfrac" || name == "dfrac") return fraction();
    if (name == "sqrt") return atom("√" + in_parentheses(plain_formula(argument())));
    if (name == "norm" || name == "abs") return atom("|" + plain_formula(argument()) + "|");
    if (name == "quad" || name == "qquad") return space();
    if (name == "not") return;
    atom("\\" + std::string(name));
  }

  // What belongs to a command or to ^ and _: a group, a command or one character.
  std::string_view argument() {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
    if (!rest_.starts_with('{')) {
      std::size_t size = character(rest_).size();
      if (rest_.starts_with('\\')) {
        while (size < rest_.size() && ((rest_[size] >= 'a' && rest_[size] <= 'z') ||
                                       (rest_[size] >= 'A' && rest_[size] <= 'Z')))
          ++size;
        if (rest_.substr(0, size) == "\\mathsf" || rest_.substr(0, size) == "\\mathrm" ||
            rest_.substr(0, size) == "\\text") {
          const std::size_t close = rest_.find('}', size);
          size = close == std::string_view::npos ? rest_.size() : close + 1;
        }
      }
      const std::string_view found = rest_.substr(0, size);
      rest_.remove_prefix(found.size());
      return found;
    }
    std::size_t depth = 0;
    std::size_t end = 0;
    for (; end < rest_.size(); ++end) {
      if (rest_[end] == '{') ++depth;
      if (rest_[end] == '}' && --depth == 0) break;
    }
    const std::string_view inside = rest_.substr(1, end - 1);
    rest_.remove_prefix(end < rest_.size() ? end + 1 : end);
    return inside;
  }

  void shift(bool up) {
    rest_.remove_prefix(1);
    const std::string text = plain_formula(argument());
    if (const auto shown = shifted(text, up ? raised() : lowered())) return attach(*shown);
    if (up && text == "°") return attach(text);
    attach(std::string(up ? "^" : "_") +
           (characters(text) == 1 || (!up && is_one(text)) ? text : "(" + text + ")"));
  }

  void fraction() {
    const std::string above = plain_formula(argument());
    const std::string below = plain_formula(argument());
    static const std::map<std::string, std::string> known{{"1/2", "½"}, {"1/3", "⅓"}, {"2/3", "⅔"},
                                                          {"1/4", "¼"}, {"3/4", "¾"}, {"1/6", "⅙"}};
    if (const auto found = known.find(above + "/" + below); found != known.end())
      return atom(found->second);
    // 3/2 m would read as 3/(2 m).
    const std::string text = in_parentheses(above) + "/" + in_parentheses(below);
    const bool more = !rest_.empty() && is_letter_or_digit(rest_.front());
    atom(more ? "(" + text + ")" : text);
  }

  void wrapped_text(std::string_view name) {
    const std::string_view inside = argument();
    // Blanks count in text, and formulas do not occur in it.
    atom(name == "text" ? std::string(inside) : plain_formula(inside));
  }

  void function(std::string_view name) {
    if (!out_.empty() && (is_letter_or_digit(out_.back()) || out_.back() == ')')) space();
    atom(name);
    after_function_ = true;
  }

  void sign(std::string_view mark) {
    // Unary at the start, and after what it cannot follow.
    const bool unary = out_.empty() || out_.ends_with('(') || out_.ends_with('|') ||
                       out_.ends_with("/") || spaced_operator_ || out_.ends_with(", ");
    if (unary) {
      out_ += mark;
      spaced_operator_ = false;
    } else {
      binary(mark);
    }
  }

  void binary(std::string_view mark) {
    space();
    out_ += mark;
    out_ += ' ';
    after_function_ = false;
    spaced_operator_ = true;
  }

  void atom(std::string_view text) {
    if (text.empty()) return;
    if (after_function_ && is_letter_or_digit(text.front())) space();
    // Two numbers beside each other are a product.
    after_function_ = false;
    spaced_operator_ = false;
    out_ += text;
  }

  // Belongs to what is there: no blank before it.
  void attach(std::string_view text) {
    while (out_.ends_with(' ')) out_.pop_back();
    out_ += text;
    spaced_operator_ = false;
  }

  void space() {
    if (!out_.empty() && !out_.ends_with(' ')) out_ += ' ';
  }

  std::string_view rest_;
  std::string out_;
  // The last was sin or the like: what follows needs a blank before it.
  bool after_function_ = false;
  // The last was = or the like: a sign that follows belongs to its number.
  bool spaced_operator_ = false;
};

}  // namespace

std::string plain_formula(std::string_view tex) { return Formula(tex).read(); }

}  // namespace contact::cli
