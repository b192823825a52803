#include <array>
#include <cstdint>
#include <utility>

#include "../message_text.hpp"
#include "rules.hpp"

namespace contact::grading {

namespace {

constexpr std::array rules{
    Rule{"comparisons like '{}' do not have{}", "chained-comparison",
         "Two comparisons cannot stand in a row: for a <= b <= c, write a <= b && b <= c."},
    Rule{"chained comparison '{}' does not{}", "chained-comparison",
         "Two comparisons cannot stand in a row: for a <= b <= c, write a <= b && b <= c."},
    Rule{"infinite recursion detected{}", "endless-recursion",
         "This function always calls itself and never returns."},
    Rule{"all paths through this function will call itself{}", "endless-recursion",
         "This function always calls itself and never returns."},
    Rule{"suggest parentheses around assignment used as truth value{}", "assignment-for-comparison",
         "One = assigns. To compare, write ==."},
    Rule{"using the result of an assignment as a condition without parentheses{}",
         "assignment-for-comparison", "One = assigns. To compare, write ==."},
    Rule{"suggest braces around empty body in an '{}' statement{}", "empty-body",
         "The ; ends the $1 here, so that what follows runs in any case."},
    Rule{"{} statement has empty body{}", "empty-body",
         "The ; ends the $1 here, so that what follows runs in any case."},
    Rule{"{} loop has empty body{}", "empty-body",
         "The ; ends the $1 here, so that what follows runs in any case."},
    Rule{"this '{}' clause does not guard{}", "misleading-indentation",
         "Only the first statement after this $1 depends on it. Put braces { } around all that "
         "do."},
    Rule{"misleading indentation; {}", "misleading-indentation",
         "This looks as if it depended on what stands above, and does not. Put braces { } around "
         "all that does."},
    Rule{"'{}' is used uninitialized{}", "uninitialised",
         "$1 has no value yet where it is used here: give it one where it is declared."},
    Rule{"'{}' may be used uninitialized{}", "uninitialised",
         "$1 may have no value yet where it is used here: give it one where it is declared."},
    Rule{"variable '{}' is uninitialized when {}", "uninitialised",
         "$1 has no value yet where it is used here: give it one where it is declared."},
    Rule{"variable '{}' is used uninitialized whenever{}", "uninitialised",
         "$1 may have no value yet where it is used here: give it one where it is declared."},
    Rule{
        "conversion from '{}' to '{}' may change {}", "narrowing",
        "Turning $1 into $2 may lose a part of the number: the digits after the point, or a number "
        "too large."},
    Rule{
        "implicit conversion turns floating-point number into integer: '{}' to '{}'{}", "narrowing",
        "Turning $1 into $2 may lose a part of the number: the digits after the point, or a number "
        "too large."},
    Rule{
        "implicit conversion loses {}: '{}' to '{}'{}", "narrowing",
        "Turning $2 into $3 may lose a part of the number: the digits after the point, or a number "
        "too large."},
    Rule{"comparison of integer expressions of different signedness: '{}' and '{}'{}",
         "signed-compared",
         "$1 can be negative and $2 cannot, or the other way round. Compare with "
         "static_cast<int>(...), or let both be of one type."},
    Rule{"comparison of integers of different signs: '{}' and '{}'{}", "signed-compared",
         "$1 can be negative and $2 cannot, or the other way round. Compare with "
         "static_cast<int>(...), or let both be of one type."},
    Rule{"unused variable '{}'{}", "unused", "$1 is never used."},
    Rule{"variable '{}' set but not used{}", "unused", "$1 gets a value and is never used."},
    Rule{"declaration of '{}' shadows {}", "shadowed",
         "There is a $1 already, declared further out: from here on this one hides it."},
    Rule{"declaration shadows {}", "shadowed",
         "A variable of this name is declared further out: from here on this one hides it."},
    Rule{"statement has no effect{}", "no-effect", "This computes something and drops it."},
    Rule{"value computed is not used{}", "no-effect", "This computes something and drops it."},
    Rule{"{} result unused{}", "no-effect", "This computes something and drops it."},
};

}  // namespace

std::span<const Rule> rules_of_warnings() { return rules; }

}  // namespace contact::grading
