# Tests of the package as its users get it: installed, in parts, and documented.

set(package_dir "${Compact_surface_mesh_SOURCE_DIR}")
set(scratch_dir "${CMAKE_CURRENT_BINARY_DIR}/package")
set(same_tools
  -G "${CMAKE_GENERATOR}"
  "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}"
  "-DCMAKE_BUILD_TYPE=Debug"
  "-DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON"
  "-DCGAL_DIR=${CGAL_DIR}")

# A foreign project finds the installed package, builds with it and runs.
add_test(NAME package.install
  COMMAND "${CMAKE_COMMAND}"
    "-DBUILD_DIR=${Compact_surface_mesh_BINARY_DIR}" "-DPREFIX=${scratch_dir}/installed"
    -P "${CMAKE_CURRENT_SOURCE_DIR}/consumer/install.cmake")
add_test(NAME package.consumer_configures
  COMMAND "${CMAKE_COMMAND}"
    -S "${CMAKE_CURRENT_SOURCE_DIR}/consumer" -B "${scratch_dir}/consumer"
    ${same_tools} "-DCompact_surface_mesh_ROOT=${scratch_dir}/installed")
add_test(NAME package.consumer_builds
  COMMAND "${CMAKE_COMMAND}" --build "${scratch_dir}/consumer")
add_test(NAME package.consumer_runs
  COMMAND "${scratch_dir}/consumer/consumer")
set_tests_properties(package.install PROPERTIES
  FIXTURES_SETUP installed_package)
set_tests_properties(package.consumer_configures PROPERTIES
  FIXTURES_REQUIRED installed_package FIXTURES_SETUP configured_consumer)
set_tests_properties(package.consumer_builds PROPERTIES
  FIXTURES_REQUIRED configured_consumer FIXTURES_SETUP built_consumer)
set_tests_properties(package.consumer_runs PROPERTIES
  FIXTURES_REQUIRED built_consumer)

# Each part builds alone; to configure it shows that it finds what it needs.
foreach(part IN ITEMS examples test benchmark)
  add_test(NAME package.${part}_configure_alone
    COMMAND "${CMAKE_COMMAND}"
      -S "${package_dir}/${part}/Compact_surface_mesh" -B "${scratch_dir}/${part}"
      ${same_tools})
endforeach()
add_test(NAME package.examples_build_alone
  COMMAND "${CMAKE_COMMAND}" --build "${scratch_dir}/examples" --target csm_first_program)
set_tests_properties(package.examples_configure_alone PROPERTIES
  FIXTURES_SETUP configured_examples)
set_tests_properties(package.examples_build_alone PROPERTIES
  FIXTURES_REQUIRED configured_examples)

# What edits connectivity does not compile, and says what to do.
get_target_property(cgal_includes CGAL::CGAL INTERFACE_INCLUDE_DIRECTORIES)
list(JOIN cgal_includes "|" cgal_includes)
add_test(NAME package.edits_do_not_compile
  COMMAND "${CMAKE_COMMAND}"
    "-DCOMPILER=${CMAKE_CXX_COMPILER}" "-DINCLUDES=${package_dir}/include|${cgal_includes}"
    -P "${CMAKE_CURRENT_SOURCE_DIR}/refused/compile.cmake")

# A second compiler takes the headers without warnings.
find_program(COMPACT_SURFACE_MESH_CLANG NAMES clang++ clang++-14)
if(COMPACT_SURFACE_MESH_CLANG)
  file(GLOB headers
    "${package_dir}/include/CGAL/Compact_surface_mesh.h" "${package_dir}/include/CGAL/Schnyder_woods.h"
    "${package_dir}/include/CGAL/Compact_surface_mesh/layouts/*.h")
  list(JOIN headers "|" headers)
  add_test(NAME package.compiles_with_clang
    COMMAND "${CMAKE_COMMAND}"
      "-DCOMPILER=${COMPACT_SURFACE_MESH_CLANG}" "-DINCLUDE=${package_dir}/include" "-DSYSTEM_INCLUDES=${cgal_includes}"
      "-DHEADERS=${headers}" "-DPROGRAM=${package_dir}/examples/Compact_surface_mesh/csm_first_program.cpp"
      -P "${CMAKE_CURRENT_SOURCE_DIR}/second_compiler/compile.cmake")
else()
  message(STATUS "clang++ was not found: no second compiler will see the headers.")
endif()

# All that takes a mesh in the headers of this CGAL is in the manual's table, and the tests that it names exist.
string(REPLACE "|" ";" cgal_directories "${cgal_includes}|${CGAL_INCLUDE_DIRS}")
list(REMOVE_DUPLICATES cgal_directories)
add_test(NAME package.entry_points
  COMMAND "${CMAKE_CURRENT_SOURCE_DIR}/entry_points/entry_points" check ${cgal_directories})

# CGAL's own examples with the name of the mesh replaced run among the long tests.
get_filename_component(cgal_examples "${CGAL_DATA_DIR}/../cgal_examples" ABSOLUTE)
if(CGAL_VERSION VERSION_GREATER_EQUAL 5.5 AND CGAL_VERSION VERSION_LESS 5.6
   AND EXISTS "${cgal_examples}/Surface_mesh" AND TARGET CGAL::METIS_support
   AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  get_target_property(eigen_includes Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  list(TRANSFORM cgal_directories PREPEND "-I" OUTPUT_VARIABLE cgal_options)
  list(FILTER cgal_options EXCLUDE REGEX "^-I$|INSTALL_INTERFACE")
  list(TRANSFORM eigen_includes PREPEND "-isystem " OUTPUT_VARIABLE eigen_options)
  list(JOIN cgal_options " " cgal_options)
  list(JOIN eigen_options " " eigen_options)
  set(run_cgal_examples "${CMAKE_CURRENT_SOURCE_DIR}/cgal_examples/cgal_examples")
  add_test(NAME package.cgal_examples_table COMMAND "${run_cgal_examples}" check "${cgal_examples}")
  if(COMPACT_SURFACE_MESH_LONG_TESTS)
    add_test(NAME package.cgal_examples
      COMMAND "${run_cgal_examples}" run "${cgal_examples}" "${CGAL_DATA_DIR}" "${scratch_dir}/cgal_examples")
    set_tests_properties(package.cgal_examples PROPERTIES
      ENVIRONMENT "CXX=${CMAKE_CXX_COMPILER};CXXFLAGS=${cgal_options} ${eigen_options}"
      LABELS long RUN_SERIAL ON TIMEOUT 14400)
  endif()
else()
  message(STATUS "There will be no test of CGAL's examples: it needs those of CGAL 5.5, METIS and g++.")
endif()

# The examples run, on a sphere of 2,050 vertices and on a small one for the drawing.
if(COMPACT_SURFACE_MESH_BUILD_EXAMPLES)
  file(MAKE_DIRECTORY "${scratch_dir}")
  add_test(NAME example.sphere
    COMMAND "${package_dir}/scripts/write_sphere" 64 32 "${scratch_dir}/sphere.off")
  add_test(NAME example.small_sphere
    COMMAND "${package_dir}/scripts/write_sphere" 6 4 "${scratch_dir}/small_sphere.off")
  set_tests_properties(example.sphere example.small_sphere PROPERTIES FIXTURES_SETUP spheres)

  foreach(program IN ITEMS csm_first_program g_schnyder_wood_example schnyder_wood_example)
    add_test(NAME example.${program} COMMAND ${program})
  endforeach()
  add_test(NAME example.compact_mesh_report
    COMMAND compact_mesh_report "${scratch_dir}/sphere.off" --layout all)
  add_test(NAME example.compact_mesh_report_draws
    COMMAND compact_mesh_report "${scratch_dir}/small_sphere.off" --svg "${scratch_dir}/wood.svg")
  add_test(NAME example.g_schnyder_wood_example_draws
    COMMAND g_schnyder_wood_example 7 4 "${scratch_dir}/torus.svg")
  add_test(NAME example.cut_graph_example
    COMMAND cut_graph_example "${scratch_dir}/small_sphere.off" "${scratch_dir}/cut_graph.ply")
  set_tests_properties(example.compact_mesh_report example.compact_mesh_report_draws example.cut_graph_example
    PROPERTIES FIXTURES_REQUIRED spheres)
endif()

# Every structure gives the same results in the benchmark's kernels, of which no time is asked here.
if(COMPACT_SURFACE_MESH_BUILD_BENCHMARKS)
  add_test(NAME benchmark.speed COMMAND benchmark_speed 1000 --inputs "random|terrain" --rounds 1)
  if(COMPACT_SURFACE_MESH_LONG_TESTS)
    add_test(NAME benchmark.end_to_end COMMAND benchmark_end_to_end 1000 --inputs "random|terrain" --rounds 1)
    set_tests_properties(benchmark.end_to_end PROPERTIES LABELS long TIMEOUT 1500)
  endif()
endif()

# The manual builds, and any warning fails.
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  file(WRITE "${scratch_dir}/Doxyfile"
    "@INCLUDE = \"${package_dir}/doc/Compact_surface_mesh/Doxyfile\"\n"
    "OUTPUT_DIRECTORY = \"${scratch_dir}\"\n")
  add_test(NAME package.manual_builds_without_warnings
    COMMAND "${DOXYGEN_EXECUTABLE}" "${scratch_dir}/Doxyfile"
    WORKING_DIRECTORY "${package_dir}/doc/Compact_surface_mesh")
else()
  message(STATUS "Doxygen was not found: there will be no test of the manual.")
endif()
