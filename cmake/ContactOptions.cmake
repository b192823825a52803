# How everything here is compiled. Two INTERFACE targets, so that a target says what it wants by linking:
#   contact_options   the language and the arithmetic; also for targets that use the headers
#   contact_warnings  for our own sources only

find_package(Eigen3 3.4 REQUIRED NO_MODULE)

add_library(contact_options INTERFACE)
target_compile_features(contact_options INTERFACE cxx_std_20)
# One arithmetic everywhere, so that results are the same bits natively and in the page. A fused multiply-add rounds once
# where the source rounds twice: with it, a watertight ray-triangle test leaks.
# GCC 12 leaves out the rounding of two neighbouring doubles to float and back at -O2, where it makes vectors of them:
# tests/package/consumer/rounding.cpp.
target_compile_options(contact_options INTERFACE
  $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off>
  $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
target_compile_definitions(contact_options INTERFACE EIGEN_DONT_VECTORIZE)
target_link_libraries(contact_options INTERFACE Eigen3::Eigen)

add_library(contact_warnings INTERFACE)
target_compile_options(contact_warnings INTERFACE
  $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion>)

# Where there is memory for it, the compiler need not collect its garbage: a tenth of the time.
cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND PROJECT_IS_TOP_LEVEL AND memory GREATER 7000)
  add_compile_options(--param=ggc-min-expand=1000 --param=ggc-min-heapsize=1500000)
endif()

# Of these chapters, sanitized tests also find what is used after the end of its scope, for which the compiler takes a
# quarter of its time. tools/test.py names those of the turn; "all" are all.
set(CONTACT_SCOPES "all" CACHE STRING "Chapters whose sanitized tests find uses after the end of a scope")
function(contact_may_ignore_scopes chapter)
  if(CONTACT_SANITIZE AND NOT CONTACT_SCOPES STREQUAL "all" AND NOT chapter IN_LIST CONTACT_SCOPES)
    foreach(target IN LISTS ARGN)
      target_compile_options(${target} PRIVATE -fno-sanitize-address-use-after-scope)
    endforeach()
  endif()
endfunction()

if(CONTACT_SANITIZE)
  # Without what AddressSanitizer finds itself (a null pointer, the end of an object, a pointer outside of one, where it
  # is used) and what only a cast of pointers could break: a third of the time to compile.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=null,object-size,vptr,alignment,pointer-overflow
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
if(CONTACT_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()
