# What an exercise's folders become. An exercise is whatever has an exercises/NN_slug/NAME/exercise.toml.
#
# A student's file is compiled with the flags and the precompiled header of contact_student_flags, and linked with one
# prebuilt object, tests.o: the exercise's tests, the asking, Catch2 and main, in which every symbol is local except
# main, todo() and the contract's functions, which it lacks. So nothing that the student's file defines can take the
# place of something in the tests. build/<preset>/exercises.json tells the program `contact` how to do both.

find_package(Catch2 3 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)
include(ContactTargets)

# The student's flags. One list, for the precompiled header, for solutions and for exercises.json: a precompiled header
# is used only if they are the same.
function(contact_student_flags out)
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  set(flags -std=c++20 -O1 -pipe -D_GLIBCXX_ASSERTIONS -ffp-contract=off -DEIGEN_DONT_VECTORIZE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-unused-parameter
    # Else <algorithm> and others include the headers of TBB wherever those happen to be installed.
    -D_GLIBCXX_USE_TBB_PAR_BACKEND=0
    # What a function without its return does differs between compilers, so that none may judge it.
    -Werror=return-type)
  foreach(dir IN LISTS eigen)
    list(APPEND flags -isystem "${dir}")
  endforeach()
  set(${out} "${flags}" PARENT_SCOPE)
endfunction()

# The fastest linker there is: measured on ray_triangle, mold 0.017 s, gold 0.023, lld 0.032, bfd 0.065.
function(contact_fastest_linker out)
  set(flags "")
  foreach(linker IN ITEMS mold gold lld)
    find_program(CONTACT_LINKER_${linker} NAMES ld.${linker} ${linker})
    mark_as_advanced(CONTACT_LINKER_${linker})
    if(CONTACT_LINKER_${linker})
      set(flags -fuse-ld=${linker})
      break()
    endif()
  endforeach()
  set(${out} "${flags}" PARENT_SCOPE)
endfunction()

# Programs that run in a box are linked statically: nothing is loaded when they start, so that they need to open no file,
# and they start six times as quickly. Empty where a system has no static libraries; nothing can be graded there.
function(contact_static_flags out)
  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_FLAGS -static)
  check_cxx_source_compiles("#include <string>\nint main() { return std::string(\"x\").size() != 1; }" CONTACT_LINKS_STATICALLY)
  set(flags "")
  if(CONTACT_LINKS_STATICALLY AND NOT CONTACT_SANITIZE)
    set(flags -static)
  endif()
  set(${out} "${flags}" PARENT_SCOPE)
endfunction()

# A list as the inside of a JSON array.
function(contact_json_strings out)
  list(TRANSFORM ARGN REPLACE "(.+)" "\"\\1\"")
  list(JOIN ARGN ", " joined)
  set(${out} "${joined}" PARENT_SCOPE)
endfunction()

# The generator runs on the venv that ./contact makes, or on a Python that has tree-sitter.
function(contact_find_generator out)
  set(python "${PROJECT_SOURCE_DIR}/build/venv/bin/python")
  if(NOT EXISTS "${python}")
    set(python "${Python3_EXECUTABLE}")
  endif()
  set(${out} "${python}" "${PROJECT_SOURCE_DIR}/grading/contract/contract_generator.py" PARENT_SCOPE)
endfunction()

# What every exercise shares.
function(contact_add_exercise_host)
  set(source "${PROJECT_SOURCE_DIR}")
  add_library(contact_exercise_host OBJECT "${source}/tests/support/exercise.cpp"
    "${source}/tests/support/observed.cpp" "${source}/tests/support/runner.cpp")
  target_include_directories(contact_exercise_host PRIVATE "${source}/tests" "${source}/grading")
  target_link_libraries(contact_exercise_host PRIVATE
    contact_00_vectors Catch2::Catch2 nlohmann_json::nlohmann_json contact_warnings)
  contact_compile_quickly(contact_exercise_host)
  # Tests of exercises reuse it, so that each is compiled quickly.
  target_precompile_headers(contact_exercise_host PRIVATE "${source}/tests/support/exercise_precompiled.hpp")

  add_library(contact_remote OBJECT "${source}/grading/contact/remote.cpp"
    "${source}/grading/contact/remote_process.cpp")
  add_library(contact_remote_server OBJECT "${source}/grading/contact/remote_server.cpp")
  foreach(target IN ITEMS contact_remote contact_remote_server)
    target_include_directories(${target} PRIVATE "${source}/grading")
    target_link_libraries(${target} PRIVATE
      contact_00_vectors nlohmann_json::nlohmann_json contact_warnings)
    contact_compile_quickly(${target})
  endforeach()

  contact_add_precompiled(contact_remote_precompiled <Eigen/Core> <Eigen/Geometry> <contact/remote.hpp>)
  contact_compile_quickly(contact_remote_precompiled)
  target_include_directories(contact_remote_precompiled PRIVATE "${source}/grading")

  # The prelude stands alone in a folder, so that a student's file cannot include anything else of grading/.
  set(student "${CMAKE_BINARY_DIR}/student/contact")
  add_custom_command(OUTPUT "${student}/prelude.hpp.gch" "${student}/prelude.hpp"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${student}"
    COMMAND "${CMAKE_COMMAND}" -E copy "${source}/grading/contact/prelude.hpp" "${student}/prelude.hpp"
    COMMAND "${CMAKE_CXX_COMPILER}" ${CONTACT_STUDENT_FLAGS} -Wno-pragma-once-outside-header -w
      -x c++-header "${student}/prelude.hpp" -o "${student}/prelude.hpp.gch"
    DEPENDS "${source}/grading/contact/prelude.hpp" "${source}/cmake/ContactExercises.cmake"
    COMMENT "Precompiling the prelude of exercises" VERBATIM)
  add_custom_target(contact_prelude DEPENDS "${student}/prelude.hpp.gch")
endfunction()

# A file compiled exactly as `contact check` compiles a student's.
function(contact_compile_as_student object source chapter name)
  contact_root_of("${chapter}" root)
  set(includes "-I${CMAKE_BINARY_DIR}/student" "-I${PROJECT_SOURCE_DIR}/chapters/00_vectors"
    "-I${root}/exercises/${chapter}/${name}")
  add_custom_command(OUTPUT "${object}"
    COMMAND "${CMAKE_CXX_COMPILER}" ${CONTACT_STUDENT_FLAGS} -include "${CMAKE_BINARY_DIR}/student/contact/prelude.hpp"
      ${includes} -MD -MF "${object}.d" -c "${source}" -o "${object}"
    DEPENDS "${source}" contact_prelude "${CMAKE_BINARY_DIR}/student/contact/prelude.hpp.gch"
    DEPFILE "${object}.d" COMMENT "Compiling ${source} as a student's file" VERBATIM)
endfunction()

# Links objects into one, in which only the named symbols (besides undefined ones) can be seen from outside. COMDAT
# groups are dissolved first: a linker would otherwise still exchange a function for another object's of the same name.
# GNU's unique symbols (inline variables of the standard library) are made weak first, because objcopy does not make them
# local; a student's file that has the same ones would not link.
function(contact_seal output keep)
  list(TRANSFORM keep PREPEND "--keep-global-symbol=")
  add_custom_command(OUTPUT "${output}"
    COMMAND "${CONTACT_PARTIAL_LINKER}" -r --force-group-allocation -o "${output}.open" ${ARGN}
    COMMAND sh -c "'${CMAKE_NM}' --format=posix '${output}.open' | awk '$2 == \"u\" { print $1 }' > '${output}.unique'"
    COMMAND "${CMAKE_OBJCOPY}" "--weaken-symbols=${output}.unique" "${output}.open"
    COMMAND "${CMAKE_OBJCOPY}" --strip-debug ${keep} "${output}.open" "${output}"
    COMMAND "${CMAKE_COMMAND}" -E rm "${output}.open" "${output}.unique"
    DEPENDS ${ARGN} COMMAND_EXPAND_LISTS COMMENT "Sealing ${output}" VERBATIM)
endfunction()

function(contact_add_exercise chapter name)
  set(source "${PROJECT_SOURCE_DIR}")
  contact_root_of("${chapter}" root)
  set(contract_dir "${root}/exercises/${chapter}/${name}")
  set(test "${root}/tests/${chapter}/${name}_test.cpp")
  set(solution "${root}/solutions/${chapter}/${name}/${name}.cpp")
  set(out "${CMAKE_BINARY_DIR}/exercises/${chapter}/${name}")
  set(target exercise_${chapter}_${name})
  foreach(file IN ITEMS "${test}" "${solution}" "${contract_dir}/${name}.hpp" "${contract_dir}/${name}.cpp")
    if(NOT EXISTS "${file}")
      message(WARNING "exercises/${chapter}/${name} is left out: there is no ${file}")
      return()
    endif()
  endforeach()
  file(MAKE_DIRECTORY "${out}")
  set_property(DIRECTORY "${source}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${contract_dir}/exercise.toml")

  # The tests, compiled once against the contract.
  add_library(${target}_tests OBJECT "${test}")
  target_include_directories(${target}_tests PRIVATE "${contract_dir}" "${source}/tests" "${source}/grading")
  target_link_libraries(${target}_tests PRIVATE contact_${chapter} contact_00_vectors Catch2::Catch2
    nlohmann_json::nlohmann_json contact_warnings)
  contact_compile_quickly(${target}_tests)
  target_precompile_headers(${target}_tests REUSE_FROM contact_exercise_host)

  # The contract's proxy and server.
  add_custom_command(OUTPUT "${out}/${name}.proxy.cpp" "${out}/${name}.server.cpp"
    COMMAND ${CONTACT_GENERATOR} "${contract_dir}/${name}.hpp"
      --proxy "${out}/${name}.proxy.cpp" --server "${out}/${name}.server.cpp"
    DEPENDS "${contract_dir}/${name}.hpp" "${source}/grading/contract/contract_generator.py"
    COMMENT "Generating proxy and server of ${chapter}/${name}" VERBATIM)
  foreach(side IN ITEMS proxy server)
    add_library(${target}_${side} OBJECT "${out}/${name}.${side}.cpp")
    target_include_directories(${target}_${side} PRIVATE "${contract_dir}" "${source}/grading")
    target_link_libraries(${target}_${side} PRIVATE contact_00_vectors contact_warnings)
    contact_compile_quickly(${target}_${side})
    target_precompile_headers(${target}_${side} REUSE_FROM contact_remote_precompiled)
  endforeach()

  # What a student's object is linked with: to be tested in one process, and to answer from another.
  contact_seal("${out}/tests.o" "main;_ZN7contact4todoEv"
    "$<TARGET_OBJECTS:${target}_tests>" "$<FILTER:$<TARGET_OBJECTS:contact_exercise_host>,EXCLUDE,gch$>"
    "$<TARGET_FILE:Catch2::Catch2>")
  contact_seal("${out}/server.o" "main;_ZN7contact4todoEv"
    "$<TARGET_OBJECTS:${target}_server>" "$<TARGET_OBJECTS:contact_remote_server>")
  # The tests in a process of their own.
  add_executable(${target}_asks "$<TARGET_OBJECTS:${target}_tests>" "$<TARGET_OBJECTS:${target}_proxy>"
    "$<TARGET_OBJECTS:contact_exercise_host>" "$<TARGET_OBJECTS:contact_remote>")
  target_link_libraries(${target}_asks PRIVATE Catch2::Catch2)
  target_link_options(${target}_asks PRIVATE ${CONTACT_SERVER_LINK_FLAGS})
  set_target_properties(${target}_asks PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${out}" OUTPUT_NAME asks)

  # The proof of the contract: the same compiled tests pass linked with the solution, and asking it in another process.
  contact_compile_as_student("${out}/solution.o" "${solution}" ${chapter} ${name})
  foreach(program IN ITEMS linked server)
    set(with "${out}/tests.o")
    set(flags ${CONTACT_STUDENT_LINK_FLAGS})
    if(program STREQUAL "server")
      set(with "${out}/server.o")
      set(flags ${CONTACT_SERVER_LINK_FLAGS})
    endif()
    add_custom_command(OUTPUT "${out}/${program}"
      COMMAND "${CMAKE_CXX_COMPILER}" ${flags} "${out}/solution.o" "${with}" -o "${out}/${program}"
      DEPENDS "${out}/solution.o" "${with}" COMMENT "Linking the solution of ${chapter}/${name}" VERBATIM)
  endforeach()
  add_custom_target(${target} ALL DEPENDS "${out}/linked" "${out}/server" ${target}_asks)
  add_dependencies(exercises ${target})
  add_test(NAME contract_linked_${chapter}_${name} COMMAND "${out}/linked")
  add_test(NAME contract_proxy_${chapter}_${name} COMMAND ${target}_asks)
  set_tests_properties(contract_proxy_${chapter}_${name} PROPERTIES ENVIRONMENT "CONTACT_SERVER=${out}/server")

  set_property(GLOBAL APPEND_STRING PROPERTY CONTACT_EXERCISES_JSON
    "${CONTACT_JSON_SEPARATOR}\n    \"${chapter}/${name}\": {
      \"include\": [\"${contract_dir}\"],
      \"target\": \"${target}\",
      \"test_object\": \"${out}/tests.o\",
      \"server_object\": \"${out}/server.o\",
      \"asks\": \"${out}/asks\",
      \"compiled_tests\": \"$<TARGET_OBJECTS:${target}_tests>\",
      \"proxy_object\": \"$<TARGET_OBJECTS:${target}_proxy>\"
    }")
  set(CONTACT_JSON_SEPARATOR "," PARENT_SCOPE)
endfunction()

# Tests of the machinery itself (tests/grading): what is reported, what a misbehaving process can do, and that nothing in
# a student's file takes the place of something in the tests.
function(contact_add_exercise_checks)
  set(dir "${PROJECT_SOURCE_DIR}/tests/grading")
  set(host "$<TARGET_OBJECTS:contact_exercise_host>")
  foreach(target IN ITEMS exercise_specimen exercise_tests remote_specimen remote_calls remote_tests)
    string(REPLACE "_tests" "_test" stem "${target}")
    add_executable(${target} "${dir}/${stem}.cpp")
    target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/tests" "${PROJECT_SOURCE_DIR}/grading")
    target_link_libraries(${target} PRIVATE contact_00_vectors nlohmann_json::nlohmann_json contact_warnings)
  endforeach()
  target_sources(exercise_specimen PRIVATE "${host}")
  target_link_libraries(exercise_specimen PRIVATE Catch2::Catch2)
  target_link_libraries(exercise_tests PRIVATE Catch2::Catch2WithMain)
  foreach(target IN ITEMS remote_tests remote_calls)
    target_sources(${target} PRIVATE "$<TARGET_OBJECTS:contact_remote>")
  endforeach()
  foreach(target IN ITEMS remote_specimen remote_calls)
    target_link_options(${target} PRIVATE ${CONTACT_SERVER_LINK_FLAGS})
  endforeach()
  target_link_libraries(remote_tests PRIVATE Catch2::Catch2)
  foreach(name IN ITEMS exercise remote)
    add_dependencies(${name}_tests ${name}_specimen)
    target_compile_definitions(${name}_tests PRIVATE "CONTACT_SPECIMEN=\"$<TARGET_FILE:${name}_specimen>\"")
    add_test(NAME ${name}_tests COMMAND ${name}_tests)
  endforeach()

  # The same object, once linked with the sealed tests and once with the open ones: the first is what is done, the second
  # shows that the attack works where nothing is sealed.
  if(NOT TARGET exercise_02_triangles_ray_triangle)
    return()
  endif()
  set(out "${CMAKE_BINARY_DIR}/exercises/sealed")
  file(MAKE_DIRECTORY "${out}")
  contact_compile_as_student("${out}/attack.o" "${dir}/sealed/replaces_exact_product.cpp" 02_triangles ray_triangle)
  set(sealed "${CMAKE_BINARY_DIR}/exercises/02_triangles/ray_triangle/tests.o")
  add_custom_command(OUTPUT "${out}/sealed" COMMAND "${CMAKE_CXX_COMPILER}" ${CONTACT_STUDENT_LINK_FLAGS}
      "${out}/attack.o" "${sealed}" -o "${out}/sealed"
    DEPENDS "${out}/attack.o" "${sealed}" exercise_02_triangles_ray_triangle VERBATIM)
  set(open "$<TARGET_OBJECTS:exercise_02_triangles_ray_triangle_tests>" "$<FILTER:${host},EXCLUDE,gch$>"
    "$<TARGET_FILE:Catch2::Catch2>")
  add_custom_command(OUTPUT "${out}/open" COMMAND "${CMAKE_CXX_COMPILER}" "${out}/attack.o" ${open} -o "${out}/open"
    DEPENDS "${out}/attack.o" ${open} COMMAND_EXPAND_LISTS VERBATIM)
  contact_compile_as_student("${out}/map.o" "${dir}/sealed/uses_a_map.cpp" 02_triangles ray_triangle)
  add_custom_target(contact_sealed ALL DEPENDS "${out}/sealed" "${out}/open" "${out}/map.o")
  add_dependencies(exercises contact_sealed)
  set(test "a ray hits where it passes inside the triangle and misses beside it")
  add_test(NAME sealed_tests_cannot_be_changed COMMAND "${out}/sealed" "${test}")
  set_tests_properties(sealed_tests_cannot_be_changed PROPERTIES WILL_FAIL ON)
  add_test(NAME open_tests_could_be_changed COMMAND "${out}/open" "${test}")
  add_test(NAME standard_library_links_with_sealed_tests COMMAND "${CMAKE_CXX_COMPILER}" ${CONTACT_STUDENT_LINK_FLAGS}
    "${out}/map.o" "${sealed}" -o "${out}/map")
endfunction()

# Finds every exercise and builds what it needs; the target `exercises` is all of them.
function(contact_add_exercises)
  contact_student_flags(CONTACT_STUDENT_FLAGS)
  contact_fastest_linker(CONTACT_STUDENT_LINK_FLAGS)
  contact_static_flags(CONTACT_SERVER_LINK_FLAGS)
  list(APPEND CONTACT_SERVER_LINK_FLAGS ${CONTACT_STUDENT_LINK_FLAGS})
  contact_find_generator(CONTACT_GENERATOR)
  find_program(CONTACT_PARTIAL_LINKER NAMES ld.bfd ld REQUIRED)
  contact_add_exercise_host()
  add_custom_target(exercises)
  add_dependencies(exercises contact_prelude)

  set(root "${PROJECT_SOURCE_DIR}")
  if(CONTACT_PACK)
    set(root "${CONTACT_PACK}")
  endif()
  file(GLOB tomls CONFIGURE_DEPENDS "${root}/exercises/*/*/exercise.toml")
  list(SORT tomls)
  set(CONTACT_JSON_SEPARATOR "")
  foreach(toml IN LISTS tomls)
    get_filename_component(dir "${toml}" DIRECTORY)
    get_filename_component(name "${dir}" NAME)
    get_filename_component(dir "${dir}" DIRECTORY)
    get_filename_component(chapter "${dir}" NAME)
    if(NOT chapter IN_LIST CONTACT_CHAPTERS)
      message(FATAL_ERROR "exercises/${chapter}/${name}: there is no chapters/${chapter}/chapter.toml")
    endif()
    contact_add_exercise(${chapter} ${name})
  endforeach()
  if(NOT CONTACT_PACK)
    contact_add_exercise_checks()
  endif()

  contact_json_strings(flags ${CONTACT_STUDENT_FLAGS})
  contact_json_strings(link_flags ${CONTACT_STUDENT_LINK_FLAGS})
  contact_json_strings(server_link_flags ${CONTACT_SERVER_LINK_FLAGS})
  contact_json_strings(include "${CMAKE_BINARY_DIR}/student" "${PROJECT_SOURCE_DIR}/chapters/00_vectors")
  get_property(exercises GLOBAL PROPERTY CONTACT_EXERCISES_JSON)
  # What a program that asks is made of besides its tests and a proxy: for private tests, which come later.
  set(host "$<FILTER:$<TARGET_OBJECTS:contact_exercise_host>,EXCLUDE,gch$>")
  set(asks_objects "\"$<JOIN:${host};$<TARGET_OBJECTS:contact_remote>;$<TARGET_FILE:Catch2::Catch2>,\", \">\"")
  file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/exercises.json" CONTENT "{
  \"root\": \"${PROJECT_SOURCE_DIR}\",
  \"compiler\": \"${CMAKE_CXX_COMPILER}\",
  \"compile_flags\": [${flags}],
  \"include\": [${include}],
  \"pch\": \"${CMAKE_BINARY_DIR}/student/contact/prelude.hpp\",
  \"link_flags\": [${link_flags}],
  \"server_link_flags\": [${server_link_flags}],
  \"support_libs\": [],
  \"asks_objects\": [${asks_objects}],
  \"exercises\": {${exercises}
  }
}
")
endfunction()
