// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_LICENSE_COMPACT_SURFACE_MESH_H
#define CGAL_LICENSE_COMPACT_SURFACE_MESH_H

#include <CGAL/config.h>
#include <CGAL/license.h>

#ifdef CGAL_COMPACT_SURFACE_MESH_COMMERCIAL_LICENSE

#  if CGAL_COMPACT_SURFACE_MESH_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE

#    if defined(CGAL_LICENSE_WARNING)
       CGAL_pragma_warning("Your commercial license for CGAL does not cover "
                           "this release of the Compact Surface Mesh package.")
#    endif

#    ifdef CGAL_LICENSE_ERROR
#      error "Your commercial license for CGAL does not cover this release \
              of the Compact Surface Mesh package. \
              You get this error, as you defined CGAL_LICENSE_ERROR."
#    endif // CGAL_LICENSE_ERROR

#  endif // CGAL_COMPACT_SURFACE_MESH_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE

#else // no CGAL_COMPACT_SURFACE_MESH_COMMERCIAL_LICENSE

#  if defined(CGAL_LICENSE_WARNING)
     CGAL_pragma_warning("\nThe macro CGAL_COMPACT_SURFACE_MESH_COMMERCIAL_LICENSE is not defined."
                          "\nYou use the CGAL Compact Surface Mesh package under "
                          "the terms of the GPLv3+.")
#  endif // CGAL_LICENSE_WARNING

#  ifdef CGAL_LICENSE_ERROR
#    error "The macro CGAL_COMPACT_SURFACE_MESH_COMMERCIAL_LICENSE is not defined.\
            You use the CGAL Compact Surface Mesh package under the terms of \
            the GPLv3+. You get this error, as you defined CGAL_LICENSE_ERROR."
#  endif // CGAL_LICENSE_ERROR

#endif // no CGAL_COMPACT_SURFACE_MESH_COMMERCIAL_LICENSE

#endif // CGAL_LICENSE_COMPACT_SURFACE_MESH_H
