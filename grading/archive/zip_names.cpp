#include "zip_names.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>

#include "../text/shown_text.hpp"

namespace contact::grading {

namespace {

constexpr std::size_t local_size = 30;
constexpr std::size_t central_size = 46;
constexpr std::size_t end_size = 22;
constexpr std::size_t locator_size = 20;
constexpr std::uint32_t elsewhere = 0xFFFFFFFF;

// Little endian; 0 where the bytes end.
std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
  if (at > bytes.size() || bytes.size() - at < size) return 0;
  std::uint64_t number = 0;
  for (std::size_t i = size; i-- > 0;)
    number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

std::size_t short_at(std::string_view bytes, std::size_t at) { return number_at(bytes, at, 2); }
std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint32_t>(number_at(bytes, at, 4));
}

bool has_at(std::string_view bytes, std::size_t at, std::string_view signature, std::size_t size) {
  return at <= bytes.size() && bytes.size() - at >= size && bytes.substr(at).starts_with(signature);
}

// Of the contents of one extra field; empty if it is not there.
std::string_view extra_field(std::string_view extra, std::size_t wanted) {
  while (extra.size() >= 4) {
    const std::size_t size = short_at(extra, 2);
    if (size > extra.size() - 4) break;
    if (short_at(extra, 0) == wanted) return extra.substr(4, size);
    extra.remove_prefix(4 + size);
  }
  return {};
}

constexpr std::array<std::uint32_t, 256> crc_table = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
    table[byte] = byte;
    for (int bit = 0; bit < 8; ++bit)
      table[byte] = table[byte] >> 1 ^ ((table[byte] & 1) != 0 ? 0xEDB88320u : 0u);
  }
  return table;
}();

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = ~0u;
  for (const char c : bytes)
    crc = crc >> 8 ^ crc_table[(crc ^ static_cast<unsigned char>(c)) & 0xFF];
  return ~crc;
}

// What stands where the archive says a name.
struct Written {
  std::string_view name;
  std::string_view extra;
  bool utf8 = false;
};

Written written(std::string_view bytes, std::size_t flags, std::size_t name, std::size_t name_size,
                std::size_t extra_size) {
  constexpr std::size_t utf8_flag = 1u << 11;
  // Both sizes are of 16 bits; what lies beyond the end is cut.
  const std::string_view from_name = bytes.substr(std::min(name, bytes.size()));
  const std::string_view from_extra = from_name.substr(std::min(name_size, from_name.size()));
  return {from_name.substr(0, name_size), from_extra.substr(0, extra_size),
          (flags & utf8_flag) != 0};
}

Written local_name(std::string_view bytes, std::size_t at) {
  return written(bytes, short_at(bytes, at + 6), at + local_size, short_at(bytes, at + 26),
                 short_at(bytes, at + 28));
}

Written central_name(std::string_view bytes, std::size_t at) {
  return written(bytes, short_at(bytes, at + 8), at + central_size, short_at(bytes, at + 28),
                 short_at(bytes, at + 30));
}

std::string from_cp437(std::string_view name) {
  static constexpr char16_t upper_half[] =
      u"ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐"
      u"└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■\u00A0";
  static_assert(std::size(upper_half) == 128 + 1);
  std::string text;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    append_utf8(text, byte < 0x80 ? byte : upper_half[byte - 0x80]);
  }
  return text;
}

// Info-ZIP's Unicode Path: a version, the checksum of the name that it stands for, and UTF-8.
std::string unicode_path(const Written& place) {
  const std::string_view field = extra_field(place.extra, 0x7075);
  if (field.size() <= 5 || field[0] != 1 || word_at(field, 1) != crc32(place.name)) return {};
  const std::string_view name = field.substr(5);
  return is_utf8(name) ? std::string(name) : std::string();
}

// Many programs write UTF-8 and do not set the flag that says so; what old ones write is no UTF-8.
std::string decoded(std::string_view name, bool utf8) {
  return utf8 || is_utf8(name) ? std::string(name) : from_cp437(name);
}

std::string with_slashes(std::string name) {
  if (name.find('/') == std::string::npos) std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

// Where the directory begins, as the end of the archive says.
std::size_t directory_of(std::string_view bytes) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  const std::size_t end = bytes.rfind("PK\x05\x06");
  if (end == std::string_view::npos || !has_at(bytes, end, "PK", end_size)) return none;
  const std::uint32_t begin = word_at(bytes, end + 16);
  if (begin != elsewhere) return begin;
  if (end < locator_size || !has_at(bytes, end - locator_size, "PK\x06\x07", locator_size))
    return none;
  const std::size_t large_end = number_at(bytes, end - locator_size + 8, 8);
  return has_at(bytes, large_end, "PK\x06\x06", 56) ? number_at(bytes, large_end + 48, 8) : none;
}

// Where the header in front of an entry's data stands; in a large archive an extra field says it,
// after those of two sizes that the record itself does not say.
std::size_t local_of(std::string_view bytes, std::size_t central) {
  const std::uint32_t place = word_at(bytes, central + 42);
  if (place != elsewhere) return place;
  const std::string_view field = extra_field(central_name(bytes, central).extra, 0x0001);
  const std::size_t before = (word_at(bytes, central + 20) == elsewhere ? 8 : 0) +
                             (word_at(bytes, central + 24) == elsewhere ? 8 : 0);
  return field.size() < before + 8 ? std::numeric_limits<std::size_t>::max()
                                   : number_at(field, before, 8);
}

}  // namespace

ZipNames::ZipNames(std::string_view bytes) : bytes_(bytes) {
  std::size_t at = directory_of(bytes);
  while (has_at(bytes, at, "PK\x01\x02", central_size)) {
    const std::size_t local = local_of(bytes, at);
    if (has_at(bytes, local, "PK\x03\x04", local_size)) {
      const std::size_t end =
          local + local_size + short_at(bytes, local + 26) + short_at(bytes, local + 28);
      entries_.emplace(end, Places{local, at});
    }
    at += central_size + short_at(bytes, at + 28) + short_at(bytes, at + 30) +
          short_at(bytes, at + 32);
  }
}

ZipName ZipNames::before(std::size_t position) const {
  ZipName name;
  const auto after = entries_.upper_bound(position);
  if (after == entries_.begin()) return name;
  const Places places = std::prev(after)->second;
  const Written local = local_name(bytes_, places.local);
  const Written central = central_name(bytes_, places.central);
  const bool utf8 = local.utf8 || central.utf8;
  for (const std::string& reading :
       {unicode_path(local), unicode_path(central), decoded(local.name, utf8),
        decoded(central.name, utf8), std::string(local.name), std::string(central.name)}) {
    const std::string path = with_slashes(reading);
    if (!path.empty() &&
        std::find(name.readings.begin(), name.readings.end(), path) == name.readings.end())
      name.readings.push_back(path);
  }
  name.as_written = std::all_of(name.readings.begin(), name.readings.end(),
                                [&](const std::string& reading) { return reading == local.name; });
  return name;
}

}  // namespace contact::grading
