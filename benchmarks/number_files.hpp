/// @file
/// Files of numbers as they are in memory, one after the other, for comparisons in other languages.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <vector>

template <class T>
void write_numbers(const std::filesystem::path& file, const std::vector<T>& numbers) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(numbers.data()),
            static_cast<std::streamsize>(numbers.size() * sizeof(T)));
}
template <class T>
std::vector<T> read_numbers(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  std::vector<T> numbers(static_cast<std::size_t>(in.tellg()) / sizeof(T));
  in.seekg(0);
  in.read(reinterpret_cast<char*>(numbers.data()),
          static_cast<std::streamsize>(numbers.size() * sizeof(T)));
  return numbers;
}
