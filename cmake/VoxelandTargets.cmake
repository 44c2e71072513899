# SPDX-License-Identifier: BSD-3-Clause
# How each kind of target of this project is built, in one place.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(VOXELAND_PLUGIN_INSTALL_DIR "${CMAKE_INSTALL_LIBDIR}/voxeland")
set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

set(VOXELAND_SANITIZERS "" CACHE STRING "Sanitizers to build with, as for -fsanitize=")
if(VOXELAND_SANITIZERS)
  add_compile_options(-fsanitize=${VOXELAND_SANITIZERS} -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${VOXELAND_SANITIZERS})
  add_library(voxeland_sanitizers OBJECT "${CMAKE_CURRENT_LIST_DIR}/SanitizerSettings.cpp")
  if(VOXELAND_SANITIZERS MATCHES "address")
    target_sources(voxeland_sanitizers PRIVATE "${CMAKE_CURRENT_LIST_DIR}/SanitizerMemory.cpp")
  endif()
endif()

function(voxeland_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion
    $<$<BOOL:${VOXELAND_WERROR}>:-Werror>)
endfunction()

# voxeland_executable(NAME source...): any program, be it for users or for tests.
function(voxeland_executable name)
  add_executable(${name} ${ARGN})
  if(VOXELAND_SANITIZERS)
    target_link_libraries(${name} PRIVATE voxeland_sanitizers)
  endif()
  voxeland_warnings(${name})
endfunction()

# voxeland_library(TARGET): a shared library and component. voxeland_NAME is in libvoxeland-NAME.so,
# and is voxeland::NAME for others. Rooms add their sources.
function(voxeland_library target)
  string(REPLACE "voxeland_" "" name ${target})
  add_library(${target} SHARED)
  add_library(voxeland::${name} ALIAS ${target})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/libvoxeland/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_include_directories(${target} PRIVATE "${CMAKE_SOURCE_DIR}/libvoxeland/src")
  target_compile_features(${target} PUBLIC cxx_std_17)
  # The same map on every processor: none fuses a multiplication with an addition.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  string(REPLACE "_" "-" file ${target})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${file} EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    INSTALL_RPATH "$ORIGIN")
  set_property(GLOBAL APPEND PROPERTY VOXELAND_LIBRARIES ${file})
  voxeland_warnings(${target})
  install(TARGETS ${target} EXPORT ${file}Targets LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    COMPONENT libraries NAMELINK_COMPONENT dev)
endfunction()

# All programs and plugins, without tests and benchmarks.
add_custom_target(programs)

# voxeland_program(NAME source...): a command line program in build/bin, with a man page.
function(voxeland_program name)
  voxeland_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE voxeland_apps_common)
  add_dependencies(programs ${name})
  set_property(GLOBAL APPEND PROPERTY VOXELAND_PROGRAMS ${name})
  install(TARGETS ${name} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT apps)
endfunction()

# voxeland_plugin(NAME source...): a plugin NAME.so in build/lib/voxeland. Beside it NAME.classes lists
# the classes that its sources register, by which the loader finds the library of a class.
function(voxeland_plugin name)
  set(classes "")
  foreach(source IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
    file(STRINGS "${source}" registrations REGEX "RegisteredClass<[A-Za-z0-9_:]+>")
    foreach(registration IN LISTS registrations)
      string(REGEX REPLACE ".*RegisteredClass<([A-Za-z0-9_:]+)>.*" "\\1\n" class "${registration}")
      string(APPEND classes "${class}")
    endforeach()
  endforeach()
  if(NOT classes)
    message(FATAL_ERROR "plugin ${name} registers no class: it needs a RegisteredClass<...>")
  endif()
  set(list "${CMAKE_BINARY_DIR}/lib/voxeland/${name}.classes")
  file(WRITE "${list}" "${classes}")
  install(FILES "${list}" DESTINATION "${VOXELAND_PLUGIN_INSTALL_DIR}" COMPONENT plugins)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE voxeland::plugin)
  add_dependencies(programs ${name})
  set_target_properties(${name} PROPERTIES PREFIX ""
    LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib/voxeland"
    INSTALL_RPATH "$ORIGIN/..")
  voxeland_warnings(${name})
  install(TARGETS ${name} LIBRARY DESTINATION "${VOXELAND_PLUGIN_INSTALL_DIR}" COMPONENT plugins)
endfunction()

# voxeland_test(NAME source...): a GoogleTest program; every TEST becomes one ctest.
function(voxeland_test name)
  voxeland_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE voxeland_test_support GTest::gtest_main)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT 300)
endfunction()
