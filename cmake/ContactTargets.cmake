# What a chapter's folders become. Everything is found by name; adding a chapter edits no list.

# A Catch2 program; each of its test cases is one ctest test.
function(contact_add_catch_test name library)
  add_executable(${name} ${ARGN})
  contact_compile_by_first_word(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE ${library} contact_support Catch2::Catch2WithMain contact_warnings)
  target_precompile_headers(${name} REUSE_FROM contact_support)
  catch_discover_tests(${name} TEST_PREFIX "${name}: " PROPERTIES TIMEOUT 300)
endfunction()

# tests/NN_slug/*_test.cpp that are not an exercise's, and tests/NN_slug/hard_cases.cpp.
function(contact_add_reference_tests chapter)
  set(dir "${PROJECT_SOURCE_DIR}/tests/${chapter}")
  contact_chapter_library("${chapter}" library)
  file(GLOB sources CONFIGURE_DEPENDS "${dir}/*_test.cpp")
  file(GLOB exercises RELATIVE "${PROJECT_SOURCE_DIR}/exercises/${chapter}" CONFIGURE_DEPENDS
    "${PROJECT_SOURCE_DIR}/exercises/${chapter}/*")
  foreach(exercise IN LISTS exercises)
    list(REMOVE_ITEM sources "${dir}/${exercise}_test.cpp")
  endforeach()
  if(sources)
    contact_add_catch_test(reference_tests_${chapter} "${library}" ${sources})
    # In one unit with the tests of the headers: compiling the functions that both call takes most of the time. Its
    # names are in a namespace of their own.
    set_property(SOURCE "${dir}/questions_test.cpp" PROPERTY UNITY_GROUP reference)
    # A construct question is judged by its figure's C++, which the test includes.
    target_include_directories(reference_tests_${chapter} PRIVATE "${PROJECT_SOURCE_DIR}/chapters/${chapter}"
      "${PROJECT_SOURCE_DIR}/page/figure")
    target_compile_definitions(reference_tests_${chapter} PRIVATE "CONTACT_CHAPTER=\"${chapter}\"")
    contact_may_ignore_scopes("${chapter}" reference_tests_${chapter})
  endif()
  if(EXISTS "${dir}/hard_cases.cpp")
    add_executable(hard_cases_${chapter} "${dir}/hard_cases.cpp")
    target_link_libraries(hard_cases_${chapter} PRIVATE ${library} contact_support contact_warnings)
    target_precompile_headers(hard_cases_${chapter} REUSE_FROM contact_support)
    contact_may_ignore_scopes("${chapter}" hard_cases_${chapter})
    # tools/test.py compares the reports with what the lessons show.
    set(reports "${CMAKE_BINARY_DIR}/hard_cases")
    file(MAKE_DIRECTORY "${reports}")
    add_test(NAME "hard_cases_${chapter}" COMMAND hard_cases_${chapter} --report "${reports}/${chapter}.json")
  endif()
endfunction()

# The target `all_but_turns`: what `all` builds, without the programs above, examples and ladders. Of these, tools/test.py
# builds those of the turn; the programs above all under sanitizers.
function(contact_add_all_but_turns)
  contact_targets_of_all("${PROJECT_SOURCE_DIR}" targets)
  list(FILTER targets EXCLUDE REGEX "^(reference_tests|hard_cases|example|ladder)_")
  add_custom_target(all_but_turns DEPENDS ${targets})
endfunction()

function(contact_targets_of_all folder out)
  get_property(targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  get_property(folders DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
  set(found "")
  foreach(target IN LISTS targets)
    get_target_property(left_out ${target} EXCLUDE_FROM_ALL)
    get_target_property(type ${target} TYPE)
    if(NOT left_out AND NOT type STREQUAL "INTERFACE_LIBRARY")
      list(APPEND found ${target})
    endif()
  endforeach()
  foreach(subfolder IN LISTS folders)
    contact_targets_of_all("${subfolder}" more)
    list(APPEND found ${more})
  endforeach()
  set(${out} ${found} PARENT_SCOPE)
endfunction()

# What every example, or every figure, includes: compiled once, with the flags that they share.
function(contact_add_precompiled name)
  file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp" CONTENT "")
  add_library(${name} OBJECT "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  target_link_libraries(${name} PRIVATE contact_00_vectors nlohmann_json::nlohmann_json contact_warnings)
  target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

# chapters/NN_slug/examples/NAME.cpp must print exactly NAME.out. Examples read scenes from CONTACT_SCENES: those of the
# chapter, or of a chapter that it builds on.
function(contact_add_examples chapter)
  set(scenes "")
  contact_read_builds_on("${chapter}" earlier)
  foreach(one IN LISTS chapter earlier)
    set(folder "${PROJECT_SOURCE_DIR}/chapters/${one}/scenes")
    if(NOT scenes AND IS_DIRECTORY "${folder}")
      set(scenes "${folder}")
    endif()
  endforeach()
  contact_chapter_library("${chapter}" library)
  file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/chapters/${chapter}/examples/*.cpp")
  foreach(source IN LISTS sources)
    get_filename_component(stem "${source}" NAME_WE)
    set(target example_${chapter}_${stem})
    add_executable(${target} "${source}")
    target_link_libraries(${target} PRIVATE ${library} contact_warnings)
    if(scenes)
      target_compile_definitions(${target} PRIVATE "CONTACT_SCENES=\"${scenes}/\"")
    endif()
    target_precompile_headers(${target} REUSE_FROM contact_examples_precompiled)
    add_test(NAME "${target}" COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:${target}>"
      "-DEXPECTED=${PROJECT_SOURCE_DIR}/chapters/${chapter}/examples/${stem}.out"
      -P "${PROJECT_SOURCE_DIR}/cmake/CompareOutput.cmake")
  endforeach()
endfunction()

# `Output out{}` sets an Eigen column to nothing in particular otherwise; as in page/wasm/flags.mjs.
set(CONTACT_FIGURE_DEFINITION EIGEN_INITIALIZE_MATRICES_BY_ZERO)

# The native twin of a live figure: the same source as the page's WebAssembly. Only tests that compare the two run it, and
# they build those that they take.
function(contact_add_figures chapter)
  file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/chapters/${chapter}/figures/*.cpp")
  foreach(source IN LISTS sources)
    get_filename_component(stem "${source}" NAME_WE)
    set(target figure_${chapter}_${stem})
    add_executable(${target} EXCLUDE_FROM_ALL "${source}")
    target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/page/figure")
    target_link_libraries(${target} PRIVATE contact_${chapter} nlohmann_json::nlohmann_json contact_warnings)
    target_compile_definitions(${target} PRIVATE ${CONTACT_FIGURE_DEFINITION})
    contact_compile_quickly(${target})
    target_precompile_headers(${target} REUSE_FROM contact_figures_precompiled)
  endforeach()
endfunction()

# Timed code is optimised whatever the preset, and without assertions. What all ladders share is compiled once.
function(contact_ladder_options target)
  target_compile_options(${target} PRIVATE -O2 -U_GLIBCXX_ASSERTIONS)
  target_compile_definitions(${target} PRIVATE NDEBUG CONTACT_HAS_GMP ${ARGN})
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/tests")
  target_link_libraries(${target} PRIVATE nlohmann_json::nlohmann_json Boost::headers PkgConfig::GMP contact_warnings)
endfunction()

function(contact_add_ladder_harness)
  file(GLOB harness CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/support/ladder*.cpp")
  list(FILTER harness EXCLUDE REGEX "_test\\.cpp$")
  add_library(contact_ladder_harness OBJECT ${harness})
  target_link_libraries(contact_ladder_harness PRIVATE contact_00_vectors)
  contact_ladder_options(contact_ladder_harness)
  # Of the sources alone: what is precompiled must know no definition that a ladder does not have.
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  set_property(SOURCE ${harness} APPEND PROPERTY COMPILE_DEFINITIONS
    "CONTACT_COMPILER=\"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}\""
    "CONTACT_FLAGS=\"-std=c++20 ${CMAKE_CXX_FLAGS_${type}} -O2 -U_GLIBCXX_ASSERTIONS -DNDEBUG -ffp-contract=off -fno-tree-slp-vectorize -DEIGEN_DONT_VECTORIZE\"")
  target_precompile_headers(contact_ladder_harness PRIVATE <Eigen/Core> <Eigen/Geometry> <nlohmann/json.hpp>
    <boost/multiprecision/gmp.hpp>)
endfunction()

function(contact_add_ladder chapter)
  set(source "${PROJECT_SOURCE_DIR}/chapters/${chapter}/ladder.cpp")
  if(NOT EXISTS "${source}")
    return()
  endif()
  set(target ladder_${chapter})
  contact_chapter_library("${chapter}" library)
  add_executable(${target} "${source}" $<TARGET_OBJECTS:contact_ladder_harness>)
  target_link_libraries(${target} PRIVATE ${library})
  contact_ladder_options(${target} "CONTACT_LADDER=\"${chapter}\"")
  target_precompile_headers(${target} REUSE_FROM contact_ladder_harness)
endfunction()
