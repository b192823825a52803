#pragma once

// One name, two spellings in Unicode: "ü" is one character, or "u" and its mark. Windows and Linux
// mostly write the first, macOS the second.

#include <string>
#include <string_view>

namespace contact::grading {

/// UTF-8 with every composed character written as its base and marks, so that two spellings of one
/// name are equal. Marks keep their order, which is right for names that are composed (NFC) or
/// decomposed (NFD) throughout. CJK compatibility ideographs stay, as they do on macOS.
std::string decomposed(std::string_view text);

}  // namespace contact::grading
