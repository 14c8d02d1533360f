#pragma once
// Reads triangle meshes that Gmsh wrote.

#include <istream>
#include <string>

#include "shoreline/bases/triangle_mesh.hpp"

namespace shoreline {

/// Reads a mesh in Gmsh's format 2.2 or 4.1, ASCII: its triangles of three nodes, in the order of the file, and the
/// nodes that they use. Points, lines, physical names and entities are passed over; anything else is refused.
///
/// @param in    the text of a .msh file, coordinates in metres, z = 0
/// @param name  of the file, for messages
/// @return      not yet checked
/// @throws MeshError with name, line, what was found and what was expected
[[nodiscard]] TriangleMesh read_gmsh(std::istream& in, const std::string& name);

}  // namespace shoreline
