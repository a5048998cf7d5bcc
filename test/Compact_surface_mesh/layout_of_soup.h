// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_LAYOUT_OF_SOUP_H
#define TEST_COMPACT_SURFACE_MESH_LAYOUT_OF_SOUP_H

#include "surface_oracle.h"

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Input_images.h>
#include <CGAL/Compact_surface_mesh/Simple_triangulation.h>

#include <string>

namespace test {

/// A layout of a soup; `arguments` go to its constructor.
template <class Layout, class... Arguments>
Layout layout_of(const Polygon_soup& soup, CGAL::Input_images<typename Layout::Index>& images,
                 const Arguments&... arguments)
{
  typedef typename Layout::Index Index;
  return Layout(CGAL::Closed_triangulation<Index>(CGAL::Simple_triangulation<Index>(soup.num_vertices, soup.faces)),
                images, arguments...);
}

/// What such a layout answers wrongly first, or nothing.
template <class Layout, class... Arguments>
std::string difference_from_soup(const Polygon_soup& soup, const Arguments&... arguments)
{
  CGAL::Input_images<typename Layout::Index> images;
  images.wants_halfedges = true;
  const Layout layout = layout_of<Layout>(soup, images, arguments...);
  return Surface_oracle<Layout>(layout, soup, images.vertices, images.halfedges).difference();
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_LAYOUT_OF_SOUP_H
