#pragma once

// The entry points of a figure in WebAssembly: four functions and two arrays of numbers, which the
// page reads and writes in place. Part of figure.hpp.

#define CONTACT_FIGURE_EXPORT(name) [[gnu::used]] __attribute__((export_name(name)))

#define CONTACT_FIGURE_ENTRY(TheFigure)                                                           \
  namespace contact::figure::detail {                                                             \
  static double the_input[static_cast<std::size_t>(TheFigure::input_size)];                       \
  static double the_output[static_cast<std::size_t>(TheFigure::output_size)];                     \
  CONTACT_FIGURE_EXPORT("layout") const char* wasm_layout() { return TheFigure::layout.data(); }  \
  CONTACT_FIGURE_EXPORT("input") double* wasm_input() { return the_input; }                       \
  CONTACT_FIGURE_EXPORT("output") const double* wasm_output() { return the_output; }              \
  CONTACT_FIGURE_EXPORT("compute") void wasm_compute() { TheFigure::run(the_input, the_output); } \
  }
