# How every target of Scanway is made: one standard, one set of warnings, one set of floating-point rules.

# A folder that holds a CMakeLists.txt is part of the build.
function(scanway_add_folders_below top)
  file(GLOB_RECURSE lists RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" CONFIGURE_DEPENDS "${top}/CMakeLists.txt")
  foreach(list IN LISTS lists)
    get_filename_component(folder "${list}" DIRECTORY)
    add_subdirectory("${folder}")
  endforeach()
endfunction()

function(scanway_target_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Werror)
  # The same input must give the same bytes on every CPU: no fused multiply-add behind our back.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}")
endfunction()

# The presets compile the files of a folder as one, which takes half the time. Not so where names that are a file's own
# meet, and where single files are worked on for speed.
function(scanway_one_by_one target wanted)
  if(wanted)
    set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
  endif()
endfunction()

# scanway_library(name LINKS targets... [ONE_BY_ONE]): the library of all sources in this folder (headers alone will do).
function(scanway_library name)
  cmake_parse_arguments(ARG "ONE_BY_ONE" "" "LINKS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  if(sources)
    add_library(${name} STATIC ${sources})
    scanway_target_options(${name})
    scanway_one_by_one(${name} ${ARG_ONE_BY_ONE})
    target_link_libraries(${name} PUBLIC ${ARG_LINKS})
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE ${ARG_LINKS})
  endif()
endfunction()

# scanway_program(name LINKS targets... [ONE_BY_ONE]): the program of all sources in this folder, in build/bin.
function(scanway_program name)
  cmake_parse_arguments(ARG "ONE_BY_ONE" "" "LINKS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  add_executable(${name} ${sources})
  scanway_target_options(${name})
  scanway_one_by_one(${name} ${ARG_ONE_BY_ONE})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
endfunction()

# scanway_test(name LINKS targets... [LABEL all] [TIMEOUT seconds] [ONE_BY_ONE]): the GoogleTest program of all *_test.cpp
# in this folder. Tests labelled `all` run only with `tests/run --all`.
function(scanway_test name)
  cmake_parse_arguments(ARG "ONE_BY_ONE" "LABEL;TIMEOUT" "LINKS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  add_executable(${name} ${sources})
  scanway_target_options(${name})
  # A test's own code is compiled more often than it runs.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  scanway_one_by_one(${name} ${ARG_ONE_BY_ONE})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} GTest::gtest GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE
    SCANWAY_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    SCANWAY_SHARED_DIR="${PROJECT_SOURCE_DIR}/../shared"
    SCANWAY_BIN_DIR="${PROJECT_BINARY_DIR}/bin")
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABEL}")
endfunction()
