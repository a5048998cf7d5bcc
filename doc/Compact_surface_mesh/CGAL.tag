<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- What the manual links to in the manual of CGAL when it is built outside of it. -->
<tagfile>
  <compound kind="group">
    <name>bgl_namedparameters</name>
    <title>Named Parameters</title>
    <filename>BGL/group__bgl__namedparameters.html</filename>
  </compound>
  <compound kind="group">
    <name>PkgStreamSupportEnumRef</name>
    <title>I/O Enumerations</title>
    <filename>Stream_support/group__PkgStreamSupportEnumRef.html</filename>
  </compound>
  <compound kind="page">
    <name>IOStreamSupportedFileFormats</name>
    <title>Supported File Formats</title>
    <filename>Stream_support/IOStreamSupportedFileFormats.html</filename>
    <docanchor file="Stream_support/IOStreamSupportedFileFormats.html" title="Object File Format (OFF)">IOStreamOFF</docanchor>
    <docanchor file="Stream_support/IOStreamSupportedFileFormats.html" title="Wavefront Advanced Visualizer Object Format (OBJ)">IOStreamOBJ</docanchor>
    <docanchor file="Stream_support/IOStreamSupportedFileFormats.html" title="STereoLithography (STL)">IOStreamSTL</docanchor>
    <docanchor file="Stream_support/IOStreamSupportedFileFormats.html" title="Polygon File Format (PLY)">IOStreamPLY</docanchor>
    <docanchor file="Stream_support/IOStreamSupportedFileFormats.html" title="GOCAD (TS)">IOStreamGocad</docanchor>
    <docanchor file="Stream_support/IOStreamSupportedFileFormats.html" title="VTK (VTU / VTP)">IOStreamVTK</docanchor>
    <docanchor file="Stream_support/IOStreamSupportedFileFormats.html" title="3D Manufacturing Format (3MF)">IOStream3MF</docanchor>
  </compound>
  <compound kind="class">
    <name>EdgeListGraph</name>
    <filename>BGL/classEdgeListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>FaceGraph</name>
    <filename>BGL/classFaceGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>FaceListGraph</name>
    <filename>BGL/classFaceListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>HalfedgeGraph</name>
    <filename>BGL/classHalfedgeGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>HalfedgeListGraph</name>
    <filename>BGL/classHalfedgeListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>Hashable</name>
    <filename>STL_Extension/classHashable.html</filename>
  </compound>
  <compound kind="class">
    <name>MutableFaceGraph</name>
    <filename>BGL/classMutableFaceGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>MutableHalfedgeGraph</name>
    <filename>BGL/classMutableHalfedgeGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>VertexListGraph</name>
    <filename>BGL/classVertexListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Surface_mesh</name>
    <filename>Surface_mesh/classCGAL_1_1Surface__mesh.html</filename>
  </compound>
</tagfile>
