/// @file
/// A value as bytes, and back. The reader trusts nothing: sizes are checked against what is left
/// and against a limit on memory before anything is allocated, and left-over bytes are an error.
///
/// Little-endian. bool: one byte, 0 or 1. int: 4 bytes; std::int64_t and enumerations: 8. double:
/// its 8 bytes, so that every value crosses exactly, NaN included. String and vector: 4 bytes of
/// length, then the elements. Matrix: rows and columns (only those that the type leaves open), then
/// the coefficients by columns. optional: a byte, then perhaps the value. variant: a byte of index,
/// then the alternative. Array and aggregate: the parts in order.
#pragma once

#include <bit>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <contact/value.hpp>

namespace contact {

using Bytes = std::vector<std::uint8_t>;

/// What the bytes say is not a value of the type that was to be read.
class BadBytes : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Appends values to a buffer.
class Writer {
 public:
  explicit Writer(Bytes& bytes) : bytes_(&bytes) {}

  template <Value T>
  void write(const T& value) {
    constexpr Kind kind = kind_of<T>;
    if constexpr (kind == Kind::boolean) {
      raw(std::uint8_t{value ? std::uint8_t{1} : std::uint8_t{0}});
    } else if constexpr (kind == Kind::integer || kind == Kind::real) {
      raw(value);
    } else if constexpr (kind == Kind::enumeration) {
      raw(static_cast<std::int64_t>(value));
    } else if constexpr (kind == Kind::text) {
      length(value.size());
      bytes_->insert(bytes_->end(), value.begin(), value.end());
    } else if constexpr (kind == Kind::matrix) {
      if constexpr (T::RowsAtCompileTime == Eigen::Dynamic)
        length(static_cast<std::size_t>(value.rows()));
      if constexpr (T::ColsAtCompileTime == Eigen::Dynamic)
        length(static_cast<std::size_t>(value.cols()));
      for (Eigen::Index j = 0; j < value.cols(); ++j) {
        for (Eigen::Index i = 0; i < value.rows(); ++i) raw(value(i, j));
      }
    } else if constexpr (kind == Kind::rotation) {
      for (const double x : {value.w(), value.x(), value.y(), value.z()}) raw(x);
    } else if constexpr (kind == Kind::sequence) {
      if constexpr (value_detail::IsVector<T>::value) length(value.size());
      for (std::size_t i = 0; i < value.size(); ++i) {
        const typename T::value_type& element = value[i];
        write(element);
      }
    } else if constexpr (kind == Kind::optional) {
      write(value.has_value());
      if (value) write(*value);
    } else if constexpr (kind == Kind::variant) {
      if (value.valueless_by_exception()) throw BadBytes("a variant without a value");
      raw(static_cast<std::uint8_t>(value.index()));
      std::visit([&](const auto& alternative) { write(alternative); }, value);
    } else {
      for_each_field(value, [&](const auto& field) { write(field); });
    }
  }

 private:
  Bytes* bytes_;

  template <class T>
  void raw(T value) {
    static_assert(std::endian::native == std::endian::little);
    const std::size_t at = bytes_->size();
    bytes_->resize(at + sizeof(T));
    std::memcpy(bytes_->data() + at, &value, sizeof(T));
  }
  void length(std::size_t n) {
    if (!std::in_range<std::uint32_t>(n)) throw BadBytes("more than 2^32 elements");
    raw(static_cast<std::uint32_t>(n));
  }
};

/// Reads values from untrusted bytes. Every member throws BadBytes if they are invalid.
class Reader {
 public:
  /// @param memory how many bytes the values read may take, all together
  Reader(const std::uint8_t* data, std::size_t size, std::size_t memory)
      : at_(data), left_(size), memory_(memory) {}
  explicit Reader(const Bytes& bytes, std::size_t memory = std::size_t{1} << 28)
      : Reader(bytes.data(), bytes.size(), memory) {}

  template <Value T>
  T read() {
    T value{};
    read_into(value);
    return value;
  }

  /// Throws unless everything has been read.
  void finish() const {
    if (left_ != 0) throw BadBytes(std::to_string(left_) + " bytes too many");
  }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
  std::size_t memory_;

  template <Value T>
  void read_into(T& value) {
    constexpr Kind kind = kind_of<T>;
    if constexpr (kind == Kind::boolean) {
      const auto byte = raw<std::uint8_t>();
      if (byte > 1) throw BadBytes("a bool that is neither 0 nor 1");
      value = byte == 1;
    } else if constexpr (kind == Kind::integer || kind == Kind::real) {
      value = raw<T>();
    } else if constexpr (kind == Kind::enumeration) {
      const auto number = raw<std::int64_t>();
      if (!std::in_range<std::underlying_type_t<T>>(number))
        throw BadBytes("an enumeration out of range");
      value = static_cast<T>(number);
    } else if constexpr (kind == Kind::text) {
      const std::size_t n = length(1, 1);
      value.assign(reinterpret_cast<const char*>(at_), n);
      at_ += n;
      left_ -= n;
    } else if constexpr (kind == Kind::matrix) {
      read_matrix(value);
    } else if constexpr (kind == Kind::rotation) {
      const auto w = raw<double>(), x = raw<double>(), y = raw<double>(), z = raw<double>();
      value = T(w, x, y, z);
    } else if constexpr (value_detail::IsVector<T>::value) {
      using Element = typename T::value_type;
      const std::size_t n = length(1, sizeof(Element));
      value.reserve(n);
      for (std::size_t i = 0; i < n; ++i) value.push_back(read<Element>());
    } else if constexpr (kind == Kind::sequence) {
      for (auto& element : value) read_into(element);
    } else if constexpr (kind == Kind::optional) {
      if (read<bool>()) value = read<typename T::value_type>();
    } else if constexpr (kind == Kind::variant) {
      read_variant(value, std::make_index_sequence<std::variant_size_v<T>>{});
    } else {
      for_each_field(value, [&](auto& field) { read_into(field); });
    }
  }

  template <class M>
  void read_matrix(M& value) {
    const std::uint64_t rows = extent<M::RowsAtCompileTime, M::MaxRowsAtCompileTime>();
    const std::uint64_t cols = extent<M::ColsAtCompileTime, M::MaxColsAtCompileTime>();
    // Both are below 2^32, so the product does not overflow.
    if (rows * cols > left_ / sizeof(double)) throw BadBytes("a matrix larger than its bytes");
    if constexpr (M::SizeAtCompileTime == Eigen::Dynamic) {
      // A matrix without rows needs no memory for any number of columns, but a loop over the
      // columns would take time.
      charge(rows * cols * sizeof(double) + rows + cols);
      value.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(cols));
    }
    for (Eigen::Index j = 0; j < value.cols(); ++j) {
      for (Eigen::Index i = 0; i < value.rows(); ++i) value(i, j) = raw<double>();
    }
  }

  template <int Fixed, int Most>
  std::uint64_t extent() {
    if constexpr (Fixed != Eigen::Dynamic) {
      return std::uint64_t{Fixed};
    } else {
      const std::uint64_t n = raw<std::uint32_t>();
      if (Most != Eigen::Dynamic && n > static_cast<std::uint64_t>(Most))
        throw BadBytes("a matrix too large for its type");
      return n;
    }
  }

  template <class V, std::size_t... I>
  void read_variant(V& value, std::index_sequence<I...>) {
    const std::size_t index = raw<std::uint8_t>();
    if (index >= sizeof...(I)) throw BadBytes("a variant's index out of range");
    ((I == index ? void(value.template emplace<I>(read<std::variant_alternative_t<I, V>>()))
                 : void()),
     ...);
  }

  template <class T>
  T raw() {
    if (left_ < sizeof(T)) throw BadBytes("too few bytes");
    T value;
    std::memcpy(&value, at_, sizeof(T));
    at_ += sizeof(T);
    left_ -= sizeof(T);
    return value;
  }

  // A count of elements that take at least `least` bytes here and `size` bytes in memory.
  std::size_t length(std::size_t least, std::size_t size) {
    const std::size_t n = raw<std::uint32_t>();
    if (n > left_ / least) throw BadBytes("a length beyond the bytes that follow");
    charge(std::uint64_t{n} * size);
    return n;
  }
  void charge(std::uint64_t bytes) {
    if (bytes > memory_) throw BadBytes("a value larger than allowed");
    memory_ -= static_cast<std::size_t>(bytes);
  }
};

template <Value T>
Bytes to_bytes(const T& value) {
  Bytes bytes;
  Writer(bytes).write(value);
  return bytes;
}

template <Value T>
T from_bytes(const Bytes& bytes) {
  Reader reader(bytes);
  T value = reader.read<T>();
  reader.finish();
  return value;
}

}  // namespace contact
