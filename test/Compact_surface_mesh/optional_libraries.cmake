# Libraries without which some of CGAL's functions for meshes are not there. Their tests are skipped where
# they are not found. Debian has them in libvtk9-dev, lib3mf-dev and libcgal-qt5-dev.

# The readers and writers of VTP and 3MF.
add_library(format_libraries INTERFACE)
find_package(VTK QUIET COMPONENTS CommonCore CommonDataModel IOXML)
if(VTK_FOUND AND TARGET VTK::IOXML)
  target_compile_definitions(format_libraries INTERFACE CGAL_USE_VTK)
  target_link_libraries(format_libraries INTERFACE VTK::CommonCore VTK::CommonDataModel VTK::IOXML)
else()
  message(STATUS "VTK was not found: VTP files will not be tested.")
endif()
find_path(LIB3MF_INCLUDE_DIR Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf)
find_library(LIB3MF_LIBRARY 3MF)
if(LIB3MF_INCLUDE_DIR AND LIB3MF_LIBRARY)
  target_compile_definitions(format_libraries INTERFACE CGAL_LINKED_WITH_3MF)
  target_include_directories(format_libraries SYSTEM INTERFACE ${LIB3MF_INCLUDE_DIR})
  target_link_libraries(format_libraries INTERFACE ${LIB3MF_LIBRARY})
else()
  message(STATUS "lib3mf was not found: 3MF files will not be tested.")
endif()

# The viewer, in windows that no one sees. That of CGAL 6 wants another test.
if(CGAL_VERSION VERSION_LESS 6)
  find_package(CGAL QUIET OPTIONAL_COMPONENTS Qt5)
endif()
if(CGAL_Qt5_FOUND)
  add_unit_tests(test_drawing
    LABEL long
    OPTIONS ${fastest_compilation}
    ENVIRONMENT QT_QPA_PLATFORM=offscreen
    SOURCES test_drawing.cpp)
  target_link_libraries(test_drawing PRIVATE CGAL::CGAL_Basic_viewer)
else()
  message(STATUS "Qt of CGAL 5 was not found: drawing will not be tested.")
  add_test(NAME Drawing COMMAND "${CMAKE_COMMAND}" -E false)
  set_tests_properties(Drawing PROPERTIES SKIP_RETURN_CODE 1 LABELS long)
endif()
